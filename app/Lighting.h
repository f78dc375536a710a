#pragma once

#include "ViewOptions.h"

#include <vtkNew.h>

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

/// Why the text is no --light (a name, AZIMUTH,ELEVATION or X,Y,Z); empty where it is one.
std::string checkLight(const std::string& text);

/// Why the text is no --shadows (none, hard, soft or a number); empty where it is.
std::string checkShadows(const std::string& text);

/// Why the text is no --ambient-occlusion (none, live, baked or a number); empty where it is.
std::string checkAmbientOcclusion(const std::string& text);

/// The lights of a scene: a main one, which may cast shadows and stands where --light says, and a
/// weaker one from the eye that keeps the other side of things, and shadows, from going dark.
class Lighting
{
public:
  /// `options` must have been checked.
  Lighting(vtkRenderer* renderer, const ViewOptions& options);
  ~Lighting();

  /// From no shadows to hard ones to soft ones to none.
  void nextShadows();

  /// "No shadows", "Hard shadows", "Soft shadows".
  std::string shadowsName() const;

  /// From plain light to live ambient occlusion, to baked, to paths, to plain light.
  void nextShading();

  /// "Plain light", "Ambient occlusion", "Ambient occlusion, baked", "Path tracing".
  std::string shadingName() const;

  /// Whether light is found by paths.
  bool tracesPaths() const;

  /// For whatever traces the scene.
  vtkMoteShading* shading() { return shading_; }

  /// The share of the light that comes from all sides, for the particles' properties.
  double ambient() const;

private:
  void place(const std::string& where);
  void setShadows(const std::string& shadows);
  void balance();
  bool isOccluded() const;

  const ViewOptions& options_;
  std::string shadows_;
  bool fromEye_ = false;
  vtkNew<vtkMoteShading> shading_;
  vtkNew<vtkMoteAreaLight> main_;
  vtkNew<vtkLight> fill_;
};

} // namespace mote::app
