#pragma once

#include "settings/Settings.h"

#include <array>
#include <string>
#include <vector>

namespace mote::app
{

/// What a film is planned of.
struct FilmScene
{
  std::vector<Settings> keys;        ///< at least one, each with a camera
  std::vector<int> keySteps;         ///< the time step of each, from 0
  int steps = 1;                     ///< of the data
  std::array<double, 6> bounds = {}; ///< of what is shown
  std::string name;                  ///< of the data, for sentences
};

/// The settings of each frame, with its camera and its time step by number. Throws Failure where
/// nothing would move, and for steps that there are not.
std::vector<Settings> planFilm(const FilmScene& scene, const FilmSettings& film);

/// The camera turned to the right about the upright axis of what is seen, by degrees: about the
/// middle of the bounds where it looks at about that, else about what it looks at.
std::vector<double> turned(
  const std::vector<double>& camera, const std::array<double, 6>& bounds, double degrees);

} // namespace mote::app
