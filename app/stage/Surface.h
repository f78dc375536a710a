#pragma once

#include <vtkMoteMeshMapper.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkDataSet;
class vtkPointSet;
class vtkUnsignedCharArray;

namespace mote::app
{

/// Cells of a part, shown by their surface.
///
/// Up to four million polygons without normals of points get some, so that they look smooth but for
/// sharp edges; for that points are split at these. Faces of grids are flat, and .mote files stay
/// as they were written.
class Surface
{
public:
  void setData(vtkDataSet* data);
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
  /// Gives the numbers of the data's cells, where the mapper's input has them, the name that they
  /// have in files; cellOf() knows nothing of them then.
  void nameCellsForFile();
  /// The cell of the data that a cell of the mapper's input stands for.
  vtkIdType cellOf(vtkIdType cell) const;

private:
  bool hasCutFaces() const { return takesFaces_ && isVisible_; }

  vtkNew<vtkMoteMeshMapper> mapper_;
  bool makesNormals_ = false, takesFaces_ = false;
  vtkMTimeType taken_ = 0;                          ///< of the data
  vtkSmartPointer<vtkUnsignedCharArray> isVisible_; ///< cells of the data; null: all
};

} // namespace mote::app
