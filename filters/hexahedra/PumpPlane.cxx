#include "PumpPlane.h"

#include "PumpShape.h"

#include <algorithm>
#include <cmath>

namespace mote::pump
{

namespace
{

/// How strongly `count` steps are drawn to walls: a few have to fill the middle as well.
double strengthFor(double most, int count)
{
  return most * std::max(0.0, 1.0 - 2.0 / count);
}

std::vector<double> wallToWall(int count, double most)
{
  std::vector<double> values;
  for (int i = 0; i <= count; ++i)
    values.push_back(denseAtEnds(static_cast<double>(i) / count, strengthFor(most, count)));
  return values;
}

/// Stations before, along and behind blades, dense at their edges.
struct Stations
{
  std::vector<double> at;
  int bladeBegin, bladeEnd; ///< which of them are the edges

  Stations(double first, double begin, double end, double last, int count, int before, int behind)
    : bladeBegin(before)
    , bladeEnd(count - behind)
  {
    const auto share = [](int i, int n) { return static_cast<double>(i) / n; };
    for (int i = 0; i < before; ++i)
      at.push_back(
        std::lerp(begin, first, denseAtStart(share(before - i, before), strengthFor(1.5, before))));
    for (int i = 0; i < bladeEnd - bladeBegin; ++i)
      at.push_back(std::lerp(begin, end,
        denseAtEnds(share(i, bladeEnd - bladeBegin), strengthFor(1.5, bladeEnd - bladeBegin))));
    for (int i = 0; i <= behind; ++i)
      at.push_back(std::lerp(end, last, denseAtStart(share(i, behind), strengthFor(1.5, behind))));
  }
};

/// A sheet around the axis with slits for blades: at their stations a blade's two sides have
/// vertices of their own.
class BladedSheet
{
public:
  BladedSheet(Plane& plane, const Stations& stations, Region region, int passages, int pitch)
    : passages_(passages)
    , pitch_(pitch)
  {
    const std::vector<double> across = wallToWall(pitch, 2.6);
    for (int i = 0; i < static_cast<int>(stations.at.size()); ++i)
    {
      split_.push_back(i > stations.bladeBegin && i < stations.bladeEnd);
      starts_.push_back(static_cast<int>(plane.vertices.size()));
      for (int p = 0; p < passages; ++p)
        for (int j = 0; j < pitch + (split_[i] ? 1 : 0); ++j)
          plane.vertices.push_back({region, p, stations.at[i], across[j]});
    }
  }

  /// The vertex at a station; `j` counts through a passage, its end included.
  int vertex(int station, int passage, int j) const
  {
    if (split_[station])
      return starts_[station] + passage * (pitch_ + 1) + j;
    return starts_[station] + (passage * pitch_ + j) % (passages_ * pitch_);
  }

  /// The quadrilaterals; those of `turned` sheets go round the other way.
  void addQuads(Plane& plane, bool turned) const
  {
    for (int i = 0; i + 1 < static_cast<int>(starts_.size()); ++i)
      for (int p = 0; p < passages_; ++p)
        for (int j = 0; j < pitch_; ++j)
        {
          const int a = this->vertex(i, p, j), b = this->vertex(i + 1, p, j),
                    c = this->vertex(i + 1, p, j + 1), d = this->vertex(i, p, j + 1);
          if (turned)
            plane.quads.push_back({a, d, c, b});
          else
            plane.quads.push_back({a, b, c, d});
        }
  }

private:
  int passages_, pitch_;
  std::vector<bool> split_;
  std::vector<int> starts_; // of the stations
};

/// Adds the volute to the ring: rows of vertices outwards, the first of each on the ring.
void addVolute(Plane& plane, const DiffuserCounts& counts, const BladedSheet& ring, int lastStation)
{
  const int angles = (vaneCount - 1) * counts.pitch, rows = angles + counts.outlet();
  const int height = counts.volute();
  std::vector<int> before;
  for (int row = 0; row <= rows; ++row)
  {
    const bool straight = row > angles;
    const int passage = 1 + row / counts.pitch, j = row % counts.pitch;
    const int onRing = straight ? -1 : ring.vertex(lastStation, passage % vaneCount, j);
    const double across =
      straight
        ? outletLength * (row - angles) / counts.outlet()
        : ringPoint(ringEnd,
            denseAtEnds(static_cast<double>(j) / counts.pitch, strengthFor(2.6, counts.pitch)),
            passage, 0.0)
            .angle;
    std::vector<int> now;
    for (int k = 0; k <= height; ++k)
    {
      if (k == 0 && !straight)
      {
        now.push_back(onRing);
        continue;
      }
      now.push_back(static_cast<int>(plane.vertices.size()));
      // Dense at the outer wall; at the inner one there is none but in the outlet.
      const double out =
        1.0 - denseAtStart(1.0 - static_cast<double>(k) / height, strengthFor(1.6, height));
      plane.vertices.push_back({straight ? Region::Outlet : Region::Volute, 0, out, across});
    }
    for (int k = 0; row > 0 && k < height; ++k)
      plane.quads.push_back({before[k], before[k + 1], now[k + 1], now[k]});
    before = now;
  }
}

} // namespace

Plane inletPlane(const InletCounts& counts)
{
  Plane plane;
  const int n = counts.core, around = 4 * n;
  const auto add = [&](double x, double y) { plane.vertices.push_back({Region::Pipe, 0, x, y}); };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
    {
      const Point at = inletCore(2.0 * i / n - 1.0, 2.0 * j / n - 1.0);
      add(at.x, at.y);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i;
      plane.quads.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  // The square's rim, counter-clockwise from its lower left corner, is the first ring.
  std::vector<int> rim;
  for (int i = 0; i < n; ++i)
    rim.push_back(i);
  for (int j = 0; j < n; ++j)
    rim.push_back(j * (n + 1) + n);
  for (int i = n; i > 0; --i)
    rim.push_back(n * (n + 1) + i);
  for (int j = n; j > 0; --j)
    rim.push_back(j * (n + 1));
  std::vector<int> inner = rim;
  for (int k = 1; k <= counts.rings; ++k)
  {
    const double share = 1.0 - denseAtStart(1.0 - static_cast<double>(k) / counts.rings,
                                 strengthFor(1.8, counts.rings));
    std::vector<int> outer;
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * pi * i / around - 0.75 * pi;
      const PlaneVertex from = plane.vertices[rim[i]];
      outer.push_back(static_cast<int>(plane.vertices.size()));
      add(std::lerp(from.along, std::cos(angle), share),
        std::lerp(from.across, std::sin(angle), share));
    }
    for (int i = 0; i < around; ++i)
    {
      const int next = (i + 1) % around;
      plane.quads.push_back({inner[i], outer[i], outer[next], inner[next]});
    }
    inner = outer;
  }
  for (int k = 0; k <= counts.axial; ++k)
  {
    const double ahead = 1.0 - static_cast<double>(k) / counts.axial;
    plane.layers.push_back(-pipeLength * denseAtStart(ahead, 0.6));
  }
  return plane;
}

Plane rotorPlane(const RotorCounts& counts)
{
  const int before = std::max(2, static_cast<int>(std::lround(0.14 * counts.stream)));
  const int behind = std::max(2, static_cast<int>(std::lround(0.12 * counts.stream)));
  const Stations stations(0.0, bladeBegin, bladeEnd, 1.0, counts.stream, before, behind);
  Plane plane;
  const BladedSheet sheet(plane, stations, Region::Rotor, bladeCount, counts.pitch);
  sheet.addQuads(plane, true);
  plane.layers = wallToWall(counts.span, 2.4);
  return plane;
}

Plane diffuserPlane(const DiffuserCounts& counts)
{
  const int before = std::max(1, static_cast<int>(std::lround(0.14 * counts.radial)));
  const int behind = std::max(2, static_cast<int>(std::lround(0.2 * counts.radial)));
  const Stations stations(ringBegin, vaneBegin, vaneEnd, ringEnd, counts.radial, before, behind);
  Plane plane;
  const BladedSheet ring(plane, stations, Region::Ring, vaneCount, counts.pitch);
  ring.addQuads(plane, false);
  addVolute(plane, counts, ring, counts.radial);
  plane.layers = wallToWall(counts.span, 2.2);
  return plane;
}

} // namespace mote::pump
