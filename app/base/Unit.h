#pragma once

#include <map>
#include <optional>
#include <string>

namespace mote::app
{

/// A product of units with whole powers, such as m s^-1.
class Unit
{
public:
  /// The unit of numbers.
  Unit() = default;

  /// "m/s", "kg m^-1 s^-2", "kg/(m s2)", "Pa", "m³/s"; none for texts that are not understood.
  static std::optional<Unit> parse(const std::string& text);

  /// Of the units of the SI that are not base units: Pa, N, J, W, Hz in kg, m and s.
  Unit inBaseUnits() const;
  Unit toThe(int power) const;
  friend Unit operator*(const Unit& a, const Unit& b);
  friend Unit operator/(const Unit& a, const Unit& b) { return a * b.toThe(-1); }
  bool operator==(const Unit&) const = default;

  /// For pictures: "m²/s²", "Pa", "N m"; empty for numbers.
  std::string text() const;

private:
  std::map<std::string, int> powers_; ///< none is 0
};

/// A unit as the data name it, for pictures; the same text where it is not understood.
std::string unitText(const std::string& unit);

} // namespace mote::app
