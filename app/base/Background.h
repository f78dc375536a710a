#pragma once

#include <functional>

namespace mote::app
{

/// Runs work on the thread that calls, which does nothing else, so that what the window's thread
/// does goes first: on the cores, and among the tasks of all threads.
void inBackground(const std::function<void()>& work);

/// Gives memory that was freed back to the system, of all threads' pools. GNU's library keeps it
/// else: half of what a window took that had opened one data set after another.
void giveBackMemory();

} // namespace mote::app
