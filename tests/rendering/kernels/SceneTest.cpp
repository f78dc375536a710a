// Scenes as values.

#include "SceneParts.h"

#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <functional>

using namespace mote;
using namespace mote::testing;

namespace
{

Scene someScene()
{
  Scene scene = oneSphere();
  const auto mesh = hexBlock(2, 2, 2).mesh();
  scene.clouds = {
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x; }), evenTransfer(0.5F))};
  scene.surfaces.push_back(isoSurfacesOf(scene.clouds[0], {0.5}));
  return scene;
}

} // namespace

TEST(Scene, EqualsItsCopyAndNothingElse)
{
  const Scene scene = someScene();
  EXPECT_EQ(scene, Scene(scene));
  const double value = 1.0;
  const std::function<void(Scene&)> changes[] = {[](Scene& s) { s.surfaces.pop_back(); },
    [](Scene& s) { s.clouds.clear(); }, [](Scene& s) { s.lights.clear(); },
    [](Scene& s) { s.lights[0].color.g = 0.5f; }, [](Scene& s) { s.occlusion.rays = 1; },
    [](Scene& s) { s.paths.bounces = 1; }, [](Scene& s) { s.sky.top.b = 0.0f; },
    [](Scene& s) { s.cloudTolerance = 0.1; }, [](Scene& s) { s.surfaces[0].id = 5; },
    [](Scene& s) { ++s.surfaces[0].revision; }, [](Scene& s) { s.surfaces[0].toWorld[3].x = 1.0; },
    [](Scene& s) { s.surfaces[0].material.opacity = 0.5f; },
    [](Scene& s) { s.surfaces[0].castsShadows = false; },
    [](Scene& s) { s.surfaces[0].surface = oneSphere().surfaces[0].surface; },
    [](Scene& s) { s.surfaces[0].coloring.constant.r = 0.0f; },
    [&](Scene& s) { s.surfaces[0].coloring.values = ArrayView(&value, 1, 1); },
    [](Scene& s) { s.surfaces[0].coloring.map.upper = 2.0; },
    [](Scene& s) { s.surfaces[1].coloring.map.table[0].g = 0.25f; },
    [](Scene& s) { s.surfaces[1] = isoSurfacesOf(s.clouds[0], {0.75}); },
    [](Scene& s) { s.clouds[0].transfer.unitDistance = 2.0; },
    [](Scene& s) { s.clouds[0].sampling.step = 0.5; }, [](Scene& s) { s.clouds[0].shade = true; },
    [](Scene& s) { s.clouds[0].field = std::make_shared<HexField>(*s.clouds[0].field); }};
  for (const auto& change : changes)
  {
    Scene other = scene;
    change(other);
    EXPECT_NE(scene, other) << "change " << &change - changes;
  }
}

TEST(Scene, CanBeComparedWithoutBeingKept)
{
  Scene scene = someScene();
  const Scene key = scene.unowned();
  EXPECT_EQ(key, scene);
  const std::weak_ptr<const ParticleStructure> particles = particlesOf(scene.surfaces[0]);
  const std::weak_ptr<const HexField> field = scene.clouds[0].field;
  scene = {};
  EXPECT_TRUE(particles.expired());
  EXPECT_TRUE(field.expired());
  EXPECT_NE(key, scene);
}
