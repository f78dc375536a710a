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
  bool isVideo = true;               ///< and no pictures, of which one a time step is enough
};

/// The settings of each frame, with its camera and its time step by number. Throws Failure where
/// nothing would move, and for steps that there are not.
std::vector<Settings> planFilm(const FilmScene& scene, const FilmSettings& film);

/// What is told of a film through such views of data of so many time steps before it is made.
struct FilmForecast
{
  std::string length; ///< "125 frames, 5 s"; or why there will be none
  std::string steps;  ///< that it stays at one time step of several; else empty
};
FilmForecast forecast(
  const std::vector<Settings>& keys, int steps, const FilmSettings& film, bool isVideo = true);

/// A sentence where all frames show one of several time steps; else empty.
std::string onlyStepOf(const std::vector<Settings>& frames, int steps);

/// The camera turned to the right about the upright axis of what is seen, by degrees: about the
/// middle of the bounds where it looks at about that, else about what it looks at.
std::vector<double> turned(
  const std::vector<double>& camera, const std::array<double, 6>& bounds, double degrees);

} // namespace mote::app
