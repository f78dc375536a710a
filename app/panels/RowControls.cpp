#include "RowControls.h"

#include "ControlPlaces.h"
#include "PanelWidgets.h"
#include "base/Text.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace mote::app
{

namespace
{

std::string joined(const Row& row, const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : row.commas ? "," : " ") + word;
  return text;
}

std::vector<std::string> split(const Row& row, const std::string& text)
{
  std::vector<std::string> words;
  if (row.shape != Shape::Many)
    return text.empty() ? words : std::vector<std::string>{text};
  const std::string between = row.commas ? ", " : " ";
  for (std::size_t from = text.find_first_not_of(between); from != std::string::npos;)
  {
    const std::size_t to = text.find_first_of(between, from);
    words.push_back(text.substr(from, to - from));
    from = text.find_first_not_of(between, to);
  }
  return words;
}

bool excludes(const Row& row, const Row& other)
{
  const auto names = [](const Row& a, const Row& b)
  { return std::find(a.excludes.begin(), a.excludes.end(), b.name) != a.excludes.end(); };
  return names(row, other) || names(other, row);
}

/// Whether there are any number of texts, each with a field of its own.
bool isList(const Row& row)
{
  return row.shape == Shape::Many && row.count == 0 && !row.commas;
}

/// Whether there is one colour, or none.
bool isOptionalColor(const Row& row)
{
  const std::vector<std::string> usual = row.get(Settings());
  return row.value == "COLOUR" && row.shape == Shape::One &&
         (usual.empty() || usual.front().empty());
}

/// Beyond this a slider as wide as the panel cannot be put on whole numbers.
constexpr double slidersReach = 300.0;

/// Whether a slider goes from one limit to the other.
bool hasSlider(const Row& row)
{
  return row.numeric && row.shape == Shape::One && std::isfinite(row.limits.least) &&
         std::isfinite(row.limits.most) && row.limits.most - row.limits.least <= slidersReach;
}

/// Gives the keys to a field, back to which they should go: its cursor stays where it was.
void giveKeysBack(ImGuiID field)
{
  if (!ImGui::GetInputTextState(field))
    return; // others were written in since
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGui::SetActiveID(field, context.CurrentWindow);
  context.ActiveIdIsJustActivated = false; // no key is lost
  ImGui::SetActiveIdUsingNavAndKeys();
  context.ActiveIdUsingKeyInputMask &= ~(ImU64(1) << ImGuiKey_Tab);
}

} // namespace

std::string labelOf(const Row& row)
{
  std::string label = row.name;
  std::string group = lowerCase(row.group);
  if (!group.empty() && group.back() == 's')
    group.pop_back();
  if (label.size() > group.size() + 1 && label.compare(0, group.size(), group) == 0 &&
      label[group.size()] == '-')
    label = label.substr(group.size() + 1);
  std::replace(label.begin(), label.end(), '-', ' ');
  return label;
}

std::string RowControls::keyOf(const Row& row)
{
  return row.name + "@" + std::to_string(ImGui::GetID("text"));
}

void RowControls::refuse(
  const Row& row, const Settings& before, const Settings& refused, const std::string& sentence)
{
  const std::vector<std::string> words = row.get(refused);
  const bool isAdded = isList(row) && words.size() > row.get(before).size();
  for (auto& [key, text] : texts_)
    if (!key.starts_with(row.name + "@"))
      continue;
    else
    {
      text.takesKeysBack = std::exchange(text.isEntered, false);
      if (key.ends_with("-new"))
        text.text = text.refused = isAdded ? words.back() : text.text;
      else if (key.find('-', row.name.size()) == std::string::npos)
      {
        text.text = text.refused = joined(row, words);
        text.wrong = sentence;
      }
    }
}

void RowControls::forgetRefused()
{
  for (auto& [key, text] : texts_)
  {
    text.wrong.clear();
    text.refused.clear();
  }
}

namespace
{

/// The tooltip alone.
void tellOf(const Row& row)
{
  std::string text = row.help + ".\n\n" + row.option() + (row.value.empty() ? "" : " " + row.value);
  if (const std::string usual = row.usualText(); !usual.empty())
    text += "\nDefault: " + usual;
  explainKey(text.c_str());
}

} // namespace

void RowControls::explain(const Row& row)
{
  noteControl(row.name);
  if (ImGui::IsItemHovered())
    tellOf(row);
}

bool RowControls::draw(const Row& row, Settings& settings, const std::string& label)
{
  const std::string shown = label.empty() ? labelOf(row) : label;
  ImGui::PushID(row.name.c_str());
  bool isChanged;
  if (row.shape == Shape::Flag)
    isChanged = this->drawFlag(row, settings, shown);
  else
  {
    putLabel(shown);
    isChanged = isList(row)                                     ? this->drawList(row, settings)
                : !row.words.empty() && row.shape == Shape::One ? this->drawWords(row, settings)
                : isOptionalColor(row) ? this->drawOptionalColor(row, settings)
                : row.value == "COLOUR" && row.shape == Shape::One ? this->drawColor(row, settings)
                : hasSlider(row) && !row.get(settings).empty()     ? this->drawSlider(row, settings)
                                                                   : this->drawText(row, settings);
  }
  if (const std::string& wrong = texts_[keyOf(row)].wrong; !wrong.empty())
  {
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.5f, 0.4f, 1.0f));
    ImGui::TextWrapped("%s", wrong.c_str());
    ImGui::PopStyleColor();
  }
  ImGui::PopID();
  return isChanged;
}

bool RowControls::set(const Row& row, Settings& settings, const std::vector<std::string>& words)
{
  std::string& wrong = texts_[keyOf(row)].wrong;
  wrong.clear();
  const Settings before = settings;
  try
  {
    row.set(settings, words);
  }
  catch (const WrongValue& value)
  {
    wrong = value.sentence;
    return false;
  }
  // Of two that exclude each other the one that was chosen last is meant.
  for (const Row& other : settingsTable())
    if (excludes(row, other) && !other.isDefault(settings))
      other.set(settings, other.get(Settings()));
  return settings != before;
}

bool RowControls::drawFlag(const Row& row, Settings& settings, const std::string& label)
{
  const std::vector<std::string> words = row.get(settings);
  bool isOn = !words.empty() && words.front() == "true";
  const bool isClicked = ImGui::Checkbox(label.c_str(), &isOn);
  explain(row);
  return isClicked && this->set(row, settings, {isOn ? "true" : "false"});
}

bool RowControls::drawWords(const Row& row, Settings& settings)
{
  const std::vector<std::string> words = row.get(settings);
  const std::string now = words.empty() ? "" : words.front();
  bool isChanged = false;
  const bool isOpen = ImGui::BeginCombo("##", now.empty() ? "default" : now.c_str());
  explain(row);
  if (!isOpen)
    return false;
  // The default of rows that choose by themselves is a value of its own.
  const std::vector<std::string> usual = row.get(Settings());
  if (usual.empty() || usual.front().empty())
    if (ImGui::Selectable("default", now.empty()))
      isChanged = this->set(row, settings, usual);
  for (const std::string& word : row.words)
  {
    if (ImGui::Selectable(word.c_str(), word == now))
      isChanged = this->set(row, settings, {word});
    noteControl(word);
  }
  ImGui::EndCombo();
  return isChanged;
}

bool RowControls::drawColor(const Row& row, Settings& settings)
{
  Color color{};
  try
  {
    color = colorOf(row.get(settings).front());
  }
  catch (const WrongValue&)
  {
    return this->drawText(row, settings);
  }
  float rgb[3];
  std::copy(color.begin(), color.end(), rgb);
  const bool isChanged = ImGui::ColorEdit3("##swatch", rgb, ImGuiColorEditFlags_NoInputs);
  noteControl(row.name + " swatch");
  tellOf(row);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1.0f);
  const bool isWritten = this->drawText(row, settings); // a name, or #rrggbb
  if (!isChanged)
    return isWritten;
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = std::round(255.0 * rgb[k]) / 255.0;
  return this->set(row, settings, {colorText(color)});
}

/// A box to tick, and the colour behind it.
bool RowControls::drawOptionalColor(const Row& row, Settings& settings)
{
  const std::vector<std::string> words = row.get(settings);
  const bool wasOn = !words.empty() && !words.front().empty();
  bool isOn = wasOn;
  ImGui::Checkbox("##on", &isOn);
  noteControl(row.name + " on");
  tellOf(row);
  ImGui::SameLine();
  if (isOn != wasOn)
    return this->set(
      row, settings, isOn ? std::vector<std::string>{"#8c8c8c"} : row.get(Settings()));
  ImGui::SetNextItemWidth(-1.0f);
  if (isOn)
    return this->drawColor(row, settings);
  ImGui::TextDisabled("%s", row.usual.c_str());
  explain(row);
  return false;
}

/// The way back to the default, beside a slider.
bool RowControls::drawForget(const Row& row)
{
  ImGui::SameLine(0.0f, 0.0f);
  const bool isPressed = ImGui::Button("x", ImVec2(ImGui::GetFrameHeight(), 0.0f));
  noteControl("forget " + row.name);
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("Default: %s", row.usualText().c_str());
  return isPressed;
}

bool RowControls::drawSlider(const Row& row, Settings& settings)
{
  const std::string text = row.get(settings).front();
  auto value = static_cast<float>(std::strtod(text.c_str(), nullptr));
  const auto least = static_cast<float>(row.limits.least),
             most = static_cast<float>(row.limits.most);
  const bool isOptional = row.get(Settings()).empty();
  if (isOptional)
    ImGui::SetNextItemWidth(-ImGui::GetFrameHeight());
  // Digits behind the point are those that a logarithmic slider begins with.
  const std::string shown = row.inDecades ? "%.2f" : text;
  const bool isChanged = ImGui::SliderFloat("##", &value, least, most, shown.c_str(),
    ImGuiSliderFlags_AlwaysClamp | (row.inDecades ? ImGuiSliderFlags_Logarithmic : 0));
  explain(row);
  if (isOptional && this->drawForget(row))
    return this->set(row, settings, {});
  if (!isChanged)
    return false;
  // As many digits as the slider has steps to tell apart; whole numbers where others are wrong.
  char rounded[32];
  std::snprintf(rounded, sizeof rounded, "%.*g", 3, static_cast<double>(value));
  Settings trial = settings;
  try
  {
    row.set(trial, {rounded});
  }
  catch (const WrongValue&)
  {
    std::snprintf(rounded, sizeof rounded, "%.0f", static_cast<double>(value));
  }
  return this->set(row, settings, {rounded});
}

/// Values of a text that have a name, and those that the data have.
std::vector<std::string> RowControls::offersOf(const Row& row) const
{
  std::vector<std::string> offers = row.offers;
  if (const auto own = offered_.find(row.name); own != offered_.end())
    offers.insert(offers.end(), own->second.begin(), own->second.end());
  return offers;
}

/// A list beside a text; returns what was chosen.
std::string RowControls::drawOffers(const Row& row, const std::vector<std::string>& offers)
{
  ImGui::SameLine(0.0f, 0.0f);
  const bool isOpen =
    ImGui::BeginCombo("##offers", "", ImGuiComboFlags_NoPreview | ImGuiComboFlags_PopupAlignLeft);
  noteControl(row.name + "-offers");
  explainKey(
    ((row.offers.empty() ? "What the data have\n" : "Values that have a name\n") + row.option())
      .c_str());
  std::string chosen;
  if (!isOpen)
    return chosen;
  for (const std::string& offer : offers)
  {
    if (ImGui::Selectable(offer.c_str()))
      chosen = offer;
    noteControl(offer);
  }
  ImGui::EndCombo();
  return chosen;
}

/// A field for each text, and an empty one for one more.
bool RowControls::drawList(const Row& row, Settings& settings)
{
  std::vector<std::string> words = row.get(settings);
  bool isChanged = false;
  for (std::size_t i = 0; i <= words.size() && !isChanged; ++i)
  {
    const bool isNew = i == words.size();
    Text& text = texts_[keyOf(row) + "-" + (isNew ? "new" : std::to_string(i))];
    if (!text.isOpen && (!isNew || texts_[keyOf(row)].wrong.empty()))
      text.text = isNew ? "" : words[i];
    ImGui::PushID(static_cast<int>(i));
    if (i > 0)
      putLabel("");
    const bool isDone = drawField(row.value, text);
    if (isNew)
      explain(row);
    else
      tellOf(row);
    ImGui::PopID();
    if (!isDone || text.text == (isNew ? "" : words[i]))
    {
      tellWhole(text);
      continue;
    }
    if (isNew)
      words.push_back(text.text);
    else if (text.text.empty())
      words.erase(words.begin() + static_cast<long>(i));
    else
      words[i] = text.text;
    isChanged = this->take(row, settings, words, text);
    break;
  }
  return isChanged;
}

/// A field for a text, which is as wide as there is room; whether the user is done with it.
bool RowControls::drawField(const std::string& hint, Text& text)
{
  text.field = ImGui::GetID("##");
  if (std::exchange(text.takesKeysBack, false))
    giveKeysBack(text.field);
  const bool isEntered = ImGui::InputTextWithHint(
    "##", hint.c_str(), &text.text, textFlags | ImGuiInputTextFlags_EnterReturnsTrue);
  text.isOpen = ImGui::IsItemActive();
  text.width = ImGui::GetItemRectSize().x;
  const bool isLeft = ImGui::IsItemDeactivatedAfterEdit() && text.text != text.refused;
  if (!isEntered && !isLeft)
    return false;
  text.isEntered = isEntered;
  return true;
}

/// All of a text that is longer than its field, below it.
void RowControls::tellWhole(const Text& text)
{
  const float room = text.width - 2.0f * ImGui::GetStyle().FramePadding.x;
  if (text.isOpen || ImGui::CalcTextSize(text.text.c_str()).x <= room)
    return;
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", text.text.c_str());
  ImGui::PopStyleColor();
  noteControl("whole text");
}

/// Sets what was written. Where it cannot be and Return was pressed, the field keeps the keys:
/// those that come next would be the view's.
bool RowControls::take(
  const Row& row, Settings& settings, const std::vector<std::string>& words, Text& text)
{
  const bool isChanged = this->set(row, settings, words);
  const bool isRefused = !texts_[keyOf(row)].wrong.empty();
  text.refused = isRefused ? text.text : "";
  if (isRefused && text.isEntered)
    giveKeysBack(text.field);
  isEntered_ = isEntered_ || (isChanged && text.isEntered);
  return isChanged;
}

bool RowControls::drawText(const Row& row, Settings& settings)
{
  Text& text = texts_[keyOf(row)];
  const std::vector<std::string> words = row.get(settings);
  if (!text.isOpen && text.wrong.empty())
    text.text = joined(row, words);
  const std::string hint = row.usual.empty() ? row.usualText() : row.usual;
  const std::vector<std::string> offers = this->offersOf(row);
  if (!offers.empty())
    ImGui::SetNextItemWidth(-ImGui::GetFrameHeight());
  const bool isDone = drawField(hint, text);
  explain(row);
  if (!offers.empty())
    if (const std::string chosen = drawOffers(row, offers); !chosen.empty())
      return this->set(row, settings, {chosen});
  if (!isDone)
    return tellWhole(text), false;
  std::vector<std::string> next = split(row, text.text);
  if (next.empty())
    next = row.get(Settings()); // none: the default
  return next != words ? this->take(row, settings, next, text) : (text.wrong.clear(), false);
}

} // namespace mote::app
