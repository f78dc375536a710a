#include "vtkMoteCellSelection.h"

#include "CellSelection.h"

#include "kernels/core/Error.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <utility>

vtkStandardNewMacro(vtkMoteCellSelection);

vtkMoteCellSelection::vtkMoteCellSelection() = default;
vtkMoteCellSelection::~vtkMoteCellSelection() = default;

void vtkMoteCellSelection::SetDataSet(vtkDataSet* data)
{
  this->DataSet = data;
  this->Selection = data ? std::make_unique<mote::CellSelection>(data) : nullptr;
  this->Intervals.clear();
  this->Modified();
}

void vtkMoteCellSelection::AddInterval(double low, double high)
{
  this->Intervals.emplace_back(low, high);
}

bool vtkMoteCellSelection::Limit(const std::string& name, int component, bool ofCells)
{
  const auto intervals = std::exchange(this->Intervals, {});
  vtkDataSetAttributes* arrays = nullptr;
  if (this->DataSet)
    arrays = ofCells ? static_cast<vtkDataSetAttributes*>(this->DataSet->GetCellData())
                     : this->DataSet->GetPointData();
  vtkDataArray* array = arrays ? arrays->GetArray(name.c_str()) : nullptr;
  if (!array || component < -1 || component >= array->GetNumberOfComponents())
  {
    vtkErrorMacro(<< "There is no component " << component << " of an array of "
                  << (ofCells ? "cells" : "points") << " '" << name << "'.");
    return false;
  }
  try
  {
    this->Selection->limit(array, component, ofCells, intervals);
  }
  catch (const mote::Error& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
  this->Modified();
  return true;
}

bool vtkMoteCellSelection::LimitPlace(int axis)
{
  const auto intervals = std::exchange(this->Intervals, {});
  if (!this->Selection || axis < 0 || axis > 2)
  {
    vtkErrorMacro(<< "There is no data set, or no axis " << axis << ".");
    return false;
  }
  this->Selection->limitPlace(axis, intervals);
  this->Modified();
  return true;
}

vtkUnsignedCharArray* vtkMoteCellSelection::GetVisibleCells()
{
  return this->Selection ? this->Selection->isVisible() : nullptr;
}

vtkIdType vtkMoteCellSelection::GetNumberOfVisibleCells()
{
  return this->Selection ? this->Selection->numberVisible() : 0;
}

void vtkMoteCellSelection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DataSet: " << this->DataSet.Get() << "\n";
  os << indent << "Intervals: " << this->Intervals.size() << "\n";
  os << indent << "VisibleCells: " << this->GetNumberOfVisibleCells() << "\n";
}
