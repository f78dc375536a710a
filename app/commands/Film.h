#pragma once

#include "base/ProgressRelay.h"
#include "stage/Picture.h"
#include "stage/Stage.h"

#include <functional>
#include <string>
#include <vector>

namespace mote::app
{

/// What came of a film.
struct FilmResult
{
  int frames = 0; ///< that were written
  bool isStopped = false;
};

/// Throws Failure for a name that is neither a film's nor that of pictures with a number's place,
/// for one that cannot be written, and where what would write it is missing.
void checkFilmName(const std::string& file, const std::vector<std::string>& inputs);

/// "frames-%04d.png" as "frames-0012.png".
std::string frameName(const std::string& pattern, int frame);

/// Shows frames one after the other on the stage, which shows time step `step` of the input, and
/// writes them as the film that the settings of the first one name. What the user stops keeps the
/// frames that it has. Throws Failure. The stage is left at the last frame that it showed, whose
/// step `step` becomes.
FilmResult makeFilm(Stage& stage, Input& input, int& step, const std::vector<Settings>& frames,
  const std::string& file, const std::array<int, 2>& size, ProgressDisplay& display);

/// Lets the colours' range and types take in time steps, so that colours mean the same in all of a
/// film. The stage is left at the last of them.
void includeColors(
  Stage& stage, Input& input, const std::vector<int>& steps, ProgressRelay& progress);

/// The same of all time steps that frames show, where no range is asked for. Returns the step that
/// the stage shows then: `step` as before, or -1 where what is shown is to be read again.
int includeColorsOf(const std::vector<Settings>& frames, Stage& stage, Input& input, int step,
  ProgressRelay& progress);

} // namespace mote::app
