#pragma once

#include "Settings.h"

#include <optional>

namespace mote::app
{

/// What the session says that was opened or saved last; nothing where there is none.
class KeptSession
{
public:
  void keep(const Settings& settings) { kept_ = settings; }
  void forget() { kept_.reset(); }

  /// Whether these settings are of the session, and say what it does not. Where the camera stands
  /// and which time step is shown does not count: both change by looking.
  bool lacks(const Settings& now) const;

private:
  std::optional<Settings> kept_;
};

} // namespace mote::app
