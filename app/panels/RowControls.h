#pragma once

#include "table/Row.h"

#include <map>
#include <string>
#include <utility>
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

  /// The program found that a setting cannot be, when it tried: what was written stays in the
  /// field, with the sentence below.
  void refuse(
    const Row& row, const Settings& before, const Settings& refused, const std::string& sentence);

  /// What the data have for a row that takes any text: beside its field, to be chosen.
  void offer(const std::string& row, std::vector<std::string> values)
  {
    offered_[row] = std::move(values);
  }

  /// Whether settings were asked for by Return in a field since the last call.
  bool takeEntered() { return std::exchange(isEntered_, false); }

  /// What was refused leaves its fields, which say what is in force again.
  void forgetRefused();

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
  static bool drawForget(const Row& row);
  std::vector<std::string> offersOf(const Row& row) const;
  static std::string drawOffers(const Row& row, const std::vector<std::string>& offers);
  static std::string keyOf(const Row& row);
  bool set(const Row& row, Settings& settings, const std::vector<std::string>& words);

  struct Text;
  static bool drawField(const std::string& hint, Text& text);
  static void tellWhole(const Text& text);
  bool take(const Row& row, Settings& settings, const std::vector<std::string>& words, Text& text);

  struct Text
  {
    std::string text, wrong;
    std::string refused;        ///< that was written last and cannot be
    unsigned field = 0;         ///< ImGui's name of it
    float width = 0.0f;         ///< of its field
    bool isOpen = false;        ///< being written
    bool isEntered = false;     ///< by Return, the last time
    bool takesKeysBack = false; ///< in the next frame
  };
  bool isEntered_ = false;
  std::map<std::string, std::vector<std::string>> offered_; ///< by the row's name
  std::map<std::string, Text> texts_; ///< by the row's name and the control's place
};

/// A row's name as a label in its group: "light-size" in Light is "size".
std::string labelOf(const Row& row);

} // namespace mote::app
