#include "Opening.h"

#include "Session.h"
#include "base/Failure.h"

#include <algorithm>

namespace mote::app
{

Settings settingsToOpen(const Settings& now, const std::vector<std::string>& files, bool isAdded)
{
  const auto session = std::find_if(files.begin(), files.end(), isSessionFile);
  if (session != files.end())
  {
    if (files.size() > 1 || isAdded)
      throw Failure(*session + " is a session, which names its data files itself; open it alone");
    Settings all = readSession(*session);
    const std::array<int, 2> size = all.output.size;
    all.output = now.output;
    if (size[0] > 0)
      all.output.size = size;
    all.data.threads = now.data.threads;
    all.plot = now.plot;
    return all;
  }
  Settings next = now;
  next.keyFrames.clear(); // which are of the files that there were
  if (isAdded)
  {
    for (const std::string& file : files)
      if (std::find(next.data.files.begin(), next.data.files.end(), file) == next.data.files.end())
        next.data.files.push_back(file);
    // The steps of all files together are others.
    next.data.time.reset();
    next.data.step = "last";
    return next;
  }
  next.data = DataSettings();
  next.data.threads = now.data.threads;
  next.data.files = files;
  next.color = {};
  next.selection = {};
  next.cuts = {};
  next.particles = {};
  next.volume = {};
  next.flow = {};
  next.camera = {};
  next.views = {};
  next.camera.orthographic = now.camera.orthographic;
  next.light.occlusionReach.reset();
  next.silhouettes.groups.clear();
  next.marks = {};
  next.film.steps.clear();
  next.picture.title.reset();
  next.picture.caption.reset();
  return next;
}

} // namespace mote::app
