// vtkMoteVolumeMapper: what is built again, and what is not.
#include "VolumeTestSupport.h"
#include "kernels/core/ContentHash.h"

#include "kernels/scene/Scene.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMotePumpSource.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace mote::testing;

namespace
{

double one(const Point&)
{
  return 1.0;
}

/// How often a mapper built a structure and took scalars since the last question.
struct Work
{
  vtkMoteVolumeMapper* mapper;
  int builds = 0, fields = 0;

  std::pair<int, int> done()
  {
    mapper->Update();
    const std::pair<int, int> more(
      mapper->GetNumberOfBuilds() - builds, mapper->GetNumberOfFieldUpdates() - fields);
    builds = mapper->GetNumberOfBuilds();
    fields = mapper->GetNumberOfFieldUpdates();
    return more;
  }
};

using Pair = std::pair<int, int>;

struct VolumeRebuild : ::testing::Test
{
  vtkSmartPointer<vtkUnstructuredGrid> grid = makeBox(3, one);
  VolumeStage stage{grid, true};
  Work work{stage.mapper};

  VolumeRebuild() { EXPECT_EQ(work.done(), Pair(1, 1)); }
};

/// Values from -1 to 4, more opaque the larger they are, seen aslant.
Picture pictureOf(vtkUnstructuredGrid* grid)
{
  VolumeStage stage(grid);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(-1.0, 0.0);
  opacity->AddPoint(4.0, 0.8);
  stage.property()->SetScalarOpacity(opacity);
  stage.camera()->Azimuth(25);
  Picture picture = stage.trace();
  double seen = 0.0;
  for (int i = 0; i < 32 * 32; ++i)
    seen += picture.color(i)[3];
  EXPECT_GT(seen, 50.0);
  return picture;
}

/// How far two of them are apart.
double farthest(const Picture& a, const Picture& b)
{
  double most = 0.0;
  for (int i = 0; i < 32 * 32; ++i)
    for (int c = 0; c < 4; ++c)
      most = std::max<double>(most, std::abs(a.color(i)[c] - b.color(i)[c]));
  return most;
}

} // namespace

TEST_F(VolumeRebuild, NotForLookOrView)
{
  stage.paint({1, 0, 0}, 0.3);
  stage.mapper->SetIntegratorName("cell-by-cell");
  stage.mapper->SetNanOpacity(0.5);
  stage.volume->SetPosition(1, 0, 0);
  stage.trace();
  EXPECT_EQ(work.done(), Pair(0, 0));
}

TEST_F(VolumeRebuild, NotForScalars)
{
  grid->GetPointData()->GetScalars()->Fill(2);
  grid->GetPointData()->GetScalars()->Modified();
  grid->Modified();
  EXPECT_EQ(work.done(), Pair(0, 1));
  double range[2];
  stage.mapper->GetScalarRange(range);
  EXPECT_EQ(range[0], 2);
  stage.mapper->SetScalarModeToUseCellFieldData();
  stage.mapper->SelectScalarArray("c");
  EXPECT_EQ(work.done(), Pair(0, 1));
}

TEST_F(VolumeRebuild, NotForTheSameCellsInOtherObjects)
{
  stage.mapper->SetInputData(copyOf(grid));
  EXPECT_EQ(work.done(), Pair(0, 1)) << "the scalars' array is another one";
  stage.mapper->SetInputData(grid);
  EXPECT_EQ(work.done(), Pair(0, 1));
  grid->GetPoints()->GetData()->Modified();
  grid->GetPoints()->Modified();
  EXPECT_EQ(work.done(), Pair(0, 0));
}

TEST_F(VolumeRebuild, ForMovedPoints)
{
  auto moved = copyOf(grid);
  double p[3];
  moved->GetPoint(5, p);
  moved->GetPoints()->SetPoint(5, p[0] + 1e-6, p[1], p[2]);
  stage.mapper->SetInputData(moved);
  EXPECT_EQ(work.done(), Pair(1, 1));
  moved->GetPoints()->SetPoint(5, p);
  moved->GetPoints()->Modified();
  moved->GetPoints()->GetData()->Modified();
  moved->Modified();
  EXPECT_EQ(work.done(), Pair(1, 1));
}

TEST_F(VolumeRebuild, ForOtherCells)
{
  auto fewer = vtkSmartPointer<vtkUnstructuredGrid>::New();
  fewer->SetPoints(grid->GetPoints());
  fewer->GetPointData()->ShallowCopy(grid->GetPointData());
  for (vtkIdType i = 1; i < grid->GetNumberOfCells(); ++i)
    fewer->InsertNextCell(grid->GetCellType(i), grid->GetCell(i)->GetPointIds());
  stage.mapper->SetInputData(fewer);
  EXPECT_EQ(work.done(), Pair(1, 1));
  EXPECT_EQ(stage.mapper->GetNumberOfCells(), 26);
}

TEST_F(VolumeRebuild, ForStructureAndAxis)
{
  stage.mapper->SetStructureName("cartgrid");
  EXPECT_EQ(work.done(), Pair(0, 0)) << "rays that go from cell to cell need none";
  stage.mapper->SetStructureName("cartbvh");
  stage.mapper->SetIntegratorName("trilinear");
  EXPECT_EQ(work.done(), Pair(1, 0));
  stage.mapper->SetStructureName(nullptr);
  EXPECT_EQ(work.done(), Pair(0, 0)) << "that is the default, which it has";
  stage.mapper->SetStructureName("cartgrid");
  EXPECT_EQ(work.done(), Pair(1, 0));
  stage.mapper->SetStructureName("cylgrid");
  stage.mapper->SetAxisDirection(1, 0, 0);
  EXPECT_EQ(work.done(), Pair(1, 0));
  stage.mapper->SetAxisOrigin(0, 0.25, 0);
  EXPECT_EQ(work.done(), Pair(1, 0));
}

TEST_F(VolumeRebuild, ForAStructureOnceItIsNeeded)
{
  const auto structure = [&]() -> bool
  {
    mote::Scene scene;
    EXPECT_TRUE(stage.mapper->DescribeTo(scene, stage.volume));
    EXPECT_EQ(scene.surfaces.size(), stage.mapper->GetShowIsoSurfaces() ? 1U : 0U);
    return scene.clouds.at(0).structure != nullptr;
  };
  EXPECT_FALSE(structure());
  const vtkTypeInt64 bytes = stage.mapper->GetStructureBytes();
  const auto colors = [&]
  {
    const Picture picture = stage.trace();
    return std::vector<float>(picture.color(0), picture.color(0) + 4 * picture.count());
  };
  const std::vector<float> walked = colors();
  stage.property()->GetIsoSurfaceValues()->SetValue(0, 0.5);
  stage.mapper->ShowIsoSurfacesOn();
  EXPECT_TRUE(structure());
  EXPECT_EQ(work.done(), Pair(1, 0));
  EXPECT_GT(stage.mapper->GetStructureBytes(), bytes);
  // Who looks again for a moment finds it; other scalars leave it out.
  stage.mapper->ShowIsoSurfacesOff();
  EXPECT_TRUE(structure());
  EXPECT_EQ(colors(), walked);
  grid->GetPointData()->GetScalars()->Modified();
  grid->Modified();
  EXPECT_FALSE(structure());
  EXPECT_EQ(work.done(), Pair(0, 1));
  EXPECT_EQ(stage.mapper->GetStructureBytes(), bytes);
  // Nearer than walks go.
  stage.mapper->SetTolerance(1e-7);
  EXPECT_TRUE(structure());
  EXPECT_EQ(work.done(), Pair(1, 0));
}

TEST_F(VolumeRebuild, FollowsThePictureOfNewScalars)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0);
  opacity->AddPoint(4, 0.8);
  stage.property()->SetScalarOpacity(opacity);
  for (const double value : {0.0, 3.0, 1.0, 0.0, 2.0})
  {
    // Ranges that were not refreshed would hide what is there.
    grid->GetPointData()->GetScalars()->Fill(value);
    grid->GetPointData()->GetScalars()->Modified();
    EXPECT_NEAR(stage.trace().color(16 + 32 * 16)[3], covered(0.2 * value, 2), 1.0 / 255) << value;
  }
  EXPECT_EQ(work.done().first, 0);
}

TEST_F(VolumeRebuild, LeavesAloneWhatSomebodyHolds)
{
  stage.mapper->SetIntegratorName("trilinear");
  mote::Scene held, later;
  ASSERT_TRUE(stage.mapper->DescribeTo(held, stage.volume));
  const mote::HexStructure* first = held.clouds.at(0).structure.get();
  const auto change = [&]
  {
    grid->GetPointData()->GetScalars()->Fill(2);
    grid->GetPointData()->GetScalars()->Modified();
    later = {};
    ASSERT_TRUE(stage.mapper->DescribeTo(later, stage.volume));
  };
  change();
  EXPECT_NE(later.clouds.at(0).structure.get(), first) << "it may be traced on another thread";
  EXPECT_EQ(held.clouds[0].field->upper(), 1);
  EXPECT_EQ(later.clouds[0].field->upper(), 2);
  held = {};
  first = later.clouds.at(0).structure.get();
  change();
  EXPECT_EQ(later.clouds.at(0).structure.get(), first) << "nobody else's memory is taken again";
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 2);
}

TEST(VolumeMemory, CloudsTakeNoStructure)
{
  vtkNew<vtkMotePumpSource> pump;
  pump->SetScale(0.02);
  pump->SetPartToRotor();
  VolumeStage stage;
  stage.mapper->SetInputConnection(pump->GetOutputPort());
  const auto bytesOfCell = [&]
  {
    mote::Scene scene;
    EXPECT_TRUE(stage.mapper->DescribeTo(scene, stage.volume));
    return double(stage.mapper->GetStructureBytes()) / double(stage.mapper->GetNumberOfCells());
  };
  const double walk = bytesOfCell();
  stage.mapper->SetIntegratorName("trilinear");
  stage.mapper->Update();
  const double both = bytesOfCell();
  RecordProperty("walk", std::to_string(walk));
  RecordProperty("both", std::to_string(both));
  EXPECT_LT(walk, 120.0);
  EXPECT_GT(both, walk + 70.0);
}

TEST(VolumeInput, CellsWithPointsOfTheirOwnAreOneMeshWhereValuesAreOne)
{
  const auto field = [](const Point& p) { return std::sin(2.0 * p[0]) + p[1] * p[2]; };
  const auto whole = makeBox(4, field), apart = cellsApart(whole);
  EXPECT_EQ(farthest(pictureOf(whole), pictureOf(apart)), 0.0);

  VolumeStage stage(apart);
  Work work{stage.mapper};
  EXPECT_EQ(work.done(), Pair(1, 1));
  vtkDataArray* values = apart->GetPointData()->GetScalars();
  const double old = values->GetTuple1(100);
  // Rounding changes nothing; another value parts the cells, as each has its own.
  for (const auto& [value, builds] :
    {std::pair(old * (1.0 + 1e-7), 0), std::pair(old + 0.5, 1), std::pair(old, 1)})
  {
    values->SetTuple1(100, value);
    values->Modified();
    apart->Modified();
    EXPECT_EQ(work.done(), Pair(builds, 1)) << value - old;
  }
}

TEST(VolumeInput, ValuesThatDifferFromCellToCellStayThose)
{
  // Each cell has one value, at its points or itself: no value is carried into the next.
  const auto whole = makeBox(4, one), apart = cellsApart(whole);
  vtkNew<vtkDoubleArray> ofCells, ofPoints;
  for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
  {
    ofCells->InsertNextValue(static_cast<double>(i % 5));
    for (int k = 0; k < 8; ++k)
      ofPoints->InsertNextValue(static_cast<double>(i % 5));
  }
  whole->GetPointData()->SetScalars(nullptr);
  whole->GetCellData()->SetScalars(ofCells);
  apart->GetPointData()->SetScalars(ofPoints);
  EXPECT_LT(farthest(pictureOf(whole), pictureOf(apart)), 0.01);
}

TEST(VolumeInput, FollowsItsPipeline)
{
  vtkNew<vtkMotePumpSource> pump;
  pump->SetScale(0.001);
  pump->SetPartToRotor();
  VolumeStage stage;
  stage.mapper->SetInputConnection(pump->GetOutputPort());
  Work work{stage.mapper};
  EXPECT_EQ(work.done(), Pair(1, 1));
  const vtkIdType rotor = stage.mapper->GetNumberOfCells();
  EXPECT_EQ(rotor, stage.mapper->GetInput()->GetNumberOfCells());
  EXPECT_LT(stage.mapper->GetScalarRange()[0], stage.mapper->GetScalarRange()[1]);
  pump->SetPartToInlet();
  EXPECT_EQ(work.done(), Pair(1, 1));
  EXPECT_NE(stage.mapper->GetNumberOfCells(), rotor);
  stage.mapper->RemoveAllInputConnections(0);
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfCells(), 0);
}

TEST(VolumeTime, StepsOfTheSameGeometryBuildNothing)
{
  vtkNew<vtkMotePumpSource> pump;
  pump->SetScale(0.001);
  pump->SetPartToRotor();
  pump->UpdateInformation();
  VolumeStage stage;
  stage.mapper->SetInputConnection(pump->GetOutputPort());
  std::vector<double> least;
  for (const double time : {0.0, 0.003, 0.006})
  {
    EXPECT_EQ(stage.mapper->UpdateTimeStep(time), 1);
    double range[2];
    stage.mapper->GetScalarRange(range);
    least.push_back(range[0]);
  }
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
  EXPECT_EQ(stage.mapper->GetNumberOfFieldUpdates(), 3);
  EXPECT_NE(least[0], least[1]);
  EXPECT_NE(least[1], least[2]);
}

TEST(ContentHash, TellsContentsApart)
{
  std::mt19937_64 random(1);
  std::vector<double> numbers(100003);
  for (double& x : numbers)
    x = std::uniform_real_distribution<double>(-1, 1)(random);
  const auto hash = [&] { return mote::hashOf(numbers.data(), numbers.size() * sizeof(double)); };
  const mote::ContentHash first = hash();
  EXPECT_EQ(first, hash());
  for (const std::size_t i : {0UL, 1UL, 5UL, 8191UL, 8192UL, 50000UL, 100002UL})
  {
    numbers[i] = -numbers[i]; // one bit
    EXPECT_NE(first, hash()) << i;
    const std::size_t j = i < 90000 ? i + 4 : i - 4;
    numbers[j] = -numbers[j];
    EXPECT_NE(first, hash()) << "two of the highest bits, in one chain";
    numbers[i] = -numbers[i];
    numbers[j] = -numbers[j];
  }
  std::swap(numbers[10], numbers[14]);
  EXPECT_NE(first, hash());
  std::swap(numbers[10], numbers[14]);
  std::swap_ranges(numbers.begin(), numbers.begin() + 8192, numbers.begin() + 8192);
  EXPECT_NE(first, hash()) << "blocks in another order";
  std::swap_ranges(numbers.begin(), numbers.begin() + 8192, numbers.begin() + 8192);
  EXPECT_EQ(first, hash());
  EXPECT_NE(first, mote::hashOf(numbers.data(), numbers.size() * sizeof(double) - 1));
  const unsigned char zeros[16] = {};
  EXPECT_NE(mote::hashOf(zeros, 7), mote::hashOf(zeros, 8));
  EXPECT_NE(mote::hashOf(zeros, 0), mote::hashOf(zeros, 1));
}

TEST(ContentHash, MirroredAndShiftedMeshesDiffer)
{
  std::vector<std::uint64_t> seen;
  std::vector<double> points;
  for (int i = 0; i < 3000; ++i)
    points.push_back(0.25 * (i % 13));
  const auto note = [&]
  {
    const mote::ContentHash h = mote::hashOf(points.data(), points.size() * sizeof(double));
    seen.push_back(h.low);
    seen.push_back(h.high);
  };
  note();
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t i = k; i < points.size(); i += 3)
      points[i] = -points[i];
    note();
    for (std::size_t i = k; i < points.size(); i += 3)
      points[i] += 0.5;
    note();
  }
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
}
