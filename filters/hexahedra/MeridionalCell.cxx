#include "MeridionalCell.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// How far a cell reaches along the axis or away from it along each of its three directions, in
/// bins. Chords of circles count by how far they dip below them.
std::array<double, 3> reachOf(const CollapsedCell& cell, const Axis& axis, double size)
{
  static constexpr int edges[3][4][2] = {{{0, 1}, {3, 2}, {4, 5}, {7, 6}},
    {{0, 3}, {1, 2}, {4, 7}, {5, 6}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  std::array<double, 3> reach{};
  for (int k = 0; k < 3; ++k)
    for (const auto& [a, b] : edges[k])
    {
      const Vec3d &p = cell.corners[a], &q = cell.corners[b];
      const double dip = 0.5 * (axis.from(p) + axis.from(q)) - axis.from(0.5 * (p + q));
      reach[k] = std::max({reach[k], std::abs(axis.along(p) - axis.along(q)) / size,
        std::abs(axis.from(p) - axis.from(q)) / size, 2.0 * dip / size});
    }
  return reach;
}

void addSample(Bin& bin, const Sampled& from, const Axis& axis, const Vec3d& place,
  const Vec3d& value, double volume, bool isVector)
{
  bin.volume += volume;
  if (!isVector)
  {
    bin.sums[0] += volume * value.x;
    bin.sums[1] += volume * (value.x - from.middle) * (value.x - from.middle);
    return;
  }
  const Vec3d outwards = axis.outwards(place);
  const double radius = glm::length(outwards);
  const Vec3d radial = radius > 0.0 ? outwards / radius : Vec3d(0.0);
  bin.sums[0] += volume * glm::dot(value, axis.direction);
  bin.sums[1] += volume * glm::dot(value, radial);
  bin.sums[2] += volume * glm::dot(value, glm::cross(axis.direction, radial));
  bin.sums[3] += volume * glm::length(value);
}

/// The place of sample `i` of two in each of `n` pieces of a direction.
double gaussPlace(int i, int n)
{
  static const double low = 0.5 - 0.5 / std::sqrt(3.0);
  return (i / 2 + (i % 2 == 0 ? low : 1.0 - low)) / n;
}

/// Place and value at coordinates in the cell.
struct Sample
{
  Vec3d place{0.0}, value{0.0};
};

Sample sampleAt(const Sampled& from, const Vec3d& rst)
{
  Sample sample;
  const auto weights = trilinearWeights(rst);
  for (int c = 0; c < 8; ++c)
  {
    sample.place += weights[c] * from.cell.corners[c];
    sample.value += weights[c] * from.values[c];
  }
  return sample;
}

/// The Gauss rule with two samples a direction in every piece: exact for the volume as a whole.
void addPieces(std::vector<Bin>& bins, const BinGrid& grid, const Axis& axis, const Sampled& from,
  bool isVector, const std::array<int, 3>& pieces)
{
  const double share = from.side / (8.0 * pieces[0] * pieces[1] * pieces[2]);
  for (int k = 0; k < 2 * pieces[2]; ++k)
    for (int j = 0; j < 2 * pieces[1]; ++j)
      for (int i = 0; i < 2 * pieces[0]; ++i)
      {
        const Vec3d rst(
          gaussPlace(i, pieces[0]), gaussPlace(j, pieces[1]), gaussPlace(k, pieces[2]));
        const auto [place, value] = sampleAt(from, rst);
        if (const std::size_t bin = grid.at(axis.along(place), axis.from(place)); bin < bins.size())
          addSample(
            bins[bin], from, axis, place, value, share * jacobianAt(from.cell, rst), isVector);
      }
}

/// A line through a cell along one of its directions, on which places and values are linear and the
/// Jacobian is a quadratic function of the coordinate.
class CellLine
{
public:
  CellLine(const Sampled& from, Vec3d rst, int along)
  {
    std::array<double, 3> jacobians{};
    std::array<Sample, 2> ends;
    for (int i = 0; i < 3; ++i)
    {
      rst[along] = 0.5 * i;
      jacobians[i] = jacobianAt(from.cell, rst);
      if (i != 1)
        ends[i / 2] = sampleAt(from, rst);
    }
    begin_ = ends[0];
    step_ = {ends[1].place - ends[0].place, ends[1].value - ends[0].value};
    constant_ = jacobians[0];
    linear_ = 4.0 * jacobians[1] - 3.0 * jacobians[0] - jacobians[2];
    square_ = 2.0 * (jacobians[0] + jacobians[2]) - 4.0 * jacobians[1];
  }

  Sample at(double t) const
  {
    return {begin_.place + t * step_.place, begin_.value + t * step_.value};
  }
  double jacobian(double t) const { return constant_ + t * (linear_ + t * square_); }

  /// Where it crosses the edges of bins, in ascending order, with its ends.
  void cut(const BinGrid& grid, const Axis& axis, std::vector<double>& cuts) const
  {
    cuts.assign({0.0, 1.0});
    const auto add = [&](double t)
    {
      if (t > 0.0 && t < 1.0) // not for nan
        cuts.push_back(t);
    };
    const double height = axis.along(begin_.place), rise = glm::dot(step_.place, axis.direction);
    forEdges(grid.first, grid.axial, grid.size, grid.limits.axial, height, height + rise,
      [&](double edge) { add((edge - height) / rise); });

    // The square of the distance from the axis is c + 2 b t + a t^2.
    const Vec3d out = axis.outwards(begin_.place);
    const Vec3d way = step_.place - rise * axis.direction;
    const double a = glm::dot(way, way), b = glm::dot(out, way), c = glm::dot(out, out);
    const double nearest = a > 0.0 ? std::clamp(-b / a, 0.0, 1.0) : 0.0;
    const auto distance = [&](double t) { return glm::length(out + t * way); };
    forEdges(grid.inner, grid.radial, grid.size, grid.limits.radial, distance(nearest),
      std::max(distance(0.0), distance(1.0)),
      [&](double edge)
      {
        const double root = std::sqrt(b * b - a * (c - edge * edge));
        add((-b - root) / a);
        add((-b + root) / a);
      });
    std::sort(cuts.begin(), cuts.end());
  }

private:
  /// Calls `visit` for the edges of bins, and for the limits, between two places.
  template <typename Visit>
  static void forEdges(double first, int count, double size, const double limits[2], double from,
    double to, const Visit& visit)
  {
    if (from > to)
      std::swap(from, to);
    if (!std::isfinite(to - from))
      return;
    const auto index = [&](double place)
    { return static_cast<int>(std::clamp((place - first) / size, 0.0, double(count))); };
    for (int i = index(from); i <= index(to); ++i)
      visit(first + i * size);
    for (const double limit : {limits[0], limits[1]})
      if (limit > from && limit < to)
        visit(limit);
  }

  Sample begin_, step_;
  double constant_, linear_, square_;
};

/// Adds what a line brings, which stands for `share` of the cell's section: exactly, between the
/// edges of bins. `cuts` is room for them.
void addLine(std::vector<Bin>& bins, const BinGrid& grid, const Axis& axis, const Sampled& from,
  bool isVector, const CellLine& line, double share, std::vector<double>& cuts)
{
  line.cut(grid, axis, cuts);
  for (std::size_t k = 1; k < cuts.size(); ++k)
  {
    const double begin = cuts[k - 1], length = cuts[k] - begin;
    const Vec3d middle = line.at(begin + 0.5 * length).place;
    const std::size_t bin = grid.at(axis.along(middle), axis.from(middle));
    for (int s = 0; bin < bins.size() && length > 0.0 && s < 2; ++s)
    {
      const double t = begin + gaussPlace(s, 1) * length;
      const auto [place, value] = line.at(t);
      addSample(
        bins[bin], from, axis, place, value, 0.5 * length * share * line.jacobian(t), isVector);
    }
  }
}

/// As addPieces(), by lines along one direction. In a second one there are two of them between the
/// edges of bins, as the middle meets these, and in the third two in each piece. What lines bring
/// to a bin changes without jumps from one to the next, so that these are enough.
void addLines(std::vector<Bin>& bins, const BinGrid& grid, const Axis& axis, const Sampled& from,
  bool isVector, int along, int second, int pieces)
{
  const int third = 3 - along - second;
  std::vector<double> cuts, seconds;
  for (int j = 0; j < 2 * pieces; ++j)
  {
    Vec3d rst(0.5);
    rst[third] = gaussPlace(j, pieces);
    CellLine(from, rst, second).cut(grid, axis, seconds);
    for (std::size_t k = 1; k < seconds.size(); ++k)
      for (int s = 0; s < 2; ++s)
      {
        const double length = seconds[k] - seconds[k - 1];
        rst[second] = seconds[k - 1] + gaussPlace(s, 1) * length;
        if (length > 0.0)
          addLine(bins, grid, axis, from, isVector, CellLine(from, rst, along),
            from.side * length / (4.0 * pieces), cuts);
      }
  }
}

} // namespace

void addCell(
  std::vector<Bin>& bins, const BinGrid& grid, const Axis& axis, const Sampled& from, bool isVector)
{
  std::array<double, 3> reach = reachOf(from.cell, axis, grid.size);
  for (double& one : reach) // so that cells which differ by rounding are cut alike
    one = std::round(1e6 * std::min(one, 1e6)) / 1e6;
  const auto count = [](double pieces, double most)
  { return static_cast<int>(std::clamp(std::ceil(pieces), 1.0, most)); };
  // Three pieces for each bin, for fewer show as stripes where cells and bins are in step.
  std::array<int, 3> pieces{};
  std::transform(
    reach.begin(), reach.end(), pieces.begin(), [&](double one) { return count(3.0 * one, 4.0); });
  if (std::all_of(pieces.begin(), pieces.end(), [](int one) { return one < 4; }))
    return addPieces(bins, grid, axis, from, isVector, pieces);
  const int along = static_cast<int>(std::max_element(reach.begin(), reach.end()) - reach.begin());
  const int a = (along + 1) % 3, b = (along + 2) % 3;
  const bool isFirst = reach[a] > reach[b];
  addLines(bins, grid, axis, from, isVector, along, isFirst ? a : b,
    count(2.0 * (isFirst ? reach[b] : reach[a]), 32.0));
}

} // namespace mote
