#include "Film.h"

namespace mote
{

void Film::resize(int width, int height, unsigned channels)
{
  width_ = width;
  height_ = height;
  channels_ = channels;
  samples_ = 0;
  const std::size_t n = pixels();
  color_.resize(4 * n);
  depth_.resize(n);
  nearest_.clear();
  latest_.clear();
  id_.resize(has(Id) ? n : 0);
  object_.resize(has(Id) ? n : 0);
  latestId_.resize(has(LatestId) ? n : 0);
  latestObject_.resize(has(LatestId) ? n : 0);
  normal_.resize(has(Normal) ? 3 * n : 0);
  squares_.resize(has(Variance) ? n : 0);
}

void Film::splitNearestDepth()
{
  if (nearest_.empty())
    nearest_ = depth_;
}

void Film::splitLatestDepth()
{
  if (has(LatestDepth))
    latest_.resize(pixels());
}

std::size_t Film::bytes() const
{
  return (color_.capacity() + depth_.capacity() + nearest_.capacity() + latest_.capacity() +
           normal_.capacity() + squares_.capacity()) *
           sizeof(float) +
         (id_.capacity() + latestId_.capacity()) * sizeof(std::uint64_t) +
         (object_.capacity() + latestObject_.capacity()) * sizeof(std::int32_t);
}

} // namespace mote
