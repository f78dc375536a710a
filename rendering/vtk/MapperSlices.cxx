#include "MapperSlices.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace mote
{

namespace
{

Vec3d vectorOf(const double* numbers)
{
  return {numbers[0], numbers[1], numbers[2]};
}

} // namespace

void MapperSlices::add(vtkMoteSlice* slice)
{
  if (!slice)
    return;
  slices_.emplace_back(slice);
  changedAt_.Modified();
}

void MapperSlices::clear()
{
  if (slices_.empty())
    return;
  slices_.clear();
  changedAt_.Modified();
}

void MapperSlices::addRange(double low, double high)
{
  ranges_.push_back({low, high});
  changedAt_.Modified();
}

void MapperSlices::clearRanges()
{
  if (ranges_.empty())
    return;
  ranges_.clear();
  changedAt_.Modified();
}

vtkMoteSlice* MapperSlices::slice(int number) const
{
  return number >= 0 && number < this->count() ? slices_[static_cast<std::size_t>(number)].Get()
                                               : nullptr;
}

std::vector<SliceShape> MapperSlices::shapes(const Mat4d& turn) const
{
  const Mat4d back = glm::inverse(turn);
  const auto point = [&](const double* p) { return Vec3d(back * Vec4d(vectorOf(p), 1.0)); };
  const auto way = [&](const double* p) { return Vec3d(back * Vec4d(vectorOf(p), 0.0)); };
  std::vector<SliceShape> shapes;
  for (const auto& slice : slices_)
  {
    SliceShape& shape = shapes.emplace_back();
    shape.kind = static_cast<SliceShape::Kind>(slice->GetShape()); // of the same order
    shape.point = point(slice->GetCenter());
    shape.axis = way(slice->GetAxis());
    shape.out = way(slice->GetOutwards());
    shape.radius = slice->GetRadius();
  }
  return shapes;
}

vtkMTimeType MapperSlices::time() const
{
  vtkMTimeType time = changedAt_.GetMTime();
  for (const auto& slice : slices_)
    time = std::max(time, slice->GetMTime());
  return time;
}

} // namespace mote
