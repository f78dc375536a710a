#pragma once

#include "settings/UserState.h"

namespace mote::app
{

/// What a user should know in the first minutes, one sentence after the other, once: which have
/// been seen is remembered from one start to the next.
class Hints
{
public:
  Hints();

  /// Draws the present one, with what puts it off; nothing where all have been seen.
  void draw(bool hasVolumes);

private:
  void remember() const;

  UserState state_;
  bool isLater_ = false; ///< not again before the next start
};

} // namespace mote::app
