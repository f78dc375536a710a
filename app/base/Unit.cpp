#include "Unit.h"

#include <cctype>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace mote::app
{

namespace
{

using Powers = std::map<std::string, int>;

const std::vector<std::pair<std::string, Powers>>& namedUnits()
{
  static const std::vector<std::pair<std::string, Powers>> all = {
    {"Pa", {{"kg", 1}, {"m", -1}, {"s", -2}}},
    {"N", {{"kg", 1}, {"m", 1}, {"s", -2}}},
    {"J", {{"kg", 1}, {"m", 2}, {"s", -2}}},
    {"W", {{"kg", 1}, {"m", 2}, {"s", -3}}},
    {"Hz", {{"s", -1}}},
  };
  return all;
}

constexpr std::string_view raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

/// Reads a product of units. What is not understood leaves isRead() false.
class UnitReader
{
public:
  explicit UnitReader(std::string_view text)
    : text_(text)
  {
  }

  Powers read()
  {
    Powers powers;
    product(powers, 1, false);
    isRead_ = isRead_ && at_ == text_.size();
    return powers;
  }

  bool isRead() const { return isRead_; }

private:
  bool take(std::string_view word)
  {
    const bool isThere = text_.substr(at_).starts_with(word);
    at_ += isThere ? word.size() : 0;
    return isThere;
  }

  void product(Powers& powers, int sign, bool inBrackets)
  {
    int next = sign; // a slash is for the one unit behind it
    while (at_ < text_.size() && isRead_)
    {
      if (take(" ") || take("*") || take("·") || take("."))
        continue;
      if (take("/"))
        next = -sign;
      else if (take("("))
      {
        product(powers, next, true);
        isRead_ = isRead_ && take(")");
        next = sign;
      }
      else if (inBrackets && text_[at_] == ')')
        return;
      else
      {
        factor(powers, next);
        next = sign;
      }
    }
  }

  void factor(Powers& powers, int sign)
  {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (std::isalpha(static_cast<unsigned char>(text_[at_])) || text_[at_] == '%'))
      ++at_;
    const std::string name(text_.substr(begin, at_ - begin));
    if (name.empty() && !take("1"))
      isRead_ = false;
    else if (!name.empty())
      powers[name] += sign * power();
  }

  /// "^-2", "2", "-2", or raised digits; 1 where there is none.
  int power()
  {
    const bool isNamed = take("^") || take("**");
    int sign = 1, value = 0;
    bool isThere = false;
    if (take("-") || take("⁻"))
      sign = -1;
    else
      take("+");
    for (bool isDigit = true; isDigit && value < 100;)
    {
      isDigit = false;
      for (int digit = 0; digit < 10; ++digit)
        if (take(std::to_string(digit)) || take(raised[digit]))
        {
          value = 10 * value + digit;
          isDigit = isThere = true;
          break;
        }
    }
    isRead_ = isRead_ && (isThere || (!isNamed && sign > 0));
    return isThere ? sign * value : 1;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool isRead_ = true;
};

/// Units with their powers, "kg m²".
std::string productText(const Powers& powers, int sign, int& count)
{
  std::string text;
  for (const auto& [name, power] : powers)
  {
    if (power * sign <= 0)
      continue;
    ++count;
    text += (text.empty() ? "" : " ") + name;
    if (std::abs(power) > 1)
      for (const char digit : std::to_string(std::abs(power)))
        text += raised[digit - '0'];
  }
  return text;
}

} // namespace

std::optional<Unit> Unit::parse(const std::string& text)
{
  UnitReader reader(text);
  Unit unit;
  unit.powers_ = reader.read();
  std::erase_if(unit.powers_, [](const auto& one) { return one.second == 0; });
  return reader.isRead() && !text.empty() ? std::optional(unit) : std::nullopt;
}

Unit Unit::inBaseUnits() const
{
  Unit result;
  for (const auto& [name, power] : powers_)
  {
    Unit one;
    one.powers_[name] = 1;
    for (const auto& [named, powers] : namedUnits())
      if (named == name)
        one.powers_ = powers;
    result = result * one.toThe(power);
  }
  return result;
}

Unit Unit::toThe(int power) const
{
  Unit result;
  for (const auto& [name, own] : powers_)
    if (own * power != 0)
      result.powers_[name] = own * power;
  return result;
}

Unit operator*(const Unit& a, const Unit& b)
{
  Unit result = a;
  for (const auto& [name, power] : b.powers_)
    if ((result.powers_[name] += power) == 0)
      result.powers_.erase(name);
  return result;
}

std::string Unit::text() const
{
  const Unit base = inBaseUnits();
  for (const auto& [name, powers] : namedUnits())
  {
    if (powers_ == Powers{{name, 1}})
      return name;
    // What is made of others are torques rather than energies, and no frequencies.
    if (base.powers_ == powers && name != "Hz")
      return name == "J" ? "N m" : name;
  }
  int above = 0, below = 0;
  const std::string over = productText(powers_, 1, above);
  const std::string under = productText(powers_, -1, below);
  if (below == 0)
    return over;
  return (above == 0 ? "1" : over) + "/" + (below > 1 ? "(" + under + ")" : under);
}

std::string unitText(const std::string& unit)
{
  const std::optional<Unit> read = Unit::parse(unit);
  return read ? read->text() : unit;
}

} // namespace mote::app
