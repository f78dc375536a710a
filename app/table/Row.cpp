#include "Table.h"

#include "base/Text.h"

#include <algorithm>

namespace mote::app
{

std::string Row::option() const
{
  const bool isOn = shape == Shape::Flag && get(Settings{}).front() == "true";
  return (isOn ? "--no-" : "--") + name;
}

bool Row::isDefault(const Settings& settings) const
{
  return get(settings) == get(Settings{});
}

void Row::goOn(Settings& settings, const Settings& asked) const
{
  if (next)
    return next(settings, asked);
  const std::string now = get(settings).front();
  if (shape == Shape::Flag)
    return set(settings, {now == "true" ? "false" : "true"});
  const std::vector<std::string>& all = words.empty() ? offers : words;
  if (all.empty())
    return;
  const auto found = std::find(all.begin(), all.end(), now);
  set(settings, {found == all.end() || found + 1 == all.end() ? all.front() : found[1]});
}

std::string Row::values() const
{
  std::vector<std::string> shown;
  std::copy_if(words.begin(), words.end(), std::back_inserter(shown),
    [](const std::string& word) { return !word.empty(); });
  return words.empty() ? limits.text() : joined(shown, ", ");
}

std::string Row::usualText(const Settings& settings) const
{
  if (shape == Shape::Flag)
    return {};
  return !usual.empty() ? usual : joined(get(settings), commas ? "," : " ");
}

std::function<void(const std::string&)> refusing(std::string (*check)(const std::string&))
{
  return [check](const std::string& text)
  {
    if (const std::string wrong = check(text); !wrong.empty())
      throw WrongValue{wrong};
  };
}

const std::vector<Row>& settingsTable()
{
  static const std::vector<Row> table = []
  {
    std::vector<Row> rows;
    for (const auto add : {addDataRows, addColorRows, addSelectionRows, addCutRows, addParticleRows,
           addVolumeRows, addSliceRows, addFlowRows, addCameraRows, addLightRows, addSilhouetteRows,
           addMarkRows, addPictureRows})
      add(rows);
    return rows;
  }();
  return table;
}

const Row* rowNamed(const std::string& name)
{
  const auto& table = settingsTable();
  const auto found =
    std::find_if(table.begin(), table.end(), [&](const Row& row) { return row.name == name; });
  return found == table.end() ? nullptr : &*found;
}

} // namespace mote::app
