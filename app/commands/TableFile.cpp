#include "TableFile.h"

#include "base/OutputFile.h"
#include "base/Text.h"

#include <vtkDataArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

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

} // namespace mote::app
