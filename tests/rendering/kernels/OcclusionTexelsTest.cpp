// One particle's map while it is baked: what coarser maps err by, and which maps still hold.

#include <kernels/occlusion/ParticleOcclusion.h>
#include <kernels/occlusion/detail/OcclusionTexels.h>

#include <gtest/gtest.h>

#include <functional>

using namespace mote;

namespace
{

/// A map of the sides' values by the middles of its texels, in (0, 1); all known.
OcclusionTexels texelsOf(int side, const std::function<float(float row, float column)>& value)
{
  OcclusionTexels texels;
  texels.side = side;
  for (int i = 0; i < texels.count(); ++i)
  {
    const auto middle = [&](int at) { return (float(at) + 0.5f) / float(side); };
    texels.value[std::size_t(i)] = value(middle(i / side), middle(i % side));
    texels.weight[std::size_t(i)] = OcclusionTexels::area(side, i / side);
  }
  return texels;
}

/// Forgets what lies within two texels of the coarse map from its borders, where it goes on beyond
/// the poles and round the seam, and is not linear.
OcclusionTexels innerOf(OcclusionTexels texels)
{
  const int rim = texels.side / 4;
  for (int i = 0; i < texels.count(); ++i)
  {
    const int row = i / texels.side, column = i % texels.side;
    if (std::min(row, column) < rim || std::max(row, column) >= texels.side - rim)
      texels.weight[std::size_t(i)] = 0.0f;
  }
  return texels;
}

} // namespace

TEST(OcclusionTexels, CoarserMapsAreLookedUpWhereTheFinerTexelsAre)
{
  const auto linear = [](float row, float column) { return 0.1f + 0.3f * row + 0.5f * column; };
  const OcclusionTexels fine = innerOf(texelsOf(16, linear));
  EXPECT_LT(fine.error(texelsOf(8, linear), 1.0f), 1e-6);
  // An offset is told as it is, as far as each texel counts: by its weight and brightness.
  const auto lighter = [&](float row, float column) { return linear(row, column) + 0.01f; };
  double counted = 0.0;
  for (int i = 0; i < fine.count(); ++i)
    counted += double(fine.weight[std::size_t(i)]) * fine.value[std::size_t(i)];
  EXPECT_NEAR(fine.error(texelsOf(8, lighter), 1.0f), 0.01 * std::sqrt(counted), 1e-6);
  EXPECT_NEAR(fine.error(texelsOf(8, lighter), 2.0f), 0.005 * std::sqrt(0.5 * counted), 1e-6);
}

TEST(OcclusionTexels, RowsBeyondAPoleLieHalfATurnFurther)
{
  EXPECT_EQ(OcclusionTexels::texelAt(8, 3, 5), 3 * 8 + 5);
  EXPECT_EQ(OcclusionTexels::texelAt(8, 3, -1), 3 * 8 + 7);
  EXPECT_EQ(OcclusionTexels::texelAt(8, 3, 8), 3 * 8);
  EXPECT_EQ(OcclusionTexels::texelAt(8, -1, 1), 5);
  EXPECT_EQ(OcclusionTexels::texelAt(8, 8, 6), 7 * 8 + 2);
}

TEST(OcclusionTexels, AreasAreThatOfTheSphere)
{
  for (const int side : {1, 2, 4, 32})
  {
    double sum = 0.0;
    for (int row = 0; row < side; ++row)
    {
      sum += side * double(OcclusionTexels::area(side, row));
      EXPECT_NEAR(
        OcclusionTexels::area(side, row), OcclusionTexels::area(side, side - 1 - row), 1e-7);
    }
    EXPECT_NEAR(sum, 1.0, 1e-6) << side;
  }
}

TEST(OcclusionTexels, CoarserOnesAreMeansOfBrightPlaces)
{
  // Places count by weight and brightness: that of four equal ones is theirs.
  const OcclusionTexels even = texelsOf(8, [](float, float) { return 0.4f; });
  const OcclusionTexels coarse = even.coarser();
  ASSERT_EQ(coarse.side, 4);
  float whole = 0.0f;
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_NEAR(coarse.value[std::size_t(i)], 0.4f, 1e-6f);
    whole += coarse.weight[std::size_t(i)];
  }
  EXPECT_NEAR(whole, 1.0f, 1e-5f);
  OcclusionTexels uneven = even;
  uneven.value[0] = 0.8f; // row 0, column 0
  const double area = OcclusionTexels::area(8, 0), below = OcclusionTexels::area(8, 1);
  const double part = area * 0.801, others = area * 0.401 + 2.0 * below * 0.401;
  EXPECT_NEAR(uneven.coarser().value[0], (part * 0.8 + others * 0.4) / (part + others), 1e-6);
  EXPECT_NEAR(uneven.coarser().value[1], 0.4f, 1e-6f);
}

TEST(OcclusionTexels, UnknownOnesAreFilledFromThoseAround)
{
  OcclusionTexels texels = texelsOf(8, [](float, float) { return 0.0f; });
  texels.weight.fill(0.0f);
  for (const auto& [at, value] : {std::pair(3 * 8 + 2, 0.2f), std::pair(3 * 8 + 4, 0.6f)})
  {
    texels.weight[std::size_t(at)] = 0.1f;
    texels.value[std::size_t(at)] = value;
  }
  texels.dilate();
  EXPECT_NEAR(texels.value[3 * 8 + 3], 0.4f, 1e-6f); // between the two
  EXPECT_NEAR(texels.value[3 * 8 + 1], 0.2f, 1e-6f); // beside one
  EXPECT_NEAR(texels.value[4 * 8 + 5], 0.6f, 1e-6f);
  EXPECT_EQ(texels.value[3 * 8 + 2], 0.2f); // known
  for (int i = 0; i < texels.count(); ++i)
  {
    EXPECT_GE(texels.value[std::size_t(i)], 0.2f) << i;
    EXPECT_LE(texels.value[std::size_t(i)], 0.6f) << i;
  }
}

TEST(OcclusionTexels, StoredMapsHoldOnlyForTheirOwnSettings)
{
  OcclusionBakeOptions options;
  options.reach = 2.0;
  StoredOcclusion stored;
  stored.side = options.side;
  stored.samples = options.samples;
  stored.reach = options.reach;
  stored.tolerance = options.tolerance;
  stored.adaptive = options.adaptive;
  stored.dilate = options.dilate;
  stored.maps = OcclusionMaps({}, options.sky);
  ASSERT_TRUE(wereBakedWith(stored, options));
  const auto isKept = [&](auto change)
  {
    OcclusionBakeOptions other = options;
    change(other);
    return wereBakedWith(stored, other);
  };
  EXPECT_FALSE(isKept([](auto& o) { o.side = 8; }));
  EXPECT_FALSE(isKept([](auto& o) { o.samples = 50; }));
  EXPECT_FALSE(isKept([](auto& o) { o.reach = 2.5; }));
  EXPECT_FALSE(isKept([](auto& o) { o.adaptive = false; }));
  EXPECT_FALSE(isKept([](auto& o) { o.tolerance = 0.01; }));
  EXPECT_FALSE(isKept([](auto& o) { o.dilate = false; }));
  EXPECT_FALSE(isKept([](auto& o) { o.sky.top *= 0.5f; }));
  // Full maps have no tolerance.
  stored.adaptive = options.adaptive = false;
  EXPECT_TRUE(isKept([](auto& o) { o.tolerance = 0.01; }));
}
