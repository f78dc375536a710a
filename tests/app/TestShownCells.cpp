// Cells of volumes and surfaces are shown and hidden as particles are, and picked by number.

#include <settings/Values.h>
#include <stage/Advice.h>
#include <stage/PickedTable.h>
#include <stage/Plot.h>
#include <stage/Stage.h>

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMoteMeshMapper.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolume.h>

#include <algorithm>
#include <array>

using namespace mote::app;

namespace
{

constexpr int side = 4; // cells along each edge, which are of length 1

vtkSmartPointer<vtkDoubleArray> arrayOf(const char* name, vtkIdType count, double factor)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
    array->InsertNextValue(factor * static_cast<double>(i));
  return array;
}

vtkSmartPointer<vtkImageData> image()
{
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(side + 1, side + 1, side + 1);
  data->GetPointData()->AddArray(arrayOf("p", data->GetNumberOfPoints(), 1.0));
  data->GetCellData()->AddArray(arrayOf("c", data->GetNumberOfCells(), 1.0));
  return data;
}

/// side^3 hexahedra, with x at points as "f", and numbers of cells as "c".
vtkSmartPointer<vtkUnstructuredGrid> grid()
{
  auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto from = image();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> f;
  f->SetName("f");
  for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(from->GetPoint(i));
    f->InsertNextValue(from->GetPoint(i)[0]);
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(f);
  for (vtkIdType c = 0; c < from->GetNumberOfCells(); ++c)
  {
    vtkIdType v[8];
    for (int i = 0; i < 8; ++i)
      v[i] = from->GetCell(c)->GetPointId(i);
    const vtkIdType hexahedron[8] = {v[0], v[1], v[3], v[2], v[4], v[5], v[7], v[6]};
    data->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
  }
  data->GetCellData()->AddArray(arrayOf("c", data->GetNumberOfCells(), 1.0));
  return data;
}

vtkSmartPointer<vtkPolyData> particles()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 10; ++i)
    points->InsertNextPoint(0.5 * i, 0.0, 0.0);
  data->SetPoints(points);
  data->GetPointData()->AddArray(arrayOf("a", 10, 1.0));
  return data;
}

class ShownCellsTest : public testing::Test
{
protected:
  ShownCellsTest() { settings.color.array = "f"; }

  void show(const std::vector<vtkDataSet*>& data)
  {
    stage = std::make_unique<Stage>(settings);
    std::vector<NamedData> named;
    for (vtkDataSet* one : data)
      named.push_back({"data " + std::to_string(named.size() + 1), one, "file"});
    stage->setData(named);
    stage->build(progress);
    stage->applyColors();
  }
  /// Follows the settings.
  void follow()
  {
    if (stage->apply(settings))
      stage->build(progress);
    stage->applyColors();
  }
  /// How many cells these limits leave.
  vtkIdType left(const SelectionSettings& selection)
  {
    settings.selection = selection;
    this->follow();
    return stage->numberOfCells() > 0 ? stage->numberOfCellsShown()
                                      : stage->parts()[0]->numberOfCellsShown();
  }
  vtkIdType triangles() const { return stage->numberOfTriangles(true); }

  Settings settings;
  ProgressRelay progress;
  std::unique_ptr<Stage> stage;
};

SelectionSettings ranges(const std::vector<ShowRange>& all)
{
  SelectionSettings selection;
  selection.ranges = all;
  return selection;
}

} // namespace

TEST_F(ShownCellsTest, AnyArrayPlaceExpressionAndNumberHidesThem)
{
  for (const char* cells : {"volume", "surface"})
  {
    settings = {};
    settings.color.array = "f";
    settings.volume.cells = cells;
    this->show({grid()});
    EXPECT_EQ(left({}), 64);
    EXPECT_EQ(left(ranges({{"c", {{0.0, 9.0}, {20.0, 21.0}}}})), 12);
    EXPECT_EQ(left(ranges({{"y", {{1.0, 4.0}}}})), 48);
    EXPECT_EQ(left(ranges({{"y", {{1.0, 4.0}}}, {"x", {{0.0, 1.0}}}, {"c", {{0.0, 31.0}}}})), 6);
    EXPECT_EQ(left(ranges({{"f", {{1.0, 2.0}}}})), 16); // by their means
    SelectionSettings where;
    where.where = "f + c > 60 && z > 1";
    EXPECT_EQ(left(where), 6); // 58 to 63
    SelectionSettings ids;
    ids.hidden = IdRanges({{0, 3, 5}, {1, 60, 99}});
    EXPECT_EQ(left(ids), 57);
    ids.only = IdRanges({{1, 0, 9}});
    EXPECT_EQ(left(ids), 7);
    EXPECT_EQ(stage->contents().rfind("7 of 64 cells shown", 0), 0u) << stage->contents();
    SelectionSettings range;
    range.range = {0.0, 9.0};
    range.array = "c";
    EXPECT_EQ(left(range), 10);
    EXPECT_EQ(left(ranges({{"z", {{7.0, 9.0}}}})), 0);
    EXPECT_EQ(whatLeavesNothing(*stage),
      "Nothing is shown: no cell has z in the range of --show; z goes from 0 to 4");
    EXPECT_EQ(left(ranges({{"z", {{0.0, 2.0}}}, {"c", {{60.0, 63.0}}}})), 0);
    EXPECT_NE(whatLeavesNothing(*stage).find("together none"), std::string::npos);
    EXPECT_EQ(left(ranges({{"c", {{100.0, 200.0}}}})), 0);
    EXPECT_EQ(whatLeavesNothing(*stage),
      "Nothing is shown: no cell has c in the range of --show; c goes from 0 to 63");
    settings.selection = ranges({{"nothing", {{0.0, 1.0}}}});
    EXPECT_THROW(this->follow(), std::exception);
  }
}

TEST_F(ShownCellsTest, OfVolumesBuildNothingAndFrameWhatIsLeft)
{
  this->show({grid()});
  auto* mapper = vtkMoteVolumeMapper::SafeDownCast(
    vtkVolume::SafeDownCast(stage->parts()[0]->prop())->GetMapper());
  ASSERT_NE(mapper, nullptr);
  EXPECT_EQ(left(ranges({{"y", {{2.0, 4.0}}}, {"c", {{0.0, 31.0}}}})), 16);
  ASSERT_NE(mapper->GetVisibleCells(), nullptr);
  double bounds[6];
  stage->shownBounds(bounds);
  EXPECT_EQ(std::vector<double>(bounds, bounds + 6), (std::vector<double>{0, 4, 2, 4, 0, 2}));
  // The array that colours cuts through cells.
  EXPECT_EQ(left(ranges({{"f", {{0.75, 4.0}}}})), 48);
  EXPECT_EQ(mapper->GetVisibleCells(), nullptr);
  stage->shownBounds(bounds);
  EXPECT_EQ(bounds[0], 0.0);
  settings.color.array = "c";
  this->follow();
  ASSERT_NE(mapper->GetVisibleCells(), nullptr);
  stage->shownBounds(bounds);
  EXPECT_EQ(bounds[0], 1.0);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
}

TEST_F(ShownCellsTest, OfSurfacesBringFacesToLight)
{
  settings.volume.cells = "surface";
  const vtkSmartPointer<vtkDataSet> both[] = {grid(), image()};
  for (vtkDataSet* data : both)
  {
    settings.selection = {};
    settings.color.array = "c";
    this->show({data});
    EXPECT_EQ(triangles(), 192);
    SelectionSettings hidden;
    hidden.hidden = IdRanges({{0, 21, 21}}); // within
    EXPECT_EQ(left(hidden), 63);
    stage->build(progress);
    EXPECT_EQ(triangles(), 204);
    EXPECT_EQ(left(ranges({{"c", {{0.0, 0.0}}}})), 1);
    stage->build(progress);
    EXPECT_EQ(triangles(), 12);
    // Numbers stay those of the data.
    const Surface* surface = stage->parts()[0]->surface();
    EXPECT_EQ(surface->cellOf(0), 0);
    EXPECT_EQ(left({}), 64);
    stage->build(progress);
    EXPECT_EQ(triangles(), 192);
  }
}

TEST_F(ShownCellsTest, OfPolygonsWithNormalsThatWereMade)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const auto& p : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {2.0, 0.0}})
    points->InsertNextPoint(p[0], p[1], 0.0);
  data->SetPoints(points);
  data->AllocateExact(4, 12);
  const vtkIdType line[2] = {0, 4}, square[4] = {0, 1, 2, 3}, triangle[3] = {1, 4, 2};
  data->InsertNextCell(VTK_LINE, 2, line); // which polygons follow in any case
  data->InsertNextCell(VTK_POLYGON, 4, square);
  data->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  settings.color.array = "none";
  this->show({data});
  EXPECT_EQ(triangles(), 3);
  EXPECT_EQ(left(ranges({{"x", {{1.0, 2.0}}}})), 2); // and the line
  stage->build(progress);
  EXPECT_EQ(triangles(), 1);
  SelectionSettings ids;
  ids.hidden = IdRanges({{0, 2, 2}});
  EXPECT_EQ(left(ids), 2);
  stage->build(progress);
  EXPECT_EQ(triangles(), 2);
}

TEST_F(ShownCellsTest, IdsOfCellsLeaveParticlesAndTheOtherWayRound)
{
  settings.color.array = "none";
  settings.volume.cells = "surface";
  this->show({particles(), grid()});
  settings.selection.only = IdRanges({{2, 5, 8}});
  this->follow();
  EXPECT_EQ(stage->numberShown(), 10);
  EXPECT_EQ(stage->parts()[1]->numberOfCellsShown(), 4);
  settings.selection.only = IdRanges({{1, 5, 8}});
  this->follow();
  EXPECT_EQ(stage->numberShown(), 4);
  EXPECT_EQ(stage->parts()[1]->numberOfCellsShown(), 64);
  settings.selection.only = IdRanges({{1, 5, 8}, {2, 0, 0}});
  this->follow();
  EXPECT_EQ(stage->numberShown(), 4);
  EXPECT_EQ(stage->parts()[1]->numberOfCellsShown(), 1);
}

TEST_F(ShownCellsTest, PlotsOfTheVisibleHaveTheirValuesAndPoints)
{
  const auto data = grid();
  data->GetPointData()->AddArray(arrayOf("p", data->GetNumberOfPoints(), 1.0));
  this->show({data});
  const PickedSet none;
  const auto total = [&](const char* name) {
    return plotOf(stage->parts(), none, {{name, ""}, Plotted::Visible}, 10, 10).total;
  };
  EXPECT_EQ(total("c"), 64);
  EXPECT_EQ(total("p"), 125);
  left(ranges({{"z", {{0.0, 1.0}}}}));
  EXPECT_EQ(total("c"), 16);
  EXPECT_EQ(total("p"), 50); // of both sides of the layer
  // What the array that colours hides has no points.
  left(ranges({{"z", {{0.0, 1.0}}}, {"f", {{2.5, 4.0}}}}));
  EXPECT_EQ(total("c"), 8);
  EXPECT_EQ(total("p"), 20);
  stage->parts()[0]->setHidden(true);
  EXPECT_EQ(total("p"), 0);
}

TEST_F(ShownCellsTest, ArePickedByNumber)
{
  settings.color.array = "none";
  settings.volume.cells = "surface";
  this->show({particles(), grid()});
  PickedSet picked;
  picked.add({{1, Picked::Kind::Cell, 7}, {0, Picked::Kind::Particle, 3}});
  EXPECT_EQ(picked.words(stage->parts()), (std::vector<std::string>{"2/7", "1/3"}));
  EXPECT_EQ(picked.counts(), "1 particle and 1 cell");
  EXPECT_EQ(
    ValuesOf<IdRanges>::words(picked.particleIds(stage->parts())), (std::vector<std::string>{"3"}));
  PickedSet again;
  again.addNamed(stage->parts(), picked.words(stage->parts()));
  EXPECT_EQ(again.items(), picked.items());
  this->show({grid()});
  PickedSet cells;
  cells.addNamed(stage->parts(), {"7", "60:70"});
  ASSERT_EQ(cells.items().size(), 5u);
  EXPECT_EQ(cells.items().back(), (Picked{0, Picked::Kind::Cell, 63}));
  EXPECT_EQ(cells.counts(), "5 cells");
  // Their table names the point that is nearest to where they were picked.
  cells.clear();
  cells.toggle({0, Picked::Kind::Cell, 0});
  cells.setPlace({0, Picked::Kind::Cell, 0}, {0.9, 0.2, 0.8});
  const PickedTable table(stage->parts(), cells);
  const auto column = std::find(table.columns().begin(), table.columns().end(), "nearest point");
  ASSERT_NE(column, table.columns().end());
  EXPECT_EQ(table.cell(0, static_cast<std::size_t>(column - table.columns().begin()), 6),
    std::to_string(1 + (side + 1) * (side + 1)));
}
