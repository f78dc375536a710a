#include "MoteProp.h"

#include "vtkMoteVolumeMapper.h"

#include "kernels/scene/Scene.h"

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

  bool describe(Scene& scene) const override
  {
    VolumeObject object;
    if (!mapper_->DescribeTo(object, volume_))
      return false;
    scene.volumes.push_back(std::move(object));
    return true;
  }
  std::vector<vtkMTimeType> times() const override
  {
    // The property's own time knows its functions, but not its iso-values.
    vtkVolumeProperty* property = volume_->GetProperty();
    return {mapper_->GetPictureMTime(), property->GetMTime(),
      property->GetIsoSurfaceValues()->GetMTime()};
  }
  bool isVolume() const override { return true; }

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
