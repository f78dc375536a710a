// Where vtkMoteParticleMapper takes radii from.
#include "VTKTestSupport.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <cmath>

using namespace mote::testing;

namespace
{

/// The radii that the mapper draws, found by looking: half the height of single particles.
double seenRadius(vtkPolyData* data, void (*set)(vtkMoteParticleMapper*))
{
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(data);
  set(mapper);
  const double* bounds = mapper->GetBounds();
  return 0.5 * (bounds[3] - bounds[2]);
}

vtkSmartPointer<vtkPolyData> onePoint()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1, 2, 3);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

} // namespace

TEST(ParticleMapperRadius, AutomaticTakesRadiusInAnyCase)
{
  for (const char* name : {"radius", "Radius", "RADIUS", "radii", "Radii", "particle_radius",
         "Sphere Radius", "PARTICLE-RADIUS", "Radius (m)"})
  {
    auto data = onePoint();
    addValues(data, name, {0.75}, false);
    EXPECT_NEAR(seenRadius(data, [](auto*) {}), 0.75, 1e-6) << name;
  }
}

TEST(ParticleMapperRadius, AutomaticTakesHalfOfDiameterInAnyCase)
{
  for (const char* name :
    {"diameter", "Diameter", "DIAMETER", "Particle Diameter [mm]", "grainDiameter"})
  {
    auto data = onePoint();
    addValues(data, name, {3}, false);
    EXPECT_NEAR(seenRadius(data, [](auto*) {}), 1.5, 1e-6) << name;
  }
}

TEST(ParticleMapperRadius, AutomaticPrefersRadiusToDiameter)
{
  auto data = onePoint();
  addValues(data, "diameter", {3}, false);
  addValues(data, "radius", {0.25}, false);
  EXPECT_NEAR(seenRadius(data, [](auto*) {}), 0.25, 1e-6);
}

TEST(ParticleMapperRadius, AutomaticTakesNoArrayThatOnlySoundsLikeRadii)
{
  for (const char* name :
    {"cutoff_radius", "radius_of_gyration", "radiusx", "inner diameter", "d", ""})
  {
    auto data = onePoint();
    addValues(data, name, {3}, false);
    EXPECT_FALSE(vtkMoteParticleMapper::FindRadii(data->GetPointData())) << name;
    EXPECT_EQ(vtkMoteParticleMapper::GetRadiusFactor(name), 0.0) << name;
  }
  EXPECT_EQ(vtkMoteParticleMapper::GetRadiusFactor(nullptr), 0.0);
}

TEST(ParticleMapperRadius, AutomaticSkipsVectorsNamedRadius)
{
  auto data = onePoint();
  vtkNew<vtkFloatArray> vector;
  vector->SetName("radius");
  vector->SetNumberOfComponents(3);
  vector->InsertNextTuple3(9, 9, 9);
  data->GetPointData()->AddArray(vector);
  addValues(data, "Diameter", {3}, false);
  EXPECT_NEAR(seenRadius(data, [](auto*) {}), 1.5, 1e-6);
}

TEST(ParticleMapperRadius, AutomaticFallsBackToSpacing)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 10; ++i)
    points->InsertNextPoint(2.0 * i, 0, 0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(data);
  mapper->Update();
  EXPECT_NEAR(mapper->GetRadiusInUse(), 1.0, 1e-6);
  mapper->SetRadiusScale(0.5);
  mapper->Update();
  EXPECT_NEAR(mapper->GetRadiusInUse(), 0.5, 1e-6);
}

TEST(ParticleMapperRadius, SpacingIgnoresRadiusArrays)
{
  auto data = makeParticles({{0, 0, 0, 9}, {1, 0, 0, 9}, {2, 0, 0, 9}});
  const double radius = seenRadius(data, [](auto* m) { m->SetRadiusModeToSpacing(); });
  EXPECT_NEAR(radius, 0.5, 1e-6);
}

TEST(ParticleMapperRadius, Constant)
{
  auto data = makeParticles({{0, 0, 0, 9}, {5, 0, 0, 9}});
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetRadiusModeToConstant();
  expectBounds(mapper, {-0.5, 5.5, -0.5, 0.5, -0.5, 0.5});
  mapper->SetRadius(2);
  expectBounds(mapper, {-2, 7, -2, 2, -2, 2});
  EXPECT_EQ(mapper->GetRadiusInUse(), 2);
}

TEST(ParticleMapperRadius, ByArrayOfAnyType)
{
  auto data = makeParticles({{0, 0, 0, 9}, {5, 0, 0, 9}});
  vtkNew<vtkIntArray> size;
  size->SetName("size");
  size->InsertNextValue(1);
  size->InsertNextValue(3);
  data->GetPointData()->AddArray(size);
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetRadiusModeToArray();
  mapper->SetRadiusArrayName("size");
  expectBounds(mapper, {-1, 8, -3, 3, -3, 3});
  EXPECT_EQ(mapper->GetRadiusInUse(), 0);
  mapper->SetRadiusScale(0.5);
  expectBounds(mapper, {-0.5, 6.5, -1.5, 1.5, -1.5, 1.5});
}

TEST(ParticleMapperRadius, ByTypeThroughTheTable)
{
  auto data = makeParticles({{0, 0, 0, 9}, {10, 0, 0, 9}, {20, 0, 0, 9}});
  vtkNew<vtkIntArray> type;
  type->SetName("type");
  for (const int t : {1, 2, 7})
    type->InsertNextValue(t);
  data->GetPointData()->AddArray(type);
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetRadiusModeToType();
  mapper->SetTypeRadius(1, 1);
  mapper->SetTypeRadius(2, 3);
  expectBounds(mapper, {-1, 20.5, -3, 3, -3, 3}); // type 7 is not in the table: Radius
  EXPECT_EQ(mapper->GetTypeRadius(2), 3);
  EXPECT_EQ(mapper->GetTypeRadius(7), 0.5);
  mapper->SetTypeRadius(7, 4);
  expectBounds(mapper, {-1, 24, -4, 4, -4, 4});
  mapper->RemoveAllTypeRadii();
  mapper->SetRadius(2);
  expectBounds(mapper, {-2, 22, -2, 2, -2, 2});
}
