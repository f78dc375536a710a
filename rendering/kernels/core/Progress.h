#pragma once

#include <functional>

namespace mote
{

/// How a long work tells how far it is and learns that it should stop. Called from one thread at a
/// time with the share done in [0, 1]; answering false asks the work to stop early.
using Progress = std::function<bool(double)>;

} // namespace mote
