#ifndef MoteTableColumns_h
#define MoteTableColumns_h

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <string>
#include <vector>

namespace mote
{

/// Columns that are filled from left to right, row by row. A table takes them when they are whole.
class TableColumns
{
public:
  void Add(const std::string& name, const std::string& value)
  {
    this->Of<vtkStringArray>(name)->InsertNextValue(value);
  }
  void Add(const std::string& name, vtkIdType value)
  {
    this->Of<vtkIdTypeArray>(name)->InsertNextValue(value);
  }
  void Add(const std::string& name, double value)
  {
    this->Of<vtkDoubleArray>(name)->InsertNextValue(value);
  }

  void FillTable(vtkTable* table) const
  {
    for (const auto& column : this->All)
      table->AddColumn(column);
  }

private:
  template <class Array>
  Array* Of(const std::string& name)
  {
    for (const auto& column : this->All)
      if (column->GetName() == name)
        return Array::SafeDownCast(column);
    vtkNew<Array> column;
    column->SetName(name.c_str());
    this->All.emplace_back(column);
    return column;
  }

  std::vector<vtkSmartPointer<vtkAbstractArray>> All;
};

} // namespace mote

#endif
