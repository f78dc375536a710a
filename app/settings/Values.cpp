#include "Values.h"

#include "Colors.h"
#include "base/Text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <system_error>

namespace mote::app
{

namespace
{

/// The one word that a value with one takes.
const std::string& only(const std::vector<std::string>& words)
{
  if (words.size() != 1)
    throw WrongValue{"takes one value, not " + std::to_string(words.size())};
  return words.front();
}

bool isWhole(double value)
{
  return value == std::floor(value) && std::abs(value) <= 2147483647.0;
}

} // namespace

std::string Limits::text() const
{
  if (aboveZero)
    return std::isfinite(most) ? "above 0, up to " + asNumber(most) : "above 0";
  if (std::isfinite(least) && std::isfinite(most))
    return "from " + asNumber(least) + " to " + asNumber(most);
  return std::isfinite(least) ? "at least " + asNumber(least) : "";
}

double numberWithin(const std::string& text, const Limits& limits)
{
  double value = 0.0;
  if (!parseNumber(text, value))
    throw WrongValue{"'" + text + "' is no finite number"};
  if (limits.aboveZero && !(value > 0.0))
    throw WrongValue{"must be above zero, not " + text};
  if (value < limits.least || value > limits.most)
    throw WrongValue{"must be " + limits.text() + ", not " + text};
  return value;
}

int integerWithin(const std::string& text, const Limits& limits)
{
  const double value = numberWithin(text, limits);
  if (!isWhole(value))
    throw WrongValue{"must be a whole number, not " + text};
  return static_cast<int>(value);
}

Color colorOf(const std::string& text)
{
  Color color;
  if (!parseColor(text, color))
    throw WrongValue{"'" + text + "' is no colour: give a name (white, navy) or #rrggbb"};
  return color;
}

void requireWords(const std::vector<std::string>& words, const std::vector<std::string>& allowed,
  const std::string& usual)
{
  for (const std::string& word : words)
    if (word != usual && std::find(allowed.begin(), allowed.end(), word) == allowed.end())
      throw WrongValue{"'" + word + "' is none of " + joined(allowed, ", ")};
}

std::string exactText(double value)
{
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

std::string colorText(const Color& color)
{
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<int>(color[0] * 255.0 + 0.5),
    static_cast<int>(color[1] * 255.0 + 0.5), static_cast<int>(color[2] * 255.0 + 0.5));
  return text;
}

bool ValuesOf<bool>::parse(const std::vector<std::string>& words, const Limits&)
{
  const std::string& word = only(words);
  if (word != "true" && word != "false")
    throw WrongValue{"'" + word + "' is neither true nor false"};
  return word == "true";
}

std::string ValuesOf<std::string>::parse(const std::vector<std::string>& words, const Limits&)
{
  return only(words);
}

double ValuesOf<double>::parse(const std::vector<std::string>& words, const Limits& limits)
{
  return numberWithin(only(words), limits);
}

int ValuesOf<int>::parse(const std::vector<std::string>& words, const Limits& limits)
{
  return integerWithin(only(words), limits);
}

Color ValuesOf<Color>::parse(const std::vector<std::string>& words, const Limits&)
{
  return colorOf(only(words));
}

std::vector<std::string> ValuesOf<std::array<int, 2>>::words(const std::array<int, 2>& size)
{
  if (size[0] == 0)
    return {};
  return {std::to_string(size[0]) + "x" + std::to_string(size[1])};
}

std::array<int, 2> ValuesOf<std::array<int, 2>>::parse(
  const std::vector<std::string>& words, const Limits&)
{
  if (words.empty())
    return {0, 0};
  const std::string& text = only(words);
  const std::size_t sign = text.find_first_of("xX");
  double width = 0.0, height = 0.0;
  if (sign == std::string::npos || !parseNumber(text.substr(0, sign), width) ||
      !parseNumber(text.substr(sign + 1), height) || !isWhole(width) || !isWhole(height))
    throw WrongValue{"'" + text + "' is no size like 1920x1080"};
  if (std::min(width, height) < 1.0 || std::max(width, height) > 65536.0)
    throw WrongValue{"width and height may go from 1 to 65536 pixels, unlike " + text};
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::vector<std::string> ValuesOf<ShowRange>::words(const ShowRange& range)
{
  const auto end = [](double value) { return std::isinf(value) ? "" : exactText(value); };
  std::string text = range.name + "=";
  for (std::size_t i = 0; i < range.intervals.size(); ++i)
  {
    const auto [low, high] = range.intervals[i];
    text += (i > 0 ? "," : "") + (low == high ? exactText(low) : end(low) + ":" + end(high));
  }
  return {text};
}

namespace
{

/// "1:3", "5:", "7".
bool parseInterval(const std::string& text, Interval& interval)
{
  const std::size_t colon = text.find(':');
  const auto read = [](const std::string& number, double& value)
  { return number.empty() || parseNumber(number, value); };
  if (text.empty() || text == ":" || !read(text.substr(0, colon), interval.low))
    return false;
  if (colon != std::string::npos)
    return read(text.substr(colon + 1), interval.high);
  interval.high = interval.low;
  return true;
}

} // namespace

std::vector<std::string> ValuesOf<std::optional<std::vector<ShowRange>>>::words(
  const std::optional<std::vector<ShowRange>>& ranges)
{
  if (!ranges)
    return {};
  return ranges->empty() ? std::vector<std::string>{"none"}
                         : ValuesOf<std::vector<ShowRange>>::words(*ranges);
}

std::optional<std::vector<ShowRange>> ValuesOf<std::optional<std::vector<ShowRange>>>::parse(
  const std::vector<std::string>& words, const Limits& limits)
{
  if (words.empty())
    return std::nullopt;
  if (words.size() == 1 && words.front() == "none")
    return std::vector<ShowRange>();
  return ValuesOf<std::vector<ShowRange>>::parse(words, limits);
}

ShowRange ValuesOf<ShowRange>::parse(const std::vector<std::string>& words, const Limits&)
{
  const std::string& text = only(words);
  const WrongValue wrong{
    "'" + text + "' is not of the form NAME=LO:HI, such as x=0:10, x=5: or type=1,3:5"};
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0)
    throw wrong;
  ShowRange range = {text.substr(0, sign), {}};
  for (std::size_t begin = sign + 1; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    Interval interval = {-HUGE_VAL, HUGE_VAL};
    if (!parseInterval(text.substr(begin, end - begin), interval))
      throw wrong;
    if (interval.low > interval.high)
      throw WrongValue{"'" + text + "' is empty: LO must not be greater than HI"};
    range.intervals.push_back(interval);
    begin = end + 1;
  }
  std::sort(range.intervals.begin(), range.intervals.end(),
    [](const Interval& a, const Interval& b) { return a.low < b.low; });
  // Those that overlap become one.
  std::vector<Interval> apart;
  for (const Interval& interval : range.intervals)
    if (!apart.empty() && interval.low <= apart.back().high)
      apart.back().high = std::max(apart.back().high, interval.high);
    else
      apart.push_back(interval);
  range.intervals = apart;
  return range;
}

std::vector<std::string> ValuesOf<IdRanges>::words(const IdRanges& ranges)
{
  std::vector<std::string> words;
  for (const auto& [part, low, high] : ranges.list())
    words.push_back((part > 0 ? std::to_string(part) + "/" : "") + std::to_string(low) +
                    (high > low ? ":" + std::to_string(high) : ""));
  return words;
}

namespace
{

template <typename Number>
bool parseWhole(const std::string& text, Number& number)
{
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

IdRange parseIds(const std::string& text)
{
  IdRange range;
  const std::size_t slash = text.find('/');
  const bool hasPart = slash != std::string::npos;
  const std::string ids = hasPart ? text.substr(slash + 1) : text;
  const std::size_t colon = ids.find(':');
  if ((hasPart && !(parseWhole(text.substr(0, slash), range.part) && range.part > 0)) ||
      !parseWhole(ids.substr(0, colon), range.low) ||
      !parseWhole(colon == std::string::npos ? ids : ids.substr(colon + 1), range.high))
    throw WrongValue{"'" + text +
                     "' is neither an id nor a range of ids, such as 7 or 7:12, or "
                     "2/7:12 of the second data set alone"};
  if (range.low > range.high)
    throw WrongValue{"'" + text + "' is empty: the first id must not be greater than the last"};
  return range;
}

} // namespace

IdRanges ValuesOf<IdRanges>::parse(const std::vector<std::string>& words, const Limits&)
{
  std::vector<IdRange> ranges;
  for (const std::string& word : words)
    ranges.push_back(parseIds(word));
  return IdRanges(std::move(ranges));
}

std::vector<std::string> ValuesOf<Calculation>::words(const Calculation& calculation)
{
  return {calculation.name + "=" + calculation.expression};
}

Calculation ValuesOf<Calculation>::parse(const std::vector<std::string>& words, const Limits&)
{
  const std::string& text = only(words);
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
    throw WrongValue{
      "'" + text + "' is not of the form NAME=EXPRESSION, such as speed=sqrt(vx^2 + vy^2)"};
  return {text.substr(0, sign), text.substr(sign + 1)};
}

std::vector<std::string> ValuesOf<OpacityPoint>::words(const OpacityPoint& point)
{
  return {exactText(point.value) + (point.isShare ? "%=" : "=") + exactText(point.opacity)};
}

OpacityPoint ValuesOf<OpacityPoint>::parse(const std::vector<std::string>& words, const Limits&)
{
  const std::string& text = only(words);
  const std::size_t sign = text.find('=');
  OpacityPoint point;
  std::string value = text.substr(0, sign);
  if (value.ends_with('%'))
  {
    point.isShare = true;
    value.pop_back();
  }
  if (sign == std::string::npos || !parseNumber(value, point.value) ||
      !parseNumber(text.substr(sign + 1), point.opacity) || point.opacity < 0.0 ||
      point.opacity > 1.0)
    throw WrongValue{"'" + text +
                     "' is not of the form VALUE=OPACITY, such as 20=0.3 or 50%=0.1, "
                     "with an opacity from 0 to 1"};
  return point;
}

namespace
{

/// "1=0.5", with the text of each value.
template <typename T, typename TextOf>
std::vector<std::string> wordsOfTypes(const std::map<int, T>& values, const TextOf& textOf)
{
  std::vector<std::string> all;
  for (const auto& [type, value] : values)
    all.push_back(std::to_string(type) + "=" + textOf(value));
  return all;
}

/// The other way: `read` takes a text and gives the value, or throws WrongValue. `form` is what
/// words look like, for messages.
template <typename T, typename Read>
std::map<int, T> parseTypes(
  const std::vector<std::string>& words, const std::string& form, const Read& read)
{
  std::map<int, T> values;
  for (const std::string& word : words)
  {
    const std::size_t sign = word.find('=');
    int type = 0;
    const WrongValue wrong = {"'" + word + "' is not of the form TYPE=" + form};
    if (sign == std::string::npos || sign + 1 == word.size() ||
        !parseWhole(word.substr(0, sign), type))
      throw wrong;
    if (const std::optional<T> value = read(word.substr(sign + 1)))
      values[type] = *value;
    else
      throw wrong;
  }
  return values;
}

} // namespace

std::vector<std::string> ValuesOf<std::map<int, double>>::words(const std::map<int, double>& values)
{
  return wordsOfTypes(values, exactText);
}

std::map<int, double> ValuesOf<std::map<int, double>>::parse(
  const std::vector<std::string>& words, const Limits& limits)
{
  return parseTypes<double>(words, "RADIUS, such as 1=0.5",
    [&](const std::string& text)
    {
      double value = 0.0;
      const bool isRight = parseNumber(text, value) && (!limits.aboveZero || value > 0.0);
      return isRight ? std::optional(value) : std::nullopt;
    });
}

std::vector<std::string> ValuesOf<std::map<int, std::string>>::words(
  const std::map<int, std::string>& values)
{
  return wordsOfTypes(values, [](const std::string& name) { return name; });
}

std::map<int, std::string> ValuesOf<std::map<int, std::string>>::parse(
  const std::vector<std::string>& words, const Limits&)
{
  return parseTypes<std::string>(
    words, "NAME, such as 1=Cu", [](const std::string& name) { return std::optional(name); });
}

std::vector<std::string> ValuesOf<std::map<int, Color>>::words(const std::map<int, Color>& values)
{
  return wordsOfTypes(values, colorText);
}

std::map<int, Color> ValuesOf<std::map<int, Color>>::parse(
  const std::vector<std::string>& words, const Limits&)
{
  return parseTypes<Color>(words, "COLOUR, such as 1=red or 2=#3060c0",
    [](const std::string& text) { return std::optional(colorOf(text)); });
}

std::vector<std::string> ValuesOf<NamedView>::words(const NamedView& view)
{
  std::string text = view.name + "=" + (view.orthographic ? "parallel" : "");
  for (const double number : view.camera)
    text += (text.back() == '=' ? "" : ",") + exactText(number);
  return {text};
}

NamedView ValuesOf<NamedView>::parse(const std::vector<std::string>& words, const Limits&)
{
  const std::string& text = only(words);
  const WrongValue wrong = {"'" + text +
                            "' is not of the form NAME=X,Y,Z,FX,FY,FZ,UX,UY,UZ,A, with ten numbers "
                            "as --camera has them, behind 'parallel,' for a parallel projection"};
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0)
    throw wrong;
  NamedView view = {text.substr(0, sign), false, {}};
  for (std::size_t from = sign + 1; from <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', from), text.size());
    const std::string word = text.substr(from, end - from);
    double number = 0.0;
    if (from == sign + 1 && word == "parallel")
      view.orthographic = true;
    else if (parseNumber(word, number))
      view.camera.push_back(number);
    else
      throw wrong;
    from = end + 1;
  }
  if (view.camera.size() != 10)
    throw wrong;
  return view;
}

} // namespace mote::app
