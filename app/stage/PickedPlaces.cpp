#include "PickedPlaces.h"

#include "PlacedCell.h"

#include <ParticleModel.h>
#include <PeriodicImages.h>
#include <vtkCell.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkMoteParticleMapper.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace mote::app
{

namespace
{

constexpr std::size_t mostMarks = 10'000;

/// What is shown of a part's particles, and how large they are drawn.
struct Drawn
{
  std::vector<unsigned char> isShown;
  std::vector<Vec3d> images{Vec3d(0.0)};
  ParticleInput particles;
};

Drawn drawnOf(const Part& part)
{
  Drawn drawn;
  if (!part.particles())
    return drawn;
  drawn.isShown.resize(static_cast<std::size_t>(part.data()->GetNumberOfPoints()));
  part.particles()->GetModel().markVisible(drawn.isShown.data());
  drawn.particles = part.particles()->GetModel().particles();
  drawn.images =
    imageOffsets(part.particles()->GetReplication(), part.particles()->GetReplicationVectors());
  return drawn;
}

} // namespace

std::vector<CellEdge> edgesOf(vtkDataSet* data, vtkIdType number, vtkTransform* placed)
{
  vtkNew<vtkGenericCell> cell;
  data->GetCell(number, cell);
  std::vector<CellEdge> edges;
  for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
  {
    CellEdge edge;
    for (std::size_t i = 0; i < 2; ++i)
    {
      double* at = edge[i].data();
      cell->GetEdge(e)->GetPoints()->GetPoint(static_cast<vtkIdType>(i), at);
      placed->TransformPoint(at, at);
    }
    edges.push_back(edge);
  }
  return edges;
}

std::vector<PickedPlace> placesOf(
  const PickedSet::Parts& parts, const PickedSet& picked, const std::vector<std::size_t>& shown)
{
  std::vector<PickedPlace> found;
  std::vector<Drawn> drawn(parts.size());
  if (!picked.empty())
    std::transform(
      parts.begin(), parts.end(), drawn.begin(), [](const auto& part) { return drawnOf(*part); });
  const std::size_t every = (picked.items().size() + mostMarks - 1) / mostMarks;
  for (std::size_t i = 0; i < picked.items().size(); i += every)
  {
    const Picked& one = picked.items()[i];
    const auto k = static_cast<std::size_t>(one.part);
    const auto id = static_cast<std::size_t>(one.id);
    if (parts[k]->isHidden() || std::find(shown.begin(), shown.end(), k) == shown.end())
      continue;
    if (one.kind == Picked::Kind::Cell)
    {
      vtkUnsignedCharArray* isVisible = parts[k]->cells().mask();
      if (isVisible && isVisible->GetValue(one.id) == 0)
        continue;
      found.push_back({k, one.id, true,
        placedCell(*parts[k], one.id, picked.placeOf(parts, one)).placed, {}, 0.0});
      continue;
    }
    const bool isParticle = one.kind == Picked::Kind::Particle;
    if (isParticle && !drawn[k].isShown[id])
      continue;
    const ParticleInput& particles = drawn[k].particles;
    const double radius =
      isParticle ? double(particles.set.radiusOf(id)) * particles.enlargement : 0.0;
    const auto place = picked.placeOf(parts, one);
    for (const Vec3d& image : drawn[k].images)
      found.push_back({k, one.id, false, nullptr,
        {place[0] + image.x, place[1] + image.y, place[2] + image.z}, radius});
  }
  return found;
}

} // namespace mote::app
