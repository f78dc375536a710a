// Parts that turn, and what flows in them.

#include <base/Failure.h>
#include <stage/FlowFinder.h>
#include <stage/PickedTable.h>
#include <stage/PlacedCell.h>
#include <stage/Stage.h>

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkHexahedron.h>
#include <vtkMoteMeshMapper.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

using namespace mote::app;

namespace
{

constexpr int side = 6; // of cells

/// A box of cells from (1, -0.5, 0) to (3, 0.5, 1), with the vectors (1, 0, 0) and the place as a
/// vector.
vtkSmartPointer<vtkUnstructuredGrid> box()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> flow, place;
  flow->SetName("U");
  place->SetName("place");
  for (vtkDoubleArray* array : {flow.Get(), place.Get()})
    array->SetNumberOfComponents(3);
  for (int k = 0; k <= side; ++k)
    for (int j = 0; j <= side; ++j)
      for (int i = 0; i <= side; ++i)
      {
        const double p[3] = {1.0 + 2.0 * i / side, -0.5 + 1.0 * j / side, 1.0 * k / side};
        points->InsertNextPoint(p);
        flow->InsertNextTuple3(1.0, 0.0, 0.0);
        place->InsertNextTuple(p);
      }
  grid->SetPoints(points);
  const auto at = [](int i, int j, int k) -> vtkIdType
  { return i + (side + 1) * (j + (side + 1) * k); };
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
      {
        const vtkIdType cell[8] = {at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k),
          at(i, j + 1, k), at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
          at(i, j + 1, k + 1)};
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, cell);
      }
  grid->GetPointData()->AddArray(flow);
  grid->GetPointData()->AddArray(place);
  return grid;
}

class Turning : public testing::Test
{
protected:
  Turning()
  {
    settings.volume.turns = {{"rotor*", {{15.0, 15.0}}}}; // a quarter in a second
    settings.color.array = "place:0";
  }
  NamedData at(double time, vtkDataSet* data)
  {
    return {.name = "rotor.vtu", .data = data, .file = "rotor.vtu", .time = time};
  }
  void show(double time)
  {
    if (!stage)
      stage = std::make_unique<Stage>(settings);
    const auto step = vtkSmartPointer<vtkUnstructuredGrid>::New();
    step->ShallowCopy(grid);
    stage->setData({this->at(time, step)});
    stage->build(progress);
    stage->applyColors();
  }
  Part& part() { return *stage->parts().front(); }
  vtkMoteVolumeMapper* mapper()
  {
    return vtkMoteVolumeMapper::SafeDownCast(vtkVolume::SafeDownCast(part().prop())->GetMapper());
  }

  Settings settings;
  ProgressRelay progress;
  vtkSmartPointer<vtkUnstructuredGrid> grid = box();
  std::unique_ptr<Stage> stage;
};

void expectNear(const std::array<double, 3>& a, const std::array<double, 3>& b, double by = 1e-9)
{
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(a[k], b[k], by);
}

} // namespace

TEST_F(Turning, AnglesFollowTimeAndAxis)
{
  EXPECT_EQ(turnOf(this->at(1.0, grid), settings).degrees, 90.0);
  EXPECT_EQ(turnOf(this->at(5.0, grid), settings).degrees, 90.0);
  settings.volume.turns.front().intervals = {{-15.0, -15.0}};
  EXPECT_EQ(turnOf(this->at(1.0, grid), settings).degrees, 270.0);
  EXPECT_EQ(turnOf({.name = "stator", .data = grid, .time = 1.0}, settings), Turn());
  // The axis is that of the data, unless one is given.
  vtkNew<vtkDoubleArray> origin, direction;
  origin->SetName("AxisOrigin");
  direction->SetName("AxisDirection");
  for (vtkDoubleArray* array : {origin.Get(), direction.Get()})
    array->SetNumberOfComponents(3);
  origin->InsertNextTuple3(0.0, 2.0, 0.0);
  direction->InsertNextTuple3(5.0, 0.0, 0.0);
  grid->GetFieldData()->AddArray(origin);
  grid->GetFieldData()->AddArray(direction);
  const CutAxis own = turnOf(this->at(1.0, grid), settings).axis;
  expectNear(own.direction, {1.0, 0.0, 0.0});
  expectNear(own.point, {0.0, 2.0, 0.0});
  settings.cuts.axis = {0.0, 1.0, 0.0};
  expectNear(turnOf(this->at(1.0, grid), settings).axis.direction, {0.0, 1.0, 0.0});
}

TEST_F(Turning, WhatCannotTurnIsTold)
{
  EXPECT_EQ(idleTurns({this->at(1.0, grid)}, settings), "");
  EXPECT_NE(idleTurns({{.name = "a", .data = grid, .time = 1.0}}, settings), "");
  EXPECT_NE(idleTurns({{.name = "rotor", .data = grid}}, settings), "");
  settings.volume.turns.front().name = "rotor";
  EXPECT_THROW(
    turnOf(
      {.name = "pump:0.1: rotor", .data = grid, .file = "pump:0.1", .block = "rotor", .time = 1.0},
      settings),
    Failure);
}

TEST_F(Turning, PartsStandAtTheirAnglesAndNothingIsBuiltAnew)
{
  settings.volume.slices = std::vector<ShowRange>{{"y", {{2.0, 2.0}}}};
  this->show(0.0);
  double before[6], after[6];
  stage->bounds(before);
  EXPECT_NEAR(before[1], 3.0, 1e-9);
  const int builds = mapper()->GetNumberOfBuilds();
  this->show(1.0);
  stage->bounds(after);
  const double wanted[6] = {-0.5, 0.5, 1.0, 3.0, 0.0, 1.0};
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(after[k], wanted[k], 1e-9) << k;
  EXPECT_EQ(mapper()->GetNumberOfBuilds(), builds);
  // The slice stays, and so cuts what has come there; the walls have come along.
  double slice[6];
  stage->shownBounds(slice);
  std::array<double, 3> center{};
  mapper()->GetSlice(0)->GetCenter(center.data());
  expectNear(center, {2.0, 0.0, 0.0}); // in the data's coordinates
  for (vtkProp3D* prop : part().props())
    expectNear({prop->GetCenter()[0], prop->GetCenter()[1], prop->GetCenter()[2]}, {0.0, 2.0, 0.5});
  // Nothing named turns no more.
  settings.volume.turns.clear();
  stage->apply(settings);
  stage->bounds(after);
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(after[k], before[k], 1e-9) << k;
}

TEST_F(Turning, PickedCellsAreFoundInEveryRepetition)
{
  settings.volume.repeatAround = 3;
  this->show(1.0);
  const vtkIdType cell = 2 + side * (3 + side * 4);
  const std::array<double, 3> own = {1.75, 0.05, 0.75};
  ASSERT_EQ(part().placements().size(), 3u);
  PickedSet picked;
  picked.toggle({0, Picked::Kind::Cell, cell});
  for (const auto& placed : part().placements())
  {
    std::array<double, 3> seen{};
    placed->TransformPoint(own.data(), seen.data());
    const PlacedCell found = placedCell(part(), cell, seen);
    ASSERT_TRUE(found.weights);
    expectNear(found.place, own);
    picked.setPlace({0, Picked::Kind::Cell, cell}, seen);
    const CellWeights weights = picked.weightsOf(stage->parts(), picked.items().front());
    vtkDataArray* place = grid->GetPointData()->GetArray("place");
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(valueBetween(weights, place, k), own[static_cast<std::size_t>(k)], 1e-6);
  }
  EXPECT_FALSE(placedCell(part(), cell, own).weights) << "there is nothing";
}

TEST_F(Turning, StreamlinesAndArrowsTurnWithTheirPart)
{
  settings.flow.lines = 20;
  settings.flow.arrows = 50;
  settings.flow.array = "U";
  this->show(1.0);
  const BuiltFlow& flow = stage->flow().built();
  ASSERT_EQ(flow.numberOfLines, 20);
  ASSERT_EQ(flow.places->GetNumberOfPoints(), 50);
  double bounds[6];
  flow.places->GetBounds(bounds);
  EXPECT_GE(bounds[2], 1.0);
  EXPECT_LE(bounds[3], 3.0);
  EXPECT_GE(bounds[0], -0.5);
  for (vtkPolyData* data : {flow.places.Get(), flow.lines.Get()})
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> u{}, place{}, at{};
      data->GetPointData()->GetArray("U")->GetTuple(i, u.data());
      expectNear(u, {0.0, 1.0, 0.0}, 1e-6);
      if (data == flow.lines)
        continue;
      data->GetPointData()->GetArray("place")->GetTuple(i, place.data());
      data->GetPoint(i, at.data());
      expectNear(place, at, 1e-6);
    }
  EXPECT_FALSE(flow.lines->GetPointData()->HasArray("MotePart"));
  // The same again is not found again.
  const vtkPolyData* before = flow.lines;
  stage->build(progress);
  EXPECT_EQ(stage->flow().built().lines, before);
}

TEST_F(Turning, ArrowsLieEvenlyOnSlices)
{
  settings.volume.turns.clear();
  settings.flow.array = "place";
  settings.flow.arrowsOn = "slices";
  for (const int count : {40, 400})
    for (const std::string vectors : {"full", "tangential"})
    {
      settings.flow.arrows = count;
      settings.flow.arrowVectors = vectors;
      settings.volume.slices = std::vector<ShowRange>{{"z", {{0.25, 0.25}}}, {"r", {{2.0, 2.0}}}};
      stage.reset();
      this->show(0.0);
      vtkPolyData* places = stage->flow().built().places;
      EXPECT_NEAR(static_cast<double>(places->GetNumberOfPoints()), count, 0.25 * count);
      int flat = 0, left = 0;
      for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
      {
        std::array<double, 3> at{}, v{};
        places->GetPoint(i, at.data());
        places->GetPointData()->GetArray("arrow")->GetTuple(i, v.data());
        const bool isFlat = std::abs(at[2] - 0.25) < 1e-9;
        const double r = std::hypot(at[0], at[1]);
        EXPECT_TRUE(isFlat || std::abs(r - 2.0) < 1e-9);
        flat += isFlat;
        left += isFlat && at[0] < 2.0;
        if (vectors == "full")
          expectNear(v, at, 1e-6);
        else if (isFlat)
          EXPECT_NEAR(v[2], 0.0, 1e-9);
        else
          EXPECT_NEAR((v[0] * at[0] + v[1] * at[1]) / r, 0.0, 1e-9);
      }
      // By area: 2 on the plane, about 1.01 on the cylinder.
      EXPECT_NEAR(static_cast<double>(flat) / places->GetNumberOfPoints(), 0.66, 0.1);
      EXPECT_NEAR(static_cast<double>(left) / flat, 0.5, 0.1);
    }
}

TEST_F(Turning, ArrowsOnSlicesLieInAllRepetitions)
{
  settings.volume.turns.clear();
  settings.flow.array = "place";
  settings.flow.arrowsOn = "slices";
  settings.flow.arrows = 300;
  settings.volume.repeatAround = 4;
  settings.volume.slices = std::vector<ShowRange>{{"y", {{0.1, 0.1}}}};
  this->show(0.0);
  vtkPolyData* places = stage->flow().built().places;
  int sides[2] = {0, 0};
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> at{}, v{};
    places->GetPoint(i, at.data());
    places->GetPointData()->GetArray("arrow")->GetTuple(i, v.data());
    expectNear(v, at, 1e-6); // which have turned, too
    EXPECT_NEAR(at[1], 0.1, 1e-9);
    ++sides[at[0] > 0.0];
  }
  EXPECT_GT(sides[0], 100);
  EXPECT_GT(sides[1], 100);
}

TEST_F(Turning, LinesAndArrowsEndWhereCellsAreHidden)
{
  settings.volume.turns.clear();
  settings.flow.lines = 30;
  settings.flow.arrows = 60;
  settings.flow.array = "U";
  settings.selection.ranges = {{"x", {{1.0, 2.0}}}};
  this->show(0.0);
  const BuiltFlow& flow = stage->flow().built();
  EXPECT_EQ(flow.places->GetNumberOfPoints(), 60);
  for (vtkPolyData* data : {flow.places.Get(), flow.lines.Get()})
  {
    double bounds[6];
    data->GetBounds(bounds);
    EXPECT_LT(bounds[1], 2.01);
    EXPECT_GT(bounds[1], 1.7);
  }
  settings.selection.ranges.clear();
  EXPECT_TRUE(stage->apply(settings));
  stage->build(progress);
  double bounds[6];
  stage->flow().built().lines->GetBounds(bounds);
  EXPECT_GT(bounds[1], 2.9);
}

TEST_F(Turning, StreamlinesThatAreReadyAreNotFoundAgain)
{
  settings.flow.lines = 10;
  settings.flow.array = "U";
  this->show(0.0);
  const std::vector<NamedData> next = {this->at(1.0, box())};
  FlowFinder finder;
  const ReadyStep ready =
    makeReady(next, stage->readyPlan(), quietly([](double) { return true; }), {}, finder);
  ASSERT_EQ(ready.flow.numberOfLines, 10);
  const ReadyStep own = withOwnData(ready);
  stage->setData(own.original, &own);
  stage->build(progress);
  stage->applyColors();
  EXPECT_EQ(stage->flow().built().lines, ready.flow.lines);
  double bounds[6];
  stage->flow().built().lines->GetBounds(bounds);
  EXPECT_GT(bounds[3], 2.9) << "where the part stands then";
  // Other lines fit no more.
  settings.flow.lines = 12;
  stage->apply(settings);
  EXPECT_FALSE(ready.plan.fits(stage->readyPlan()));
}
