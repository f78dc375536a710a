#pragma once

#include "../Options.h"
#include "HexInput.h"
#include "VolumeReference.h"

#include <kernels/core/Camera.h>
#include <kernels/scene/Cloud.h>

namespace mote::bench
{

/// All that is the same for everyone who draws an input: what is to be seen, and what of it is
/// right.
struct VolumeTask
{
  HexInput input;
  Camera camera;
  TransferFunction transfer;
  int width = 0, height = 0, threads = 1, repeat = 1;
  bool singleRays = false; ///< structures take them one at a time
  ReferencePixels reference;

  /// Of this structure, as the kernels draw it.
  CloudObject volume(
    std::shared_ptr<const HexStructure> structure, const VolumeSampling& sampling) const;
  CameraRays rays() const { return {camera, width, height}; }
};

/// Makes or reads the input. There is no reference yet.
VolumeTask makeVolumeTask(const Options& options, const std::string& input);

/// Gives the task its reference, if it has none.
void integrateReference(VolumeTask& task);

/// A camera that looks along `-towards` at the middle of the bounds, from where the ball around
/// them fills its view of 35 degrees.
Camera wholeCamera(const Box& bounds, const Vec3d& towards, const Vec3d& up);

/// The one view: from (1.1, 0.7, 1.5) towards the middle, so far away that the ball around the
/// bounds fills a view of 35 degrees.
extern const Named wholeView;

/// What the transfer function of the tasks is, in one sentence.
extern const char* const transferSentence;

} // namespace mote::bench
