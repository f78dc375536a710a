#ifndef MotePolyDataParts_h
#define MotePolyDataParts_h

#include "TextRows.h"

#include "kernels/core/ScratchSpace.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <string>

class vtkAbstractArray;
class vtkFieldData;
class vtkPoints;
class vtkPolyData;

namespace mote
{

/// Where the values of columns are put.
struct ColumnSpace
{
  ScratchSpace* space = nullptr; ///< null: the heap
  bool inFile = false;           ///< whatever room the space has in memory
};

/// A VTK array for columns of one type, with `data` at its first value, or null if it has none.
/// Int64 is vtkIdTypeArray, String vtkStringArray (whose values are std::string, on the heap).
vtkSmartPointer<vtkAbstractArray> makeColumnArray(
  ColumnType type, int components, vtkIdType tuples, void*& data, const ColumnSpace& space = {});

/// The size of one value in such an array.
std::size_t bytesOf(ColumnType type);

/// Gives the points space for `count` positions in double; returns it, or null for none.
double* makePositions(vtkPoints* points, vtkIdType count, const ColumnSpace& space = {});

/// One vertex cell an atom, so that cell-wise filters (vtkThreshold) can take atoms apart. In
/// 32-bit storage these cost the 8 bytes an atom that one 64-bit poly-vertex would.
void setVertices(vtkPolyData* output, vtkIdType points);

/// Adds one tuple of numbers.
void addNumbers(vtkFieldData* fields, const char* name, const double* values, int count);

/// Adds one string; none if it is empty.
void addText(vtkFieldData* fields, const char* name, const std::string& text);

} // namespace mote

#endif
