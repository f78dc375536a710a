#include "History.h"

namespace mote::app
{

namespace
{

std::optional<Settings> step(
  std::vector<Settings>& from, std::vector<Settings>& to, const Settings& now)
{
  if (from.empty())
    return {};
  Settings next = from.back();
  from.pop_back();
  to.push_back(now);
  return next;
}

} // namespace

void History::add(const Settings& now)
{
  if (past_.size() == most)
    past_.erase(past_.begin());
  past_.push_back(now);
  future_.clear();
}

std::optional<Settings> History::undo(const Settings& now)
{
  return step(past_, future_, now);
}

std::optional<Settings> History::redo(const Settings& now)
{
  return step(future_, past_, now);
}

} // namespace mote::app
