#include "WalkCells.h"

#include "detail/Blocks.h"
#include "detail/CellFaces.h"

#include <cmath>

namespace mote
{

namespace
{

/// Faces that are this near to a plane count as plane: no more than
/// a few roundings.
constexpr double planeFace = 1e-6;

bool isWarped(const WalkCells& cells, const CellFace& face)
{
  Vec3d p[4];
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::uint32_t id = cells.mesh().cell(face.cell)[faceCorners[face.face][i]];
    p[i] = cells.toLocal(cells.mesh().point(id));
  }
  const Vec3d normal = glm::cross(p[2] - p[0], p[3] - p[1]);
  const double off = std::abs(glm::dot(normal, p[1] - p[0]));
  return off > planeFace * glm::length(normal);
}

} // namespace

WalkCells::WalkCells(std::shared_ptr<const HexMesh> mesh,
  std::shared_ptr<const FaceAdjacency> adjacency, const HexField& field,
  std::shared_ptr<WalkViews> views)
  : mesh_(std::move(mesh))
  , adjacency_(std::move(adjacency))
  , views_(views ? std::move(views) : std::make_shared<WalkViews>())
{
  const std::size_t cells = mesh_->cellCount();
  if (cells > 0)
  {
    center_ = mesh_->bounds().center();
    for (int k = 0; k < 3; ++k)
      if (const double size = mesh_->bounds().size()[k]; size > 0.0)
        size_[k] = size;
  }
  const bool ofCells = field.isOfCells();
  points_.resize(mesh_->allPointCount());
  forBlocks(points_.size(),
    [&](std::size_t i)
    {
      const Vec3f p(this->toLocal(mesh_->point(i)));
      points_[i] = {p.x, p.y, p.z, ofCells ? 0.0f : field.ofPoint(i)};
    });
  bends_.resize(cells);
  ofCells_.resize(ofCells ? cells : 0);
  forBlocks(cells,
    [&](std::size_t c)
    {
      if (ofCells)
      {
        ofCells_[c] = field.ofCell(c);
        bends_[c] = std::isnan(ofCells_[c]) ? INFINITY : 0.0f;
        return;
      }
      const CornerValues values = field.corners(mesh_->cell(c));
      double sum = 0.0;
      for (const double v : values)
        sum += v;
      bends_[c] =
        std::isnan(sum) ? INFINITY : static_cast<float>(bendOf(mesh_->corners(c), values));
    });
  for (const CellFace& face : adjacency_->boundary())
    if (isWarped(*this, face))
      bends_[face.cell] = -std::abs(bends_[face.cell]);
}

std::size_t WalkCells::bytes() const
{
  return adjacency_->bytes() + points_.capacity() * sizeof(Point) +
         (bends_.capacity() + ofCells_.capacity()) * sizeof(float);
}

} // namespace mote
