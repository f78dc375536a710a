// How large particles are, and how thick lines.

#include "Part.h"

#include "base/Failure.h"
#include "base/Text.h"

#include <vtkDataArray.h>
#include <vtkMoteParticleMapper.h>
#include <vtkPointData.h>

namespace mote::app
{

namespace
{

/// Whether the data say how large particles are.
bool hasRadii(vtkDataSet* data)
{
  if (Part::isOfSource(data))
    return true;
  return vtkMoteParticleMapper::FindRadii(data->GetPointData()) != nullptr;
}

/// The number of --radius; 0 where that is none. Throws Failure.
double numberOf(const ParticleSettings& settings)
{
  double radius = 0.0;
  if (!parseNumber(settings.radius, radius))
    return 0.0;
  if (!(radius > 0.0))
    throw Failure("--radius must be above zero, not " + settings.radius);
  return radius;
}

/// Throws Failure where there is no array that --radius names.
void checkArray(const std::string& name, vtkDataSet* data, const ParticleSettings& settings)
{
  if (!data->GetPointData()->GetArray(settings.radius.c_str()))
    throw Failure(
      "--radius: " + name + " has no array '" + settings.radius + "'; it has " + listArrays(data));
}

TubeRadius tubeRadiusOf(const std::string& name, vtkDataSet* data, const ParticleSettings& settings)
{
  TubeRadius tube{numberOf(settings), "", settings.radiusScale};
  if (tube.radius > 0.0 || settings.radius == "spacing")
    return tube;
  if (settings.radius != "auto")
  {
    checkArray(name, data, settings);
    tube.array = settings.radius;
  }
  else if (vtkDataArray* radii = vtkMoteParticleMapper::FindRadii(data->GetPointData()))
  {
    tube.array = radii->GetName();
    tube.scale *= vtkMoteParticleMapper::GetRadiusFactor(radii->GetName());
  }
  return tube;
}

} // namespace

void Part::setRadius()
{
  if (surface_ && isLines(data_))
    surface_->setTubeRadius(tubeRadiusOf(name_, data_, settings_.particles));
  if (particles_)
    this->setParticleRadius();
}

void Part::setParticleRadius()
{
  particles_->SetStructureName(settings_.particles.structure.c_str());
  particles_->SetStructureForm(settings_.particles.form.c_str());
  particles_->SetRadiusScale(settings_.particles.radiusScale);
  const double radius = numberOf(settings_.particles);
  const bool number = radius > 0.0;
  if (number)
    particles_->SetRadius(radius);
  if (!settings_.particles.typeRadius.empty())
  {
    const std::string& others = settings_.particles.radius;
    if (!number && others != "auto")
      throw Failure("--radius must be a number beside --type-radius, for the other types, not '" +
                    others + "'");
    if (!data_->GetPointData()->GetArray("type"))
      throw Failure(name_ + " has no array 'type' for --type-radius; it has " + listArrays(data_));
    particles_->SetRadiusModeToType();
    particles_->RemoveAllTypeRadii();
    for (const auto& [type, value] : settings_.particles.typeRadius)
      particles_->SetTypeRadius(type, value);
  }
  else if (number)
    particles_->SetRadiusModeToConstant();
  else if (settings_.particles.radius == "spacing" ||
           (settings_.particles.radius == "auto" && !hasRadii(data_)))
  {
    // Particles keep their size when a simulation spreads or packs them. The same positions with
    // other arrays are what the structure is built for already.
    const bool isKept = keptRadius_ > 0.0 && !spaced_;
    particles_->SetRadius(keptRadius_);
    particles_->SetRadiusMode(
      isKept ? vtkMoteParticleMapper::RADIUS_CONSTANT : vtkMoteParticleMapper::RADIUS_FROM_SPACING);
  }
  else if (settings_.particles.radius == "auto")
    particles_->SetRadiusModeToAutomatic();
  else
  {
    checkArray(name_, data_, settings_.particles);
    particles_->SetRadiusArrayName(settings_.particles.radius.c_str());
    particles_->SetRadiusModeToArray();
  }
}

} // namespace mote::app
