// Parts have names, by which they are hidden and shown.

#include <stage/Blocks.h>
#include <stage/HiddenParts.h>
#include <stage/Part.h>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkAppendFilter.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMoteMeshMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

using namespace mote::app;

namespace
{

vtkSmartPointer<vtkDataSet> surface()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkDataSet> image()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 3, 3);
  return image;
}

void add(vtkMultiBlockDataSet* blocks, const char* name, vtkDataObject* data)
{
  const unsigned int index = blocks->GetNumberOfBlocks();
  blocks->SetBlock(index, data);
  if (name)
    blocks->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name);
}

/// A case of two regions, which have a patch of the same name each.
vtkSmartPointer<vtkMultiBlockDataSet> twoRegions()
{
  auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const char* region : {"rotor", "stator"})
  {
    vtkNew<vtkMultiBlockDataSet> blocks, patches;
    add(patches, "inlet", surface());
    add(patches, region[0] == 'r' ? "blade 1" : "casing", surface());
    add(blocks, "internalMesh", image());
    add(blocks, "boundary", patches);
    add(all, region, blocks);
  }
  return all;
}

std::vector<std::string> namesOf(const std::vector<NamedData>& data)
{
  std::vector<std::string> names;
  for (const NamedData& one : data)
    names.push_back(partName(one));
  return names;
}

/// The names of what is shown, with blanks between.
std::string shown(const std::vector<NamedData>& data, const SelectionSettings& selection)
{
  std::string names;
  for (const NamedData& one : shownParts(data, selection))
    names += (names.empty() ? "" : " ") + partName(one);
  return names;
}

using Names = std::vector<std::string>;

} // namespace

TEST(HiddenParts, BlocksHaveTheShortestNamesThatTellThemApart)
{
  const auto data = dataSetsOf(twoRegions(), "a.foam");
  EXPECT_EQ(namesOf(data), (Names{"rotor/internalMesh", "rotor/boundary/inlet", "blade 1",
                             "stator/internalMesh", "stator/boundary/inlet", "casing"}));
  EXPECT_EQ(data[2].name, "a.foam: blade 1");
  EXPECT_TRUE(vtkUnstructuredGrid::SafeDownCast(data[0].data)) << "images are hexahedra";
  EXPECT_FALSE(data[0].isBoundary);
  EXPECT_TRUE(data[2].isBoundary);

  vtkNew<vtkMultiBlockDataSet> unnamed;
  add(unnamed, nullptr, surface());
  EXPECT_EQ(dataSetsOf(unnamed, "a.vtm")[0].name, "a.vtm");
  add(unnamed, nullptr, nullptr);
  add(unnamed, nullptr, surface());
  const auto two = dataSetsOf(unnamed, "a.vtm");
  EXPECT_EQ(namesOf(two), (Names{"block 1", "block 3"}));
  EXPECT_FALSE(two[0].isBoundary) << "without a volume all surfaces are shown";
}

TEST(HiddenParts, CellsOfHigherOrderAreLinearOnes)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(VTK_QUADRATIC_TETRA);
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdList> nodes;
  for (vtkIdType i = 0; i < 10; ++i)
    nodes->InsertNextId(points->InsertNextPoint(cell->GetParametricCoords() + 3 * i));
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_QUADRATIC_TETRA, nodes);
  const auto found = dataSetsOf(grid, "a");
  ASSERT_EQ(found[0].data->GetNumberOfCells(), 8);
  for (vtkIdType i = 0; i < 8; ++i)
    EXPECT_EQ(found[0].data->GetCellType(i), VTK_TETRA);
}

TEST(HiddenParts, CopiesOfParticlesAreNotThere)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> ids;
  vtkNew<vtkUnsignedCharArray> marks;
  ids->SetName("id");
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(i / 2, 0.0, 0.0);
    ids->InsertNextValue(i / 2);
    marks->InsertNextValue(i % 2 == 0 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(ids);
  EXPECT_EQ(dataSetsOf(data, "a")[0].data.Get(), data.Get());
  data->GetPointData()->AddArray(marks);
  const auto found = dataSetsOf(data, "a");
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].data->GetNumberOfPoints(), 3);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(found[0].data->GetPoint(i)[0], i);
    EXPECT_EQ(found[0].data->GetPointData()->GetArray("id")->GetTuple1(i), i);
  }
  EXPECT_FALSE(found[0].data->GetPointGhostArray());
}

TEST(HiddenParts, PatternsNameParts)
{
  const auto data = dataSetsOf(twoRegions(), "a.foam");
  SelectionSettings selection;
  EXPECT_EQ(shown(data, selection), "rotor/internalMesh stator/internalMesh");
  selection.hiddenParts = {"stator/*"};
  EXPECT_EQ(shown(data, selection), "rotor/internalMesh");
  selection.shownParts = {"inlet"};
  EXPECT_EQ(
    shown(data, selection), "rotor/internalMesh rotor/boundary/inlet stator/boundary/inlet");
  selection.shownParts = {"*"};
  EXPECT_EQ(shownParts(data, selection).size(), 6u);
  selection.shownParts = {"rotor*inlet", "c*s*g", "*1"};
  EXPECT_EQ(shown(data, selection), "rotor/internalMesh rotor/boundary/inlet blade 1 casing");
  selection.shownParts = {"rotor*inlet*x", "casin", "asing", "a.foam: blade*"};
  EXPECT_EQ(shown(data, selection), "rotor/internalMesh blade 1");
  selection = {};
  selection.hiddenData = {1};
  EXPECT_EQ(shown(data, selection), "stator/internalMesh");
}

TEST(HiddenParts, ABoxHidesAndShowsOneAlone)
{
  const auto data = dataSetsOf(twoRegions(), "a.foam");
  SelectionSettings begins[4];
  begins[1].hiddenParts = {"*internalMesh"};
  begins[2].shownParts = {"*"};
  begins[3].shownParts = {"inlet"};
  begins[3].hiddenData = {1, 3};
  for (const SelectionSettings& begin : begins)
    for (std::size_t i = 0; i < data.size(); ++i)
    {
      auto wanted = hiddenParts(data, begin);
      SelectionSettings now = begin;
      for (const bool isShown : {true, false, true, false})
      {
        now = withPart(now, data, i, isShown);
        wanted[i] = !isShown;
        EXPECT_EQ(hiddenParts(data, now), wanted) << partName(data[i]);
      }
    }
  // What was hidden by hand and is shown again leaves nothing behind.
  SelectionSettings selection;
  EXPECT_EQ(withPart(withPart(selection, data, 0, false), data, 0, true), selection);
  EXPECT_EQ(withPart(withPart(selection, data, 1, true), data, 1, false), selection);
  EXPECT_EQ(withPart(selection, data, 0, false).hiddenParts, (Names{"rotor/internalMesh"}));
  // Files go by their numbers.
  const std::vector<NamedData> files = {{"a.vtp", surface()}, {"a.vtp", surface()}};
  EXPECT_EQ(withPart(selection, files, 1, false).hiddenData, (std::vector<int>{2}));
}

TEST(HiddenParts, HiddenBoundariesAreTold)
{
  const auto data = dataSetsOf(twoRegions(), "a.foam");
  SelectionSettings selection;
  const std::string told = hiddenBoundaries(data, selection);
  EXPECT_NE(told.find("blade 1"), std::string::npos) << told;
  EXPECT_NE(told.find("--show-part"), std::string::npos) << told;
  selection.shownParts = {"inlet"};
  EXPECT_EQ(hiddenBoundaries(data, selection), "");
}

TEST(HiddenParts, BlocksOfAMeshHaveNoWallsBetweenThem)
{
  // Three boxes in a row; the last one has other arrays, as a solid beside a fluid.
  std::vector<std::unique_ptr<Part>> parts;
  const Settings settings;
  for (int k = 0; k < 3; ++k)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 3, 3);
    image->SetOrigin(2.0 * k, 0.0, 0.0);
    vtkNew<vtkIntArray> values;
    values->SetName(k < 2 ? "p" : "T");
    values->SetNumberOfValues(27);
    values->Fill(k);
    image->GetPointData()->SetScalars(values);
    vtkNew<vtkAppendFilter> grid;
    grid->AddInputData(image);
    grid->Update();
    parts.push_back(std::make_unique<Part>("box", grid->GetOutput(), settings, 0.0));
  }
  const auto walls = [&](std::size_t k)
  {
    auto* actor = vtkActor::SafeDownCast(parts[k]->props().back());
    auto* mapper = actor ? vtkMoteMeshMapper::SafeDownCast(actor->GetMapper()) : nullptr;
    EXPECT_TRUE(mapper);
    mapper->Update();
    return mapper->GetNumberOfTriangles();
  };
  EXPECT_EQ(walls(0), 48);
  joinWalls(parts);
  EXPECT_EQ(walls(0), 40);
  EXPECT_EQ(walls(1), 40) << "the wall of the solid stays";
  EXPECT_EQ(walls(2), 48);
  parts[0]->setHidden(true);
  joinWalls(parts);
  EXPECT_EQ(walls(1), 48);
  parts[0]->setHidden(false);
  joinWalls(parts);
  EXPECT_EQ(walls(1), 40);
}
