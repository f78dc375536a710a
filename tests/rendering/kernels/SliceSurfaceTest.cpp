// Slices of cells: where they are, what values and which edges they show.

#include "ShadowParts.h"

#include <kernels/core/Error.h>
#include <kernels/hexahedra/SliceSurface.h>
#include <kernels/tracing/Picking.h>

#include <support/CastOracle.h>
#include <support/Structure.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

struct Hit
{
  double t = 0.0, value = 0.0;
  Vec3d point{0.0};
  std::uint64_t slot = 0, id = 0;
};

std::optional<Hit> castOne(const SliceSurface& surface, const Vec3d& from, const Vec3d& way)
{
  RayPacket packet;
  packet.count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    packet.origin[axis][0] = from[axis];
    packet.direction[axis][0] = way[axis];
  }
  packet.tMin[0] = 0.0;
  packet.t[0] = INFINITY;
  packet.slot[0] = RayPacket::noHit;
  packet.object[0] = -1;
  surface.cast(packet, 0);
  if (packet.object[0] < 0)
    return {};
  Hit hit{packet.t[0], 0.0, from + packet.t[0] * way, packet.slot[0]};
  surface.values(&hit.slot, &hit.point, 1, &hit.value);
  surface.inputIds(&hit.slot, 1, &hit.id);
  return hit;
}

SliceSurface sliced(const CloudObject& volume, const SliceShape& shape)
{
  return {volume.structure, volume.field, {shape}, volume.hidden};
}

/// Trilinear cells have what is linear exactly, however they are bent.
double linear(const Vec3d& p)
{
  return 3.0 * p.x - 2.0 * p.y + 0.7 * p.z + 12.0;
}

SliceShape shapeOf(SliceShape::Kind kind)
{
  SliceShape shape;
  shape.kind = kind;
  shape.point = {3.1, 2.9, 3.0};
  shape.axis = {0.1, -0.2, 2.0};
  shape.out = {1.0, 0.4, 0.3};
  shape.radius = 1.7;
  return shape;
}

constexpr SliceShape::Kind placed[] = {
  SliceShape::Kind::Plane, SliceShape::Kind::HalfPlane, SliceShape::Kind::Cylinder};

/// Whether the point is on a shape, other than one that is rolled out.
bool isOn(const SliceShape& shape, const Vec3d& p)
{
  const Vec3d axis = glm::normalize(shape.axis), from = p - shape.point;
  const Vec3d out = glm::normalize(shape.out - glm::dot(shape.out, axis) * axis);
  const Vec3d across = from - glm::dot(from, axis) * axis;
  switch (shape.kind)
  {
  case SliceShape::Kind::Plane:
    return std::abs(glm::dot(from, axis)) < 1e-9;
  case SliceShape::Kind::HalfPlane:
    return glm::dot(from, out) >= -1e-9 && std::abs(glm::dot(from, glm::cross(axis, out))) < 1e-9;
  default:
    return std::abs(glm::length(across) - shape.radius) < 1e-9;
  }
}

} // namespace

TEST(SliceSurface, LiesOnItsShapeWithTheCellsValues)
{
  const auto mesh = hexBlock(6, 6, 6, 0.3).mesh();
  for (const HexStructureKind kind : hexKinds)
  {
    const CloudObject volume = volumeOf(mesh, pointValues(*mesh, linear), evenTransfer(0.5F), kind);
    for (const SliceShape::Kind shapeKind : placed)
    {
      const SliceShape shape = shapeOf(shapeKind);
      const SliceSurface surface = sliced(volume, shape);
      int hits = 0;
      Random random(5);
      for (int i = 0; i < 400; ++i)
      {
        const Vec3d from = Vec3d(3.0) + 12.0 * random.direction();
        const Vec3d way = Vec3d(3.0) + 2.0 * random.direction() - from;
        const auto hit = castOne(surface, from, way);
        if (!hit)
          continue;
        ++hits;
        EXPECT_TRUE(isOn(shape, hit->point));
        EXPECT_NEAR(hit->value, linear(hit->point), 2e-6);
        EXPECT_EQ(mesh->inputCell(cellAt(*volume.structure, hit->point)), hit->id);
        // Nothing of the shape lies before it.
        const SliceShape own = shape;
        for (int k = 1; k < 50; ++k)
          EXPECT_FALSE(
            isOn(own, from + (k / 50.0 * hit->t) * way) &&
            cellAt(*volume.structure, from + (k / 50.0 * hit->t) * way) != HexMesh::noCell);
      }
      EXPECT_GT(hits, 100);
    }
  }
}

TEST(SliceSurface, IsWholeWhereTheMeshIs)
{
  // Every ray through the middle of the block meets its slice, along edges and corners as well.
  const auto mesh = hexBlock(8, 8, 8, 0.0).mesh();
  const CloudObject volume = volumeOf(mesh, pointValues(*mesh, linear), evenTransfer(0.5F));
  SliceShape shape;
  shape.point = {0.0, 0.0, 4.0}; // along faces
  const SliceSurface surface = sliced(volume, shape);
  for (int y = 1; y < 64; ++y)
    for (int x = 1; x < 64; ++x)
    {
      const auto hit = castOne(surface, {x / 8.0, y / 8.0, 20.0}, {0.0, 0.0, -1.0});
      ASSERT_TRUE(hit) << x << " " << y;
      EXPECT_NEAR(hit->t, 16.0, 1e-12);
    }
  EXPECT_FALSE(castOne(surface, {8.1, 4.0, 20.0}, {0.0, 0.0, -1.0}));
}

TEST(SliceSurface, InFacesOfCellsShowsTheOnesOnTheSideOfItsNormal)
{
  constexpr int n = 6;
  const auto mesh = hexBlock(n, n, n, 0.0).mesh();
  std::vector<double> values(mesh->cellCount());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<double>(i);
  const CloudObject volume =
    volumeOf(mesh, values, evenTransfer(0.5F), HexStructureKind::CylindricalBvh, true);
  Random random(6);
  for (int k = 0; k < 4000; ++k)
  {
    SliceShape shape;
    const int axis = k % 3, side = k % 2 == 0 ? 1 : -1, at = k / 6 % (n + 1);
    shape.kind = k % 5 == 0 ? SliceShape::Kind::HalfPlane : SliceShape::Kind::Plane;
    shape.axis = shape.out = Vec3d(0.0);
    shape.axis[axis] = side;
    if (shape.kind == SliceShape::Kind::HalfPlane) // across the axis of which its normal is
    {
      shape.axis = shape.out = Vec3d(0.0);
      shape.axis[(axis + 2) % 3] = side;
      shape.out[(axis + 1) % 3] = -1.0;
      shape.out[(axis + 2) % 3] = 0.3;
    }
    shape.point = Vec3d(7.5);
    shape.point[axis] = at;
    const SliceSurface surface = sliced(volume, shape);
    Vec3d place = random.inBox(Vec3d(0.0), Vec3d(n));
    place[axis] = at;
    const Vec3d way = random(0.5, 2.0) * random.direction();
    if (std::abs(way[axis]) < 0.05)
      continue;
    const auto hit = castOne(surface, place - 3.0 * way, way);
    ASSERT_TRUE(hit) << k;
    const Vec3d normal = surface.normalAt(hit->slot, hit->point);
    Vec3d inside = place;
    inside[axis] += normal[axis] > 0.0 ? 0.5 : -0.5;
    if (inside[axis] < 0.0 || inside[axis] > n)
      inside[axis] = 2.0 * at - inside[axis]; // behind the last cells the others
    EXPECT_EQ(hit->id, mesh->inputCell(cellAt(*volume.structure, inside))) << k;
    EXPECT_EQ(hit->value, values[hit->id]);
  }
}

TEST(SliceSurface, FacesThatLieInItHaveNoEdges)
{
  const auto mesh = hexBlock(4, 4, 4, 0.0).mesh();
  const CloudObject volume = volumeOf(mesh, pointValues(*mesh, linear), evenTransfer(0.5F));
  SliceShape shape;
  shape.point = {0.0, 0.0, 2.0};
  const SliceSurface surface = sliced(volume, shape);
  Random random(9);
  for (int k = 0; k < 1000; ++k)
  {
    const Vec3d place = {
      0.5 + std::floor(random(0.0, 4.0)), 0.5 + std::floor(random(0.0, 4.0)), 2.0};
    const Vec3d way = {random(-5.0, 5.0), random(-5.0, 5.0), k % 2 == 0 ? 10.0 : -10.0};
    const Vec3d from = place - way;
    const auto hit = castOne(surface, from, way);
    ASSERT_TRUE(hit);
    EdgeSeen seen;
    surface.edges(&hit->slot, &hit->point, &way, 1, &seen);
    EXPECT_GT(seen.distance, 0.1) << "the edges are half a cell away";
  }
}

TEST(SliceSurface, RolledOutKeepsArcsAndHeights)
{
  const RingShape ring;
  const auto mesh = hexRing(ring).mesh();
  const Box bounds = mesh->bounds();
  const double radius = 0.5 * (ring.inner + ring.outer);
  const auto field = [](const Vec3d& p) { return p.x * p.y + 3.0 * p.z; };
  const CloudObject volume = volumeOf(mesh, pointValues(*mesh, field), evenTransfer(0.5F));
  SliceShape round;
  round.kind = SliceShape::Kind::Cylinder;
  round.radius = radius;
  SliceShape flat = round;
  flat.kind = SliceShape::Kind::Unrolled;
  const SliceSurface onCylinder = sliced(volume, round), onPlane = sliced(volume, flat);
  int hits = 0;
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 12; ++k)
    {
      const double angle = (i + 0.5) / 60.0 * 2.0 * M_PI - M_PI;
      const double height = bounds.lower.z + (k + 0.5) / 12.0 * bounds.size().z;
      const Vec3d outwards(std::cos(angle), std::sin(angle), 0.0);
      const Vec3d above = 3.0 * bounds.size().x * outwards + Vec3d(0.0, 0.0, height);
      const auto there = castOne(onCylinder, above, -outwards);
      const auto rolled =
        castOne(onPlane, {3.0 * bounds.size().x, radius * angle, height}, {-1.0, 0.0, 0.0});
      // The near side of the cylinder is the one at this angle.
      if (there && glm::dot(there->point, outwards) > 0.0)
      {
        ++hits;
        ASSERT_TRUE(rolled);
        EXPECT_NEAR(rolled->point.x, radius, 1e-9);
        EXPECT_NEAR(rolled->value, there->value, 1e-6);
        EXPECT_EQ(rolled->id, there->id);
      }
      else
        EXPECT_FALSE(rolled);
    }
  EXPECT_GT(hits, 100);
  const Box tight = onPlane.tightBounds();
  EXPECT_NEAR(tight.size().y, 2.0 * M_PI * radius, 0.3);
  EXPECT_NEAR(tight.size().z, ring.height, 1e-9);
  const Vec3d normal = onPlane.normalAt(0, {radius, 1.0, 0.0});
  EXPECT_NEAR(std::abs(normal.x), 1.0, 1e-12);
}

TEST(SliceSurface, SectorsRolledOutAreAsWideAsTheirAngles)
{
  HexCells cells = hexBlock(4, 4, 4);
  // About the x axis, its angles from the y axis on.
  cells.move(
    [](const Vec3d& p) { return Vec3d(7.0 + 0.5 * p.x, 3.0 + 0.25 * p.y, -0.2 + 0.3 * p.z); });
  const auto mesh = cells.mesh();
  const CloudObject volume =
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x; }), evenTransfer(0.5F));
  SliceShape shape;
  shape.kind = SliceShape::Kind::Unrolled;
  shape.axis = {1.0, 0.0, 0.0};
  shape.out = {0.0, 1.0, 0.0};
  shape.radius = 3.5;
  const Box tight = sliced(volume, shape).tightBounds();
  EXPECT_NEAR(tight.lower.x, 7.0, 1e-9);
  EXPECT_NEAR(tight.upper.x, 9.0, 1e-9);
  EXPECT_NEAR(tight.lower.y, 3.5, 1e-6);
  EXPECT_NEAR(tight.upper.y, 3.5, 1e-6);
  EXPECT_NEAR(tight.lower.z, 3.5 * std::atan2(-0.2, 3.0), 1e-6);
  EXPECT_NEAR(tight.upper.z, 3.5 * std::atan2(1.0, 3.0), 1e-6);
}

TEST(SliceSurface, HiddenCellsAndThoseWithNaNAreNotThere)
{
  const auto mesh = hexBlock(3, 1, 1).mesh();
  auto values = pointValues(*mesh, [](const Vec3d& p) { return p.x; });
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
    if (mesh->point(p).x == 0.0)
      values[p] = NAN;
  const std::vector<unsigned char> isVisible = {1, 1, 0};
  CloudObject volume = volumeOf(mesh, values, evenTransfer(0.5F));
  volume.hidden = std::make_shared<HiddenCells>(*mesh, isVisible.data());
  SliceShape shape;
  shape.point.z = 0.5;
  const auto meets = [&](const SliceSurface& surface, double x) {
    return castOne(surface, {x, 0.5, 9.0}, {0.0, 0.0, -1.0}).has_value();
  };
  const SliceSurface surface = sliced(volume, shape);
  EXPECT_FALSE(meets(surface, 0.5));
  EXPECT_TRUE(meets(surface, 1.5));
  EXPECT_FALSE(meets(surface, 2.5));
  const SliceSurface whole(volume.structure, volume.field, {shape}, nullptr, true);
  for (const double x : {0.5, 1.5, 2.5})
    EXPECT_TRUE(meets(whole, x));
  EXPECT_TRUE(std::isnan(castOne(whole, {0.5, 0.5, 9.0}, {0.0, 0.0, -1.0})->value));
}

TEST(SliceSurface, OfPolyhedraHasTheInputsEdgesAlone)
{
  // Two cubes as one polyhedron beside others.
  const auto mesh = merged(hexBlock(4, 4, 4), {{0, 1}}).mesh();
  const CloudObject volume =
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.z; }), evenTransfer(0.5F));
  SliceShape shape;
  shape.point.z = 0.4;
  const SliceSurface surface = sliced(volume, shape);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x)
    {
      const Vec3d from(0.05 + x / 10.0, 0.05 + y / 10.0, 9.0), way(0.0, 0.0, -1.0);
      const auto hit = castOne(surface, from, way);
      ASSERT_TRUE(hit);
      EdgeSeen seen;
      surface.edges(&hit->slot, &hit->point, &way, 1, &seen);
      const bool isMerged = from.x < 2.0 && from.y < 1.0;
      const auto near = [](double at, double low, double high)
      { return std::min(at - low, high - at); };
      const double wanted = isMerged ? std::min(near(from.x, 0.0, 2.0), near(from.y, 0.0, 1.0))
                                     : std::min(std::abs(from.x - std::round(from.x)),
                                         std::abs(from.y - std::round(from.y)));
      // Within the polyhedron an edge of another part may be farther than its own are.
      if (isMerged)
      {
        EXPECT_GE(seen.distance, wanted - 1e-9);
      }
      if (!isMerged || wanted < 0.1)
      {
        EXPECT_NEAR(seen.distance, wanted, 1e-9);
      }
    }
}

TEST(SliceSurface, EdgesAreAsFarAsTheyAreSeen)
{
  const auto mesh = hexBlock(4, 4, 4).mesh();
  const CloudObject volume =
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.z; }), evenTransfer(0.5F));
  SliceShape shape;
  shape.point.z = 1.5;
  const SliceSurface surface = sliced(volume, shape);
  // From aside, edges across the view are nearer to one another, those along it are not.
  for (const double slope : {0.0, 1.0, 5.0})
  {
    const Vec3d way = glm::normalize(Vec3d(slope, 0.0, -1.0));
    const double foreshortened = std::abs(way.z);
    for (const Vec3d& at : {Vec3d(1.2, 1.5, 1.5), Vec3d(1.5, 2.9, 1.5), Vec3d(2.55, 2.51, 1.5)})
    {
      const auto hit = castOne(surface, at - 7.0 * way, way);
      ASSERT_TRUE(hit);
      EdgeSeen seen;
      surface.edges(&hit->slot, &hit->point, &way, 1, &seen);
      const double x = foreshortened * std::abs(at.x - std::round(at.x));
      const double y = std::abs(at.y - std::round(at.y));
      EXPECT_NEAR(seen.distance, std::min(x, y), 1e-9);
      EXPECT_NEAR(seen.extent, x < y ? foreshortened : 1.0, 1e-9);
    }
  }
}

TEST(SliceSurface, LinesCoverTheirShareOfThePicture)
{
  // 8 x 8 cells of 20 pixels each, white, and black lines: what is dark is what lines cover.
  const auto mesh = hexBlock(8, 8, 2).mesh();
  TransferFunction white = evenTransfer(0.5F);
  const CloudObject volume =
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d&) { return 0.5; }), white);
  SliceShape shape;
  shape.point.z = 1.0;
  for (const double width : {1.0, 2.5})
  {
    Scene scene;
    addTo(scene, slicesOf(volume, {shape}, {width, Vec4f(0.0f, 0.0f, 0.0f, 1.0f)}));
    scene.surfaces.back().material = {};
    scene.surfaces.back().material.ambient = 1.0f;
    scene.surfaces.back().material.diffuse = 0.0f;
    Camera camera = lookAt({4.0, 4.0, 40.0}, {4.0, 4.0, 0.0});
    camera.projection = Camera::Projection::Orthographic;
    camera.parallelScale = 4.0;
    const Film film = tracedFilm(scene, camera, 160, 160, {4});
    double sum = 0.0;
    for (int i = 0; i < 160 * 160; ++i)
      sum += film.color()[4 * i];
    const double open = 1.0 - width / 20.0; // of a cell, along one side
    EXPECT_NEAR(sum / (160 * 160), open * open, 0.01) << width;
  }
}

TEST(SliceSurface, KeepsItsColoursInEveryLight)
{
  const auto mesh = hexBlock(6, 6, 6, 0.3).mesh();
  const CloudObject volume = volumeOf(mesh, pointValues(*mesh, linear), evenTransfer(0.5F));
  const auto filmOf = [&](int rays, bool isAssumed)
  {
    SliceShape across = shapeOf(SliceShape::Kind::Plane);
    SliceShape along = shapeOf(SliceShape::Kind::HalfPlane);
    Scene scene;
    scene.surfaces = {slicesOf(volume, {across, along})};
    scene.occlusion.rays = rays;
    scene.occlusion.isAssumed = isAssumed;
    if (rays > 0)
    {
      Light light;
      light.shadows = true;
      scene.lights = {light};
    }
    return tracedFilm(scene, lookAt({9.0, 5.0, 11.0}, Vec3d(3.0), 40.0), 64);
  };
  const Film plain = filmOf(0, false);
  for (const Film& other : {filmOf(16, false), filmOf(0, true)})
    EXPECT_TRUE(std::equal(plain.color(), plain.color() + 4 * plain.pixels(), other.color()));
  EXPECT_GT(std::count_if(plain.color(), plain.color() + 4 * plain.pixels(),
              [](float value) { return value > 0.0f; }),
    2000);
}

TEST(SliceSurface, IsPickedWithCellAndValue)
{
  const auto mesh = hexBlock(4, 4, 4, 0.2).mesh();
  const CloudObject volume = volumeOf(mesh, pointValues(*mesh, linear), evenTransfer(0.5F));
  Scene scene;
  addTo(scene, slicesOf(volume, {shapeOf(SliceShape::Kind::Plane)}));
  const auto found = pick(scene, {2.2, 1.9, 9.0}, {0.0, 0.0, -1.0});
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->value);
  EXPECT_NEAR(*found->value, linear(found->position), 1e-6);
  EXPECT_EQ(found->id, mesh->inputCell(cellAt(*volume.structure, found->position)));
}

TEST(SliceSurface, WhatIsNoShapeIsRefused)
{
  const auto mesh = hexBlock(1, 1, 1).mesh();
  const CloudObject volume = volumeOf(mesh, pointValues(*mesh, linear), evenTransfer(0.5F));
  SliceShape shape;
  shape.axis = Vec3d(0.0);
  EXPECT_THROW(sliced(volume, shape), Error);
  shape = {};
  shape.kind = SliceShape::Kind::HalfPlane;
  shape.out = 3.0 * shape.axis;
  EXPECT_THROW(sliced(volume, shape), Error);
  shape = {};
  shape.kind = SliceShape::Kind::Cylinder;
  shape.radius = 0.0;
  EXPECT_THROW(sliced(volume, shape), Error);
}
