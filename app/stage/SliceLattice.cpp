#include "SliceLattice.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

SliceLattice::SliceLattice(vtkMoteSlice* slice, const double bounds[6])
  : slice_(slice)
{
  slice->GetCenter(center_.data());
  slice->GetAxis(axis_.data());
  slice->GetOutwards(across_.data());
  vtkMath::Normalize(axis_.data());
  const double off = vtkMath::Dot(across_.data(), axis_.data());
  for (std::size_t k = 0; k < 3; ++k)
    across_[k] -= off * axis_[k];
  if (!(vtkMath::Normalize(across_.data()) > 0.0))
    vtkMath::Perpendiculars(axis_.data(), across_.data(), nullptr, 0.0);
  const bool isHalf = slice->GetShape() == vtkMoteSlice::HALF_PLANE;
  if (isHalf || this->isRound())
    along_ = axis_;
  else
    vtkMath::Cross(axis_.data(), across_.data(), along_.data());
  low_[0] = low_[1] = HUGE_VAL, high_[0] = high_[1] = -HUGE_VAL;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vec from{};
    for (int k = 0; k < 3; ++k)
      from[static_cast<std::size_t>(k)] =
        bounds[2 * k + (corner >> k & 1)] - center_[static_cast<std::size_t>(k)];
    const double at[2] = {
      vtkMath::Dot(from.data(), across_.data()), vtkMath::Dot(from.data(), along_.data())};
    for (int k = 0; k < 2; ++k)
      low_[k] = std::min(low_[k], at[k]), high_[k] = std::max(high_[k], at[k]);
  }
  if (isHalf)
    low_[0] = std::max(low_[0], 0.0), high_[0] = std::max(high_[0], 0.0);
  if (this->isRound())
    low_[0] = 0.0, high_[0] = 2.0 * vtkMath::Pi() * slice->GetRadius();
}

double SliceLattice::area() const
{
  return (high_[0] - low_[0]) * (high_[1] - low_[1]);
}

vtkSmartPointer<vtkPoints> SliceLattice::places(double areaOfEach) const
{
  auto places = vtkSmartPointer<vtkPoints>::New();
  places->SetDataTypeToDouble();
  // Triangles with sides as long as this; round, a whole number of them goes around.
  double side = std::sqrt(2.0 * areaOfEach / std::sqrt(3.0));
  const double width = high_[0] - low_[0], height = high_[1] - low_[1];
  if (!(areaOfEach > 0.0) || !(width > 0.0) || !(height > 0.0))
    return places;
  if (this->isRound())
    side = width / std::max(1.0, std::round(width / side));
  const double row = areaOfEach / side;
  const auto columns = static_cast<long>(std::ceil(width / side - 1e-9));
  const auto rows = static_cast<long>(std::ceil(height / row - 1e-9));
  // About the middle, so that what is left over is shared by both sides.
  const double first[2] = {low_[0] + 0.5 * (width - side * static_cast<double>(columns - 1)),
    low_[1] + 0.5 * (height - row * static_cast<double>(rows - 1))};
  for (long j = 0; j < rows; ++j)
    for (long i = 0; i < columns; ++i)
    {
      const double u = first[0] + side * (static_cast<double>(i) + (j % 2 == 0 ? -0.25 : 0.25));
      const double v = first[1] + row * static_cast<double>(j);
      Vec way = across_;
      double out = u;
      if (slice_->GetShape() == vtkMoteSlice::HALF_PLANE && out < 0.0)
        continue;
      if (this->isRound())
      {
        out = slice_->GetRadius();
        Vec side3{};
        vtkMath::Cross(axis_.data(), across_.data(), side3.data());
        for (std::size_t k = 0; k < 3; ++k)
          way[k] = std::cos(u / out) * across_[k] + std::sin(u / out) * side3[k];
      }
      Vec place{};
      for (std::size_t k = 0; k < 3; ++k)
        place[k] = center_[k] + out * way[k] + v * along_[k];
      places->InsertNextPoint(place.data());
    }
  return places;
}

std::array<double, 3> SliceLattice::normalAt(const Vec& place) const
{
  Vec normal = axis_;
  if (slice_->GetShape() == vtkMoteSlice::HALF_PLANE)
    vtkMath::Cross(axis_.data(), across_.data(), normal.data());
  if (!this->isRound())
    return normal;
  Vec from{};
  vtkMath::Subtract(place.data(), center_.data(), from.data());
  const double height = vtkMath::Dot(from.data(), axis_.data());
  for (std::size_t k = 0; k < 3; ++k)
    normal[k] = from[k] - height * axis_[k];
  vtkMath::Normalize(normal.data());
  return normal;
}

} // namespace mote::app
