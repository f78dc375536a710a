#pragma once

#include <string>
#include <vector>

namespace mote::app
{

/// What a key of the window asks for.
enum class Action
{
  None,
  // Of the row of settingsTable() that the binding names:
  Next,     ///< the next value, or the other state
  NextPart, ///< the next component of an array
  More,
  Less,
  First,
  Last,
  Set, ///< the value that the binding names
  // Of the window:
  Help,
  HelpUp,
  HelpDown,
  Open,
  Panel,
  ResetView,
  ZoomIn,
  ZoomOut,
  Play,
  Pick,
  PickMore,
  HidePicked,
  OnlyPicked,
  ShowHidden,
  CopyPicked,
  SavePicked,
  SavePickedJson,
  SavePickedData, ///< for other programs
  PathsOfPicked,
  PlotOverTime, ///< values of the picked
  SaveOverTime,
  SavePlot, ///< as a picture
  SavePlotSvg,
  SaveCounts, ///< of the plot, as CSV
  Center,
  SavePicture,
  SaveFilm,
  SaveShown,       ///< as data for other programs
  RangeOfAllSteps, ///< of colours
  RangeOfView,
  AddKeyFrame,
  ForgetKeyFrame,
  ForgetKeyFrames,
  SaveSession,
  PrintCommand,
  PrintScript,
  Record,        ///< what is done, or no more
  PlayRecording, ///< or stop it
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
  std::string row = {};             ///< of settingsTable(), that the action changes
  std::string value = {};
};

/// What a key symbol is bound to; None where to nothing.
const Binding& bindingOf(const std::string& keySymbol);

/// All keys with what they do, a line each; for the window and for --help. What is longer than so
/// many letters goes on below.
std::string keysHelp(std::size_t columns = 1000);

/// The same as a page of the docs, with the options that keys change.
std::string keysMarkdown();

} // namespace mote::app
