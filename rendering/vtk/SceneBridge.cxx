#include "SceneBridge.h"

#include "vtkMoteAreaLight.h"
#include "vtkMoteShading.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

Vec3d toVec(const double* v)
{
  return {v[0], v[1], v[2]};
}

Vec3f toColor(const double* v)
{
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

Light toLight(vtkLight* from)
{
  Light light;
  double position[3], focalPoint[3];
  from->GetTransformedPosition(position);
  from->GetTransformedFocalPoint(focalPoint);
  light.color = toColor(from->GetDiffuseColor()) * static_cast<float>(from->GetIntensity());
  if (from->GetPositional())
  {
    light.kind = Light::Kind::Point;
    light.vector = toVec(position);
  }
  else
  {
    light.kind = Light::Kind::Directional;
    light.vector = toVec(focalPoint) - toVec(position);
  }
  if (auto* area = vtkMoteAreaLight::SafeDownCast(from))
  {
    light.shadows = area->GetShadows() != 0;
    light.size = from->GetPositional() ? area->GetSize() : std::min(area->GetSize(), 90.0);
    light.samples = light.size > 0.0 ? area->GetSamples() : 1;
  }
  return light;
}

} // namespace

Camera cameraOf(vtkRenderer* renderer, double viewportAspect, int width, int height)
{
  vtkCamera* from = renderer->GetActiveCamera();
  Camera camera;
  camera.projection = from->GetParallelProjection() ? Camera::Projection::Orthographic
                                                    : Camera::Projection::Perspective;
  camera.position = toVec(from->GetPosition());
  camera.forward = toVec(from->GetDirectionOfProjection());
  camera.up = toVec(from->GetViewUp());
  camera.pixelAspect = viewportAspect * height / width;
  camera.viewAngle = from->GetViewAngle();
  if (from->GetUseHorizontalViewAngle())
    camera.viewAngle = 2.0 / M_PI * 180.0 *
                       std::atan(std::tan(from->GetViewAngle() * M_PI / 360.0) / viewportAspect);
  camera.parallelScale = from->GetParallelScale();
  camera.centerX = from->GetWindowCenter()[0];
  camera.centerY = from->GetWindowCenter()[1];
  camera.nearDistance = from->GetClippingRange()[0];
  camera.farDistance = from->GetClippingRange()[1];
  return camera;
}

std::vector<Light> lightsOf(vtkRenderer* renderer)
{
  std::vector<Light> lights;
  vtkLightCollection* all = renderer->GetLights();
  vtkCollectionSimpleIterator next;
  all->InitTraversal(next);
  while (vtkLight* light = all->GetNextLight(next))
    if (light->GetSwitch())
      lights.push_back(toLight(light));
  if (all->GetNumberOfItems() == 0)
  {
    Light headlight;
    headlight.kind = Light::Kind::Directional;
    headlight.vector = toVec(renderer->GetActiveCamera()->GetDirectionOfProjection());
    lights.push_back(headlight);
  }
  return lights;
}

MoteProps pickableProps(vtkPropCollection* props)
{
  MoteProps pickable;
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* prop = props->GetNextProp(next))
    if (auto ours = motePropOf(prop))
      if (prop->GetVisibility() && prop->GetPickable())
        pickable.push_back(std::move(ours));
  return pickable;
}

Mat4d placementOf(vtkProp3D* prop)
{
  Mat4d toWorld;
  vtkMatrix4x4* matrix = prop->GetMatrix();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      toWorld[column][row] = matrix->GetElement(row, column);
  return toWorld;
}

void describeActor(vtkActor* actor, SurfaceObject& object)
{
  object.toWorld = placementOf(actor);
  vtkProperty* property = actor->GetProperty();
  object.coloring.constant = Vec4f(toColor(property->GetDiffuseColor()), 1.0f);
  if (property->GetEdgeVisibility())
    object.edges = {property->GetLineWidth(), Vec4f(toColor(property->GetEdgeColor()), 1.0f)};
  Material& m = object.material;
  m.opacity = static_cast<float>(property->GetOpacity());
  if (vtkProperty* back = actor->GetBackfaceProperty())
    object.backOpacity = static_cast<float>(back->GetOpacity());
  if (!property->GetLighting())
  {
    m.ambient = 1.0f;
    m.diffuse = m.specular = 0.0f;
    return;
  }
  m.metallic = static_cast<float>(property->GetMetallic());
  m.roughness = static_cast<float>(property->GetRoughness());
  m.ambient = static_cast<float>(property->GetAmbient());
  m.diffuse = static_cast<float>(property->GetDiffuse());
  m.specular = static_cast<float>(property->GetSpecular());
  m.specularColor = toColor(property->GetSpecularColor());
  m.specularPower = static_cast<float>(property->GetSpecularPower());
}

vtkMTimeType lookTimeOf(vtkActor* actor)
{
  vtkProperty* back = actor->GetBackfaceProperty();
  return std::max(actor->GetProperty()->GetMTime(), back ? back->GetMTime() : vtkMTimeType(0));
}

Material materialOf(vtkVolumeProperty* property)
{
  Material m;
  m.ambient = static_cast<float>(property->GetAmbient());
  m.diffuse = static_cast<float>(property->GetDiffuse());
  m.specular = static_cast<float>(property->GetSpecular());
  m.specularPower = static_cast<float>(property->GetSpecularPower());
  return m;
}

namespace
{

void shadeBy(Scene& scene, vtkMoteShading* shading)
{
  scene.cloudTolerance = shading->GetCloudTolerance();
  if (shading->GetMode() == vtkMoteShading::LOCAL)
  {
    const bool on = shading->GetAmbientOcclusion() != vtkMoteShading::OCCLUSION_NONE;
    scene.occlusion = {
      on ? shading->GetAmbientOcclusionSamples() : 0, shading->GetAmbientOcclusionReach()};
    return;
  }
  scene.paths.bounces = shading->GetMaximumBounces();
  scene.sky.top = toColor(shading->GetSkyTop());
  scene.sky.bottom = toColor(shading->GetSkyBottom());
  const Vec3d up = toVec(shading->GetSkyUp());
  if (glm::length(up) > 0.0)
    scene.sky.up = glm::normalize(up);
}

} // namespace

Scene sceneOf(vtkRenderer* renderer, MoteProps& props, vtkMoteShading* shading)
{
  Scene scene;
  MoteProps drawn;
  for (auto& prop : props)
    if (prop->describe(scene, static_cast<std::int32_t>(drawn.size())))
      drawn.push_back(std::move(prop));
  props = std::move(drawn);
  // Slices that lie in walls are seen where they come behind them.
  std::stable_partition(scene.surfaces.begin(), scene.surfaces.end(),
    [](const SurfaceObject& object)
    { return !std::holds_alternative<SliceSurface>(object.surface); });
  scene.lights = lightsOf(renderer);
  const vtkNew<vtkMoteShading> usual;
  shadeBy(scene, shading ? shading : usual.Get());
  return scene;
}

} // namespace mote
