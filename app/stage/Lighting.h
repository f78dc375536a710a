#pragma once

#include "settings/Settings.h"

#include <vtkNew.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkLight;
class vtkMoteAreaLight;
class vtkMoteShading;
class vtkRenderer;

namespace mote::app
{

/// The places that --light knows by name, as the viewer sees them.
const std::vector<std::string>& lightNames();

/// The light settings after the next press of a key: from no shadows to hard ones to soft ones, or
/// those that were asked for by a number, to none.
LightSettings withNextShadows(const LightSettings& light, const LightSettings& asked);
/// From plain light to live ambient occlusion, to baked, to paths, to plain light.
LightSettings withNextShading(const LightSettings& light);

/// "No shadows", "Hard shadows", "Soft shadows".
std::string shadowsName(const LightSettings& light);
/// "Plain light", "Ambient occlusion", "Ambient occlusion, baked", "Path tracing".
std::string shadingName(const LightSettings& light);

/// Why the text is no --light (a name, AZIMUTH,ELEVATION or X,Y,Z); empty where it is one.
std::string checkLight(const std::string& text);

/// Why the text is no --shadows (none, hard, soft or a number); empty where it is.
std::string checkShadows(const std::string& text);

/// Why the text is no --ambient-occlusion (none, live, baked or a number); empty where it is.
std::string checkAmbientOcclusion(const std::string& text);

/// The lights of the picture, as the settings say: a main one, which may cast shadows and stands
/// where --light says, and a weaker one from the eye that keeps the other side of things, and
/// shadows, from going dark.
class Lighting
{
public:
  /// The settings are those of the scene.
  Lighting(vtkRenderer* renderer, const Settings& settings);
  ~Lighting();

  /// Follows the settings.
  void update();

  /// For whatever traces the picture.
  vtkMoteShading* shading() const { return shading_; }

  /// Where the main light stands, as the viewer sees it: degrees to the right and up; none where it
  /// stays with the data.
  std::optional<std::array<double, 2>> angles() const { return angles_; }

  /// The share of the light that comes from all sides, for the particles' properties.
  double ambient() const;

private:
  void place();
  void setShadows();
  void setSky();
  void balance();
  bool isOccluded() const;

  const Settings& settings_;
  bool fromEye_ = false;
  std::optional<std::array<double, 2>> angles_;
  vtkNew<vtkMoteShading> shading_;
  vtkNew<vtkMoteAreaLight> main_;
  vtkNew<vtkLight> fill_;
};

} // namespace mote::app
