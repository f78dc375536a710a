#pragma once

#include <vtkMoteLineTubes.h>
#include <vtkMoteMeshMapper.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkDataSet;
class vtkPointSet;
class vtkUnsignedCharArray;

namespace mote::app
{

/// How thick lines are drawn.
struct TubeRadius
{
  double radius = 0.0; ///< in the data's units; 0: by the data's size
  std::string array;   ///< of points, in place of `radius`; empty: none
  double scale = 1.0;  ///< a factor on all
  bool operator==(const TubeRadius&) const = default;
};

/// Cells of a part, shown by their surface.
///
/// Up to four million polygons without normals of points get some, so that they look smooth but for
/// sharp edges; for that points are split at these. Faces of grids are flat, and .mote files stay
/// as they were written. Lines become tubes.
class Surface
{
public:
  void setData(vtkDataSet* data);
  void setTubeRadius(const TubeRadius& radius);
  /// Takes arrays that the data have got since.
  void followArrays(vtkDataSet* data);

  /// Shows those of the data's cells alone for which this is not 0; null for all.
  void setVisible(vtkDataSet* data, vtkUnsignedCharArray* isVisible);

  /// What is drawn in place of the data, where something was made of them; else null. A data object
  /// of its own. Also null where that lacks faces of hidden cells.
  vtkSmartPointer<vtkPointSet> drawn() const;
  /// Takes what another made of the same data, in place of making it.
  void takeDrawn(vtkPointSet* drawn);

  vtkMoteMeshMapper* mapper() const { return mapper_; }
  /// Whether normals were made, by a vtkPolyDataNormals as it is made.
  bool makesNormals() const { return makesNormals_; }
  /// Whether the faces were taken out before, as of images, by a vtkDataSetSurfaceFilter.
  bool takesFaces() const { return takesFaces_; }
  /// What makes tubes of lines, or null.
  vtkMoteLineTubes* tubes() const { return tubes_; }
  /// Whether one of these makes what is drawn, with other cells than the data's.
  bool isMade() const { return makesNormals_ || takesFaces_ || tubes_; }
  /// Gives the numbers of the data's cells, where the mapper's input has them, the name that they
  /// have in files; cellOf() knows nothing of them then.
  void nameCellsForFile();
  /// The cell of the data that a cell of the mapper's input stands for.
  vtkIdType cellOf(vtkIdType cell) const;

private:
  void connectTubes();
  bool hasCutFaces() const { return takesFaces_ && isVisible_; }

  vtkNew<vtkMoteMeshMapper> mapper_;
  bool makesNormals_ = false, takesFaces_ = false;
  vtkSmartPointer<vtkMoteLineTubes> tubes_;
  TubeRadius tubeRadius_;
  vtkMTimeType taken_ = 0;                          ///< of the data
  vtkSmartPointer<vtkUnsignedCharArray> isVisible_; ///< cells of the data; null: all
};

} // namespace mote::app
