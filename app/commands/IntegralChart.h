#pragma once

#include "Chart.h"
#include "settings/Settings.h"
#include "stage/Input.h"

class vtkTable;

namespace mote::app
{

/// Whether the pressure is over the density, by the unit that the data name: that of a velocity
/// squared.
bool isKinematic(const std::vector<NamedData>& data, const std::string& pressure);

/// What the columns of a table of integrals are measured in, as far as the data name units.
class IntegralUnits
{
public:
  /// `velocity` and `pressure` are names of arrays, or empty.
  IntegralUnits(const std::vector<NamedData>& data, const std::string& velocity,
    const std::string& pressure, const Settings& settings);

  /// For pictures; empty where it is not known.
  std::string of(const std::string& column) const;
  const std::string& ofLength() const { return length_; }
  const std::string& ofTime() const { return time_; }

private:
  std::map<std::string, std::string> columns_;
  std::string length_, time_;
};

/// The table's curves over time, or over the places of its sections, as the settings say. Throws
/// Failure where it has none.
Chart integralChart(vtkTable* table, const IntegralUnits& units, const Settings& settings);

} // namespace mote::app
