// What the locator builds, when, and what it says where it cannot.

#include "LocatorTools.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkStructuredGrid.h>

#include <gtest/gtest.h>

namespace
{

/// Sentences that an object reports.
class Errors
{
public:
  explicit Errors(vtkObject* from)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Errors*>(self)->texts.emplace_back(static_cast<const char*>(text)); });
    from->AddObserver("ErrorEvent", command);
  }
  std::vector<std::string> texts;
};

TEST(CylindricalLocator, BuildsWhenPointsChangeAndNotWhenValuesDo)
{
  const Grid grid = twisted();
  const Locator prototype = Locator::New();
  prototype->SetStructureName("cartgrid");
  const auto instance = Locator::Take(prototype->NewInstance());
  EXPECT_EQ(instance->GetStructureName(), "cartgrid");
  EXPECT_EQ(instance->GetStructureTime(), 0);
  instance->SetDataSet(grid);
  instance->Update();
  const auto first = instance->GetStructureTime();
  EXPECT_GT(first, 0);
  EXPECT_EQ(instance->GetNumberOfCells(), 343);
  EXPECT_GT(instance->GetActualMemorySize(), 30);

  grid->GetPointData()->GetScalars()->Modified();
  addField(grid, "new", 1, [](Vec p) { return Vec{p[2]}; });
  instance->Update();
  EXPECT_EQ(instance->GetStructureTime(), first);

  // A new data set over the same points, in another locator of the prototype.
  const Grid copy = Grid::New();
  copy->ShallowCopy(grid);
  const auto other = Locator::Take(prototype->NewInstance());
  other->SetDataSet(copy);
  other->Update();
  EXPECT_EQ(other->GetStructureTime(), first);

  Vec p = {0.0, 0.0, 0.0}, q = {20.0, 0.0, 0.0};
  EXPECT_GE(instance->FindCell(p.data()), 0);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Vec at = pointOf(grid, i);
    grid->GetPoints()->SetPoint(i, at[0] + 20.0, at[1], at[2]);
  }
  grid->GetPoints()->Modified();
  instance->Update();
  const auto second = instance->GetStructureTime();
  EXPECT_GT(second, first);
  EXPECT_LT(instance->FindCell(p.data()), 0);
  EXPECT_GE(instance->FindCell(q.data()), 0);

  instance->SetStructureName("cylgrid");
  instance->Update();
  EXPECT_GT(instance->GetStructureTime(), second);
  instance->FreeSearchStructure();
  EXPECT_EQ(instance->GetStructureTime(), 0);
  EXPECT_LT(instance->FindCell(q.data()), 0);
}

TEST(CylindricalLocator, StructuredGridsAndImages)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 5, 6);
  image->SetSpacing(0.5, 1.0, 2.0);
  vtkNew<vtkStructuredGrid> curved;
  curved->SetDimensions(4, 5, 6);
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    points->InsertNextPoint(image->GetPoint(i));
  curved->SetPoints(points);
  for (vtkDataSet* data : {static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(curved)})
  {
    const Locator locator = locatorOf(data);
    EXPECT_EQ(locator->GetNumberOfCells(), 3 * 4 * 5);
    Vec p = {0.7, 3.25, 9.0}, pcoords{};
    double weights[8];
    vtkNew<vtkGenericCell> cell;
    EXPECT_EQ(locator->FindCell(p.data(), 0.0, cell, pcoords.data(), weights), 1 + 3 * (3 + 4 * 4));
    EXPECT_NEAR(pcoords[0], 0.4, 1e-12);
    EXPECT_NEAR(pcoords[1], 0.25, 1e-12);
    EXPECT_NEAR(pcoords[2], 0.5, 1e-12);
    EXPECT_TRUE(locator->InsideCellBounds(p.data(), 1 + 3 * (3 + 4 * 4)));
    EXPECT_FALSE(locator->InsideCellBounds(p.data(), 0));
    EXPECT_FALSE(locator->InsideCellBounds(p.data(), 1000));
    Vec corner = {1.5, 4.0, 10.0}; // of the outside, and of the last cell
    EXPECT_EQ(locator->FindCell(corner.data()), 3 * 4 * 5 - 1);
  }
  const Locator locator = locatorOf(curved);
  const auto built = locator->GetStructureTime();
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfTuples(curved->GetNumberOfPoints());
  curved->GetPointData()->SetScalars(values);
  locator->Update();
  EXPECT_EQ(locator->GetStructureTime(), built);
  curved->BlankCell(1 + 3 * (3 + 4 * 4));
  locator->Update();
  EXPECT_EQ(locator->GetNumberOfCells(), 3 * 4 * 5 - 1);
}

TEST(CylindricalLocator, NothingToFindIsNoCrash)
{
  const Grid empty = Grid::New();
  const Grid lines = cellsOf(VTK_LINE, {{0, 0, 0}, {1, 0, 0}}, {{0, 1}});
  const Grid flat = cellsOf(VTK_HEXAHEDRON,
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
    {{0, 1, 2, 3, 4, 5, 6, 7}});
  for (const Grid& grid : {empty, lines, flat})
    for (const std::string& name : names)
    {
      const Locator locator = locatorOf(grid, name);
      EXPECT_EQ(locator->GetNumberOfCells(), 0);
      Vec p = {0.5, 0.0, 0.0}, q = {0.5, 1.0, 1.0}, x, pcoords;
      EXPECT_EQ(locator->FindCell(p.data()), -1);
      EXPECT_EQ(locator->FindCell(p.data(), 1.0, nullptr, nullptr, nullptr), -1);
      double t = 0.0, distance2 = 0.0;
      int subId = 0;
      vtkIdType id = 7;
      EXPECT_EQ(
        locator->IntersectWithLine(p.data(), q.data(), 0.0, t, x.data(), pcoords.data(), subId, id),
        0);
      locator->FindClosestPoint(p.data(), x.data(), id, subId, distance2);
      EXPECT_EQ(id, -1);
      vtkNew<vtkIdList> cells;
      double box[6] = {-1, 1, -1, 1, -1, 1};
      locator->FindCellsWithinBounds(box, cells);
      EXPECT_EQ(cells->GetNumberOfIds(), 0);
      locator->FindCellsAlongLine(p.data(), q.data(), 0.0, cells);
      EXPECT_EQ(cells->GetNumberOfIds(), 0);
      vtkNew<vtkPolyData> drawn;
      locator->GenerateRepresentation(0, drawn);
      EXPECT_EQ(drawn->GetNumberOfPoints(), 0);
    }
}

TEST(CylindricalLocator, ErrorsAreSentences)
{
  const Locator locator = Locator::New();
  const Errors errors(locator);
  const auto last = [&] { return errors.texts.empty() ? std::string() : errors.texts.back(); };
  Vec p = {0.5, 0.5, 0.5};
  locator->BuildLocator();
  EXPECT_NE(last().find("needs a data set"), std::string::npos);
  EXPECT_EQ(locator->FindCell(p.data()), -1);
  const Grid grid = block(2, [](Vec q) { return q; });
  locator->SetDataSet(grid);
  locator->SetStructureName("octree");
  locator->BuildLocator();
  EXPECT_NE(last().find("no structure of the name \"octree\""), std::string::npos);
  locator->SetStructureName("cylgrid");
  locator->FindAxisOff();
  locator->SetAxis(0.0, 0.0, 0.0);
  locator->BuildLocator();
  EXPECT_NE(last().find("needs a direction"), std::string::npos);
  const auto count = errors.texts.size();
  locator->SetAxis(0.0, 1.0, 0.0);
  locator->BuildLocator();
  EXPECT_GE(locator->FindCell(p.data()), 0);
  const Grid bad = block(1, [](Vec q) { return q; });
  bad->GetCells()->GetConnectivityArray()->SetComponent(3, 0, 99.0);
  locator->SetDataSet(bad);
  locator->BuildLocator();
  EXPECT_NE(last().find("names the point 99"), std::string::npos);
  EXPECT_EQ(errors.texts.size(), count + 1);
  EXPECT_EQ(locator->FindCell(p.data()), -1);
  locator->SetDataSet(nullptr);
  EXPECT_EQ(locator->FindCell(p.data()), -1);
}

TEST(CylindricalLocator, DrawsWhatItCovers)
{
  const Grid grid = swirl(1);
  for (const std::string& name : names)
  {
    const Locator locator = locatorOf(grid, name);
    vtkNew<vtkPolyData> drawn;
    locator->GenerateRepresentation(0, drawn);
    const double *b = drawn->GetBounds(), *all = grid->GetBounds();
    EXPECT_GT(drawn->GetNumberOfLines(), 5);
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(b[k], all[k], 0.02 * grid->GetLength()) << name;
  }
}

} // namespace
