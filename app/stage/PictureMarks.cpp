#include "PictureMarks.h"

#include "Measure.h"
#include "PickedPlaces.h"
#include "base/Text.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkMoteImageMarks.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr double veilInk[3] = {1.0, 0.16, 0.86}; // those of the window
constexpr double rulerInk[3] = {1.0, 0.95, 0.3}, rulerEdge[3] = {0.09, 0.10, 0.12};
constexpr double larger = 1.04, before = 0.4, leastPixels = 5.0;
constexpr double usualHeight = 860.0; // pixels, of the window's view

} // namespace

PictureMarks::PictureMarks(vtkCamera* camera, const std::array<int, 2>& size, vtkMoteImageMarks* to)
  : to_(to)
  , size_(size)
  , isParallel_(camera->GetParallelProjection() != 0)
  , half_(isParallel_ ? camera->GetParallelScale()
                      : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())))
  , scale_(std::max(0.6, size[1] / usualHeight))
{
  camera->GetPosition(position_.data());
  camera->GetDirectionOfProjection(forward_.data());
  camera->GetViewUp(up_.data());
  vtkMath::Cross(forward_.data(), up_.data(), right_.data());
  vtkMath::Normalize(right_.data());
  vtkMath::Cross(right_.data(), forward_.data(), up_.data());
  to->SetParallelProjection(isParallel_);
  to->RemoveAll();
}

/// To the right, upwards and away from the eye.
PictureMarks::Place PictureMarks::inEye(const Place& place) const
{
  double way[3];
  vtkMath::Subtract(place.data(), position_.data(), way);
  return {vtkMath::Dot(way, right_.data()), vtkMath::Dot(way, up_.data()),
    vtkMath::Dot(way, forward_.data())};
}

PictureMarks::Place PictureMarks::inPicture(const Place& eye) const
{
  const double unit = 0.5 * size_[1] / (isParallel_ ? half_ : half_ * eye[2]);
  return {0.5 * size_[0] + eye[0] * unit, 0.5 * size_[1] + eye[1] * unit, eye[2]};
}

void PictureMarks::addLine(Place from, Place to, const double color[3], double width, bool onTop)
{
  Place a = this->inEye(from), b = this->inEye(to);
  if (!isParallel_)
  {
    // Nothing behind the eye is seen.
    const double nearest = 1e-6 * std::max(std::abs(a[2]), std::abs(b[2]));
    if (a[2] <= nearest && b[2] <= nearest)
      return;
    for (Place* end : {&a, &b})
      if ((*end)[2] < nearest)
      {
        const Place& other = end == &a ? b : a;
        const double t = (nearest - (*end)[2]) / (other[2] - (*end)[2]);
        for (std::size_t i = 0; i < 3; ++i)
          (*end)[i] += t * (other[i] - (*end)[i]);
      }
  }
  to_->AddLine(this->inPicture(a).data(), this->inPicture(b).data(), color, width * scale_, onTop);
}

void PictureMarks::addPicked(
  const PickedSet::Parts& parts, const PickedSet& picked, const std::vector<std::size_t>& shown)
{
  for (const PickedPlace& one : placesOf(parts, picked, shown))
  {
    if (one.isCell)
    {
      for (const auto& [from, to] : edgesOf(parts[one.part]->data(), one.id, one.placed))
        this->addLine(from, to, veilInk, 2.0, false);
      continue;
    }
    const Place eye = this->inEye(one.at);
    if (!isParallel_ && eye[2] <= 0.0)
      continue;
    const Place at = this->inPicture(eye);
    const double unit = 0.5 * size_[1] / (isParallel_ ? half_ : half_ * eye[2]);
    const double radius = std::max(larger * one.radius, leastPixels * scale_ / unit);
    // A bit before what it marks: as the window has it.
    const double middle[3] = {at[0], at[1], at[2] - before * radius};
    to_->AddBall(middle, radius * unit, radius, veilInk, 0.75);
  }
  const auto& items = picked.items();
  if (std::any_of(items.begin(), items.end(),
        [&](const Picked& one)
        { return std::find(shown.begin(), shown.end(), one.part) != shown.end(); }))
    this->addRuler(parts, picked);
}

void PictureMarks::addRuler(const PickedSet::Parts& parts, const PickedSet& picked)
{
  const auto measured = measure(parts, picked);
  if (!measured)
    return;
  const auto label = [&](const Place& place, const std::string& text, bool below)
  {
    const Place eye = this->inEye(place);
    if (isParallel_ || eye[2] > 0.0)
      to_->AddLabel(this->inPicture(eye).data(), text, rulerInk, below);
  };
  const auto ruler = [&](const Place& from, const Place& to)
  {
    this->addLine(from, to, rulerEdge, 5.0, true);
    this->addLine(from, to, rulerInk, 2.0, true);
  };
  for (const Distance& distance : measured->distances)
  {
    Place end = distance.from, middle = distance.from, begin = distance.to;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      end[axis] += distance.step[axis];
      middle[axis] += 0.5 * distance.step[axis];
      begin[axis] -= distance.step[axis];
    }
    ruler(distance.from, end);
    if (distance.isAcross)
      ruler(begin, distance.to);
    label(middle, asNumber(distance.length, 5), false);
  }
  if (measured->angle)
    label(measured->distances[0].to, asNumber(*measured->angle, 4) + "\u00b0", true);
}

void PictureMarks::addPaths(vtkPolyData* lines)
{
  vtkDataArray* colors = lines->GetCellData()->GetScalars();
  vtkNew<vtkIdList> ends;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    lines->GetLines()->GetCellAtId(i, ends);
    Place from, to;
    lines->GetPoint(ends->GetId(0), from.data());
    lines->GetPoint(ends->GetId(1), to.data());
    double rgb[3];
    for (int c = 0; c < 3; ++c)
      rgb[c] = colors->GetComponent(i, c) / 255.0;
    this->addLine(from, to, rgb, 3.0, false);
  }
}

} // namespace mote::app
