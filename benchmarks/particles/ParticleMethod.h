#pragma once

#include "HitImage.h"
#include "OcclusionRays.h"
#include "ParticleInput.h"
#include "ParticleLodErrors.h"

#include <kernels/core/Camera.h>
#include <kernels/core/Error.h>

#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// What a method is made with.
struct MethodOptions
{
  int threads = 1;     ///< that it builds with, where it keeps threads of its own
  double lambda = 1.0; ///< cells of a grid a particle
  int packet = 0;      ///< side of the bundles cast through Mote's grid, 0: its own choice
};

/// One way to find what the rays of a camera meet. A new one is a file with a class like this and a
/// row in ParticleMethods.cpp; a structure of Mote's is a row in StructureMethods.cpp.
class ParticleMethod
{
public:
  virtual ~ParticleMethod() = default;

  /// Builds everything that casting needs, anew where that was done before. Timed.
  virtual void build(const ParticleInput& input) = 0;
  /// Memory of structure and particle storage together.
  virtual std::size_t bytes() const = 0;
  /// Ways of casting, one or more; the fastest of them speaks for the method.
  virtual std::vector<std::string> modes() const = 0;
  /// Casts a ray through every pixel's centre. Timed. May be called from one thread at a time.
  virtual void cast(std::size_t mode, const CameraRays& rays, HitImage& image) const = 0;

  /// Makes levels of detail for casts with an error; false where the method has none. Timed.
  virtual bool makeLods() { return false; }
  /// Pixels of error that casts may make from now on.
  virtual void setPoe(double /*poe*/) {}
  /// What they make wrong then.
  virtual ParticleLodErrors lodErrors(
    const Camera& /*camera*/, int /*width*/, int /*height*/, double /*poe*/) const
  {
    return {};
  }

  /// Ways of looking for anything in the way of rays; none where the method has not learnt it.
  virtual std::vector<std::string> occlusionModes() const { return {}; }
  /// Learns which of its particles the rays leave, as whoever casts a camera's rays through the
  /// method first knows already. Not timed.
  virtual void prepareOcclusion(const OcclusionRays& /*rays*/) {}
  /// Answers which rays meet a particle. Timed. May be called from one thread at a time.
  virtual void occlude(
    std::size_t /*mode*/, const OcclusionRays& /*rays*/, OcclusionAnswers& /*answers*/) const
  {
    throw Error("This method looks for nearest hits only.");
  }
};

struct ParticleMethodEntry
{
  std::string name;
  std::string summary;
  std::unique_ptr<ParticleMethod> (*make)(const MethodOptions& options);
  bool occludes; ///< whether it has occlusionModes(), known before it is made
};

/// All of them.
const std::vector<ParticleMethodEntry>& particleMethods();

/// Those of Mote's structures.
std::vector<ParticleMethodEntry> structureMethods();

std::unique_ptr<ParticleMethod> makeReferenceGridMethod(const MethodOptions& options);
std::unique_ptr<ParticleMethod> makeSingleRayMethod(const MethodOptions& options);
std::unique_ptr<ParticleMethod> makeEmbreeMethod(const MethodOptions& options);

} // namespace mote::bench
