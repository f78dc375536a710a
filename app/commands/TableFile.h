#pragma once

#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <string>
#include <vector>

namespace mote::app
{

/// Writes a table as comma-separated values with nine digits, a line of names first; to standard
/// output for an empty name. Throws Failure; then no file is left that is not complete.
void writeTable(vtkTable* table, const std::string& file);

/// Whether the name is that of a table: .csv, or none for standard output.
bool isTableFile(const std::string& file);

/// Puts a column with one number in front.
vtkSmartPointer<vtkTable> withTime(vtkTable* table, double time);

/// Adds the rows of a table, all of whose columns the other has; false where it has not. A table
/// that is null becomes this one.
bool appendRows(vtkSmartPointer<vtkTable>& to, vtkTable* rows);

/// A column of numbers; NaN where there is none of that name.
std::vector<double> numbersOf(vtkTable* table, const std::string& column);

} // namespace mote::app
