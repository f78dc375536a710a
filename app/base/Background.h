#pragma once

#include <functional>

namespace mote::app
{

/// Runs work on the thread that calls, which does nothing else, so that what the window's thread
/// does goes first: on the cores, and among the tasks of all threads.
void inBackground(const std::function<void()>& work);

} // namespace mote::app
