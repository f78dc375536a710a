#pragma once

#include "ParticleInput.h"

#include "kernels/particles/ParticleStructure.h"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>

namespace mote
{

/// Builds a structure on a thread of its own, which reads the arrays of the input and touches no
/// VTK object. The input is held, and let go of on the thread that calls, for as long as this
/// object lives. Its methods are to be called from one thread.
class StructureBuild
{
public:
  /// Begins. The structure is built into `used` as buildStructure() does it. Throws
  /// std::system_error where there can be no more threads.
  StructureBuild(ParticleInput input, const ParticleStructureOptions& options,
    std::shared_ptr<ParticleStructure> used)
    : input_(std::move(input))
    , result_(std::async(std::launch::async,
        [this, options, used = std::move(used)]() mutable
        {
          buildStructure(used, input_.set, options,
            [this](double done)
            {
              progress_ = done;
              return !stop_;
            });
          return std::move(used);
        }))
  {
  }
  /// Stops the build, and waits until it has stopped.
  ~StructureBuild() { stop_ = true; } // a future waits

  /// Share done, in [0, 1].
  double progress() const { return progress_; }
  /// Waits until the build has finished, but no longer than `seconds`; whether it has.
  bool wait(double seconds) const
  {
    return result_.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
  }
  /// What was built, once; call when it has finished. Throws what the build threw.
  std::shared_ptr<ParticleStructure> take() { return result_.get(); }

private:
  const ParticleInput input_;
  std::atomic<double> progress_{0.0};
  std::atomic<bool> stop_{false};
  std::future<std::shared_ptr<ParticleStructure>> result_; ///< the last: the thread uses the others
};

} // namespace mote
