#ifndef MoteMeshStatistics_h
#define MoteMeshStatistics_h

#include "vtkType.h"

#include <limits>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace mote
{

/// What the cells of a data set amount to; see vtkMoteMeshStatistics for the words.
struct CellStatistics
{
  vtkIdType cells = 0, hexahedra = 0, wedges = 0, pyramids = 0, tetrahedra = 0, polyhedra = 0;
  vtkIdType other = 0;
  vtkIdType inverted = 0, zeroVolume = 0, nonFinite = 0;
  double volume = 0.0, minVolume = std::numeric_limits<double>::infinity(), maxVolume = 0.0;
  double minScaledJacobian = std::numeric_limits<double>::infinity();
  double sumScaledJacobian = 0.0, maxAspectRatio = 0.0;

  /// Those that have a quality.
  vtkIdType taken() const { return hexahedra + wedges + pyramids + tetrahedra; }
  void add(const CellStatistics& other);
};

struct ArrayStatistics
{
  double min = std::numeric_limits<double>::infinity(), max = -min;
  double integral = 0.0, volume = 0.0;
  vtkIdType nonFinite = 0;

  void add(const ArrayStatistics& other);
};

struct MeasuredArray
{
  vtkDataArray* array;
  bool ofCells;
  ArrayStatistics statistics;
};

struct MeshStatistics
{
  CellStatistics cells;
  std::vector<MeasuredArray>
    arrays; ///< all that hold numbers and have a name, without ghosts' marks
};

/// A component of an array, or with -1 the magnitude.
double valueOf(vtkDataArray* array, vtkIdType tuple, int component = -1);

/// Looks at all cells, in parallel.
MeshStatistics statisticsOf(vtkDataSet* data);

} // namespace mote

#endif
