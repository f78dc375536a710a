#pragma once

#include <string>

namespace mote::app
{

/// What a key of the window asks for. The table in Keys.cpp binds keys and words of help to these.
enum class Action
{
  None,
  Help,
  ResetView,
  ViewPlusX,
  ViewMinusX,
  ViewPlusY,
  ViewMinusY,
  ViewPlusZ,
  ViewMinusZ,
  Projection,
  ZoomIn,
  ZoomOut,
  NextArray,
  NextComponent,
  NextMap,
  Smaller,
  Larger,
  PreviousStep,
  NextStep,
  FirstStep,
  LastStep,
  Play,
  Pick,
  Center,
  Box,
  Legend,
  Axes,
  Background,
  Shadows,
  Shading,
  Silhouettes,
  Save,
  Escape,
  Quit
};

/// What an X11 key symbol, such as "bracketleft", is bound to.
Action actionOf(const std::string& keySymbol);

/// All keys with what they do, a line each; for the window and for --help.
std::string keysHelp();

} // namespace mote::app
