#include "Silhouettes.h"

#include "Text.h"

#include <vtkMoteSilhouettes.h>

namespace mote::app
{

bool areOn(const SilhouetteSettings& settings)
{
  if (settings.lines != "auto")
    return settings.lines != "off";
  // Whoever says how lines look wants some.
  return settings != SilhouetteSettings{};
}

SilhouetteSettings toggled(const SilhouetteSettings& now, const SilhouetteSettings& asked)
{
  SilhouetteSettings next = now;
  const bool own = asked.lines != "off" && asked.lines != "auto";
  next.lines = areOn(now) ? "off" : own ? asked.lines : "on";
  return next;
}

Silhouettes::Silhouettes(const SilhouetteSettings& settings)
  : settings_(settings)
{
  this->update();
}

Silhouettes::~Silhouettes() = default;

void Silhouettes::update()
{
  double radii = 0.0;
  options_->SetEnabled(areOn(settings_));
  options_->SetThreshold(parseNumber(settings_.lines, radii) ? radii : 10.0);
  options_->SetThickness(settings_.thickness);
  options_->SetColor(settings_.color.data());
  options_->SetGroupArrayName(settings_.groups.c_str());
}

bool Silhouettes::isOn() const
{
  return areOn(settings_);
}

} // namespace mote::app
