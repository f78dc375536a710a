#include "KeptSession.h"

#include <algorithm>

namespace mote::app
{

namespace
{

/// The choices alone that somebody would miss.
Settings choicesOf(Settings settings)
{
  settings.camera = {};
  settings.data.time.reset();
  settings.data.step.clear();
  settings.data.threads = 0;
  settings.marks.picked.clear();
  settings.picture.size = {};
  settings.output = {};
  settings.film = {};
  settings.plot = {};
  return settings;
}

} // namespace

bool KeptSession::lacks(const Settings& now) const
{
  if (!kept_)
    return false;
  // Other data are no change of the session, unless they were added to its own.
  const auto& files = now.data.files;
  for (const std::string& file : kept_->data.files)
    if (std::find(files.begin(), files.end(), file) == files.end())
      return false;
  return choicesOf(*kept_) != choicesOf(now);
}

} // namespace mote::app
