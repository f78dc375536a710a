#pragma once

#include "kernels/core/Camera.h"
#include "kernels/scene/Scene.h"

#include <vector>

class vtkActor;
class vtkMoteShading;
class vtkProp;
class vtkRenderer;

namespace mote
{

/// The renderer's camera for an image of the given size that fills its viewport. `viewportAspect`
/// is the viewport's width over its height; where it is not width / height pixels are not square.
Camera cameraOf(vtkRenderer* renderer, double viewportAspect, int width, int height);

/// The renderer's lights that are on; a headlight where it has none at all.
std::vector<Light> lightsOf(vtkRenderer* renderer);

/// Placement, material and plain colour of an actor.
void describeActor(vtkActor* actor, ParticleObject& object);

/// The prop as an actor with a Mote mapper, or null.
vtkActor* moteActor(vtkProp* prop);

/// The scene of these actors as the renderer sees it. `actors` loses those that have nothing to
/// draw, so that scene object i belongs to actors[i]. `shading` may be null: as a new one.
Scene sceneOf(
  vtkRenderer* renderer, std::vector<vtkActor*>& actors, vtkMoteShading* shading = nullptr);

} // namespace mote
