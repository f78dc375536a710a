#pragma once

#include "MapperOcclusion.h"
#include "MoteRenderingDataModule.h" // For export macro
#include "ParticleInput.h"
#include "ParticleSelection.h"

#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <chrono>
#include <functional>
#include <set>

class vtkAlgorithm;
class vtkIndent;
class vtkUnsignedCharArray;

namespace mote
{

class StructureBuild;

/// A structure that one model has built and another may take over, instead of building it. One
/// model at a time draws it, as the ranges of that one are a part of it.
struct BuiltParticles
{
  std::shared_ptr<ParticleStructure> structure;
  InputKey key; ///< what it was built from
  double commonRadius = 0.0;
  double buildTime = 0.0; ///< seconds
};

/// A range of the values of a point array that is wanted by name.
struct ArrayRange
{
  std::string name;
  int component = 0; ///< or ArrayView::magnitude
  double low = 0.0, high = 0.0;
  const char* purpose = "a range"; ///< for messages
  vtkDataArray* array = nullptr;   ///< where it is known already, in place of the name
  RangeParts parts = {};           ///< none: all of it
};

/// vtkGhostType of the points, which marks copies of what another rank has; null where it does not
/// fit, and for null.
MOTERENDERINGDATA_EXPORT vtkUnsignedCharArray* ghostMarksOf(vtkPointSet* points);

/// The points of a data set as particles that rays can be cast at: radii, the structure over them,
/// the preview that stands in for it while it is built, ranges that hide particles, and occlusion
/// maps. A mapper is a view of one, a filter works on one. The structure is built only when points
/// or radii, or how to build it, have changed.
class MOTERENDERINGDATA_EXPORT ParticleModel
{
public:
  /// `owner` fires ProgressEvents during builds and has them stopped by its AbortExecute. With
  /// `tellsOfBuilds` it fires Start- and EndEvents, too, and warns of particles that are left out.
  ParticleModel(vtkAlgorithm* owner, bool tellsOfBuilds);
  ~ParticleModel();

  //@{
  /// How update() makes the particles. Names of structure and form are those of structureOf().
  RadiusChoice radii;
  std::string structureName, structureForm;
  bool keepPointIds = true; ///< of P-k-d trees
  bool meetsGhosts = false; ///< points that are another rank's, which are hidden otherwise
  std::shared_ptr<ScratchSpace> space; ///< where P-k-d trees lie; null: on the heap
  /// Particles of a preview, for sets of more than four times as many; 0, or no function, for none:
  /// then update() waits for the structure. Asked again while it waits.
  std::function<vtkIdType()> previewSize;
  //@}

  /// Brings structure or preview up to date. Throws Error where that cannot be, and there is no
  /// structure then; nor is there one where the owner's AbortExecute stopped the build.
  void update(vtkPointSet* input);
  /// What was built, for offer() of another model; null where there is only a preview, or a file's
  /// own tree, which costs nothing to take.
  std::shared_ptr<const BuiltParticles> built() const;
  /// The next update() takes this where it was built from what it would build from itself.
  void offer(std::shared_ptr<const BuiltParticles> built) { offered_ = std::move(built); }

  /// Stops what is built on another thread, and forgets the preview: update() begins anew.
  void stopBuild();
  /// The same, and forgets the structure.
  void clear();

  //@{
  /// As of the last update(). The structure, which is that of the preview where there is one, is
  /// null where there is nothing to draw; the tree where that is not the structure.
  const std::shared_ptr<ParticleStructure>& structure() const { return structure_; }
  std::shared_ptr<const PkdTree> tree() const;
  /// Makes levels of detail where there are none; false where the structure can have none, or is a
  /// preview's.
  bool makeLods();
  /// Of all particles, also while a part of them is drawn.
  ParticleStatistics statistics() const;
  std::size_t bytes() const;                            ///< of the structure
  double commonRadius() const { return commonRadius_; } ///< 0 where radii differ
  double buildTime() const { return buildTime_; }       ///< seconds of the last build
  int builds() const { return builds_; }                ///< so far
  /// Changes with the structure, and with what it shows.
  vtkMTimeType time() const { return changed_.GetMTime(); }
  /// Changes with the structure alone.
  vtkMTimeType structureTime() const { return structureChanged_.GetMTime(); }
  //@}

  //@{
  /// Whether there is a preview, of how many particles, whether a structure is built on another
  /// thread, and the share of it that is built.
  bool isPreview() const { return preview_ != nullptr; }
  std::size_t previewed() const { return preview_ ? preview_->particles : 0; }
  bool isBuilding() const { return build_ != nullptr; }
  double buildProgress() const;
  //@}

  /// The particles of the input as the structure was built from them, and their fingerprint.
  ParticleInput particles() const;
  const ContentHash& content();

  //@{
  /// Ranges of point arrays, of which there may be four, and of x, y, z of centres and of radii (k
  /// from 0 to 3). Whether anything changed; setting ones throws Error where they are none.
  static constexpr std::size_t mostRanges = 4;
  const std::vector<ArrayRange>& ranges() const { return ranges_; }
  const PlaceRanges& places() const { return places_; }
  bool addRange(const ArrayRange& range);
  /// Adds to the parts of the range that the array's component has, if any.
  bool addToRange(const ArrayRange& range);
  bool removeRange(const std::string& name, int component);
  bool setPlaceRange(int k, double low, double high);
  bool removeAllRanges();
  //@}

  /// Has the structure show what the ranges leave, those of `more` included; after update(). Gives
  /// the sentences about arrays that are missing that the last call did not give; other ranges hold
  /// nevertheless.
  std::vector<std::string> updateRanges(const std::vector<ArrayRange>& more = {});
  void printRanges(std::ostream& out, vtkIndent indent) const;
  /// All of them, also those that were given before.
  const std::set<std::string>& rangeProblems() const { return rangeProblems_; }

  //@{
  /// What the ranges leave: their number, and the bounds of the spheres. The first call after a
  /// change looks at all.
  std::size_t visible() const;
  Box visibleBounds() const;
  /// Sets to 1 those of the marks, one for each point of the input, whose particles the ranges
  /// leave. Of a preview those that it has.
  void markVisible(unsigned char* marks) const;
  //@}

  /// Brings maps up to date with the particles, without baking: those that `find` gives, which is
  /// asked after a change of particles, options or `key`, else new ones; see MapperOcclusion. The
  /// owner warns where maps cannot be used.
  void updateOcclusion(
    const OcclusionBakeOptions& options, const InputKey& key, const FindMaps& find);
  /// The same with the maps in the input's field data. With no request maps stay as they are. Null
  /// where there are no particles, a preview, or no maps yet of these particles.
  MapperOcclusion* occlusion(const OcclusionRequest* request);
  MapperOcclusion& maps() { return occlusion_; }

private:
  using Clock = std::chrono::steady_clock;

  /// What is known of a preview, and of all that it stands for.
  struct PreviewFacts
  {
    ParticleStatistics whole;
    double enlargement = 1.0;
    std::size_t particles = 0; ///< that are drawn or hidden by range
  };

  bool wantsPreview() const;
  ParticleStructureOptions buildOptions() const;
  void takeFile();
  bool takeOffer(const InputKey& key);
  void buildAtOnce();
  void beginPreview();
  void continueBuild();
  void takeBuild();
  void noteChange();
  void warnOfLeftOut() const;
  std::optional<StoredOcclusion> findMaps(const OcclusionRequest& request);

  vtkAlgorithm* owner_;
  bool tellsOfBuilds_;
  vtkWeakPointer<vtkPointSet> input_; ///< of the last update()

  std::shared_ptr<ParticleStructure> structure_;
  InputKey key_; ///< what the structure was built from
  std::shared_ptr<const BuiltParticles> offered_;
  vtkTimeStamp changed_, structureChanged_;
  std::optional<ContentHash> content_;
  double commonRadius_ = 0.0;
  double buildTime_ = 0.0;
  int builds_ = 0;

  std::unique_ptr<PreviewFacts> preview_; ///< where `structure_` is that of a preview
  std::unique_ptr<StructureBuild> build_;
  Clock::time_point buildStart_; ///< of build_
  bool continuing_ = false;      ///< in continueBuild()

  std::vector<ArrayRange> ranges_;
  PlaceRanges places_;
  ParticleSelection selection_;
  std::set<std::string> rangeProblems_;

  MapperOcclusion occlusion_;
};

} // namespace mote
