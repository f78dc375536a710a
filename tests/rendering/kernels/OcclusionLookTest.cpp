// Pictures whose ambient light is looked up in maps, and which particles a picture shows.

#include "ShadowParts.h"

#include <kernels/tracing/SeenParticles.h>

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstring>
#include <set>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Maps of all levels with texels at random; one particle in `share` is not baked.
std::shared_ptr<const OcclusionMaps> randomMaps(std::size_t count, std::uint64_t seed, int share)
{
  Random random(seed);
  OcclusionMaps::Piece piece;
  for (std::size_t k = 0; k < count; ++k)
  {
    const bool known = share == 0 || random(0.0, share) >= 1.0;
    piece.levels.push_back(known ? static_cast<std::uint8_t>(random(0.0, OcclusionMaps::Open + 1))
                                 : std::uint8_t{OcclusionMaps::NotBaked});
    const auto texels =
      OcclusionMaps::texelsOf(static_cast<OcclusionMaps::Level>(piece.levels.back()));
    for (std::size_t i = 0; i < texels; ++i)
      piece.texels.push_back(static_cast<std::uint8_t>(random(0.0, 256.0)));
  }
  return std::make_shared<OcclusionMaps>(std::span(&piece, 1));
}

/// Two heaps of particles, one of them turned and scaled unevenly, in a light that casts shadows.
struct Heaps
{
  Scene scene;
  Camera camera = lookAt({1.0, 2.0, 6.0}, Vec3d(0.0), 40.0);

  explicit Heaps(float ambient = 0.5f, float diffuse = 0.5f)
  {
    Mat4d place = glm::rotate(Mat4d(1.0), 0.7, Vec3d(1.0, 2.0, 3.0));
    place = glm::scale(glm::translate(place, Vec3d(0.4, -0.2, 0.5)), Vec3d(1.0, 0.4, 1.7));
    addTo(scene, objectOf(randomParticles(150, 3, 0.1, 0.3)));
    addTo(scene, objectOf(randomParticles(150, 4, 0.1, 0.3), place));
    for (SurfaceObject& object : scene.surfaces)
    {
      object.material.ambient = ambient;
      object.material.diffuse = diffuse;
    }
    scene.lights = {shadowLight(Light::Kind::Directional, {-1.0, -1.0, -0.5})};
  }

  /// Gives all objects maps; one particle in `share` has none.
  void bake(int share = 0)
  {
    for (SurfaceObject& object : scene.surfaces)
      object.occlusion =
        randomMaps(withSurface(object.surface, [](const auto& s) { return s.slots(); }), 5, share);
  }

  Film traced(int size = 97) const { return tracedFilm(scene, camera, size); }
};

bool areEqual(const Film& a, const Film& b)
{
  return std::memcmp(a.color(), b.color(), 4 * a.pixels() * sizeof(float)) == 0;
}

} // namespace

TEST(OcclusionLook, PicturesShowWhatTheMapsSay)
{
  Heaps heaps(1.0f, 0.0f);
  heaps.bake();
  heaps.scene.lights.clear();
  constexpr int size = 97;
  const Film film = heaps.traced(size);
  const CameraRays rays(heaps.camera, size, size);
  int hits[2] = {0, 0};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
    {
      const auto at =
        pick(heaps.scene, rays.originAt(x + 0.5, y + 0.5), rays.directionAt(x + 0.5, y + 0.5));
      if (!at)
        continue;
      ++hits[std::size_t(at->object)];
      const SurfaceObject& object = heaps.scene.surfaces[std::size_t(at->object)];
      const Vec3d local = glm::normalize(glm::transpose(Mat3d(object.toWorld)) * at->normal);
      const float wanted = withStructure(*particlesOf(object),
        [&](const auto& s)
        {
          std::size_t slot = 0;
          while (s.inputIndex(slot) != at->id)
            ++slot;
          return object.occlusion->at(slot, Vec3f(local));
        });
      // A texel differs from the next by up to 1 within pi / 32 of a normal.
      EXPECT_NEAR(film.color()[4 * (std::size_t(y) * size + x)], wanted, 2e-3) << x << " " << y;
    }
  EXPECT_GT(hits[0], 500);
  EXPECT_GT(hits[1], 500);
}

TEST(OcclusionLook, WhatHasNoMapIsLitByRaysOrAllAlike)
{
  Heaps heaps;
  const Film plain = heaps.traced();
  heaps.scene.occlusion = {4, 0.5};
  const Film live = heaps.traced();
  EXPECT_FALSE(areEqual(plain, live));

  for (SurfaceObject& object : heaps.scene.surfaces)
    object.occlusion = std::make_shared<OcclusionMaps>(
      withSurface(object.surface, [](const auto& s) { return s.slots(); }));
  EXPECT_TRUE(areEqual(live, heaps.traced()));
  heaps.scene.occlusion.rays = 0;
  const Film even = heaps.traced();
  const Film dim = Heaps(0.3f).traced(); // sees 0.6 of the sky
  for (std::size_t i = 0; i < 4 * even.pixels(); ++i)
    ASSERT_NEAR(even.color()[i], dim.color()[i], 1e-6) << i;

  // Some known: every pixel is one of the two.
  heaps.bake(2);
  const Film known = heaps.traced();
  heaps.scene.occlusion.rays = 4;
  const Film mixed = heaps.traced();
  int fromMaps = 0, fromRays = 0;
  for (std::size_t i = 0; i < mixed.pixels(); ++i)
  {
    const float red = mixed.color()[4 * i];
    const bool isKnown = red == known.color()[4 * i], isLive = red == live.color()[4 * i];
    EXPECT_TRUE(isKnown || isLive) << i;
    fromMaps += isKnown && !isLive;
    fromRays += isLive && !isKnown;
  }
  EXPECT_GT(fromMaps, 500);
  EXPECT_GT(fromRays, 500);
}

TEST(OcclusionLook, OnlyAmbientLightIsDarkened)
{
  Heaps both, direct(0.0f, 0.5f), even(0.5f, 0.0f);
  for (Heaps* heaps : {&both, &direct, &even})
    heaps->bake();
  const Film sum = both.traced(), first = direct.traced(), second = even.traced();
  for (std::size_t i = 0; i < 4 * sum.pixels(); ++i)
    if (i % 4 != 3)
    {
      EXPECT_NEAR(sum.color()[i], first.color()[i] + second.color()[i], 1e-6);
    }
  Heaps unmapped(0.0f, 0.5f);
  EXPECT_TRUE(areEqual(first, unmapped.traced())) << "direct light and shadows stay as they are";
}

TEST(OcclusionLook, PathsKnowNoMaps)
{
  Heaps heaps;
  heaps.scene.paths.bounces = 3;
  const Film without = heaps.traced(40);
  heaps.bake();
  EXPECT_TRUE(areEqual(without, heaps.traced(40)));
}

TEST(OcclusionLook, SpheresSeenFromWithinHaveNoMap)
{
  Scene scene = oneSphere();
  scene.surfaces[0].material.ambient = 1.0f;
  const Camera inside = lookAt({0.1, 0.2, 0.0}, {0.0, 0.0, -1.0}, 60.0);
  const Film plain = tracedFilm(scene, inside, 20);
  scene.surfaces[0].occlusion = randomMaps(1, 1, 0);
  EXPECT_TRUE(areEqual(plain, tracedFilm(scene, inside, 20)));
}

TEST(OcclusionLook, SeenParticlesAreThoseOfThePictures)
{
  const Heaps heaps;
  const int width = 101, height = 67; // no multiples of a bundle's side
  constexpr int samples = 3;
  SeenParticles seen;
  ASSERT_TRUE(findSeenParticles(heaps.scene, heaps.camera, {width, height, samples}, seen));
  // The ids of films whose only sample is the one that is asked about, by moving the camera.
  std::set<std::pair<std::size_t, std::uint64_t>> wanted;
  for (int sample = 0; sample < samples; ++sample)
  {
    double x = 0.0, y = 0.0;
    RayCaster::sampleOffset(sample, x, y);
    Camera camera = heaps.camera;
    camera.centerX += 2.0 * x / width;
    camera.centerY += 2.0 * y / height;
    const Film film = tracedFilm(heaps.scene, camera, width, height);
    for (std::size_t i = 0; i < film.pixels(); ++i)
      if (film.object()[i] >= 0)
        wanted.insert({static_cast<std::size_t>(film.object()[i]), film.id()[i]});
  }
  std::set<std::pair<std::size_t, std::uint64_t>> found;
  for (std::size_t object = 0; object < seen.size(); ++object)
    withStructure(*particlesOf(heaps.scene.surfaces[object]),
      [&](const auto& s)
      {
        ASSERT_EQ(seen[object].size(), (s.size() + 63) / 64);
        for (std::size_t slot = 0; slot < s.size(); ++slot)
          if (seen[object][slot / 64] >> (slot % 64) & 1)
            found.insert({object, s.inputIndex(slot)});
      });
  EXPECT_GT(found.size(), 60u);
  // Rounding may decide about a sphere of which one ray sees the rim.
  std::vector<std::pair<std::size_t, std::uint64_t>> differing;
  std::set_symmetric_difference(
    found.begin(), found.end(), wanted.begin(), wanted.end(), std::back_inserter(differing));
  EXPECT_LE(differing.size(), 1u);
}

TEST(OcclusionLook, NothingIsSeenBeyondTheLimits)
{
  const Heaps heaps;
  const int width = 40, height = 30;
  std::vector<float> limits(std::size_t(width) * height, 1.0f);
  SeenParticles seen;
  EXPECT_TRUE(
    findSeenParticles(heaps.scene, heaps.camera, {width, height, 1, limits.data()}, seen));
  for (const auto& bits : seen)
    for (const std::uint64_t word : bits)
      EXPECT_EQ(word, 0u);
  EXPECT_FALSE(findSeenParticles(
    heaps.scene, heaps.camera, {width, height}, seen, [](double) { return false; }));
}
