#include "Lighting.h"

#include "base/Text.h"
#include "settings/ErrorBudget.h"

#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkMoteAreaLight.h>
#include <vtkMoteShading.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mote::app
{

namespace
{

struct Place
{
  const char* name;
  double azimuth, elevation; // degrees, from behind the viewer to the right and up
};

constexpr Place places[] = {
  {"left-top", -32, 38},
  {"top", 0, 48},
  {"right-top", 32, 38},
  {"left", -48, 0},
  {"right", 48, 0},
  {"left-bottom", -32, -38},
  {"bottom", 0, -48},
  {"right-bottom", 32, -38},
  {"eye", 0, 0},
};

/// The main light of a picture without shadows, where one from far aside would leave much dark.
constexpr Place plainPlace = {"", -19.3, 25.3};

const Place* placeNamed(const std::string& name)
{
  const auto found = std::find_if(
    std::begin(places), std::end(places), [&](const Place& p) { return name == p.name; });
  return found == std::end(places) ? nullptr : found;
}

/// "1,-2,3" as numbers; none where one is not.
std::vector<double> numbersOf(const std::string& text)
{
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    double number = 0.0;
    if (!parseNumber(text.substr(begin, end - begin), number))
      return {};
    numbers.push_back(number);
    begin = end + 1;
  }
  return numbers;
}

bool isOccluded(const LightSettings& light)
{
  double rays = 1.0;
  return light.ambientOcclusion != "none" &&
         (!parseNumber(light.ambientOcclusion, rays) || rays > 0.0);
}

} // namespace

const std::vector<std::string>& lightNames()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> all;
    for (const Place& place : places)
      all.emplace_back(place.name);
    return all;
  }();
  return names;
}

std::string checkLight(const std::string& text)
{
  const std::vector<double> numbers = numbersOf(text);
  if (numbers == std::vector<double>(3, 0.0))
    return "'" + text + "' is no direction: at least one of X,Y,Z must not be 0";
  if (text == "auto" || placeNamed(text) || numbers.size() == 2 || numbers.size() == 3)
    return {};
  return "'" + text + "' is neither one of " + joined(lightNames(), ", ") +
         " nor AZIMUTH,ELEVATION nor X,Y,Z";
}

std::string checkShadows(const std::string& text)
{
  double number = 0.0;
  if (text == "none" || text == "hard" || text == "soft" ||
      (parseNumber(text, number) && number >= 1 && number <= 64 && number == std::floor(number)))
    return {};
  return "'" + text + "' is neither none, hard, soft nor a number from 1 to 64";
}

std::string checkAmbientOcclusion(const std::string& text)
{
  double number = 0.0;
  if (text == "none" || text == "live" || text == "baked" ||
      (parseNumber(text, number) && number >= 0 && number <= 4096 && number == std::floor(number)))
    return {};
  return "'" + text + "' is neither none, live, baked nor a number from 0 to 4096";
}

LightSettings withNextShadows(const LightSettings& light, const LightSettings& asked)
{
  LightSettings next = light;
  // A number that was asked for is the softness that the user wants.
  const bool own = asked.shadows != "none" && asked.shadows != "hard";
  next.shadows = light.shadows == "none"                           ? "hard"
                 : light.shadows == "hard" || light.shadows == "1" ? own ? asked.shadows : "soft"
                                                                   : "none";
  return next;
}

LightSettings withNextShading(const LightSettings& light)
{
  LightSettings next = light;
  next.pathTrace = false;
  if (light.pathTrace)
    next.ambientOcclusion = "none";
  else if (!isOccluded(light))
    next.ambientOcclusion = "live";
  else if (light.ambientOcclusion != "baked")
    next.ambientOcclusion = "baked";
  else
  {
    next.ambientOcclusion = "none";
    next.pathTrace = true;
  }
  return next;
}

std::string shadowsName(const LightSettings& light)
{
  return light.shadows == "none"                           ? "No shadows"
         : light.shadows == "hard" || light.shadows == "1" ? "Hard shadows"
                                                           : "Soft shadows";
}

std::string shadingName(const LightSettings& light)
{
  return light.pathTrace                     ? "Path tracing"
         : light.ambientOcclusion == "baked" ? "Ambient occlusion, baked"
         : isOccluded(light)                 ? "Ambient occlusion"
                                             : "Plain light";
}

Lighting::Lighting(vtkRenderer* renderer, const Settings& settings)
  : settings_(settings)
{
  fill_->SetLightTypeToHeadlight();
  main_->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(main_);
  renderer->AddLight(fill_);
  renderer->AutomaticLightCreationOff();
  shading_->SetSkyTop(0.95, 0.97, 1.0);
  shading_->SetSkyBottom(0.45, 0.43, 0.4);
  this->update();
}

Lighting::~Lighting() = default;

void Lighting::update()
{
  this->setSky();
  this->setShadows();
  this->place();
  this->balance();
}

bool Lighting::isOccluded() const
{
  return app::isOccluded(settings_.light);
}

double Lighting::ambient() const
{
  return this->isOccluded() ? 0.72 : 0.28;
}

void Lighting::setSky()
{
  const LightSettings& light = settings_.light;
  double rays = 0.0;
  if (parseNumber(light.ambientOcclusion, rays))
    shading_->SetAmbientOcclusionSamples(static_cast<int>(rays));
  else if (light.ambientOcclusion == "live")
    shading_->SetAmbientOcclusionToLive();
  else if (light.ambientOcclusion == "baked")
    shading_->SetAmbientOcclusionToBaked();
  else
    shading_->SetAmbientOcclusionToNone();
  shading_->SetCloudTolerance(errorShares(settings_).cloudTolerance);
  shading_->SetAmbientOcclusionReach(light.occlusionReach.value_or(0.0));
  shading_->SetMode(light.pathTrace ? vtkMoteShading::PATH_TRACED : vtkMoteShading::LOCAL);
}

void Lighting::place()
{
  const LightSettings& light = settings_.light;
  const std::vector<double> numbers = numbersOf(light.place);
  main_->SetSize(light.size);
  fromEye_ = false;
  angles_.reset();
  if (numbers.size() == 3)
  {
    // With the data, however the viewer turns.
    main_->SetLightTypeToSceneLight();
    main_->SetPosition(numbers.data());
    return;
  }
  const Place* named = placeNamed(light.place);
  const Place from =
    named ? *named
    : numbers.size() == 2
      ? Place{"", numbers[0], numbers[1]}
      : (light.shadows == "none" && !light.pathTrace ? plainPlace : *placeNamed("left-top"));
  angles_ = {from.azimuth, from.elevation};
  const double azimuth = vtkMath::RadiansFromDegrees(from.azimuth);
  const double elevation = vtkMath::RadiansFromDegrees(from.elevation);
  main_->SetLightTypeToCameraLight();
  main_->SetPosition(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
    std::cos(azimuth) * std::cos(elevation));
  fromEye_ = from.azimuth == 0.0 && from.elevation == 0.0;
}

void Lighting::setShadows()
{
  const std::string& shadows = settings_.light.shadows;
  main_->SetShadows(shadows != "none");
  double samples = 1.0;
  // A light's samples differ from one ray of a pixel to the next: 64 in all look smooth.
  if (shadows == "soft")
    samples =
      std::clamp(std::ceil(8.0 / std::sqrt(settings_.picture.mostSamples(false))), 2.0, 8.0);
  else if (shadows != "hard")
    parseNumber(shadows, samples);
  main_->SetSamples(static_cast<int>(samples));
}

/// Shares the light out between the lights and the sky.
void Lighting::balance()
{
  const bool on = settings_.light.shadows != "none";
  const bool paths = settings_.light.pathTrace;
  const double factor = settings_.light.intensity, fill = settings_.light.headlight;
  if (paths || this->isOccluded())
  {
    // The sky, of which crevices see less, takes over from the light of the eye.
    main_->SetIntensity(factor * (paths ? 0.8 : 0.55));
    fill_->SetIntensity(fill * (fromEye_ || paths ? 0.0 : 0.1));
    return;
  }
  main_->SetIntensity(factor * (fromEye_ ? 1.05 : on ? 0.8 : 0.64));
  fill_->SetIntensity(fill * (fromEye_ ? 0.0 : on ? 0.28 : 0.41));
}

} // namespace mote::app
