#pragma once

#include <string>

class vtkTable;

namespace mote::app
{

/// Writes a table as comma-separated values with nine digits, a line of names first; to standard
/// output for an empty name. Throws Failure; then no file is left that is not complete.
void writeTable(vtkTable* table, const std::string& file);

/// Whether the name is that of a table: .csv, or none for standard output.
bool isTableFile(const std::string& file);

} // namespace mote::app
