#pragma once

#include <string>
#include <vector>

namespace mote::app
{

/// What a key of the window asks for, besides turning a setting on or off.
enum class Action
{
  None,
  Help,
  ResetView,
  View, ///< from the side that the binding names
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
  Background,
  Shadows,
  Shading,
  Silhouettes,
  Projection,
  Toggle, ///< the setting that the binding names
  SavePicture,
  SaveSession,
  PrintCommand,
  PrintScript,
  Undo,
  Redo,
  Escape,
  Quit
};

/// A key and what it does.
struct Binding
{
  Action action = Action::None;
  std::vector<std::string> symbols; ///< as InteractorStyle::onKey has them
  std::string name;                 ///< a side to look from, or a row of settingsTable()
};

/// What a key symbol is bound to; None where to nothing.
const Binding& bindingOf(const std::string& keySymbol);

/// All keys with what they do, a line each; for the window and for --help.
std::string keysHelp();

} // namespace mote::app
