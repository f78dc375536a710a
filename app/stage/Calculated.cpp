#include "Calculated.h"

#include "Ids.h"
#include "Part.h"
#include "base/Failure.h"
#include "base/Messages.h"

#include <vtkCellDataToPointData.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkMoteExpression.h>
#include <vtkMotePeriodicPositions.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>

namespace mote::app
{

const std::string whereArray = "--where";

namespace
{

/// Adds what --where says, to the cells of meshes.
std::string addWhere(vtkDataSet* data, const Calculation& wanted)
{
  return Part::isMesh(data)
           ? vtkMoteExpression::AddToCells(data, wanted.expression, wanted.name, VTK_UNSIGNED_CHAR)
           : vtkMoteExpression::AddTo(data, wanted.expression, wanted.name, VTK_UNSIGNED_CHAR);
}

std::string addCalculated(vtkDataSet* data, const Calculation& wanted)
{
  return vtkMoteExpression::AddTo(data, wanted.expression, wanted.name);
}

/// To all data sets that have anything.
void add(const std::vector<NamedData>& data, const std::string& option, const Calculation& wanted,
  std::string (*addTo)(vtkDataSet*, const Calculation&), KnownExpressions& known)
{
  std::string problem;
  bool isAdded = false;
  for (const NamedData& one : data)
  {
    if (one.data->GetNumberOfPoints() == 0)
      continue;
    const std::string wrong = addTo(one.data, wanted);
    isAdded = isAdded || wrong.empty();
    if (problem.empty() && !wrong.empty())
      problem = option + ": " + one.name + ": " + wrong;
  }
  const auto before = known.find(wanted.expression);
  if (isAdded && before == known.end())
    known[wanted.expression] = false;
  if (isAdded || problem.empty())
    return;
  if (before == known.end())
    throw Failure(problem);
  if (!before->second)
    Messages::warn(problem + "; this time step goes without");
  before->second = true;
}

/// The points of lines alone, with the values of the lines.
void dropLines(std::vector<NamedData>& data)
{
  for (NamedData& one : data)
    if (Part::isLines(one.data))
    {
      vtkNew<vtkPolyData> points;
      points->SetPoints(vtkPointSet::SafeDownCast(one.data)->GetPoints());
      vtkNew<vtkCellDataToPointData> values;
      values->SetInputData(one.data);
      values->Update();
      points->GetPointData()->ShallowCopy(values->GetOutput()->GetPointData());
      points->GetFieldData()->ShallowCopy(one.data->GetFieldData());
      one.data = points;
    }
}

/// Wraps particles into their box, or unwraps them.
void movePositions(const std::vector<NamedData>& data, const std::string& kind)
{
  const int mode =
    kind == "wrapped" ? vtkMotePeriodicPositions::WRAPPED : vtkMotePeriodicPositions::UNWRAPPED;
  for (const NamedData& one : data)
    if (auto* points = vtkPointSet::SafeDownCast(one.data);
        points && points->GetNumberOfPoints() > 0 && !Part::isMesh(points))
      if (const std::string problem = vtkMotePeriodicPositions::Move(points, mode);
          !problem.empty())
        throw Failure("--positions " + kind + ": " + one.name + ": " + problem);
}

} // namespace

std::vector<NamedData> withCalculated(
  const std::vector<NamedData>& data, const Settings& settings, KnownExpressions& known)
{
  const bool isMoved = settings.data.positions != "file";
  const bool hasLines = settings.data.lines == "tubes";
  if (settings.data.calculations.empty() && !isLimited(settings.selection) && !isMoved && hasLines)
    return data;
  std::vector<NamedData> copies;
  for (const NamedData& one : data)
  {
    copies.push_back(one);
    copies.back().data.TakeReference(one.data->NewInstance());
    copies.back().data->ShallowCopy(one.data);
  }
  if (!hasLines)
    dropLines(copies);
  if (isMoved)
    movePositions(copies, settings.data.positions);
  for (const Calculation& calculation : settings.data.calculations)
    add(copies, "--calculate", calculation, addCalculated, known);
  if (!settings.selection.where.empty())
    add(copies, "--where", {whereArray, settings.selection.where}, addWhere, known);
  if (!settings.selection.hidden.empty() || !settings.selection.only.empty())
    addIdMarks(copies, settings.selection, whereArray);
  return copies;
}

std::vector<NamedData> readAsAsked(
  Input& input, int step, const Settings& settings, ProgressRelay& progress)
{
  KnownExpressions known;
  return withCalculated(input.read(step, progress), settings, known);
}

void noteCalculated(const Settings& settings, KnownExpressions& known)
{
  for (const Calculation& calculation : settings.data.calculations)
    known.emplace(calculation.expression, false);
  if (!settings.selection.where.empty())
    known.emplace(settings.selection.where, false);
}

bool isLimited(const SelectionSettings& selection)
{
  return !selection.where.empty() || !selection.hidden.empty() || !selection.only.empty();
}

bool areOtherCalculations(const Settings& a, const Settings& b)
{
  return a.data.positions != b.data.positions || a.data.lines != b.data.lines ||
         a.data.calculations != b.data.calculations || a.selection.where != b.selection.where ||
         a.selection.hidden != b.selection.hidden || a.selection.only != b.selection.only;
}

} // namespace mote::app
