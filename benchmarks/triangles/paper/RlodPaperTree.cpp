#include "RlodPaperTree.h"

#include <glm/geometric.hpp>

namespace mote::bench
{

std::size_t RlodPaperTree::bytes() const
{
  const auto bytesOf = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytesOf(arrays_.nodes) + bytesOf(arrays_.references) + bytesOf(arrays_.triangles) +
         bytesOf(arrays_.ids) + bytesOf(arrays_.planes) + bytesOf(arrays_.words);
}

std::vector<std::uint64_t> RlodPaperTree::lodSlots() const
{
  std::vector<std::uint64_t> slots(arrays_.planes.size());
  for (std::size_t k = 0; k < slots.size(); ++k)
    slots[k] = RlodTree::lodBit | k;
  return slots;
}

std::vector<std::uint64_t> RlodPaperTree::slotsBelow(std::uint64_t slot) const
{
  if (!isLod(slot))
    return {slot};
  std::vector<std::uint64_t> slots;
  std::vector<std::uint32_t> waiting = {planeNodes_[slot & ~RlodTree::lodBit]};
  while (!waiting.empty())
  {
    const RlodPaperNode node = arrays_.nodes[waiting.back()];
    waiting.pop_back();
    if (node.isLeaf())
      slots.insert(slots.end(), &arrays_.references[node.first()],
        &arrays_.references[node.first()] + node.value);
    else
      waiting.insert(waiting.end(), {node.first(), node.first() + 1});
  }
  return slots;
}

std::uint64_t RlodPaperTree::inputIndex(std::uint64_t slot) const
{
  return arrays_.ids[isLod(slot) ? plane(slot).triangle : slot];
}

std::array<Vec3f, 3> RlodPaperTree::localCorners(std::uint64_t slot) const
{
  return arrays_.triangles[isLod(slot) ? plane(slot).triangle : slot];
}

Vec3f RlodPaperTree::normal(std::uint64_t slot) const
{
  if (isLod(slot))
    return {plane(slot).normal[0], plane(slot).normal[1], plane(slot).normal[2]};
  const auto& [a, b, c] = arrays_.triangles[slot];
  return glm::cross(b - a, c - a);
}

void RlodPaperTree::normals(const std::uint64_t* slots, int count, float* const normals[3]) const
{
  for (int k = 0; k < count; ++k)
  {
    const Vec3f own = normal(slots[k]);
    for (int axis = 0; axis < 3; ++axis)
      normals[axis][k] = own[axis];
  }
}

void RlodPaperTree::inputIndices(
  const std::uint64_t* slots, int count, std::uint64_t* indices) const
{
  for (int k = 0; k < count; ++k)
    indices[k] = inputIndex(slots[k]);
}

float RlodPaperTree::error(std::uint64_t slot) const
{
  const std::uint32_t node = planeNodes_[slot & ~RlodTree::lodBit];
  return arrays_.levels.radius(arrays_.words[node] >> RlodWords::indexBits);
}

} // namespace mote::bench
