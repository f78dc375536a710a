#include "TableFile.h"

#include "base/OutputFile.h"
#include "base/Text.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkVariant.h>
#include <vtkVariantArray.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace mote::app
{

namespace
{

std::string cellText(vtkTable* table, vtkIdType row, vtkIdType column)
{
  const vtkVariant value = table->GetValue(row, column);
  if (!value.IsNumeric())
    return inQuotes(value.ToString(), ',');
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value.ToDouble());
  return text;
}

std::string asLines(vtkTable* table)
{
  std::string text;
  for (vtkIdType row = -1; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
    {
      if (c > 0)
        text += ',';
      text += row < 0 ? inQuotes(table->GetColumnName(c), ',') : cellText(table, row, c);
    }
    text += '\n';
  }
  return text;
}

} // namespace

bool isTableFile(const std::string& file)
{
  return file.empty() || lowerCase(std::filesystem::path(file).extension().string()) == ".csv";
}

void writeTable(vtkTable* table, const std::string& file)
{
  const std::string text = asLines(table);
  if (file.empty())
    std::fwrite(text.data(), 1, text.size(), stdout);
  else
    writeText(file, text);
}

vtkSmartPointer<vtkTable> withTime(vtkTable* table, double time)
{
  vtkNew<vtkDoubleArray> times;
  times->SetName("time");
  times->SetNumberOfValues(table->GetNumberOfRows());
  times->Fill(time);
  auto timed = vtkSmartPointer<vtkTable>::New();
  timed->AddColumn(times);
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    timed->AddColumn(table->GetColumn(column));
  return timed;
}

bool appendRows(vtkSmartPointer<vtkTable>& to, vtkTable* rows)
{
  if (!to)
  {
    to = rows;
    return true;
  }
  if (to->GetNumberOfColumns() != rows->GetNumberOfColumns())
    return false;
  for (vtkIdType column = 0; column < to->GetNumberOfColumns(); ++column)
    if (std::string(to->GetColumnName(column)) != rows->GetColumnName(column))
      return false;
  for (vtkIdType row = 0; row < rows->GetNumberOfRows(); ++row)
    to->InsertNextRow(rows->GetRow(row));
  return true;
}

std::vector<double> numbersOf(vtkTable* table, const std::string& column)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(column.c_str()));
  std::vector<double> numbers;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    numbers.push_back(array ? array->GetComponent(row, 0) : std::nan(""));
  return numbers;
}

} // namespace mote::app
