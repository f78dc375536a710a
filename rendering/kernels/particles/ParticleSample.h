#pragma once

#include "CoherentGrid.h"
#include "ParticleSet.h"

#include <cstdint>
#include <vector>

namespace mote
{

/// A part of a large set that stands for all of it: particles taken evenly, their radii enlarged so
/// that they fill as much of space as all of them do. It is a first picture, while the structure of
/// all is built, and no exact one.
class ParticleSample
{
public:
  /// Takes `wanted` particles, or all where there are no more: one of each of `wanted` stretches of
  /// the input that are as long as one another, somewhere in it. So the sample is even in
  /// space where the input's order has to do with places, and no regular pattern of the input
  /// meets a stride. It is the same every time. Copies what it takes, unfit particles included;
  /// throws Error for a malformed set (see checkParticles()).
  ParticleSample(const ParticleSet& particles, std::size_t wanted);

  /// The sample as a set of its own, with the enlarged radii. The view holds while this object is
  /// neither moved nor destroyed.
  const ParticleSet& set() const { return set_; }
  std::size_t size() const { return indices_.size(); }
  /// Index in the input of each particle of the sample, ascending.
  const std::vector<std::uint64_t>& indices() const { return indices_; }
  /// Number of particles in the input.
  std::size_t inputs() const { return inputs_; }
  /// Factor on the radii: the cube root of inputs() / size(); 1 where there is nothing.
  double enlargement() const { return enlargement_; }

  /// Has a grid over set() speak of particles by their indices in the input, in attributes too.
  CoherentGridOptions gridOptions() const;

  ParticleSample(const ParticleSample&) = delete;
  ParticleSample& operator=(const ParticleSample&) = delete;

private:
  ParticleSet set_;
  std::vector<std::uint64_t> indices_;
  std::vector<double> positions_, radii_;
  std::size_t inputs_ = 0;
  double enlargement_ = 1.0;
};

} // namespace mote
