#pragma once

#include "MoteRenderingDataModule.h" // For export macro
#include "ParticleInput.h"

#include "kernels/particles/ParticleStructure.h"

#include <atomic>
#include <exception>
#include <memory>
#include <thread>

namespace mote
{

/// Builds a structure on a thread of its own, which reads the arrays of the input and touches no
/// VTK object. The input is held, and let go of on the thread that calls, for as long as this
/// object lives. Its methods are to be called from one thread.
class MOTERENDERINGDATA_EXPORT StructureBuild
{
public:
  /// Begins. The structure is built into `used` as buildStructure() does it. Throws
  /// std::system_error where there can be no more threads.
  StructureBuild(ParticleInput input, const ParticleStructureOptions& options,
    std::shared_ptr<ParticleStructure> used);
  /// Stops the build, and waits until it has stopped.
  ~StructureBuild();
  StructureBuild(const StructureBuild&) = delete;
  StructureBuild& operator=(const StructureBuild&) = delete;

  /// Share done, in [0, 1].
  double progress() const { return progress_; }
  /// Whether there is nothing to wait for.
  bool finished() const { return finished_; }
  /// Waits until the build has finished, but no longer than `seconds`.
  void wait(double seconds) const;

  /// What was built, once; call when it has finished. Throws what the build threw.
  std::shared_ptr<ParticleStructure> take();

private:
  void run() noexcept;

  const ParticleInput input_;
  const ParticleStructureOptions options_;
  std::shared_ptr<ParticleStructure> structure_; ///< the thread's until finished_
  std::exception_ptr error_;                     ///< the same
  std::atomic<double> progress_{0.0};
  std::atomic<bool> stop_{false};
  std::atomic<bool> finished_{false};
  std::thread thread_;
};

} // namespace mote
