#include "MoteProp.h"

#include "SceneBridge.h"

#include "RotatedCopies.h"
#include "vtkMoteMeshMapper.h"

#include "kernels/scene/Scene.h"
#include "kernels/tracing/Picking.h"

#include "vtkActor.h"
#include "vtkProperty.h"

namespace mote
{

namespace
{

/// An actor with a vtkMoteMeshMapper.
class MeshProp : public PropWithMapper<MeshProp, vtkActor, vtkMoteMeshMapper>
{
public:
  using PropWithMapper::PropWithMapper;

  bool describe(Scene& scene, std::int32_t id) const override
  {
    SurfaceObject object;
    if (!mapper_->DescribeTo(object, prop_))
      return false;
    object.id = id;
    object.revision = mapper_->GetPictureMTime();
    const Mat4d placed = object.toWorld;
    for (const Mat4d& turn : rotatedCopies(
           mapper_->GetRepetitions(), mapper_->GetRepetitionCenter(), mapper_->GetRepetitionAxis()))
    {
      object.toWorld = placed * turn;
      mapper_->TurnColors(object);
      scene.surfaces.push_back(object);
    }
    return true;
  }
  std::vector<vtkMTimeType> times() const override
  {
    return {mapper_->GetPictureMTime(), lookTimeOf(prop_)};
  }
  vtkUnsignedCharArray* ghosts() const override { return mapper_->GetGhosts(); }
  bool picksCells() const override { return true; }
  double pickedValue(const ScenePick& pick) const override { return mapper_->ValueOf(pick); }
};

} // namespace

std::shared_ptr<MoteProp> meshPropOf(vtkProp* prop)
{
  return MeshProp::of(prop);
}

} // namespace mote
