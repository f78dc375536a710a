#pragma once

#include "Arrays.h"
#include "FlowFinder.h"
#include "Input.h"
#include "Opacity.h"
#include "Part.h"
#include "settings/Settings.h"

#include <cstddef>
#include <vector>

namespace mote::app
{

/// What decides how time steps are made ready: the settings, and what the parts of the present step
/// keep for the others.
struct ReadyPlan
{
  struct Kept
  {
    Part::Kind kind = Part::Kind::Particles;
    double radius = 0.0; ///< Part::keptRadius()
    ArrayChoice colored; ///< of volumes
    bool operator==(const Kept&) const = default;
  };
  Settings settings;
  std::vector<Kept> kept; ///< one a part
  ArrayChoice colored;    ///< the array that colours

  /// Whether the other plan makes the same of the same data.
  bool fits(const ReadyPlan& other) const;
  /// Whether these settings ask for the same calculated arrays.
  bool fitsCalculations(const Settings& other) const;
};

/// A time step that was read, and as much of it built as a picture needs.
struct ReadyStep
{
  std::vector<NamedData> original; ///< as it was read
  std::vector<NamedData> data;     ///< with what is calculated
  std::vector<BuiltPart> parts;    ///< of `data`; none where nothing could be built
  BuiltFlow flow;                  ///< streamlines and arrows of them
  UsualOpacity::Found opacity;     ///< of its volumes; no array where it was not asked for
  ReadyPlan plan;                  ///< by which it was built
  MemoryPieces memory;             ///< that it takes, about

  /// Finds `memory`.
  void count();
};

/// Builds what the plan asks for of data that were read, taking from an earlier step what both have
/// in common; `finder` keeps what streamlines have. Where they do not fit the plan nothing is
/// built. Throws Interrupted. Uses nothing that another thread uses, but for what `before` holds,
/// which stays as it is.
ReadyStep makeReady(const std::vector<NamedData>& original, const ReadyPlan& plan,
  const Runner& runner, const std::vector<BuiltPart>& before, FlowFinder& finder);

/// Data objects of one's own, which share their arrays with those of the step. Arrays and
/// structures may be used by one thread at a time.
ReadyStep withOwnData(const ReadyStep& step);

} // namespace mote::app
