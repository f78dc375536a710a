#pragma once

#include "base/Failure.h"
#include "base/ProgressRelay.h"
#include "base/Text.h"
#include "stage/Calculated.h"
#include "stage/HiddenParts.h"

#include <algorithm>

namespace mote::app
{

/// The files of a command, opened, with its progress on the terminal. Throws Failure and
/// Interrupted.
struct OpenedInput
{
  explicit OpenedInput(const Settings& asked)
    : settings(asked)
    , input(asked.data.files)
  {
    progress.add(terminal);
    input.open(progress);
    step = input.chosenStep(settings);
  }

  /// The data sets of the step that was asked for, without those that are hidden. Throws Failure
  /// where all are.
  std::vector<NamedData> read()
  {
    auto shown = shownParts(readAsAsked(input, step, settings, progress), settings.selection);
    if (shown.empty())
      throw Failure(input.name() + ": --hide-data and --hide-part leave nothing");
    return shown;
  }

  /// Calls with the number of each step that was asked for, which is then the one to read.
  template <class Visit>
  void forSteps(const Visit& visit)
  {
    if (!settings.output.allSteps)
      visit(step);
    else
      for (step = 0; step < std::max(1, input.numberOfSteps()); ++step)
        visit(step);
    step = std::min(step, std::max(1, input.numberOfSteps()) - 1);
  }

  /// The time of a step; its number from 1 where the data have no times.
  double timeOf(int which) const
  {
    const std::vector<double>& times = input.times();
    return times.empty() ? which + 1.0 : times[static_cast<std::size_t>(which)];
  }

  /// Of a chart, which shows its times itself where it has several.
  std::string chartCaption() const { return settings.output.allSteps ? input.name() : caption(); }

  /// "swirl.vtu, t = 0.05".
  std::string caption() const
  {
    const std::vector<double>& times = input.times();
    return input.name() + (times.empty() ? "" : ", t = " + asNumber(times[step], 10));
  }

  const Settings& settings;
  TerminalProgress terminal;
  ProgressRelay progress;
  Input input;
  int step = 0;
};

} // namespace mote::app
