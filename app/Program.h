#pragma once

#include <tbb/global_control.h>

#include <memory>

namespace mote::app
{

/// Keeps every part of the program, the readers too, to so many threads while it lives; 0 for all.
std::unique_ptr<tbb::global_control> limitThreads(int threads);

/// The program: chooses between the window and the commands, and turns what goes wrong into a
/// sentence on standard error and an exit code.
int runProgram(int argc, char** argv);

} // namespace mote::app
