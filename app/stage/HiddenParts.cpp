#include "HiddenParts.h"

#include "base/Text.h"

#include <algorithm>

namespace mote::app
{

namespace
{

bool matches(std::string_view text, std::string_view pattern)
{
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos)
    return text == pattern;
  if (!text.starts_with(pattern.substr(0, star)))
    return false;
  // As little as possible for a star that others follow.
  text.remove_prefix(star);
  pattern.remove_prefix(star + 1);
  for (std::size_t next = pattern.find('*'); next != std::string_view::npos;
       next = pattern.find('*'))
  {
    const std::size_t at = text.find(pattern.substr(0, next));
    if (at == std::string_view::npos)
      return false;
    text.remove_prefix(at + next);
    pattern.remove_prefix(next + 1);
  }
  return text.ends_with(pattern);
}

bool isNamedByAny(const NamedData& one, const std::vector<std::string>& patterns)
{
  return std::any_of(patterns.begin(), patterns.end(),
    [&](const std::string& pattern) { return isNamed(one, pattern); });
}

bool isHidden(const NamedData& one, int number, const SelectionSettings& selection)
{
  if (isNamedByAny(one, selection.shownParts))
    return false;
  const std::vector<int>& numbers = selection.hiddenData;
  return one.isBoundary || isNamedByAny(one, selection.hiddenParts) ||
         std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

/// A name that no other data set has, where there is one.
std::string ownName(const std::vector<NamedData>& data, std::size_t index)
{
  const std::string& name = partName(data[index]);
  const auto count = std::count_if(
    data.begin(), data.end(), [&](const NamedData& other) { return isNamed(other, name); });
  return count > 1 ? data[index].name : name;
}

} // namespace

const std::string& partName(const NamedData& one)
{
  return one.block.empty() ? one.name : one.block;
}

bool isNamed(const NamedData& one, const std::string& pattern)
{
  const std::string& name = partName(one);
  const std::size_t slash = name.rfind('/');
  return matches(name, pattern) || matches(one.name, pattern) ||
         (slash != std::string::npos && matches(name.substr(slash + 1), pattern));
}

std::vector<bool> hiddenParts(
  const std::vector<NamedData>& data, const SelectionSettings& selection)
{
  std::vector<bool> hidden;
  for (const NamedData& one : data)
    hidden.push_back(isHidden(one, static_cast<int>(hidden.size()) + 1, selection));
  return hidden;
}

std::vector<NamedData> shownParts(
  const std::vector<NamedData>& data, const SelectionSettings& selection)
{
  const std::vector<bool> hidden = hiddenParts(data, selection);
  std::vector<NamedData> shown;
  for (std::size_t i = 0; i < data.size(); ++i)
    if (!hidden[i])
      shown.push_back(data[i]);
  return shown;
}

SelectionSettings withPart(const SelectionSettings& selection, const std::vector<NamedData>& data,
  std::size_t index, bool isShown)
{
  SelectionSettings next = selection;
  const int number = static_cast<int>(index) + 1;
  const std::string name = ownName(data, index);
  // Blocks by their names; files by their numbers, as several may be called the same.
  const bool isBlock = !data[index].block.empty();
  const auto isRight = [&] { return isHidden(data[index], number, next) != isShown; };
  std::erase(isShown ? next.hiddenParts : next.shownParts, name);
  if (isShown)
    std::erase(next.hiddenData, number);
  if (isRight())
    return next;
  std::vector<int>& numbers = next.hiddenData;
  if (!isShown && !isBlock && !isNamedByAny(data[index], next.shownParts))
    numbers.insert(std::upper_bound(numbers.begin(), numbers.end(), number), number);
  else
    (isShown ? next.shownParts : next.hiddenParts).push_back(name);
  if (isRight())
    return next;
  // A pattern shows it: those that it means are named one by one instead.
  std::vector<std::string> shown;
  for (const std::string& pattern : next.shownParts)
    if (!isNamed(data[index], pattern))
      shown.push_back(pattern);
  for (std::size_t i = 0; i < data.size(); ++i)
    if (i != index && isNamedByAny(data[i], next.shownParts) && !isNamedByAny(data[i], shown))
      shown.push_back(ownName(data, i));
  next.shownParts = shown;
  return next;
}

SelectionSettings withPartsOf(const SelectionSettings& parts, SelectionSettings other)
{
  other.hiddenData = parts.hiddenData;
  other.hiddenParts = parts.hiddenParts;
  other.shownParts = parts.shownParts;
  return other;
}

std::string hiddenBoundaries(const std::vector<NamedData>& data, const SelectionSettings& selection)
{
  if (!selection.hiddenParts.empty() || !selection.shownParts.empty())
    return "";
  std::vector<std::string> names;
  for (const NamedData& one : data)
    if (one.isBoundary)
      names.push_back(partName(one));
  if (names.empty())
    return "";
  constexpr std::size_t mostNames = 6;
  const std::size_t more = names.size() > mostNames ? names.size() - mostNames : 0;
  const std::string one = names.front();
  names.resize(names.size() - more);
  return joined(names, ", ") + (more > 0 ? " and " + std::to_string(more) + " more" : "") +
         " would hide the volume, and are not shown: --show-part '" + one +
         "' shows one, --show-part '*' all";
}

} // namespace mote::app
