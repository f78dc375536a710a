#include "AllSteps.h"

#include "Convert.h"
#include "settings/Values.h"
#include "stage/Part.h"

#include <vtkActor.h>
#include <vtkMoteParticleMapper.h>
#include <vtkPointSet.h>

#include <cstdio>
#include <filesystem>

namespace mote::app
{

std::string numbered(const std::string& file, int step, int steps)
{
  const int digits = std::max(4, static_cast<int>(std::to_string(steps).size()));
  std::string number = std::to_string(step);
  number.insert(0, std::max(0, digits - static_cast<int>(number.size())), '0');
  std::filesystem::path path(file);
  std::string ending = path.extension().string();
  path.replace_extension();
  if (ending == ".gz" && path.has_extension()) // as in .xyz.gz
  {
    ending.insert(0, path.extension().string());
    path.replace_extension();
  }
  return path.string() + "." + number + ending;
}

void forSteps(Input& input, const Settings& settings, ProgressRelay& progress,
  const std::function<void(const Settings& ofStep, const std::string& which)>& work)
{
  if (!settings.output.allSteps)
    return work(settings, "");
  Settings ofStep = settings;
  ofStep.data.time.reset();
  ofStep.data.step = "last";
  if (const auto last = onlyParticlesOf(input, ofStep, progress))
  {
    const Part part(last->name, last->data, ofStep, 0.0);
    auto* points = vtkPointSet::SafeDownCast(last->data);
    if (points && points->GetNumberOfPoints() > 1 &&
        part.particles()->GetRadiusMode() == vtkMoteParticleMapper::RADIUS_FROM_SPACING)
      ofStep.particles.radius = exactText(0.5 * vtkMoteParticleMapper::EstimateSpacing(points));
  }
  const int steps = input.numberOfSteps();
  for (int step = 1; step <= steps; ++step)
  {
    ofStep.data.step = std::to_string(step);
    work(ofStep, " step " + std::to_string(step) + " of " + std::to_string(steps));
  }
}

} // namespace mote::app
