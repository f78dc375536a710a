#include "MoteProp.h"

#include "vtkMoteVolumeMapper.h"

#include "kernels/tracing/Picking.h"

#include "vtkContourValues.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace mote
{

namespace
{

/// A vtkVolume with a vtkMoteVolumeMapper.
class VolumeProp : public MoteProp
{
public:
  VolumeProp(vtkVolume* volume, vtkMoteVolumeMapper* mapper)
    : MoteProp(volume)
    , volume_(volume)
    , mapper_(mapper)
  {
  }

  bool describe(Scene& scene, std::int32_t id) const override
  {
    return mapper_->DescribeTo(scene, volume_, id);
  }
  std::vector<vtkMTimeType> times() const override
  {
    // The property's own time knows its functions, but not its iso-values.
    vtkVolumeProperty* property = volume_->GetProperty();
    return {mapper_->GetPictureMTime(), property->GetMTime(),
      property->GetIsoSurfaceValues()->GetMTime()};
  }
  bool isVolume() const override { return true; }
  bool picksCells() const override { return true; }
  double pickedValue(const ScenePick& pick) const override
  {
    return volume_->GetProperty()->GetIsoSurfaceValues()->GetValue(
      static_cast<int>(pick.colorIndex));
  }

private:
  vtkVolume* volume_;
  vtkMoteVolumeMapper* mapper_;
};

} // namespace

std::shared_ptr<MoteProp> volumePropOf(vtkProp* prop)
{
  vtkVolume* volume = vtkVolume::SafeDownCast(prop);
  auto* mapper = volume ? vtkMoteVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
  return mapper ? std::make_shared<VolumeProp>(volume, mapper) : nullptr;
}

} // namespace mote
