#include "MoteProp.h"

#include "SceneBridge.h"

#include "PeriodicImages.h"
#include "vtkMoteParticleMapper.h"

#include "kernels/tracing/Picking.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <glm/gtc/matrix_transform.hpp>

namespace mote
{

namespace
{

/// An actor with a vtkMoteParticleMapper.
class ParticleProp : public PropWithMapper<ParticleProp, vtkActor, vtkMoteParticleMapper>
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
    // Images share the structure; all else that they take is a matrix.
    const Mat4d place = object.toWorld;
    for (const Vec3d& offset :
      imageOffsets(mapper_->GetReplication(), mapper_->GetReplicationVectors()))
    {
      object.toWorld = glm::translate(place, offset);
      scene.surfaces.push_back(object);
    }
    return true;
  }
  std::vector<vtkMTimeType> times() const override
  {
    return {mapper_->GetPictureMTime(), lookTimeOf(prop_)};
  }
  vtkDataArray* particleArray(const char* name) const override
  {
    vtkPointSet* input = mapper_->GetInput();
    vtkDataArray* array = input ? input->GetPointData()->GetArray(name) : nullptr;
    return array && array->GetNumberOfTuples() == input->GetNumberOfPoints() ? array : nullptr;
  }
  vtkUnsignedCharArray* ghosts() const override { return mapper_->GetGhosts(); }
  MapperOcclusion* occlusion(const OcclusionRequest* request) const override
  {
    return mapper_->UpdateOcclusion(request);
  }
  double pickedValue(const ScenePick& pick) const override
  {
    return mapper_->GetParticleValue(static_cast<vtkIdType>(pick.id));
  }
  bool isPreview() const override { return mapper_->IsPreview(); }
  bool finish() const override { return mapper_->FinishBuild(); }
};

} // namespace

std::shared_ptr<MoteProp> particlePropOf(vtkProp* prop)
{
  return ParticleProp::of(prop);
}

} // namespace mote
