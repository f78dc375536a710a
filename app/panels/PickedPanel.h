#pragma once

#include "OverTimePanel.h"
#include "stage/Measure.h"
#include "stage/PickedTable.h"
#include "stage/Stage.h"
#include "table/Keys.h"

#include <utility>
#include <vector>

namespace mote::app
{

/// What the panel tells of the picked, and lets the user choose about them.
struct PickedFacts
{
  const PickedSet* set = nullptr;
  bool* picksThrough = nullptr;             ///< rectangles take what others hide, too
  const ValuesOverTime* overTime = nullptr; ///< that are read, or were; null: none
  std::vector<double> times;                ///< of the steps
  int step = 0, steps = 1;                  ///< the one that is shown, from 0, of so many
};

/// The part of the panel that lists what is picked.
class PickedPanel
{
public:
  /// Returns what the user asked for; changes `next`, the settings to be. Values over time are
  /// first those of the array that colours.
  Action draw(
    const Stage& stage, const PickedFacts& facts, const std::string& coloredBy, Settings& next);

  /// Whether there is more picked than in the last frame.
  bool isNew(const PickedFacts& facts);

private:
  void drawTable(const Stage& stage, const PickedSet& set);
  static void drawHidden(Settings& next);
  static void drawMeasured(const Measured& measured);

  std::vector<std::pair<vtkDataSet*, unsigned long>> key_; ///< of the table's data
  unsigned long version_ = 0;                              ///< of its set
  PickedTable table_;
  std::vector<float> widths_; ///< of its columns, for letters of this size
  float fontSize_ = 0.0f;
  bool wasEmpty_ = true;
  OverTimePanel overTime_;
};

} // namespace mote::app
