#pragma once

#include "stage/Arrays.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <array>
#include <string>
#include <vector>

class vtkDoubleArray;
class vtkPointData;

namespace mote::app
{

/// Points that are looked up: of a line, or each for itself.
struct ProbedPoints
{
  vtkSmartPointer<vtkPolyData> data;
  bool isLine = true;

  std::array<double, 3> at(vtkIdType i) const;
  /// From the first one.
  double distance(vtkIdType i) const;
  /// "0.1, 0, 0.2".
  std::string place(vtkIdType i) const;
};

/// The columns of the table in their order; values are NaN until they are known.
class ProbeTable
{
public:
  explicit ProbeTable(const ProbedPoints& points);

  /// Takes a part's values at the points that lie in it and in no part before.
  void add(const std::string& name, vtkPointData* values);

  vtkTable* table() const { return table_; }

  /// The values of one choice at the points, by the heading of its column; NaN where there are
  /// none.
  std::vector<double> values(const ArrayChoice& choice, const std::string& heading) const;

  bool anyInside() const;

private:
  vtkDoubleArray* column(const std::string& name);

  vtkIdType rows_;
  vtkNew<vtkTable> table_;
  vtkNew<vtkStringArray> parts_;
};

} // namespace mote::app
