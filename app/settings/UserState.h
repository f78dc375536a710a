#pragma once

#include <functional>
#include <string>
#include <vector>

namespace mote::app
{

/// What the program remembers of its user from one start to the next.
struct UserState
{
  std::vector<std::vector<std::string>> recent; ///< files that were opened together, latest first
  int hintsSeen = 0;                            ///< of the hints for beginners, in their order
  bool hints = true;                            ///< whether more are wanted
};

/// As the state's file has it; the usual state where there is none, or it makes no sense.
UserState readUserState();

/// Changes what is remembered. Nothing happens where it cannot be written: no one waits for that.
void changeUserState(const std::function<void(UserState&)>& change);

/// Puts files that were opened first among the recent ones, by their full names.
void noteRecent(const std::vector<std::string>& files);

} // namespace mote::app
