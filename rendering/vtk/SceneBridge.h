#pragma once

#include "MoteProp.h"

#include "kernels/core/Camera.h"
#include "kernels/scene/Scene.h"

#include <vector>

class vtkActor;
class vtkMoteShading;
class vtkPropCollection;
class vtkRenderer;
class vtkVolumeProperty;

namespace mote
{

/// The renderer's camera for an image of the given size that fills its viewport. `viewportAspect`
/// is the viewport's width over its height; where it is not width / height pixels are not square.
Camera cameraOf(vtkRenderer* renderer, double viewportAspect, int width, int height);

/// The renderer's lights that are on; a headlight where it has none at all.
std::vector<Light> lightsOf(vtkRenderer* renderer);

/// Those that Mote traces of what is visible and pickable.
MoteProps pickableProps(vtkPropCollection* props);

/// From the coordinates of a prop's data to the world.
Mat4d placementOf(vtkProp3D* prop);

/// Placement, material and plain colour of an actor.
void describeActor(vtkActor* actor, SurfaceObject& object);

/// When what describeActor() reads of the actor's properties changed last.
vtkMTimeType lookTimeOf(vtkActor* actor);

/// How a volume, and a surface in it, answers light.
Material materialOf(vtkVolumeProperty* property);

/// The scene of these props as the renderer sees it. `props` loses those that have nothing to draw;
/// the id of all that props[i] gives the scene is i.
/// `shading` may be null: as a new one.
Scene sceneOf(vtkRenderer* renderer, MoteProps& props, vtkMoteShading* shading = nullptr);

} // namespace mote
