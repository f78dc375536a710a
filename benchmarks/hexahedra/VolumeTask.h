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
  ReferencePixels reference;

  /// Of this structure, as the kernels draw it.
  CloudObject volume(
    std::shared_ptr<const HexStructure> structure, const VolumeSampling& sampling) const;
  CameraRays rays() const { return {camera, width, height}; }
};

/// Makes or reads the input, and integrates the reference.
VolumeTask makeVolumeTask(const Options& options, const std::string& input);

/// The one view: from (1.1, 0.7, 1.5) towards the middle, so far away that the ball around the
/// bounds fills a view of 35 degrees.
extern const Named wholeView;

/// What the transfer function of the tasks is, in one sentence.
extern const char* const transferSentence;

} // namespace mote::bench
