#pragma once

#include "../core/Camera.h"
#include "../core/Progress.h"
#include "../core/RayBundle.h"
#include "../core/RayPacket.h"
#include "NearParticle.h"
#include "ParticleRanges.h"
#include "ParticleSet.h"
#include "StoredParticles.h"

#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mote
{

/// What every structure over particles offers.
///
/// It holds the valid particles of a ParticleSet, each at a slot, counted from 0 to size(), in an
/// order of its own. One that holds nothing is hit by nothing. Its const functions may be called
/// from any number of threads.
template <typename S>
concept IsParticleStructure = std::default_initializable<S> && std::copyable<S> &&
  requires(S made, const S held, const ParticleSet particles, const typename S::Options options,
    const Progress progress, RayPacket packet, RayBundle bundle, const std::int32_t object,
    const CameraRays rays, const std::size_t slot, std::vector<NearParticle> found)
{
  // Its name in options and messages.
  requires std::convertible_to<decltype(S::name()), std::string>;

  // How it is built. The defaults suit most particles.
  requires std::default_initializable<typename S::Options>;

  // Builds over the particles, in parallel, and forgets what was there, attributes, ranges and
  // visibility included; memory is used again. The result does not depend on the number of threads.
  // Throws Error for a malformed set (see examine()). Where it throws, or where `progress` answers
  // false, which stops it early, nothing is held afterwards.
  made.build(particles, options, progress);

  // Finds for each ray the nearest hit with tMin < t < its t, and where there is one writes t, slot
  // and `object`. Of coincident spheres the one with the smallest input index is hit. A ray that
  // starts inside a sphere hits its far side. The rays of a packet may point anywhere; for those of
  // a camera a bundle is faster.
  held.cast(packet, object);
  held.cast(bundle, object);

  // Looks for anything between the ends of the rays: t of each ray that meets a sphere with tMin <
  // t < its t becomes -infinity. For a ray whose `object` is this one the particle `slot` does not
  // count: the ray starts or ends on it. slot and object stay as they are.
  held.occlude(packet, object);
  held.occlude(bundle, object);

  // Side in pixels (2, 4, 8 or 16) of the camera's bundles that are cast fastest in the square at
  // (x0, y0): bundleSide(rays, x0, y0, size), all in pixels.
  requires std::same_as<decltype(held.bundleSide(rays, 0, 0, 16)), int>;

  // Keeps up to four attributes for setRanges(), in float; none forgets them. They are in input
  // order and need kept indices; nothing is viewed after the call. Throws Error where an attribute
  // has not one tuple for each particle of the input.
  made.setAttributes(std::vector<ParticleAttribute>());

  // Shows only the particles with all values in range, besides what setVisibility() hides.
  // Attributes compare as float: limits are rounded inwards, so that for values that are float the
  // answer is exact. Throws Error for a range on an attribute where none is kept.
  made.setRanges(ParticleRanges());

  // Shows only the particles whose slots the function accepts, without a rebuild; it is called from
  // several threads. An empty function shows all again.
  made.setVisibility(std::function<bool(std::size_t)>());

  // Whether visibility and ranges leave the particle shown, and how many they leave.
  requires std::same_as<decltype(held.isShown(slot)), bool>;
  requires std::same_as<decltype(held.shownCount()), std::size_t>;

  // Runs of slots that hold, beside others, all particles with center(slot)[k], or with k = 3
  // radius(slot), in a range: slotsBetween(k, low, high). Each slot is in one run at most, and no
  // run is longer than SlotRun::longest, so that they suit loops in parallel.
  requires std::same_as<decltype(held.slotsBetween(0, 0.0, 1.0)), std::vector<SlotRun>>;

  // Adds to `found` the shown particles whose spheres come closer to a point, in the input's
  // coordinates, than a distance, in no special order: findNear(point, distance, found). Of many
  // that are one and the same sphere it may add but one.
  held.findNear(Vec3d(0.0), 1.0, found);

  // The number of particles held, and what the build found in the input.
  requires std::same_as<decltype(held.size()), std::size_t>;
  requires std::same_as<decltype(held.statistics()), const ParticleStatistics&>;

  // What is stored counts from origin(), in multiples of unit(): a length in the input, and a power
  // of two.
  requires std::same_as<decltype(held.origin()), const Vec3d&>;
  requires std::same_as<decltype(held.unit()), double>;

  // Centre and radius in the input's coordinates, as they are stored.
  requires std::same_as<decltype(held.center(slot)), Vec3d>;
  requires std::same_as<decltype(held.radius(slot)), double>;

  // The particle's index in the input; the slot itself where indices were not kept.
  requires std::same_as<decltype(held.inputIndex(slot)), std::uint64_t>;

  // Memory of the structure and of the particles stored in it.
  requires std::same_as<decltype(held.bytes()), std::size_t>;
};

} // namespace mote
