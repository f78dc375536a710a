#pragma once

// What tests of every structure run over: the alternatives of the closed variants. A structure that
// is listed there is tested.

#include "CastOracle.h"
#include "Particles.h"

#include <kernels/hexahedra/HexStructure.h>
#include <kernels/particles/ParticleStructure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <variant>

namespace mote::testing
{

template <typename Variant>
struct TypesOfVariant;
template <typename... Structures>
struct TypesOfVariant<std::variant<Structures...>>
{
  using Types = ::testing::Types<Structures...>;
};

/// Of a suite whose tests need no more than the structure's type, for
/// TYPED_TEST_SUITE(Suite, ParticleStructures, StructureName).
template <typename Structure>
class StructureTest : public ::testing::Test
{
};

using ParticleStructures = TypesOfVariant<ParticleStructure>::Types;

struct StructureName
{
  template <typename Structure>
  static std::string GetName(int)
  {
    std::string name = Structure::name();
    std::replace(name.begin(), name.end(), '-', '_'); // filters of tests give '-' a meaning
    return name;
  }
};

/// Six views of the particles through a structure that is built with the options.
template <typename Structure>
void expectRightViews(const Particles& particles, const typename Structure::Options& options)
{
  Structure structure;
  structure.build(particles.set(), options);
  ASSERT_EQ(structure.size(), particles.size());
  const CastOracle oracle = CastOracle::forFloat(particles.set());
  Random random(3);
  CastReport report;
  for (int k = 0; k < 6; ++k)
    report.add(checkImage(
      structure, oracle, lookAt(random(1.5, 4.0) * random.direction(), Vec3d(0.0), 50.0), 32, 32));
  EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays; " << report.complaint;
}

/// A kind for each alternative of a variant, from `first` on.
template <typename Variant, typename Kind>
constexpr auto kindsOf(Kind first)
{
  std::array<Kind, std::variant_size_v<Variant>> kinds{};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    kinds[i] = static_cast<Kind>(static_cast<std::size_t>(first) + i);
  return kinds;
}

inline constexpr auto particleKinds =
  kindsOf<ParticleStructure>(ParticleStructureKind::CoherentGrid);
inline constexpr auto hexKinds = kindsOf<HexStructure>(HexStructureKind::CylindricalGrid);

} // namespace mote::testing
