// Storage and look-up of occlusion maps.

#include <kernels/core/Error.h>
#include <kernels/occlusion/OcclusionMaps.h>

#include <support/Particles.h>
#include <support/Structure.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr int levels = OcclusionMaps::Open + 1;

/// Maps of all levels, with texels at random.
OcclusionMaps::Piece randomPiece(std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  OcclusionMaps::Piece piece;
  for (std::size_t k = 0; k < count; ++k)
  {
    const int level = static_cast<int>(random(0.0, levels + 1));
    piece.levels.push_back(
      static_cast<std::uint8_t>(level == levels ? int(OcclusionMaps::NotBaked) : level));
    const auto texels =
      OcclusionMaps::texelsOf(static_cast<OcclusionMaps::Level>(piece.levels.back()));
    for (std::size_t i = 0; i < texels; ++i)
      piece.texels.push_back(static_cast<std::uint8_t>(random(0.0, 256.0)));
  }
  return piece;
}

OcclusionMaps mapsOf(const OcclusionMaps::Piece& piece, const OcclusionSky& sky = {})
{
  return OcclusionMaps(std::span(&piece, 1), sky);
}

/// One particle with a map of `side` x `side` texels at random.
OcclusionMaps oneMap(int side, std::uint64_t seed, const OcclusionSky& sky = {})
{
  Random random(seed);
  OcclusionMaps::Piece piece;
  piece.levels = {OcclusionMaps::levelOf(side)};
  for (int i = 0; i < side * side; ++i)
    piece.texels.push_back(static_cast<std::uint8_t>(random(0.0, 256.0)));
  return mapsOf(piece, sky);
}

/// Direction at row and column of a map of `side` texels, which may be fractions.
Vec3f directionAt(double row, double column, int side)
{
  const double theta = M_PI * row / side, phi = 2.0 * M_PI * column / side;
  return Vec3f(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
}

/// The look-up by its definition, in double.
double bilinear(const OcclusionMaps& maps, std::size_t particle, const Vec3d& n)
{
  const int side = OcclusionMaps::side(maps.level(particle));
  const auto map = maps.texels(particle);
  const double v = std::acos(std::clamp(n.z, -1.0, 1.0)) / M_PI * side - 0.5;
  const double u = std::atan2(n.y, n.x) / (2.0 * M_PI) * side - 0.5;
  double value = 0.0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
    {
      int row = static_cast<int>(std::floor(v)) + i, column = static_cast<int>(std::floor(u)) + j;
      const double share = (1.0 - std::abs(v - row)) * (1.0 - std::abs(u - column));
      if (row < 0 || row == side)
      {
        row = row < 0 ? 0 : side - 1;
        column += side / 2;
      }
      const double q =
        map[static_cast<std::size_t>(row * side + (column + 2 * side) % side)] / 255.0;
      value += share * maps.maximum() * q * q;
    }
  return value;
}

bool isSame(const OcclusionMaps& a, std::size_t i, const OcclusionMaps& b, std::size_t k)
{
  const auto one = a.texels(i), other = b.texels(k);
  return a.level(i) == b.level(k) && std::equal(one.begin(), one.end(), other.begin(), other.end());
}

} // namespace

TEST(OcclusionMaps, KeepsWhatItIsGiven)
{
  const OcclusionMaps::Piece pieces[3] = {
    randomPiece(37, 1), OcclusionMaps::Piece(), randomPiece(100, 2)};
  const OcclusionMaps maps(pieces);
  ASSERT_EQ(maps.size(), 137u);
  std::size_t particle = 0, texels = 0;
  for (const OcclusionMaps::Piece& piece : pieces)
  {
    auto from = piece.texels.begin();
    for (const std::uint8_t level : piece.levels)
    {
      ASSERT_EQ(maps.level(particle), level);
      const auto map = maps.texels(particle++);
      ASSERT_TRUE(std::equal(map.begin(), map.end(), from)) << particle - 1;
      from += static_cast<std::ptrdiff_t>(map.size());
    }
    texels += piece.texels.size();
  }
  EXPECT_EQ(maps.texels().size(), texels);
  EXPECT_EQ(maps.bytes(), texels + 16 * 9); // one byte a particle, in blocks of 16
}

TEST(OcclusionMaps, RefusesWhatDoesNotFit)
{
  OcclusionMaps::Piece piece = randomPiece(20, 3);
  piece.texels.push_back(1);
  EXPECT_THROW(mapsOf(piece), Error);
  piece = randomPiece(20, 3);
  piece.levels[7] = 9;
  EXPECT_THROW(mapsOf(piece), Error);
  EXPECT_THROW(OcclusionMaps(3, {0.0f, 0.0f}), Error);
  EXPECT_THROW(OcclusionMaps(3, {1.0f, -0.5f}), Error);
  EXPECT_THROW(OcclusionMaps(3, {1.0f, std::numeric_limits<float>::infinity()}), Error);
  for (const int side : {0, 3, 64, -1})
    EXPECT_THROW(OcclusionMaps::levelOf(side), Error) << side;
}

TEST(OcclusionMaps, MiddlesOfTexelsHaveTheirValues)
{
  for (const int side : {1, 2, 4, 8, 16, 32})
  {
    const OcclusionMaps maps = oneMap(side, 10);
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
      {
        const float q = maps.texels(0)[static_cast<std::size_t>(row * side + column)];
        EXPECT_NEAR(maps.at(0, directionAt(row + 0.5, column + 0.5, side)), maps.decoded(q), 1e-3)
          << side << " " << row << " " << column;
      }
  }
}

TEST(OcclusionMaps, LooksUpBilinearly)
{
  const OcclusionSky sky{2.0f, 0.5f, {0.0f, 1.0f, 0.0f}};
  const OcclusionMaps maps = mapsOf(randomPiece(200, 4), sky);
  Random random(5);
  constexpr int count = 256;
  for (int repeat = 0; repeat < 40; ++repeat)
  {
    std::uint64_t particles[count];
    float nx[count], ny[count], nz[count], values[count];
    const int used = repeat < 20 ? count : repeat - 19; // short blocks, too
    for (int i = 0; i < used; ++i)
    {
      particles[i] = static_cast<std::uint64_t>(random(0.0, 200.0));
      const Vec3d n = random.direction();
      nx[i] = static_cast<float>(n.x);
      ny[i] = static_cast<float>(n.y);
      nz[i] = static_cast<float>(n.z);
    }
    maps.lookUp(particles, nx, ny, nz, used, values);
    for (int i = 0; i < used; ++i)
    {
      const Vec3f n(nx[i], ny[i], nz[i]);
      const OcclusionMaps::Level level = maps.level(particles[i]);
      if (level == OcclusionMaps::NotBaked)
        EXPECT_TRUE(std::isnan(values[i]));
      else if (level == OcclusionMaps::Dark)
        EXPECT_EQ(values[i], 0.0f);
      else if (level == OcclusionMaps::Open)
        EXPECT_NEAR(values[i], 1.25 + 0.5 * n.y, 1e-6); // 2/3 of the sky's slope
      else
        EXPECT_NEAR(values[i], bilinear(maps, particles[i], Vec3d(n)), 2e-3);
    }
  }
}

TEST(OcclusionMaps, SeamAndPolesAreContinuous)
{
  constexpr double step = 1e-3; // radians
  for (const int side : {2, 4, 8, 16, 32})
  {
    const OcclusionMaps maps = oneMap(side, 11);
    // Across the seam, all along it; a texel's whole range within its width is the steepest slope.
    const double slope = side / M_PI * 1.01;
    for (double theta = 0.01; theta < M_PI; theta += 0.01)
    {
      const Vec3f east(
        std::sin(theta) * std::cos(step), -std::sin(theta) * std::sin(step), std::cos(theta));
      const Vec3f west(east.x, -east.y, east.z);
      EXPECT_NEAR(maps.at(0, east), maps.at(0, west), slope * step + 1e-3) << side << " " << theta;
    }
    // Over the poles, in a straight line.
    for (double phi = 0.0; phi < M_PI; phi += 0.01)
      for (const float z : {1.0f, -1.0f})
      {
        const Vec3f from(step * std::cos(phi), step * std::sin(phi), z);
        const Vec3f to(-from.x, -from.y, z);
        EXPECT_NEAR(maps.at(0, from), maps.at(0, to), 2.0 * slope * step + 1e-3)
          << side << " " << phi;
      }
    EXPECT_FALSE(std::isnan(maps.at(0, {0.0f, 0.0f, 1.0f})));
    EXPECT_FALSE(std::isnan(maps.at(0, {0.0f, 0.0f, -1.0f})));
    EXPECT_FALSE(std::isnan(maps.at(0, {0.0f, 0.0f, 1.0000001f})));
  }
}

TEST(OcclusionMaps, BytesAreTheNearest)
{
  const OcclusionMaps maps(1, {3.0f, 1.0f});
  for (int q = 0; q < 256; ++q)
    EXPECT_EQ(maps.encoded(maps.decoded(static_cast<float>(q))), q);
  Random random(12);
  double most = 0.0;
  for (int k = 0; k < 10000; ++k)
  {
    const auto value = static_cast<float>(random(0.0, 3.0));
    const int q = maps.encoded(value);
    const double error = std::abs(double(maps.decoded(static_cast<float>(q))) - value);
    for (const int other : {q - 1, q + 1})
      if (other >= 0 && other < 256)
      {
        EXPECT_LE(error, std::abs(double(maps.decoded(static_cast<float>(other))) - value) + 1e-6);
      }
    most = std::max(most, error);
  }
  // Half the widest step, that from 254 to 255.
  EXPECT_LE(most, 3.0 * (255.0 * 255.0 - 254.0 * 254.0) / (255.0 * 255.0) / 2.0 + 1e-6);
  EXPECT_EQ(maps.encoded(-1.0f), 0);
  EXPECT_EQ(maps.encoded(4.0f), 255);
}

TEST(OcclusionMaps, OrderOfSlotsAndOfTheInput)
{
  Particles particles = randomParticles(300, 13, 0.01, 0.05);
  for (const std::size_t unfit : {std::size_t(0), std::size_t(150), std::size_t(298)})
    particles.radii[unfit] = -1.0;
  for (const auto kind : particleKinds)
  {
    ParticleStructureOptions options;
    options.kind = kind;
    const auto structure = makeParticleStructure(particles.set(), options);
    const OcclusionMaps bySlot = mapsOf(randomPiece(297, 14));
    const OcclusionMaps byInput = bySlot.inInputOrder(*structure, 300);
    ASSERT_EQ(byInput.size(), 300u);
    for (std::size_t slot = 0; slot < 297; ++slot)
      EXPECT_TRUE(isSame(bySlot, slot, byInput,
        withStructure(*structure, [&](const auto& s) { return s.inputIndex(slot); })));
    for (const std::size_t unfit : {std::size_t(0), std::size_t(150), std::size_t(298)})
      EXPECT_FALSE(byInput.isBaked(unfit));
    const OcclusionMaps back = byInput.inSlotOrder(*structure);
    ASSERT_EQ(back.size(), 297u);
    for (std::size_t slot = 0; slot < 297; ++slot)
      EXPECT_TRUE(isSame(bySlot, slot, back, slot));
    EXPECT_THROW(byInput.inInputOrder(*structure, 300), Error);
    EXPECT_THROW(bySlot.inInputOrder(*structure, 299), Error);
    EXPECT_THROW(mapsOf(randomPiece(299, 15)).inSlotOrder(*structure), Error);
  }
}

TEST(OcclusionMaps, NewerOnesReplaceOlderOnes)
{
  const OcclusionMaps older = mapsOf(randomPiece(100, 16)), newer = mapsOf(randomPiece(100, 17));
  const OcclusionMaps maps = older.updated(newer);
  for (std::size_t k = 0; k < 100; ++k)
    EXPECT_TRUE(isSame(maps, k, newer.isBaked(k) ? newer : older, k));
  EXPECT_THROW(older.updated(mapsOf(randomPiece(99, 17))), Error);
  EXPECT_THROW(older.updated(mapsOf(randomPiece(100, 17), {1.0f, 0.0f})), Error);
}
