#pragma once

#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkDataArray;
class vtkProp;
class vtkProp3D;
class vtkUnsignedCharArray;

namespace mote
{

class MapperOcclusion;
struct OcclusionRequest;
struct Scene;
struct ScenePick;

/// A prop that Mote traces, whatever its mapper: what the bridge to the kernels asks of each kind.
/// A new kind is one more class in a file of its own, and one more entry in motePropOf().
class MoteProp
{
public:
  explicit MoteProp(vtkProp3D* prop)
    : prop_(prop)
  {
  }
  virtual ~MoteProp() = default;
  MoteProp(const MoteProp&) = delete;
  MoteProp& operator=(const MoteProp&) = delete;

  vtkProp3D* prop() const { return prop_; }

  /// Updates the mapper and adds to the scene what there is to draw, by this id; false where there
  /// is nothing.
  virtual bool describe(Scene& scene, std::int32_t id) const = 0;
  /// The times of change of all that its look depends on, besides place, camera and lights.
  virtual std::vector<vtkMTimeType> times() const = 0;
  /// Its occlusion maps, brought up to date without baking, or with no request as they are; null
  /// where it has none.
  virtual MapperOcclusion* occlusion(const OcclusionRequest*) const { return nullptr; }
  /// Whether rays go through it, so that they must be told where other props stand.
  virtual bool isVolume() const { return false; }
  /// The array of its particles with one tuple for each, or null where there is none of that name.
  virtual vtkDataArray* particleArray(const char* name) const
  {
    (void)name;
    return nullptr;
  }
  /// The marks of its particles or cells, as its ids are of either, that are copies of what another
  /// rank has (DUPLICATEPOINT, which is the same as DUPLICATECELL); null where there are none.
  virtual vtkUnsignedCharArray* ghosts() const { return nullptr; }
  /// Whether the ids of what is picked are cells of the input, or else points.
  virtual bool picksCells() const { return false; }
  /// The value that colours what was picked; NaN where none does.
  virtual double pickedValue(const ScenePick& pick) const = 0;
  /// Whether what is drawn is a preview of more.
  virtual bool isPreview() const { return false; }
  /// Waits until what is drawn is no preview; false where nothing is to be had.
  virtual bool finish() const { return true; }

private:
  vtkProp3D* prop_;
};

/// A MoteProp of this VTK class whose mapper is one of ours; `Kind` is the class derived from it.
template <typename Kind, typename Prop, typename Mapper>
class PropWithMapper : public MoteProp
{
public:
  PropWithMapper(Prop* prop, Mapper* mapper)
    : MoteProp(prop)
    , prop_(prop)
    , mapper_(mapper)
  {
  }

  /// The prop as such a one, or null where it is none.
  static std::shared_ptr<MoteProp> of(vtkProp* prop)
  {
    Prop* own = Prop::SafeDownCast(prop);
    Mapper* mapper = own ? Mapper::SafeDownCast(own->GetMapper()) : nullptr;
    return mapper ? std::make_shared<Kind>(own, mapper) : nullptr;
  }

protected:
  Prop* const prop_;
  Mapper* const mapper_;
};

using MoteProps = std::vector<std::shared_ptr<MoteProp>>;

/// The prop as one that Mote traces, for as long as the prop lives and keeps its mapper; null for
/// all others.
std::shared_ptr<MoteProp> motePropOf(vtkProp* prop);

} // namespace mote
