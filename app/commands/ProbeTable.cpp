#include "ProbeTable.h"

#include "base/Text.h"

#include <vtkCharArray.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cmath>

namespace mote::app
{

std::array<double, 3> ProbedPoints::at(vtkIdType i) const
{
  std::array<double, 3> place{};
  data->GetPoint(i, place.data());
  return place;
}

double ProbedPoints::distance(vtkIdType i) const
{
  const auto start = at(0), place = at(i);
  return std::sqrt(vtkMath::Distance2BetweenPoints(start.data(), place.data()));
}

std::string ProbedPoints::place(vtkIdType i) const
{
  const auto place = at(i);
  return asNumber(place[0]) + ", " + asNumber(place[1]) + ", " + asNumber(place[2]);
}

ProbeTable::ProbeTable(const ProbedPoints& points)
  : rows_(points.data->GetNumberOfPoints())
{
  vtkDoubleArray* along = this->column(points.isLine ? "distance" : "point");
  vtkDoubleArray* place[3] = {this->column("x"), this->column("y"), this->column("z")};
  for (vtkIdType i = 0; i < rows_; ++i)
  {
    along->SetValue(i, points.isLine ? points.distance(i) : static_cast<double>(i + 1));
    for (int k = 0; k < 3; ++k)
      place[k]->SetValue(i, points.at(i)[static_cast<std::size_t>(k)]);
  }
  parts_->SetName("part");
  parts_->SetNumberOfValues(rows_);
  table_->AddColumn(parts_);
}

void ProbeTable::add(const std::string& name, vtkPointData* values)
{
  auto* valid = vtkCharArray::SafeDownCast(values->GetArray("vtkValidPointMask"));
  if (!valid)
    return;
  std::vector<vtkIdType> mine;
  for (vtkIdType i = 0; i < rows_; ++i)
    if (valid->GetValue(i) && parts_->GetValue(i).empty())
      mine.push_back(i);
  for (const vtkIdType i : mine)
    parts_->SetValue(i, name);
  for (int a = 0; a < values->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = values->GetArray(a);
    const std::string heading = nameOf(array);
    if (heading.empty() || array == valid)
      continue;
    const int components = array->GetNumberOfComponents();
    for (int k = 0; k < components; ++k)
    {
      const char* component = array->GetComponentName(k);
      vtkDoubleArray* column = this->column(
        heading + (components == 1 ? "" : ":" + (component ? component : std::to_string(k))));
      for (const vtkIdType i : mine)
        column->SetValue(i, array->GetComponent(i, k));
    }
  }
}

std::vector<double> ProbeTable::values(const ArrayChoice& choice, const std::string& heading) const
{
  std::vector<double> values;
  std::vector<vtkDataArray*> parts;
  for (vtkIdType c = 0; c < table_->GetNumberOfColumns(); ++c)
    if (const std::string name = table_->GetColumnName(c);
        name == heading || (heading == choice.name && name.starts_with(heading + ":")))
      parts.push_back(vtkDataArray::SafeDownCast(table_->GetColumn(c)));
  for (vtkIdType i = 0; i < rows_; ++i)
  {
    double squares = parts.empty() ? std::nan("") : 0.0;
    for (vtkDataArray* part : parts)
      squares += std::pow(part->GetComponent(i, 0), 2);
    values.push_back(parts.size() == 1 ? parts.front()->GetComponent(i, 0) : std::sqrt(squares));
  }
  return values;
}

bool ProbeTable::anyInside() const
{
  for (vtkIdType i = 0; i < rows_; ++i)
    if (!parts_->GetValue(i).empty())
      return true;
  return false;
}

vtkDoubleArray* ProbeTable::column(const std::string& name)
{
  if (auto* known = vtkDoubleArray::SafeDownCast(table_->GetColumnByName(name.c_str())))
    return known;
  vtkNew<vtkDoubleArray> made;
  made->SetName(name.c_str());
  made->SetNumberOfValues(rows_);
  made->Fill(std::nan(""));
  table_->AddColumn(made);
  return made;
}

} // namespace mote::app
