#pragma once

#include "../Report.h"
#include "../Timing.h"
#include "AmbientBaker.h"
#include "AmbientPictures.h"

#include <functional>

namespace mote::bench
{

/// All methods that the options ask for over one input, piece by piece of the report.
class AmbientContest
{
public:
  /// Builds the structures and makes the reference pictures.
  AmbientContest(const Options& options, const ParticleInput& input);

  /// Error of the picture against the time that it takes, by all methods that the options ask for.
  void compareErrors(Report& report);
  /// The same by those of a table.
  void compareErrors(const AmbientTable& table, Report& report);
  /// Bakes of the same particles by Mote and by Embree, round after round.
  void raceEmbree(Report& report);
  /// Frames with and without a look-up in maps.
  void timeLookUps(Report& report);

private:
  using Structure = std::shared_ptr<const ParticleStructure>;

  /// A method's picture and what it took, in one view.
  struct Entry
  {
    const AmbientMethod* method = nullptr;
    const ReferencePicture* reference = nullptr;
    Scene scene;
    std::string mode;
    BakedMaps baked;                 ///< null maps where rays are cast
    double frame = 0.0, plain = 0.0; ///< seconds of a picture, and of one without occlusion
    ShareErrors errors;

    double seconds() const { return baked.maps ? baked.statistics.seconds : frame; }
    double mrays() const;
  };

  /// Maps to look up in, and the scene that does.
  struct LookUp
  {
    const AmbientMethod* method = nullptr;
    BakedMaps baked;
    Scene scene;
  };

  Structure build(ParticleStructureKind kind) const;
  void chooseLiveStructure();
  void chooseParticles();
  SlotBits seen(const PictureSize& size) const;
  std::vector<const AmbientMethod*> wanted(
    const std::function<bool(const AmbientMethod&)>& is) const;
  void addEntry(const AmbientMethod& method, std::vector<Entry>& entries);
  void compareErrors(const std::string& table, const std::string& title,
    const std::vector<const AmbientMethod*>& methods, Report& report);
  void timeFrames(std::vector<Entry>& entries) const;
  void raceEmbree(
    const AmbientMethod& method, const SlotBits& some, int threads, Table& table, Report& report);
  void timeLookUps(const std::vector<LookUp>& all, const ReferencePicture& reference, Table& table,
    Report& report);
  std::string bakedName() const { return slots_.empty() ? "all" : "seen"; }
  Record recordOf(const std::string& table, const std::string& method, const std::string& view,
    const PictureSize& size) const;
  Record recordOf(const std::string& table, const Entry& entry) const;

  const Options& options_;
  const ParticleInput& input_;
  int threads_;
  double reach_; ///< world units
  std::vector<View> views_;
  PictureSize size_, frameSize_;
  Structure structure_; ///< that maps are baked for
  Structure tree_;      ///< that references are cast in
  Structure live_;      ///< the one of the two that casts rays of hits faster
  std::vector<ReferencePicture> references_;
  SlotBits slots_; ///< particles that are baked
  std::unique_ptr<AmbientBaker> baker_;
};

} // namespace mote::bench
