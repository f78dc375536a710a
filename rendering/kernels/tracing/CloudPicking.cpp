#include "CloudPicking.h"

#include "../hexahedra/CellSampler.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mote
{

namespace
{

/// A piece of the ray within a cell, as if it looked the same all the way.
struct Piece
{
  const CloudObject* cloud = nullptr;
  std::uint32_t cell = 0;
  double tIn = 0.0, tOut = 0.0;
  double extinction = 0.0; ///< per world unit
  double value = 0.0;
};

/// Pieces of the ray in one cloud.
class Pieces
{
public:
  Pieces(const CloudObject& cloud, const HexRay& ray, std::vector<Piece>& all)
    : cloud_(cloud)
    , transfer_(cloud.transfer, cloud.field->offset())
    , sampler_(meshOf(cloud), *cloud.field)
    , ray_(ray)
    , all_(all)
  {
  }

  const TransferTable& transfer() const { return transfer_; }

  bool operator()(const CellSpan& span)
  {
    constexpr int perCell = 8;
    sampler_.enter(span.cell);
    const double length = (span.tOut - span.tIn) / perCell;
    for (int i = 0; i < perCell && length > 0.0; ++i)
    {
      Piece piece{&cloud_, span.cell, span.tIn + i * length, span.tIn + (i + 1) * length};
      const Vec3d middle = ray_.origin + 0.5 * (piece.tIn + piece.tOut) * ray_.direction;
      const double value = sampler_.isNaN() ? std::nan("") : sampler_.trilinear(middle);
      piece.extinction = (sampler_.isNaN() ? transfer_.ofNaN() : transfer_(value)).extinction;
      piece.value = value + cloud_.field->offset();
      if (piece.extinction > 0.0)
        all_.push_back(piece);
    }
    return true;
  }

private:
  const CloudObject& cloud_;
  TransferTable transfer_;
  CellSampler sampler_;
  const HexRay& ray_;
  std::vector<Piece>& all_;
};

} // namespace

std::optional<CloudPick> pickCloud(
  const Scene& scene, const Vec3d& origin, const Vec3d& direction, double tMin, double tMax)
{
  std::vector<Piece> pieces;
  for (const CloudObject& cloud : scene.clouds)
  {
    const Mat4d toLocal = glm::inverse(cloud.toWorld);
    const HexRay ray = {
      transformPoint(toLocal, origin), transformVector(toLocal, direction), tMin, tMax};
    Pieces add(cloud, ray, pieces);
    if (!cloud.structure)
    {
      for (const CellSpan& span :
        cloud.walk->views().runs(meshOf(cloud)).spansOf(meshOf(cloud), ray))
        add(span);
      continue;
    }
    withStructure(*cloud.structure,
      [&](const auto& s)
      {
        s.forCellsAlong(
          ray, [&](const CellSpan& span) { return add(span); },
          [&](const ScalarRange& range)
          { return add.transfer().isVisible(range.lower, range.upper); },
          NoCounts{});
      });
  }
  std::stable_sort(
    pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.tIn < b.tIn; });

  const double speed = glm::length(direction);
  double through = 1.0, best = 0.0;
  const Piece* found = nullptr;
  for (auto first = pieces.begin(); first != pieces.end();)
  {
    // The pieces of a cell count together; the one that keeps back most says where.
    double ofCell = 0.0, most = 0.0;
    const Piece* densest = nullptr;
    auto piece = first;
    for (; piece != pieces.end() && piece->cell == first->cell && piece->cloud == first->cloud;
         ++piece)
    {
      const double kept =
        through * -std::expm1(-piece->extinction * (piece->tOut - piece->tIn) * speed);
      through -= kept;
      ofCell += kept;
      if (kept > most)
        most = kept, densest = &*piece;
    }
    if (ofCell > best)
      best = ofCell, found = densest;
    first = piece;
  }
  if (!found)
    return std::nullopt;
  CloudPick pick;
  pick.object = found->cloud->id;
  pick.cell = meshOf(*found->cloud).inputCell(found->cell);
  pick.value = found->value;
  pick.t = 0.5 * (found->tIn + found->tOut);
  pick.position = origin + pick.t * direction;
  pick.opacity = 1.0 - through;
  return pick;
}

} // namespace mote
