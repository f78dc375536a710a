#include "ParticlePaths.h"

#include "Ids.h"
#include "Part.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <sstream>

namespace mote::app
{

namespace
{

/// Bright on a dark background, and still seen on a light one.
constexpr std::array<unsigned char, 3> colors[] = {{255, 127, 14}, {31, 165, 230}, {44, 190, 44},
  {230, 60, 60}, {190, 110, 230}, {240, 200, 0}, {230, 110, 190}, {0, 190, 180}};

/// Which sides of the box are joined; all where the data do not say.
std::array<bool, 3> periodicAxes(vtkDataSet* data)
{
  std::array<bool, 3> isPeriodic = {true, true, true};
  auto* flags = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("boundary"));
  if (!flags || flags->GetNumberOfValues() == 0)
    return isPeriodic;
  std::istringstream words(flags->GetValue(0));
  std::string word;
  for (int axis = 0; axis < 3 && words >> word; ++axis)
    isPeriodic[static_cast<std::size_t>(axis)] = word.starts_with("p");
  return isPeriodic;
}

/// What only moves particles, without what expressions would add.
Settings movingAlone(Settings settings)
{
  settings.data.calculations.clear();
  settings.selection = {};
  return settings;
}

} // namespace

std::array<unsigned char, 3> pathColor(std::size_t number)
{
  return colors[number % std::size(colors)];
}

ParticlePaths::ParticlePaths(std::unique_ptr<Input> input, const IdRanges& ids,
  const Settings& settings, const std::weak_ptr<StepCache>& cache)
  : ids_(ids)
  , settings_(movingAlone(settings))
  , read_(static_cast<std::size_t>(input->numberOfSteps()))
  , reader_(std::move(input), settings_, cache,
      [this](int step, const std::vector<NamedData>& data)
      {
        Step found = this->look(data);
        const std::lock_guard lock(mutex_);
        read_[static_cast<std::size_t>(step)] = std::move(found);
        ++stepsRead_;
      })
{
}

std::unique_ptr<ParticlePaths> ParticlePaths::whole(
  const Settings& settings, const Input& input, ProgressRelay& progress)
{
  const IdRanges& wanted = settings.marks.trajectories;
  if (wanted.empty())
    return nullptr;
  auto paths = std::make_unique<ParticlePaths>(input.again(), wanted, settings);
  paths->finish(progress);
  return paths;
}

void ParticlePaths::finish(ProgressRelay& progress) const
{
  vtkNew<vtkObject> reading;
  ProgressRelay::Work work(progress, "Reading paths", reading);
  while (this->stepsRead() < this->steps())
  {
    double share = static_cast<double>(this->stepsRead()) / this->steps();
    reading->InvokeEvent(vtkCommand::ProgressEvent, &share);
    work.finish(); // where the user stops it
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

ParticlePaths::Step ParticlePaths::look(const std::vector<NamedData>& data) const
{
  Step step;
  for (std::size_t k = 0; k < data.size(); ++k)
  {
    vtkDataSet* particles = data[k].data;
    if (Part::isMesh(particles))
      continue;
    if (!step.box)
    {
      step.box = simulationBoxOf(particles);
      step.isPeriodic = periodicAxes(particles);
    }
    const auto wanted = ids_.of(static_cast<int>(k) + 1);
    vtkDataArray* ids = idArrayOf(particles);
    for (vtkIdType i = 0; i < particles->GetNumberOfPoints(); ++i)
      if (const std::int64_t id = idOf(ids, i); holds(wanted, id))
        particles->GetPoint(i, step.places[{k, id}].data());
  }
  return step;
}

int ParticlePaths::stepsRead() const
{
  const std::lock_guard lock(mutex_);
  return stepsRead_;
}

/// Whether the way is by more than half of a periodic box: the particle left it on one side and
/// came in on the other.
bool ParticlePaths::isJump(const Step& step, const Place& from, const Place& to)
{
  if (!step.box)
    return false;
  double cell[3][3], inverse[3][3], way[3], share[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    way[axis] = to[static_cast<std::size_t>(axis)] - from[static_cast<std::size_t>(axis)];
    for (int v = 0; v < 3; ++v)
      cell[axis][v] = step.box->vectors[v][axis];
  }
  if (vtkMath::Determinant3x3(cell) == 0.0)
    return false;
  vtkMath::Invert3x3(cell, inverse);
  vtkMath::Multiply3x3(inverse, way, share);
  for (std::size_t v = 0; v < 3; ++v)
    if (step.isPeriodic[v] && std::abs(share[v]) > 0.5)
      return true;
  return false;
}

void ParticlePaths::fill(vtkPolyData* lines, const std::vector<std::size_t>& sets) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> shades;
  shades->SetNumberOfComponents(3);
  const bool mayJump = settings_.data.positions != "unwrapped";
  const std::lock_guard lock(mutex_);
  std::map<Id, std::size_t> shadeOf; // in the order of ids
  for (const auto& step : read_)
    if (step)
      for (const auto& [id, place] : step->places)
        shadeOf.emplace(id, 0);
  std::size_t next = 0;
  for (auto& [id, shade] : shadeOf)
    shade = next++;
  for (std::size_t s = 1; s < read_.size(); ++s)
    for (const auto& [id, here] : read_[s] && read_[s - 1] ? read_[s]->places : Places())
    {
      const auto before = read_[s - 1]->places.find(id);
      if (std::find(sets.begin(), sets.end(), id.first) == sets.end() ||
          before == read_[s - 1]->places.end() ||
          (mayJump && isJump(*read_[s], before->second, here)))
        continue;
      const vtkIdType ends[2] = {
        points->InsertNextPoint(before->second.data()), points->InsertNextPoint(here.data())};
      cells->InsertNextCell(2, ends);
      shades->InsertNextTypedTuple(pathColor(shadeOf[id]).data());
    }
  lines->Initialize();
  lines->SetPoints(points);
  lines->SetLines(cells);
  lines->GetCellData()->SetScalars(shades);
}

} // namespace mote::app
