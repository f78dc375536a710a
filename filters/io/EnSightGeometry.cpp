#include "EnSightGeometry.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

namespace mote
{

namespace
{

using Count = std::int64_t;

constexpr Count mostParts = 65536;

/// How many nodes an element has; 0 of polygons, -1 of polyhedra; none for other words.
std::optional<int> nodesOf(std::string type)
{
  static const std::map<std::string, int> known = {{"point", 1}, {"bar2", 2}, {"bar3", 3},
    {"tria3", 3}, {"tria6", 6}, {"quad4", 4}, {"quad8", 8}, {"tetra4", 4}, {"tetra10", 10},
    {"pyramid5", 5}, {"pyramid13", 13}, {"penta6", 6}, {"penta15", 15}, {"hexa8", 8},
    {"hexa20", 20}, {"nsided", 0}, {"nfaced", -1}};
  if (type.starts_with("g_"))
    type.erase(0, 2);
  const auto found = known.find(type);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

bool isStepBegin(const std::string& text)
{
  return text.starts_with("BEGIN TIME STEP");
}

/// Goes through geometry.
class Geometry
{
public:
  explicit Geometry(const std::string& path)
    : source_(path, formOfEnSight(path))
  {
  }

  std::vector<EnSightParts> steps()
  {
    std::vector<EnSightParts> all;
    std::string text = source_.requiredText("its head");
    if (text.starts_with("C Binary") || text.starts_with("Fortran Binary"))
      text = source_.requiredText("its head");
    const bool isWrapped = isStepBegin(text);
    while (true)
    {
      if (isWrapped && !isStepBegin(text))
        source_.fail("expected BEGIN TIME STEP, found '" + text + "'");
      if (isWrapped)
        source_.requiredText("its head");
      all.push_back(this->step(isWrapped));
      const std::optional<std::string> next = source_.text();
      if (!next)
        return all;
      text = *next;
    }
  }

private:
  bool hasIds(const std::string& kind)
  {
    const std::string text = source_.requiredText("its head");
    for (const char* word : {"given", "ignore", "off", "assign"})
      if (text.find(kind) != text.npos && text.find(word) != text.npos)
        return *word == 'g' || *word == 'i';
    source_.fail(
      "expected '" + kind + " id' with off, assign, given or ignore, found '" + text + "'");
  }

  EnSightParts step(bool isWrapped)
  {
    source_.passDescription(); // the second
    hasNodeIds_ = this->hasIds("node");
    hasElementIds_ = this->hasIds("element");
    EnSightParts parts;
    std::optional<std::string> text = source_.text();
    if (text == "extents")
    {
      this->extents();
      text = source_.text();
    }
    while (text && !(isWrapped && text->starts_with("END TIME STEP")))
    {
      if (*text != "part")
        source_.fail("expected a part, found '" + *text + "'");
      const Count number = source_.whole("the number of a part");
      if (number < 1 || number > mostParts || parts.contains(number))
        source_.fail("a part cannot have the number " + std::to_string(number));
      source_.requiredText("the name of a part");
      text = this->part(parts[number]);
    }
    if (isWrapped && !text)
      source_.fail("the last time step has no end");
    if (parts.empty())
      source_.fail("there is no part in this file");
    return parts;
  }

  /// Two a line, or six.
  void extents() { source_.numbers(source_.isLines() ? 3 : 6, "the extents"); }

  /// Reads a part; returns the text behind it.
  std::optional<std::string> part(EnSightPart& part)
  {
    std::optional<std::string> text = source_.text();
    if (text && text->starts_with("block"))
    {
      this->block(*text, part);
      return source_.text();
    }
    if (text == "coordinates")
    {
      part.nodes = this->count("nodes");
      if (hasNodeIds_)
        source_.wholes(part.nodes, 1, "the numbers of nodes");
      for (int axis = 0; axis < 3; ++axis)
        source_.numbers(part.nodes, "coordinates");
      text = source_.text();
    }
    while (text && nodesOf(*text))
    {
      if (part.elements.contains(*text))
        source_.fail("elements " + *text + " come twice in one part");
      this->elements(*text, part);
      text = source_.text();
    }
    return text;
  }

  Count count(const std::string& what)
  {
    const Count number = source_.whole("the number of " + what);
    if (number < 0)
      source_.fail("there cannot be " + std::to_string(number) + ' ' + what);
    return number;
  }

  void elements(const std::string& type, EnSightPart& part)
  {
    const int size = *nodesOf(type);
    const Count number = this->count("elements " + type);
    const auto checkNode = [&](Count node)
    {
      if (node < 1 || node > part.nodes)
        source_.fail("an element " + type + " names the node " + std::to_string(node) +
                     ", and the part has " + std::to_string(part.nodes));
    };
    part.elements[type] = number;
    if (hasElementIds_)
      source_.wholes(number, 1, "the numbers of elements");
    if (size > 0)
      return source_.wholes(number, size, "elements " + type, checkNode);
    std::vector<Count> sizes = this->sizes(number, type);
    if (size < 0)
    {
      Count faces = 0;
      for (const Count one : sizes)
        faces += one;
      sizes = this->sizes(faces, type);
    }
    for (const Count one : sizes)
      source_.wholes(1, one, "elements " + type, checkNode);
  }

  /// How many nodes polygons have, or faces polyhedra.
  std::vector<Count> sizes(Count number, const std::string& type)
  {
    std::vector<Count> all;
    source_.wholes(number, 1, "the sizes of elements " + type,
      [&](Count size)
      {
        if (size < 1 || size > 10'000)
          source_.fail("an element " + type + " cannot have the size " + std::to_string(size));
        all.push_back(size);
      });
    return all;
  }

  void block(const std::string& words, EnSightPart& part)
  {
    std::istringstream stream(words);
    std::string kind = "curvilinear";
    bool isBlanked = false, hasGhosts = false;
    for (std::string word; stream >> word;)
      if (word == "rectilinear" || word == "uniform" || word == "curvilinear")
        kind = word;
      else if (word == "iblanked")
        isBlanked = true;
      else if (word == "with_ghost")
        hasGhosts = true;
      else if (word != "block")
        source_.fail("blocks with '" + word + "' are not read");
    std::array<Count, 3> along{};
    std::size_t axis = 0;
    source_.wholes(1, 3, "the size of a block", [&](Count size) { along[axis++] = size; });
    part.isBlock = true;
    part.nodes = part.cells = 1;
    for (const Count size : along)
    {
      if (size < 1 || size > (Count{1} << 20))
        source_.fail("a block cannot have " + std::to_string(size) + " nodes along an axis");
      part.nodes *= size;
      part.cells *= std::max<Count>(1, size - 1);
    }
    if (kind == "curvilinear")
      for (int k = 0; k < 3; ++k)
        source_.numbers(part.nodes, "coordinates");
    else if (kind == "rectilinear")
      for (const Count size : along)
        source_.numbers(size, "coordinates");
    else
    {
      source_.numbers(3, "the origin of a block");
      source_.numbers(3, "the spacing of a block");
    }
    if (isBlanked)
      source_.wholes(part.nodes, 1, "the blanked nodes");
    if (hasGhosts)
    {
      source_.requiredText("ghost flags");
      source_.wholes(part.cells, 1, "ghost flags");
    }
    if (hasNodeIds_)
    {
      source_.requiredText("the numbers of nodes");
      source_.wholes(part.nodes, 1, "the numbers of nodes");
    }
    if (hasElementIds_)
    {
      source_.requiredText("the numbers of elements");
      source_.wholes(part.cells, 1, "the numbers of elements");
    }
  }

  EnSightSource source_;
  bool hasNodeIds_ = false;
  bool hasElementIds_ = false;
};

/// How many values stand under a heading of a part; none where that is none.
std::optional<Count> valuesUnder(
  const std::string& heading, const EnSightPart& part, bool isOfNodes)
{
  if (heading.starts_with("block") && part.isBlock)
    return isOfNodes ? part.nodes : part.cells;
  if (heading == "coordinates" && isOfNodes && !part.isBlock)
    return part.nodes;
  const auto found = part.elements.find(heading);
  return isOfNodes || found == part.elements.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

std::vector<EnSightParts> checkEnSightGeometry(const std::string& path)
{
  return Geometry(path).steps();
}

std::size_t checkEnSightValues(const std::string& path, EnSightForm form,
  const std::vector<EnSightParts>& steps, int components, bool isOfNodes)
{
  EnSightSource source(path, form);
  std::string description = source.requiredText("its head");
  const bool isWrapped = isStepBegin(description);
  for (std::size_t step = 0;; ++step)
  {
    const EnSightParts& parts = steps[std::min(step, steps.size() - 1)];
    if (isWrapped)
      source.requiredText("its head");
    std::optional<std::string> text = source.text();
    while (text && !(isWrapped && text->starts_with("END TIME STEP")))
    {
      if (*text != "part")
        source.fail("expected a part, found '" + *text + "'");
      const Count number = source.whole("the number of a part");
      const auto part = parts.find(number);
      if (part == parts.end())
        source.fail("the geometry has no part " + std::to_string(number));
      text = source.text();
      while (text && *text != "part" && !(isWrapped && text->starts_with("END TIME STEP")))
      {
        const auto count = valuesUnder(*text, part->second, isOfNodes);
        if (!count)
          source.fail(
            "part " + std::to_string(number) + " has no '" + *text + "' to have these values");
        for (int component = 0; component < components; ++component)
          source.numbers(*count, "values");
        text = source.text();
      }
    }
    const std::optional<std::string> next = isWrapped && text ? source.text() : std::nullopt;
    if (!next)
      return step + 1;
    if (!isStepBegin(*next))
      source.fail("expected BEGIN TIME STEP, found '" + *next + "'");
  }
}

} // namespace mote
