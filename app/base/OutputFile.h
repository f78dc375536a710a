#pragma once

#include "ProgressRelay.h"

#include <string>
#include <vector>

class vtkMoteFileWriter;

namespace mote::app
{

/// Throws Failure where a file of that name cannot be written, as far as can be seen beforehand, or
/// where it is one of the files that are read, under whatever name: nobody replaces data by chance.
/// Does nothing for an empty name, which is the standard output.
void checkOutput(const std::string& output, const std::vector<std::string>& inputs);

/// Writes a file of this text, which appears complete or not at all. Throws Failure.
void writeText(const std::string& file, const std::string& text);

/// Has a writer write a file, with progress, where `which` says which of several it is. Throws
/// Failure and Interrupted.
void writeFile(vtkMoteFileWriter* writer, const std::string& file, ProgressRelay& progress,
  const std::string& which = {});

} // namespace mote::app
