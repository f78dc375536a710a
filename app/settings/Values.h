#pragma once

#include "Settings.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace mote::app
{

/// Why words are no value, as a sentence without the option's name.
struct WrongValue
{
  std::string sentence;
};

/// Between which numbers a value may lie.
struct Limits
{
  double least = -HUGE_VAL, most = HUGE_VAL;
  bool aboveZero = false;

  /// "from 0 to 90", "above 0", or nothing.
  std::string text() const;
};

/// The text as a number within the limits. Throws WrongValue.
double numberWithin(const std::string& text, const Limits& limits);
int integerWithin(const std::string& text, const Limits& limits);
/// "#rrggbb" or a name as a colour. Throws WrongValue.
Color colorOf(const std::string& text);

/// Throws WrongValue where one of the words is neither one of those that are allowed nor `usual`.
void requireWords(const std::vector<std::string>& words, const std::vector<std::string>& allowed,
  const std::string& usual);

/// The shortest text that reads as the same number.
std::string exactText(double value);
/// A colour as "#rrggbb", or as three shares where bytes would not be exact.
std::string colorText(const Color& color);

/// How many values a choice has.
enum class Shape
{
  Flag, ///< on or off
  One,
  OptionalOne, ///< on the command line --name alone stands for "on"
  Many         ///< as many as Row::count says, or any number where that is 0
};

/// How a type is written in words. parse() of words() gives the same value, and parse() of no words
/// the one that stands for no choice.
template <typename T>
struct ValuesOf;

template <>
struct ValuesOf<bool>
{
  static constexpr Shape shape = Shape::Flag;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(bool value) { return {value ? "true" : "false"}; }
  static bool parse(const std::vector<std::string>& words, const Limits&);
};

template <>
struct ValuesOf<std::string>
{
  static constexpr Shape shape = Shape::One;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const std::string& value) { return {value}; }
  static std::string parse(const std::vector<std::string>& words, const Limits&);
};

template <>
struct ValuesOf<double>
{
  static constexpr Shape shape = Shape::One;
  static constexpr bool numeric = true;
  static std::vector<std::string> words(double value) { return {exactText(value)}; }
  static double parse(const std::vector<std::string>& words, const Limits& limits);
};

template <>
struct ValuesOf<int>
{
  static constexpr Shape shape = Shape::One;
  static constexpr bool numeric = true;
  static std::vector<std::string> words(int value) { return {std::to_string(value)}; }
  static int parse(const std::vector<std::string>& words, const Limits& limits);
};

template <>
struct ValuesOf<Color>
{
  static constexpr Shape shape = Shape::One;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const Color& value) { return {colorText(value)}; }
  static Color parse(const std::vector<std::string>& words, const Limits&);
};

/// "1920x1080"
template <>
struct ValuesOf<std::array<int, 2>>
{
  static constexpr Shape shape = Shape::One;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const std::array<int, 2>& size);
  static std::array<int, 2> parse(const std::vector<std::string>& words, const Limits&);
};

/// None, or one.
template <typename T>
struct ValuesOf<std::optional<T>>
{
  static constexpr Shape shape = ValuesOf<T>::shape;
  static constexpr bool numeric = ValuesOf<T>::numeric;
  static std::vector<std::string> words(const std::optional<T>& value)
  {
    return value ? ValuesOf<T>::words(*value) : std::vector<std::string>();
  }
  static std::optional<T> parse(const std::vector<std::string>& words, const Limits& limits)
  {
    return words.empty() ? std::nullopt : std::optional<T>(ValuesOf<T>::parse(words, limits));
  }
};

/// "c_pe=-3:-1", "type=2", "type=1,3:5"
template <>
struct ValuesOf<ShowRange>
{
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const ShowRange& range);
  static ShowRange parse(const std::vector<std::string>& words, const Limits&);
};

/// "7", "7:12"; "2/7:12" of the second data set alone
template <>
struct ValuesOf<IdRanges>
{
  static constexpr Shape shape = Shape::Many;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const IdRanges& ranges);
  static IdRanges parse(const std::vector<std::string>& words, const Limits&);
};

/// "speed=sqrt(vx^2 + vy^2)"
template <>
struct ValuesOf<Calculation>
{
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const Calculation& calculation);
  static Calculation parse(const std::vector<std::string>& words, const Limits&);
};

/// "12.5=0.3", "40%=0.3"
template <>
struct ValuesOf<OpacityPoint>
{
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const OpacityPoint& point);
  static OpacityPoint parse(const std::vector<std::string>& words, const Limits&);
};

/// "front=X,Y,Z,FX,FY,FZ,UX,UY,UZ,A"; "front=parallel,X,..." of a parallel projection
template <>
struct ValuesOf<NamedView>
{
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const NamedView& view);
  static NamedView parse(const std::vector<std::string>& words, const Limits&);
};

/// Any number, a word each.
template <typename T>
struct ValuesOf<std::vector<T>>
{
  static constexpr Shape shape = Shape::Many;
  static constexpr bool numeric = ValuesOf<T>::numeric;
  static std::vector<std::string> words(const std::vector<T>& values)
  {
    std::vector<std::string> all;
    for (const T& value : values)
      all.push_back(ValuesOf<T>::words(value).front());
    return all;
  }
  static std::vector<T> parse(const std::vector<std::string>& words, const Limits& limits)
  {
    std::vector<T> values;
    for (const std::string& word : words)
      values.push_back(ValuesOf<T>::parse({word}, limits));
    return values;
  }
};

/// Any number, or none where nothing is to be chosen: "none".
template <>
struct ValuesOf<std::optional<std::vector<ShowRange>>>
{
  static constexpr Shape shape = Shape::Many;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const std::optional<std::vector<ShowRange>>& ranges);
  static std::optional<std::vector<ShowRange>> parse(
    const std::vector<std::string>& words, const Limits& limits);
};

/// Any number, such as "1=0.5".
template <>
struct ValuesOf<std::map<int, double>>
{
  static constexpr Shape shape = Shape::Many;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const std::map<int, double>& values);
  static std::map<int, double> parse(const std::vector<std::string>& words, const Limits& limits);
};

/// Any number, such as "1=red".
template <>
struct ValuesOf<std::map<int, Color>>
{
  static constexpr Shape shape = Shape::Many;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const std::map<int, Color>& values);
  static std::map<int, Color> parse(const std::vector<std::string>& words, const Limits&);
};

/// Any number, such as "1=Cu".
template <>
struct ValuesOf<std::map<int, std::string>>
{
  static constexpr Shape shape = Shape::Many;
  static constexpr bool numeric = false;
  static std::vector<std::string> words(const std::map<int, std::string>& values);
  static std::map<int, std::string> parse(const std::vector<std::string>& words, const Limits&);
};

} // namespace mote::app
