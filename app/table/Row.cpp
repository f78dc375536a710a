#include "Table.h"

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

const std::vector<Row>& settingsTable()
{
  static const std::vector<Row> table = []
  {
    std::vector<Row> rows;
    for (const auto add : {addDataRows, addColorRows, addSelectionRows, addParticleRows,
           addVolumeRows, addCameraRows, addLightRows, addSilhouetteRows, addPictureRows})
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
