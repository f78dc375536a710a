#pragma once

#include "Settings.h"

#include <optional>
#include <vector>

namespace mote::app
{

/// Settings that were, to go back to and forth again.
class History
{
public:
  /// What is about to change. What was undone is forgotten.
  void add(const Settings& now);

  /// The settings before the last change, or after the one undone last; none where there are none.
  std::optional<Settings> undo(const Settings& now);
  std::optional<Settings> redo(const Settings& now);

private:
  static constexpr std::size_t most = 1000;

  std::vector<Settings> past_, future_;
};

} // namespace mote::app
