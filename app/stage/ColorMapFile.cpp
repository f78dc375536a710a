#include "ColorMapFile.h"

#include "base/Failure.h"
#include "base/Text.h"
#include "kernels/core/JsonDepth.h"
#include "settings/Colors.h"

#include <nlohmann/json.hpp>

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <utility>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uintmax_t mostBytes = 16 << 20;
/// VTK sorts them anew for each that comes.
constexpr std::size_t mostPoints = 4096;
constexpr int sampleCount = 256;

struct Named
{
  std::string file, map;
};

/// A file's name, and that of a map in it.
Named partsOf(const std::string& named)
{
  std::error_code error;
  const std::size_t colon = named.rfind(':');
  if (colon == named.npos || fs::exists(named, error) || !fs::exists(named.substr(0, colon), error))
    return {named, ""};
  return {named.substr(0, colon), named.substr(colon + 1)};
}

std::string contentOf(const std::string& file)
{
  std::error_code error;
  if (!fs::exists(file, error))
    throw Failure(file + ": there is no such file");
  if (!fs::is_regular_file(file, error))
    throw Failure(file + ": this is no file of a colour map");
  if (fs::file_size(file, error) > mostBytes)
    throw Failure(file + ": a colour map's file has 16 MB at most");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || (stream.peek() != EOF && !(text << stream.rdbuf())))
    throw Failure(file + ": the file cannot be read");
  return text.str();
}

/// Numbers of a list of JSON, all of them finite.
std::vector<double> numbersOf(const Json& list, const std::string& what)
{
  if (!list.is_array())
    throw Failure(what + " must be a list of numbers");
  std::vector<double> numbers;
  for (const Json& one : list)
  {
    if (!one.is_number() || !std::isfinite(one.get<double>()))
      throw Failure(what + " must be a list of numbers");
    numbers.push_back(one.get<double>());
  }
  return numbers;
}

Color shareColor(const double* rgb, const std::string& what)
{
  for (int k = 0; k < 3; ++k)
    if (!(rgb[k] >= 0.0 && rgb[k] <= 1.0))
      throw Failure(what + ": colours go from 0 to 1, and " + asNumber(rgb[k]) + " is outside");
  return {rgb[0], rgb[1], rgb[2]};
}

/// How colours are mixed between those of the file.
void setSpace(vtkColorTransferFunction* function, const std::string& space, const std::string& what)
{
  if (space == "RGB")
    function->SetColorSpaceToRGB();
  else if (space == "HSV")
    function->SetColorSpaceToHSV();
  else if (space == "Lab" || space == "CIELAB")
    function->SetColorSpaceToLab();
  else if (space == "CIEDE2000" || space == "Lab/CIEDE2000" || space == "LabCIEDE2000")
    function->SetColorSpaceToLabCIEDE2000();
  else if (space == "Diverging")
    function->SetColorSpaceToDiverging();
  else if (space == "Step")
    function->SetColorSpaceToStep();
  else
    throw Failure(what + ": no way of mixing colours is called \"" + oneLine(space) +
                  "\"; there are RGB, HSV, Lab, CIEDE2000, Diverging and Step");
}

/// Values with their colours, evenly sampled between the least and the greatest.
std::vector<Color> sampledColors(
  const std::vector<double>& points, const std::string& space, const std::string& what)
{
  if (points.size() % 4 != 0 || points.size() < 8 || points.size() > 4 * mostPoints)
    throw Failure(what + ": RGBPoints has a value, red, green and blue for each of 2 to " +
                  withThousands(mostPoints) + " points, not " +
                  counted(static_cast<std::int64_t>(points.size()), "number"));
  vtkNew<vtkColorTransferFunction> function;
  setSpace(function, space, what);
  double least = points[0], most = points[0];
  for (std::size_t i = 0; i < points.size(); i += 4)
  {
    const Color color = shareColor(&points[i + 1], what);
    function->AddRGBPoint(points[i], color[0], color[1], color[2]);
    least = std::min(least, points[i]);
    most = std::max(most, points[i]);
  }
  if (!(least < most) || !std::isfinite(most - least))
    throw Failure(what + ": all points of RGBPoints have one value");
  std::vector<double> table(std::size_t{3} * sampleCount);
  function->GetTable(least, most, sampleCount, table.data());
  std::vector<Color> colors;
  for (std::size_t i = 0; i < table.size(); i += 3)
    colors.push_back({std::clamp(table[i], 0.0, 1.0), std::clamp(table[i + 1], 0.0, 1.0),
      std::clamp(table[i + 2], 0.0, 1.0)});
  return colors;
}

std::string textOf(const Json& map, const char* name)
{
  const auto found = map.find(name);
  return found != map.end() && found->is_string() ? found->get<std::string>() : "";
}

ColorMapFile mapOf(const Json& map, const std::string& what)
{
  ColorMapFile file;
  if (const auto none = map.find("NanColor"); none != map.end())
    if (const auto rgb = numbersOf(*none, what + ": NanColor"); rgb.size() == 3)
      file.none = shareColor(rgb.data(), what);
  if (const auto points = map.find("RGBPoints"); points != map.end())
  {
    const std::string space = textOf(map, "ColorSpace");
    file.colors =
      sampledColors(numbersOf(*points, what + ": RGBPoints"), space.empty() ? "RGB" : space, what);
    return file;
  }
  const auto indexed = map.find("IndexedColors");
  if (indexed == map.end())
    throw Failure(what + ": this is no colour map: it has neither RGBPoints nor IndexedColors");
  const std::vector<double> rgb = numbersOf(*indexed, what + ": IndexedColors");
  if (rgb.size() % 3 != 0 || rgb.size() < 6)
    throw Failure(what + ": IndexedColors has red, green and blue for each of 2 colours or more");
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    file.colors.push_back(shareColor(&rgb[i], what));
  file.isStepped = true;
  return file;
}

ColorMapFile parsedMaps(const std::string& text, const Named& named)
{
  if (isDeepJson(text))
    throw Failure(named.file + ": this is no colour map: its lists lie in one another too deeply");
  Json json;
  try
  {
    json = Json::parse(text);
  }
  catch (const Json::exception&)
  {
    throw Failure(named.file + ": the file is no JSON, or is truncated");
  }
  if (!json.is_array())
    json = Json::array({std::move(json)});
  std::vector<std::string> names;
  for (const Json& map : json)
  {
    if (!map.is_object())
      continue;
    const std::string name = textOf(map, "Name");
    names.push_back(oneLine(name));
    if (named.map.empty() || name == named.map)
      return mapOf(map, named.file);
  }
  if (names.empty())
    throw Failure(named.file + ": there is no colour map in this file");
  throw Failure(
    named.file + " has no colour map " + oneLine(named.map) + "; there are " + joined(names, ", "));
}

/// Red, green and blue of a line; nothing where it has none.
std::vector<double> colorIn(const std::string& line, const std::string& place)
{
  std::istringstream words(line);
  std::vector<double> numbers;
  for (std::string word; words >> word;)
  {
    double number = 0.0;
    if (word.front() == '#')
      break; // a comment
    if (!parseNumber(word, number) || !(number >= 0.0 && number <= 255.0))
      throw Failure(place + ": " + oneLine(word) +
                    " is no share of a colour: they go from 0 to 1, or from 0 to 255");
    numbers.push_back(number);
  }
  // The fourth is how opaque a colour is.
  if (numbers.size() == 4 && (numbers[3] == 1.0 || numbers[3] == 255.0))
    numbers.pop_back();
  if (!numbers.empty() && numbers.size() != 3)
    throw Failure(place + ": a colour has red, green and blue, not " +
                  counted(static_cast<std::int64_t>(numbers.size()), "number"));
  return numbers;
}

ColorMapFile parsedLines(const std::string& text, const std::string& file)
{
  ColorMapFile map;
  std::vector<Color> hexadecimal;
  std::istringstream lines(text);
  double most = 0.0;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);)
  {
    ++number;
    std::replace_if(
      line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\0'; }, ' ');
    std::string word;
    std::istringstream(line) >> word;
    if (Color color; word.starts_with('#') && parseColor(word, color))
    {
      hexadecimal.push_back(color);
      continue;
    }
    const std::vector<double> rgb = colorIn(line, file + ", line " + std::to_string(number));
    if (rgb.empty())
      continue;
    map.colors.push_back({rgb[0], rgb[1], rgb[2]});
    most = std::max({most, rgb[0], rgb[1], rgb[2]});
  }
  if (!hexadecimal.empty() && !map.colors.empty())
    throw Failure(file + ": some colours are numbers, and others #rrggbb");
  if (map.colors.empty())
    map.colors = hexadecimal;
  if (map.colors.size() < 2)
    throw Failure(file + ": a colour map has two colours or more, a line each");
  if (most > 1.0)
    for (Color& color : map.colors)
      for (double& share : color)
        share /= 255.0;
  return map;
}

struct Kept
{
  fs::file_time_type time;
  std::shared_ptr<const ColorMapFile> map;
};

} // namespace

ColorMapFile parseColorMap(const std::string& text, const std::string& file, const std::string& map)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool isJson = first != text.npos && (text[first] == '[' || text[first] == '{');
  return isJson ? parsedMaps(text, {file, map}) : parsedLines(text, file);
}

ColorMapFile readColorMapFile(const std::string& named)
{
  const Named parts = partsOf(named);
  return parseColorMap(contentOf(parts.file), parts.file, parts.map);
}

std::shared_ptr<const ColorMapFile> keptColorMapFile(const std::string& named)
{
  static std::mutex mutex;
  static std::map<std::string, Kept> all;
  const std::lock_guard lock(mutex);
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(partsOf(named).file, error);
  Kept& kept = all[named];
  if (!kept.map || (!error && time != kept.time))
    kept = {time, std::make_shared<const ColorMapFile>(readColorMapFile(named))};
  return kept.map;
}

} // namespace mote::app
