// Where the colour of a particle comes from, and from which side it is lit.

#include "SceneParts.h"

#include <kernels/tracing/RayCaster.h>

#include <support/CastOracle.h>

#include <gtest/gtest.h>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Colour of the middle of particle `i` of a row of three, seen from the front, fully lit.
Vec4f colorOf(const Scene& scene, int i)
{
  Film film;
  film.resize(1, 1);
  const Camera camera = lookAt({3.0 * i, 0.0, 9.0}, {3.0 * i, 0.0, 0.0}, 1.0);
  RayCaster(scene).addSample(camera, film);
  return {film.color()[0], film.color()[1], film.color()[2], film.color()[3]};
}

class Shading : public ::testing::Test
{
protected:
  void SetUp() override
  {
    Particles particles;
    for (int i = 0; i < 3; ++i)
      particles.add({3.0 * i, 0.0, 0.0}, 1.0);
    addTo(scene, objectOf(particles));
  }
  SurfaceColoring& coloring() { return scene.surfaces[0].coloring; }
  void expectColor(int particle, const Vec4f& wanted) const
  {
    const Vec4f found = colorOf(scene, particle);
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(found[c], wanted[c], 1e-5f) << "particle " << particle << ", channel " << c;
  }
  Scene scene;
};

} // namespace

TEST_F(Shading, ValuesGoThroughTheMapByInputIndex)
{
  const std::vector<double> values = {0.0, 0.25, 1.0};
  coloring().values = ArrayView(values.data(), 3, 1);
  coloring().map.table = {{0.0f, 0.0f, 1.0f, 1.0f}, {1.0f, 0.0f, 0.0f, 1.0f}};
  expectColor(0, {0.0f, 0.0f, 1.0f, 1.0f});
  expectColor(1, {0.25f, 0.0f, 0.75f, 1.0f});
  expectColor(2, {1.0f, 0.0f, 0.0f, 1.0f});
}

TEST_F(Shading, ComponentsAndMagnitude)
{
  const std::vector<float> values = {3.0f, 4.0f, 0.0f, 5.0f, 6.0f, 8.0f};
  coloring().values = ArrayView(values.data(), 3, 2);
  coloring().map.table = {Vec4f(0.0f, 0.0f, 0.0f, 1.0f), Vec4f(1.0f)};
  coloring().map.upper = 10.0;
  coloring().component = 1;
  expectColor(0, {0.4f, 0.4f, 0.4f, 1.0f});
  expectColor(2, {0.8f, 0.8f, 0.8f, 1.0f});
  coloring().component = ArrayView::magnitude;
  expectColor(0, {0.5f, 0.5f, 0.5f, 1.0f});
  expectColor(2, {1.0f, 1.0f, 1.0f, 1.0f});
}

TEST_F(Shading, DirectColoursOfOneToFourChannels)
{
  const std::vector<std::uint8_t> bytes = {255, 0, 51, 102, 255, 0, 0, 153, 204, 51, 255, 255};
  const auto use = [&](int channels)
  { coloring().direct = ArrayView(bytes.data(), ArrayView::Type::UInt8, 3, channels); };
  use(1);
  expectColor(0, {1.0f, 1.0f, 1.0f, 1.0f});
  expectColor(2, {0.2f, 0.2f, 0.2f, 1.0f});
  use(2); // grey and alpha, premultiplied
  expectColor(1, {0.08f, 0.08f, 0.08f, 0.4f});
  use(3);
  expectColor(0, {1.0f, 0.0f, 0.2f, 1.0f});
  use(4);
  expectColor(2, {0.8f, 0.2f, 1.0f, 1.0f});
  expectColor(0, {0.4f, 0.0f, 0.08f, 0.4f});
}

TEST_F(Shading, DirectColoursWinOverValues)
{
  const std::vector<std::uint8_t> bytes = {51, 51, 51};
  const std::vector<double> values = {1.0, 1.0, 1.0};
  coloring().values = ArrayView(values.data(), 3, 1);
  coloring().direct = ArrayView(bytes.data(), ArrayView::Type::UInt8, 3, 1);
  expectColor(1, {0.2f, 0.2f, 0.2f, 1.0f});
}

TEST_F(Shading, FromWithinTheSphereIsLitToo)
{
  Film film;
  film.resize(1, 1, Film::Normal);
  RayCaster(scene).addSample(lookAt({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 1.0), film);
  EXPECT_NEAR(film.color()[0], 1.0f, 1e-5f);
  EXPECT_NEAR(film.normal()[2], -1.0f, 1e-5f); // the normal points outwards all the same
}

TEST_F(Shading, NormalsStandOnWhatAnUnevenTransformMakesOfSpheres)
{
  Random random(811);
  for (int k = 0; k < 20; ++k)
  {
    const Mat4d place = unevenTransform(random);
    scene.surfaces[0].toWorld = place;
    const Vec3d local = random.direction();
    const Mat3d linear(place);
    const Vec3d at = Vec3d(place * Vec4d(local, 1.0));
    const Vec3d normal = glm::normalize(glm::transpose(glm::inverse(linear)) * local);
    Film film;
    film.resize(1, 1, Film::Normal);
    const Vec3d eye = at + 0.5 * normal;
    RayCaster(scene).addSample(lookAt(eye, at, 1e-3), film);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(film.normal()[c], normal[c], 1e-4) << k;
    EXPECT_NEAR(film.color()[0], 1.0f, 1e-4) << k; // seen from straight above, with a headlight
  }
}

TEST_F(Shading, LightsBehindAndNoLightsLeaveTheAmbientPart)
{
  scene.surfaces[0].material.ambient = 0.125f;
  scene.lights = {{Light::Kind::Directional, Vec3d(0.0, 0.0, 1.0), Vec3f(1.0f)}};
  expectColor(0, {0.125f, 0.125f, 0.125f, 1.0f});
  scene.lights.clear();
  expectColor(0, {0.125f, 0.125f, 0.125f, 1.0f});
}

TEST_F(Shading, ColoursDoNotExceedOne)
{
  scene.lights = {{Light::Kind::Headlight, Vec3d(0.0), Vec3f(3.0f)}};
  expectColor(0, {1.0f, 1.0f, 1.0f, 1.0f});
}
