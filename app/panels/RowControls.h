#pragma once

#include "table/Row.h"

#include <map>
#include <string>
#include <vector>

namespace mote::app
{

/// Draws the control of any row of the table of settings: a box to tick, a list, a slider, a colour
/// or a text, as its values are. What cannot be is told below it, and the settings stay.
class RowControls
{
public:
  /// With the row's name, or another label. Returns whether the settings are others now.
  bool draw(const Row& row, Settings& settings, const std::string& label = {});

  /// The tooltip of the control that was drawn last: help, option and default.
  static void explain(const Row& row);

private:
  bool drawFlag(const Row& row, Settings& settings, const std::string& label);
  bool drawWords(const Row& row, Settings& settings);
  bool drawColor(const Row& row, Settings& settings);
  bool drawOptionalColor(const Row& row, Settings& settings);
  bool drawSlider(const Row& row, Settings& settings);
  bool drawList(const Row& row, Settings& settings);
  bool drawText(const Row& row, Settings& settings);
  std::string drawOffers(const Row& row);
  bool set(const Row& row, Settings& settings, const std::vector<std::string>& words);

  struct Text
  {
    std::string text, wrong;
    bool isOpen = false; ///< being written
  };
  std::map<std::string, Text> texts_; ///< by the row's name
};

/// A row's name as a label in its group: "light-size" in Light is "size".
std::string labelOf(const Row& row);

} // namespace mote::app
