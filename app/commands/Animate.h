#pragma once

#include "stage/Stage.h"

#include <string>
#include <vector>

namespace mote::app
{

/// `mote animate`: a film of an orbit, of time steps, through key frames. Throws Failure and, where
/// the user stopped it, Interrupted; the film then has the frames that were made.
void animate(const Settings& given);

/// The frames of a film of what the stage shows, that begins at the first key, which has a camera,
/// and goes on to the others; as the stage's settings ask for. Throws Failure.
std::vector<Settings> framesOf(
  const Stage& stage, const Input& input, const std::vector<Settings>& keys);

/// "film.ogv: 640x480, 12 of 100 frames, 0.48 s at 25 frames a second".
std::string filmText(const std::string& file, const std::array<int, 2>& size, int written,
  std::size_t planned, int rate);

} // namespace mote::app
