#include "CGNSCheck.h"

#include "CGNSNode.h"
#include "FileError.h"

#include "vtk_cgns.h"

// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

using Count = std::int64_t;

/// Looks whether the sizes of nodes fit together.
class Check
{
public:
  explicit Check(const std::string& path)
    : path_(path)
  {
  }

  void root(const CGNSNode& root)
  {
    bool any = false;
    for (const CGNSNode& node : root.children)
      if (node.label == "CGNSBase_t")
      {
        any = true;
        this->base(node);
      }
    if (!any)
      this->fail(root, "there is no base in this file");
  }

private:
  [[noreturn]] void fail(const CGNSNode& node, const std::string& sentence) const
  {
    throw FileError(FileError::Kind::Malformed, path_,
      node.label.starts_with("Root Node") ? sentence : "in '" + node.name + "' " + sentence);
  }

  void requireSize(const CGNSNode& node, Count wanted) const
  {
    if (node.size() != wanted)
      this->fail(node, "there are " + std::to_string(node.size()) + " values, and " +
                         std::to_string(wanted) + " belong there");
  }

  void base(const CGNSNode& base)
  {
    if (base.values.size() != 2 || base.values[0] < 1 || base.values[0] > 3 ||
        base.values[1] < base.values[0] || base.values[1] > 3)
      this->fail(base, "the dimensions of cells and space are none");
    cellDimension_ = static_cast<std::size_t>(base.values[0]);
    spaceDimension_ = static_cast<std::size_t>(base.values[1]);
    steps_ = 0;
    if (const CGNSNode* steps = base.childLabelled("BaseIterativeData_t"))
      this->times(*steps);
    bool any = false;
    for (const CGNSNode& node : base.children)
      if (node.label == "Zone_t")
      {
        any = true;
        this->zone(node);
      }
    if (!any)
      this->fail(base, "there is no zone");
  }

  void times(const CGNSNode& node)
  {
    steps_ = node.values.size() == 1 ? node.values[0] : 0;
    if (steps_ < 1 || steps_ > 10'000'000)
      this->fail(node, "there is no number of time steps");
    for (const char* name : {"TimeValues", "IterationValues"})
      if (const CGNSNode* times = node.childNamed(name))
        this->requireSize(*times, steps_);
  }

  void zone(const CGNSNode& zone)
  {
    const CGNSNode* kind = zone.childLabelled("ZoneType_t");
    isStructured_ = kind && kind->type == "C1" && kind->size() == 10; // "Structured"
    const std::size_t along = isStructured_ ? cellDimension_ : 1;
    if (!kind || zone.values.size() != 3 * along)
      this->fail(zone, "there are no numbers of vertices and cells");
    vertices_ = cells_ = 1;
    for (std::size_t i = 0; i < along; ++i)
    {
      const Count vertices = zone.values[i], cells = zone.values[along + i];
      constexpr Count most = Count{1} << 31;
      if (vertices < 1 || cells < 0 || vertices > most || cells > most ||
          (isStructured_ && cells != vertices - 1) || vertices_ > (Count{1} << 40) / vertices)
        this->fail(zone, "there cannot be " + std::to_string(vertices) + " vertices and " +
                           std::to_string(cells) + " cells");
      vertices_ *= vertices;
      cells_ *= cells;
    }
    elements_ = counted_ = 0;
    polygons_.clear();
    for (const bool isOfFaces : {false, true}) // polyhedra name polygons
      for (const CGNSNode& node : zone.children)
        if (node.label == "Elements_t" &&
            isOfFaces == (!node.values.empty() && node.values[0] == CGNS_ENUMV(NFACE_n)))
          this->section(node);
    if (elements_ > counted_)
      this->fail(zone, "elements have numbers up to " + std::to_string(elements_) +
                         ", and there are " + std::to_string(counted_));
    if (!zone.childLabelled("GridCoordinates_t"))
      this->fail(zone, "there are no coordinates");
    for (const CGNSNode& node : zone.children)
      if (node.label == "GridCoordinates_t")
        this->coordinates(node);
      else if (node.label == "FlowSolution_t")
        this->solution(node);
      else if (node.label == "ZoneBC_t")
        this->conditions(node);
      else if (node.label == "ZoneIterativeData_t")
        this->pointers(node);
  }

  /// At least so many values in each array; exactly, where there is no rind.
  void arrays(const CGNSNode& node, Count wanted) const
  {
    const bool hasRind = node.childLabelled("Rind_t") != nullptr;
    for (const CGNSNode& array : node.children)
      if (array.label == "DataArray_t" &&
          (hasRind ? array.size() < wanted : array.size() != wanted))
        this->requireSize(array, wanted);
  }

  void rind(const CGNSNode& node) const
  {
    const CGNSNode* rind = node.childLabelled("Rind_t");
    if (!rind)
      return;
    const std::size_t wanted = isStructured_ ? 2 * cellDimension_ : 2;
    if (rind->values.size() != wanted ||
        std::any_of(rind->values.begin(), rind->values.end(),
          [](Count layers) { return layers < 0 || layers > 1000; }))
      this->fail(node, "the layers of rind are none");
  }

  void coordinates(const CGNSNode& node) const
  {
    this->rind(node);
    this->arrays(node, vertices_);
    const auto isNumbers = [](const CGNSNode& child)
    { return child.label == "DataArray_t" && (child.type == "R4" || child.type == "R8"); };
    const auto count = std::count_if(node.children.begin(), node.children.end(), isNumbers);
    if (count < static_cast<std::ptrdiff_t>(spaceDimension_))
      this->fail(node, "there are not as many coordinates as space has dimensions");
  }

  void solution(const CGNSNode& node) const
  {
    const CGNSNode* location = node.childLabelled("GridLocation_t");
    const bool isOfCells = location && location->size() == 10;  // "CellCenter"
    const bool isOfPoints = !location || location->size() == 6; // "Vertex"
    this->rind(node);
    if (isOfCells || isOfPoints)
      this->arrays(node, isOfCells ? cells_ : vertices_);
  }

  void pointers(const CGNSNode& node) const
  {
    for (const CGNSNode& array : node.children)
      if (array.label == "DataArray_t" && array.name.ends_with("Pointers"))
        this->requireSize(array, 32 * steps_);
  }

  void section(const CGNSNode& node)
  {
    const CGNSNode* range = node.childNamed("ElementRange");
    const CGNSNode* corners = node.childNamed("ElementConnectivity");
    if (node.values.size() != 2 || !range || range->values.size() != 2 || !corners)
      this->fail(node, "the type, the range or the corners of elements are missing");
    const Count type = node.values[0];
    const Count first = range->values[0], last = range->values[1];
    if (first < 1 || last < first || last > (Count{1} << 40) || type < CGNS_ENUMV(NODE) ||
        type >= NofValidElementTypes)
      this->fail(node, "the type or the range of elements is none");
    elements_ = std::max(elements_, last);
    counted_ += last - first + 1;
    if (type == CGNS_ENUMV(NGON_n))
      polygons_.emplace_back(first, last);
    const Count count = last - first + 1;
    int points = 0;
    if (type == CGNS_ENUMV(MIXED) || type == CGNS_ENUMV(NGON_n) || type == CGNS_ENUMV(NFACE_n))
      return this->lists(node, *corners, type, count);
    if (cg_npe(static_cast<CGNS_ENUMT(ElementType_t)>(type), &points) || points < 1)
      this->fail(node, "elements are of a type that is not read");
    this->requireSize(*corners, count * points);
  }

  /// Elements of several sizes, one after the other: with a list of where each begins, or, of
  /// polygons and polyhedra in files before version 4, with their sizes before them.
  void lists(const CGNSNode& node, const CGNSNode& corners, Count type, Count count) const
  {
    const CGNSNode* offsets = node.childNamed("ElementStartOffset");
    if (offsets && static_cast<Count>(offsets->values.size()) != count + 1)
      this->fail(node, "there is no whole list of where each element begins");
    const std::vector<Count>& values = corners.values;
    const auto total = static_cast<Count>(values.size());
    Count at = 0;
    for (Count i = 0; i < count; ++i)
    {
      if (at >= total || (offsets && offsets->values[i] != at))
        this->fail(node, "the places where elements begin do not fit their corners");
      const bool isSized = type == CGNS_ENUMV(MIXED) || !offsets;
      const Count size = type == CGNS_ENUMV(MIXED) ? this->cornersOf(node, values[at])
                         : offsets                 ? offsets->values[i + 1] - at
                                                   : values[at];
      at += isSized;
      if (size < 1 || size > total - at)
        this->fail(node, "the sizes of elements do not fit their corners");
      for (const Count end = at + size; at < end; ++at)
        if (type == CGNS_ENUMV(NFACE_n) ? !this->isFace(std::abs(values[at]))
                                        : values[at] < 1 || values[at] > vertices_)
          this->fail(node,
            "an element names the number " + std::to_string(values[at]) + ", which is not there");
    }
    if (at != total || (offsets && offsets->values[count] != at))
      this->fail(node, "there are more corners than elements have");
  }

  Count cornersOf(const CGNSNode& node, Count type) const
  {
    int points = 0;
    if (type <= CGNS_ENUMV(ElementTypeUserDefined) || type >= CGNS_ENUMV(MIXED) ||
        cg_npe(static_cast<CGNS_ENUMT(ElementType_t)>(type), &points))
      this->fail(node, "an element is of a type that is not read");
    return points;
  }

  bool isFace(Count number) const
  {
    return std::any_of(polygons_.begin(), polygons_.end(),
      [=](const std::pair<Count, Count>& range)
      { return number >= range.first && number <= range.second; });
  }

  void conditions(const CGNSNode& node) const
  {
    for (const CGNSNode& condition : node.children)
      if (condition.label == "BC_t")
        for (const CGNSNode& list : condition.children)
          if (list.label == "IndexRange_t" || list.label == "IndexArray_t" ||
              list.name == "ElementRange")
            this->places(condition, list);
  }

  void places(const CGNSNode& condition, const CGNSNode& list) const
  {
    const Count along = isStructured_ ? static_cast<Count>(cellDimension_) : 1;
    const bool isRange = list.label == "IndexRange_t";
    if (list.values.empty() || list.dimensions.front() != along ||
        (isRange && list.size() != 2 * along))
      this->fail(condition, "the places are none");
    if (isRange && !isStructured_ && list.values[0] > list.values[1])
      this->fail(condition, "the range of places ends before it begins");
    const Count most = isStructured_ ? Count{1} << 31 : std::max(elements_, vertices_);
    for (const Count value : list.values)
      if (value < 1 || value > most)
        this->fail(condition, "there is no place " + std::to_string(value));
  }

  std::string path_;
  std::size_t cellDimension_ = 3, spaceDimension_ = 3;
  Count steps_ = 0;
  bool isStructured_ = false;
  Count vertices_ = 0, cells_ = 0;
  Count elements_ = 0;                            ///< the greatest number of one
  Count counted_ = 0;                             ///< how many there are
  std::vector<std::pair<Count, Count>> polygons_; ///< their first and last numbers
};

} // namespace

void checkCGNSIsWhole(const std::string& path)
{
  Check(path).root(readCGNSNodes(path));
}

} // namespace mote
