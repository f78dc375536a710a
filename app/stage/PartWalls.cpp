// Walls of a volume's parts, which are not between those of one mesh.

#include "Part.h"

#include <vtkMoteMeshMapper.h>

namespace mote::app
{

void Part::setNeighbors(const std::vector<const Part*>& others)
{
  if (!walls_ || others == neighbors_)
    return;
  neighbors_ = others;
  walls_->RemoveAllNeighbors();
  for (const Part* other : others)
    walls_->AddNeighbor(other->walls_);
}

bool Part::isBlockWith(const Part& other) const
{
  return volume_ && other.volume_ && arrays_ == other.arrays_;
}

void joinWalls(const std::vector<std::unique_ptr<Part>>& parts)
{
  for (const auto& part : parts)
  {
    std::vector<const Part*> others;
    for (const auto& other : parts)
      if (other != part && other->isBlockWith(*part) && !other->isHidden())
        others.push_back(other.get());
    if (part->kind() == Part::Kind::Volume)
      part->setNeighbors(others);
  }
}

} // namespace mote::app
