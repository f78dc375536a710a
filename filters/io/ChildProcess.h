#ifndef MoteChildProcess_h
#define MoteChildProcess_h

#include <functional>

namespace mote
{

/// How a child process ended.
enum class ChildEnd
{
  Well, ///< or there could be none
  Died,
  Late ///< it was stopped
};

/// Does in a child process what a library may not survive, and waits for it. What it says is not
/// heard, and nothing that it changes is kept. It is stopped after so many seconds, which `work`
/// may put off by alarm().
ChildEnd inChildProcess(unsigned seconds, const std::function<void()>& work);

} // namespace mote

#endif
