#include "Turning.h"

#include "HiddenParts.h"
#include "base/Failure.h"

#include <vtkBoundingBox.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

bool readVector(vtkDataSet* data, const char* name, std::array<double, 3>& to)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != 1)
    return false;
  array->GetTuple(0, to.data());
  return true;
}

CutAxis axisOf(vtkDataSet* data, const Settings& settings)
{
  CutAxis axis = cutAxisOf(settings.cuts.axis);
  CutAxis own;
  if (settings.cuts.axis.empty() && readVector(data, "AxisOrigin", own.point) &&
      readVector(data, "AxisDirection", own.direction) &&
      vtkMath::Normalize(own.direction.data()) > 0.0)
    axis = own;
  return axis;
}

const ShowRange* askedOf(const NamedData& one, const Settings& settings)
{
  const auto& turns = settings.volume.turns;
  const auto found = std::find_if(
    turns.begin(), turns.end(), [&](const ShowRange& turn) { return isNamed(one, turn.name); });
  return found == turns.end() ? nullptr : &*found;
}

} // namespace

Turn turnOf(const NamedData& one, const Settings& settings)
{
  const ShowRange* asked = askedOf(one, settings);
  if (!asked)
    return {};
  if (one.file.starts_with("pump:") && partName(one).find("rotor") != std::string::npos)
    throw Failure("--turn: the rotor of the synthetic pump turns by itself");
  Turn turn;
  turn.axis = axisOf(one.data, settings);
  const double turns = asked->intervals.front().low / 60.0 * one.time.value_or(0.0);
  turn.degrees = 360.0 * (turns - std::floor(turns));
  return turn;
}

std::string idleTurns(const std::vector<NamedData>& data, const Settings& settings)
{
  for (const ShowRange& turn : settings.volume.turns)
  {
    bool isThere = false, hasTime = false;
    for (const NamedData& one : data)
      if (isNamed(one, turn.name))
      {
        isThere = true;
        hasTime = hasTime || one.time.has_value();
      }
    if (!isThere)
      return "--turn: there is no part '" + turn.name + "'";
    if (!hasTime)
      return "--turn: " + turn.name + " has no time, so it does not turn";
  }
  return {};
}

vtkSmartPointer<vtkTransform> transformOf(const Turn& turn)
{
  auto moved = vtkSmartPointer<vtkTransform>::New();
  const auto& [point, direction] = turn.axis;
  moved->Translate(point.data());
  moved->RotateWXYZ(turn.degrees, direction.data());
  moved->Translate(-point[0], -point[1], -point[2]);
  return moved;
}

void moveBounds(vtkTransform* moved, double bounds[6])
{
  if (bounds[0] > bounds[1])
    return;
  vtkBoundingBox all;
  for (int corner = 0; corner < 8; ++corner)
  {
    double p[3];
    for (int i = 0; i < 3; ++i)
      p[i] = bounds[2 * i + (corner >> i & 1)];
    all.AddPoint(moved->TransformDoublePoint(p));
  }
  all.GetBounds(bounds);
}

} // namespace mote::app
