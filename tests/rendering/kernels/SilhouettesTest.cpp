// Silhouettes of depth images: where they are, where none must be, and what background, groups
// and options do.

#include <kernels/imaging/Silhouettes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

using namespace mote;

namespace
{

constexpr float nothing = std::numeric_limits<float>::infinity();

/// A depth image of one's own making. `at` gets pixel coordinates.
struct Picture
{
  Picture(int w, int h, const std::function<float(int, int)>& at)
    : depth(static_cast<std::size_t>(w) * h)
  {
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        depth[static_cast<std::size_t>(y) * w + x] = at(x, y);
    image.width = w;
    image.height = h;
    image.depth = depth.data();
    image.pixelSize = 1.0;
  }

  std::vector<float> coverage(const SilhouetteOptions& options, int threads = 1) const
  {
    std::vector<float> out(static_cast<std::size_t>(reducedSize(image.width, options.reduction)) *
                             reducedSize(image.height, options.reduction),
      0.0f);
    findSilhouettes(image, options, out.data(), threads);
    return out;
  }

  std::vector<float> depth;
  DepthImage image;
};

/// Lines on the farther pixels alone, which are covered or not.
SilhouetteOptions onPixels(double step)
{
  SilhouetteOptions options;
  options.step = step;
  options.stepInPixels = 0.0;
  options.centered = false;
  return options;
}

int count(const std::vector<float>& coverage)
{
  return static_cast<int>(
    std::count_if(coverage.begin(), coverage.end(), [](float e) { return e > 0; }));
}

} // namespace

TEST(Silhouettes, StraightBordersOfMoreThanTheStepHaveOneLine)
{
  for (const double height : {0.99, 1.01, 50.0, 1e6})
  {
    for (const bool upright : {true, false})
    {
      const Picture picture(70, 67,
        [&](int x, int y) { return (upright ? x : y) < 30 ? 10.0f : float(10.0 + height); });
      const auto coverage = picture.coverage(onPixels(1.0));
      for (int y = 0; y < 67; ++y)
        for (int x = 0; x < 70; ++x)
          ASSERT_EQ(coverage[y * 70 + x], height > 1.0 && (upright ? x : y) == 30 ? 1.0f : 0.0f)
            << x << " " << y << " " << height;
    }
  }
}

TEST(Silhouettes, DiagonalBordersHaveALineOfOnePixel)
{
  const Picture picture(64, 64, [](int x, int y) { return x + y < 60 ? 10.0f : 100.0f; });
  const auto coverage = picture.coverage(onPixels(1.0));
  for (int y = 1; y < 63; ++y)
    for (int x = 1; x < 63; ++x)
      ASSERT_EQ(coverage[y * 64 + x], x + y == 60 ? 1.0f : 0.0f) << x << " " << y;
}

TEST(Silhouettes, PlanesHaveNone)
{
  // Seen in perspective with half of the right angle, at tilts up to 89 degrees.
  for (const double tilt : {0.0, 30.0, 60.0, 80.0, 89.0})
    for (const double turn : {0.0, 20.0, 90.0, 200.0})
    {
      const double a = tilt * M_PI / 180.0, b = turn * M_PI / 180.0;
      const double dx = 1.0 / 256.0;
      Picture picture(256, 256,
        [&](int x, int y)
        {
          const double u = (x + 0.5 - 128) * dx, v = (y + 0.5 - 128) * dx;
          // n . p = n . (0, 0, 100)
          const double n[3] = {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
          const double t = 100.0 * n[2] / (n[0] * u + n[1] * v + n[2]);
          return t > 0.0 && t < 1e5 ? static_cast<float>(t) : nothing;
        });
      picture.image.pixelSize = 0.0;
      picture.image.dx = picture.image.dy = dx;
      picture.image.x0 = picture.image.y0 = -128 * dx;
      SilhouetteOptions options = onPixels(0.0);
      options.hulls = false;
      EXPECT_EQ(count(picture.coverage(options)), 0) << tilt << " " << turn;
    }
}

TEST(Silhouettes, BackgroundHasOneLineAroundSurfaces)
{
  for (const float background : {nothing, -nothing, std::nanf(""), 1e10f})
  {
    Picture picture(40, 40,
      [&](int x, int y) { return x >= 10 && x < 20 && y >= 12 && y < 30 ? 5.0f : background; });
    picture.image.background = 1e9f;
    const auto coverage = picture.coverage(onPixels(1.0));
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x)
      {
        const bool beside =
          (y >= 12 && y < 30 && (x == 9 || x == 20)) || (x >= 10 && x < 20 && (y == 11 || y == 30));
        ASSERT_EQ(coverage[y * 40 + x], beside ? 1.0f : 0.0f) << x << " " << y;
      }
    SilhouetteOptions without = onPixels(1.0);
    without.hulls = false;
    EXPECT_EQ(count(picture.coverage(without)), 0);
  }
}

TEST(Silhouettes, ImagesOfOnePixelAndOfOneRow)
{
  for (const float value : {1.0f, nothing, std::nanf("")})
    EXPECT_EQ(count(Picture(1, 1, [&](int, int) { return value; }).coverage(onPixels(1.0))), 0);
  const auto step = [](int i, int) { return i < 20 ? 1.0f : 9.0f; };
  for (const int length : {2, 3, 21, 22, 100})
  {
    const int expected = length > 21 ? 1 : 0; // none across the image's border
    EXPECT_EQ(count(Picture(length, 1, step).coverage(onPixels(1.0))), expected);
    const auto upright = [&](int x, int y) { return step(y, x); };
    EXPECT_EQ(count(Picture(1, length, upright).coverage(onPixels(1.0))), expected);
    EXPECT_EQ(count(Picture(2, length, upright).coverage(onPixels(1.0))), 2 * expected);
  }
  const Picture none(0, 0, [](int, int) { return 0.0f; });
  none.coverage(onPixels(1.0));
}

TEST(Silhouettes, ThreadsAndPartsMakeNoDifference)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0.0f, 20.0f);
  const int w = 301, h = 259;
  std::vector<std::uint64_t> groups;
  Picture picture(w, h,
    [&](int, int)
    {
      const float v = uniform(random);
      groups.push_back(static_cast<std::uint64_t>(v) % 3);
      return v < 4.0f ? nothing : v;
    });
  picture.image.group = groups.data();
  SilhouetteOptions options;
  options.step = 4.0;
  options.thickness = 3.3;
  options.leastThickness = 0.3;
  options.leastOpacity = 0.2;
  for (const int reduction : {1, 2, 3})
  {
    options.reduction = reduction;
    const auto whole = picture.coverage(options, 1);
    EXPECT_GT(count(whole), 1000);
    EXPECT_EQ(picture.coverage(options, 0), whole);
    EXPECT_EQ(picture.coverage(options, 2), whole);
    // Each part from no more of the image than the margin says.
    const int rw = reducedSize(w, reduction), rh = reducedSize(h, reduction);
    const int margin = silhouetteMargin(options);
    std::vector<float> parts(whole.size(), 0.0f);
    for (int y0 = 0; y0 < rh; y0 += 37)
      for (int x0 = 0; x0 < rw; x0 += 23)
      {
        const int left = std::max(0, x0 - margin), low = std::max(0, y0 - margin);
        const int right = std::min(w, (x0 + 23 + margin) * reduction);
        const int top = std::min(h, (y0 + 37 + margin) * reduction);
        DepthImage part = picture.image;
        part.width = right - left * reduction;
        part.height = top - low * reduction;
        const std::ptrdiff_t first = std::ptrdiff_t(low) * reduction * w + left * reduction;
        part.depth += first;
        part.group += first;
        part.depthStride = part.groupStride = w;
        const PixelBox box = {
          x0 - left, y0 - low, std::min(rw, x0 + 23) - left, std::min(rh, y0 + 37) - low};
        findSilhouettes(part, options, box, parts.data() + std::ptrdiff_t(y0) * rw + x0, rw);
      }
    EXPECT_EQ(parts, whole) << reduction;
  }
}

TEST(Silhouettes, GroupsHaveALineOnTheFartherSide)
{
  // Three upright strips: groups 7, 3, 3, and nothing to the right.
  const auto lineAt = [](float left, float right)
  {
    const int w = 40, h = 9;
    Picture picture(w, h, [&](int x, int) { return x < 20 ? left : x < 35 ? right : nothing; });
    std::vector<std::uint64_t> groups;
    for (int i = 0; i < w * h; ++i)
      groups.push_back(i % w < 20 ? 7 : i % w < 30 ? 3 : 3 + (i % w >= 35));
    picture.image.group = groups.data();
    SilhouetteOptions options = onPixels(5.0);
    options.hulls = false;
    const auto coverage = picture.coverage(options);
    int line = -1;
    for (int i = 0; i < w * h; ++i)
      if (coverage[i] != 0.0f)
      {
        EXPECT_EQ(coverage[i], 1.0f);
        EXPECT_TRUE(line < 0 || line == i % w);
        line = i % w;
      }
    EXPECT_EQ(count(coverage), h);
    return line;
  };
  EXPECT_EQ(lineAt(10.0f, 10.0f), 19); // the larger group
  EXPECT_EQ(lineAt(10.0f, 10.5f), 20); // the farther, with a step that makes none
  EXPECT_EQ(lineAt(10.5f, 10.0f), 19);
  EXPECT_EQ(lineAt(10.0f, 30.0f), 20); // and with one that is
}

TEST(Silhouettes, LinesAreAsThickAndDarkAsTheirStep)
{
  SilhouetteOptions options;
  options.stepInPixels = 0.0;
  options.fullStep = 16.0;
  // What a line covers across itself is its thickness times its opacity. Coverage and opacities are
  // multiples of 1 / 254.
  const double rounding = 0.02;
  const auto across = [&](double step, bool upright)
  {
    const Picture picture(
      41, 41, [&](int x, int y) { return (upright ? x : y) < 20 ? 5.0f : float(5.0 + step); });
    const auto coverage = picture.coverage(options);
    double sum = 0.0;
    for (int k = 0; k < 41; ++k)
      sum += coverage[upright ? 20 * 41 + k : k * 41 + 20];
    return sum;
  };
  for (const bool upright : {true, false})
    for (const double thickness : {0.5, 1.0, 2.0, 3.5, 7.0})
    {
      options.thickness = thickness;
      options.leastOpacity = 1.0;
      EXPECT_NEAR(across(2.0, upright), thickness, rounding);
      EXPECT_NEAR(across(1e9, upright), thickness, rounding);
      options.leastOpacity = 0.2;
      EXPECT_NEAR(across(1.0001, upright), 0.2 * thickness, rounding);
      EXPECT_NEAR(across(4.0, upright), 0.6 * thickness, rounding); // half of the way to 16
      EXPECT_NEAR(across(16.0, upright), thickness, rounding);
    }
  options.leastThickness = 0.25; // a share of
  options.thickness = 4.0;
  options.leastOpacity = 1.0;
  EXPECT_NEAR(across(1.0001, true), 1.0, rounding);
  EXPECT_NEAR(across(16.0, true), 4.0, rounding);
  EXPECT_NEAR(across(4.0, true), 2.5, 3.0 / 7); // in eight steps
}

TEST(Silhouettes, PitsOfOnePixelHaveNoOutline)
{
  for (const float bottom : {90.0f, nothing})
    for (const int width : {1, 2, 3})
    {
      // What is seen of the bottom of a pit is beside its border.
      const Picture picture(
        30, 30, [&](int x, int y) { return x >= 9 && x < 9 + width && y == 20 ? bottom : 5.0f; });
      EXPECT_EQ(count(picture.coverage(onPixels(1.0))), width == 1 ? 0 : width);
    }
}

TEST(Silhouettes, WeakerSilhouettesDoNotEraseStrongerOnes)
{
  const Picture picture(30, 5, [](int x, int) { return x < 15 ? 1.0f : 9.0f; });
  std::vector<float> coverage(150, 0.75f);
  SilhouetteOptions options;
  findSilhouettes(picture.image, options, coverage.data());
  EXPECT_EQ(coverage[2 * 30 + 15], 0.75f); // 0.5 of the line
  EXPECT_EQ(coverage[2 * 30 + 3], 0.75f);
}

TEST(Silhouettes, FootprintsLimitTheStepByDistance)
{
  // Steps of 2 units; a pixel is 0.01 of the distance wide.
  for (const double distance : {50.0, 99.0, 101.0, 500.0})
  {
    Picture picture(
      32, 32, [&](int x, int) { return static_cast<float>(x < 16 ? distance - 2.0 : distance); });
    picture.image.pixelSize = 0.0;
    picture.image.dx = picture.image.dy = 0.01;
    picture.image.x0 = picture.image.y0 = -0.16;
    picture.image.alongRays = true;
    SilhouetteOptions options = onPixels(0.5);
    options.stepInPixels = 2.0;
    EXPECT_EQ(count(picture.coverage(options)), distance < 100.0 ? 32 : 0) << distance;
  }
}
