#include "MoteProp.h"

#include "vtkMoteVolumeMapper.h"

#include "kernels/tracing/Picking.h"

#include "vtkContourValues.h"
#include "vtkMath.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace mote
{

namespace
{

/// A vtkVolume with a vtkMoteVolumeMapper.
class VolumeProp : public PropWithMapper<VolumeProp, vtkVolume, vtkMoteVolumeMapper>
{
public:
  using PropWithMapper::PropWithMapper;

  bool describe(Scene& scene, std::int32_t id) const override
  {
    return mapper_->DescribeTo(scene, prop_, id);
  }
  std::vector<vtkMTimeType> times() const override
  {
    // The property's own time knows its functions, but not its iso-values.
    vtkVolumeProperty* property = prop_->GetProperty();
    return {mapper_->GetPictureMTime(), property->GetMTime(),
      property->GetIsoSurfaceValues()->GetMTime()};
  }
  bool isVolume() const override { return true; }
  bool picksCells() const override { return true; }
  double pickedValue(const ScenePick& pick) const override
  {
    return pick.value.value_or(vtkMath::Nan()); // which all that is picked of a volume has
  }
};

} // namespace

std::shared_ptr<MoteProp> volumePropOf(vtkProp* prop)
{
  return VolumeProp::of(prop);
}

} // namespace mote
