// Cells that are hidden: mappers show what they show of the data without them. No display.
#include "MeshTestSupport.h"
#include "VolumeTestSupport.h"

#include <CellSelection.h>
#include <vtkMoteCellSelection.h>

#include "vtkCellData.h"
#include "vtkCellTypeSource.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMoteAreaPicker.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <map>
#include <set>

using namespace mote::testing;

namespace
{

template <typename IsVisible>
vtkSmartPointer<vtkUnsignedCharArray> marksOf(vtkIdType cells, const IsVisible& isVisible)
{
  auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  marks->SetName("marks");
  for (vtkIdType c = 0; c < cells; ++c)
    marks->InsertNextValue(isVisible(c) ? 1 : 0);
  return marks;
}

/// The grid of the marked cells alone.
vtkSmartPointer<vtkUnstructuredGrid> only(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* marks)
{
  const auto marked = copyOf(grid);
  marked->GetCellData()->AddArray(marks);
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(marked);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "marks");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(1.0);
  threshold->Update();
  auto rest = copyOf(threshold->GetOutput());
  rest->GetPointData()->SetActiveScalars("f");
  return rest;
}

double ofPlace(const Point& p)
{
  return p[0] + 0.5 * p[2];
}

/// Every third one, and the corner.
bool isEveryThird(vtkIdType cell)
{
  return cell % 3 == 1 && cell != 0;
}

vtkSmartPointer<vtkUnstructuredGrid> hexahedra()
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(VTK_HEXAHEDRON);
  source->SetBlocksDimensions(3, 3, 3);
  source->Update();
  return source->GetOutput();
}

} // namespace

TEST(VisibleCells, OfVolumesAreSeenAsTheyAreAloneAndNothingIsBuilt)
{
  const auto grid = makeBox(6, ofPlace);
  VolumeStage stage(grid);
  stage.paint({1.0, 0.5, 0.2}, 0.6);
  const Picture whole = stage.trace();
  const auto marks = marksOf(grid->GetNumberOfCells(), isEveryThird);
  VolumeStage rest(only(grid, marks));
  rest.paint({1.0, 0.5, 0.2}, 0.6);
  const auto change = stage.mapper->GetPictureMTime();
  stage.mapper->SetVisibleCells(marks);
  EXPECT_GT(stage.mapper->GetPictureMTime(), change);
  EXPECT_EQ(stage.mapper->GetVisibleCells(), marks);
  EXPECT_LT(mostBetween(stage.trace(), rest.trace()), 1e-3);
  EXPECT_GT(mostBetween(stage.trace(), whole), 0.1);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
  // Isosurfaces, too, which have a structure of their own.
  for (VolumeStage* one : {&stage, &rest})
  {
    one->mapper->ShowCloudOff();
    one->mapper->ShowIsoSurfacesOn();
    one->property()->GetIsoSurfaceValues()->SetValue(0, 0.2);
  }
  EXPECT_GT(rest.trace().covered(), 50);
  EXPECT_EQ(stage.trace().covered(), rest.trace().covered());
  const int builds = stage.mapper->GetNumberOfBuilds();
  // Marks may change in place.
  marks->FillValue(0);
  marks->Modified();
  EXPECT_EQ(stage.trace().covered(), 0);
  stage.mapper->SetVisibleCells(nullptr);
  EXPECT_GT(stage.trace().covered(), rest.trace().covered());
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), builds);
  EXPECT_EQ(stage.mapper->GetNumberOfFieldUpdates(), 1);
}

TEST(VisibleCells, WrongNumbersOfMarksAreTold)
{
  VolumeStage stage(makeBox(3, ofPlace));
  stage.mapper->SetVisibleCells(marksOf(5, [](vtkIdType) { return true; }));
  const Complaints complaints(stage.mapper);
  EXPECT_EQ(stage.trace().covered(), 0);
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("5 values"), std::string::npos) << complaints.text;

  vtkNew<vtkMoteMeshMapper> mapper;
  mapper->SetInputData(polygonAndStrip());
  mapper->SetVisibleCells(marksOf(2, [](vtkIdType) { return true; }));
  const Complaints others(mapper);
  mapper->Update();
  EXPECT_EQ(others.errors, 1);
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 0);
}

TEST_F(MeshStage, HiddenPolygonsAndStripsAreNotThere)
{
  mapper->SetInputData(polygonAndStrip()); // a line, a polygon, a strip
  const Complaints complaints(mapper);
  mapper->SetVisibleCells(marksOf(3, [](vtkIdType c) { return c != 1; }));
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 2);
  EXPECT_EQ(cellAt(0.0, 0.0), -1);
  EXPECT_EQ(cellAt(0.55, -0.4), 2);
  mapper->SetVisibleCells(marksOf(3, [](vtkIdType c) { return c == 1; }));
  mapper->Update();
  EXPECT_EQ(cellAt(-0.25, 0.25), 1);
  EXPECT_EQ(cellAt(0.55, -0.4), -1);
  mapper->SetVisibleCells(marksOf(3, [](vtkIdType c) { return c == 0; }));
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 0);
  EXPECT_EQ(trace().covered(), 0);
  EXPECT_LT(mapper->GetBounds()[1], mapper->GetBounds()[0]) << "of nothing";
  mapper->SetVisibleCells(nullptr);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 4);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1) << "the tree has all of them";
}

TEST_F(MeshStage, FacesOfHiddenCellsComeToLight)
{
  const auto grid = hexahedra();
  mapper->SetInputData(grid);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 108);
  const vtkIdType cells = grid->GetNumberOfCells();
  mapper->SetVisibleCells(marksOf(cells, [](vtkIdType c) { return c != 13; }));
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 120); // the middle's six
  const auto inRow = [](vtkIdType c) { return c < 3; };
  mapper->SetVisibleCells(marksOf(cells, inRow));
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 28);
  // The same marks of another array build nothing; other mappers take what was built.
  const int builds = mapper->GetNumberOfBuilds();
  mapper->SetVisibleCells(marksOf(cells, inRow));
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfBuilds(), builds);
  vtkNew<vtkMoteMeshMapper> other;
  other->SetInputData(grid);
  other->SetVisibleCells(marksOf(cells, inRow));
  other->OfferBuilt(mapper->GetBuilt());
  other->Update();
  EXPECT_EQ(other->GetNumberOfBuilds(), 0);
  EXPECT_EQ(other->GetNumberOfTriangles(), 28);
}

TEST(VisibleCells, AreThoseWhoseMeansLieInAllRanges)
{
  const auto grid = makeBox(5, ofPlace);
  const vtkIdType cells = grid->GetNumberOfCells();
  grid->GetCellData()->GetArray("c")->SetComponent(7, 0, NAN);
  vtkDataArray* f = grid->GetPointData()->GetArray("f");
  vtkDataArray* c = grid->GetCellData()->GetArray("c");
  mote::CellSelection selection(grid);
  EXPECT_EQ(selection.isVisible(), nullptr);
  EXPECT_EQ(selection.numberVisible(), cells);
  selection.limit(f, 0, false, {{-0.7, 0.1}, {0.3, 2.0}});
  selection.limit(c, 0, true, {{-10.0, 10.0}});
  selection.limitPlace(1, {{-0.5, 0.7}});
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    vtkIdList* points = grid->GetCell(cell)->GetPointIds();
    double mean = 0.0, y = 0.0;
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      mean += f->GetComponent(points->GetId(i), 0) / 8.0;
      y += grid->GetPoint(points->GetId(i))[1] / 8.0;
    }
    if (std::abs(mean + 0.7) < 1e-6 || std::abs(mean - 0.1) < 1e-6 || std::abs(mean - 0.3) < 1e-6)
      continue; // rounding decides
    const bool isIn = (mean >= -0.7 && mean <= 0.1) || mean >= 0.3;
    const bool wanted = isIn && std::isfinite(c->GetComponent(cell, 0)) && y >= -0.5 && y <= 0.7;
    EXPECT_EQ(selection.isVisible()->GetValue(cell), wanted ? 1 : 0) << cell;
    count += wanted;
  }
  EXPECT_GT(count, 10);
  EXPECT_LT(count, cells / 2);
  EXPECT_THROW(selection.limit(f, 0, true, {{0.0, 1.0}}), std::exception);

  // The class of VTK's for it does the same.
  vtkNew<vtkMoteCellSelection> wrapped;
  wrapped->SetDataSet(grid);
  EXPECT_EQ(wrapped->GetVisibleCells(), nullptr);
  wrapped->AddInterval(-0.7, 0.1);
  wrapped->AddInterval(0.3, 2.0);
  EXPECT_TRUE(wrapped->Limit("f", 0, false));
  wrapped->AddInterval(-10.0, 10.0);
  EXPECT_TRUE(wrapped->Limit("c", 0, true));
  wrapped->AddInterval(-0.5, 0.7);
  EXPECT_TRUE(wrapped->LimitPlace(1));
  EXPECT_EQ(wrapped->GetNumberOfVisibleCells(), selection.numberVisible());
  for (vtkIdType cell = 0; cell < cells; ++cell)
    EXPECT_EQ(wrapped->GetVisibleCells()->GetValue(cell), selection.isVisible()->GetValue(cell));
  wrapped->GlobalWarningDisplayOff();
  EXPECT_FALSE(wrapped->Limit("none", 0, true));
  EXPECT_FALSE(wrapped->Limit("c", 3, true));
  EXPECT_FALSE(wrapped->LimitPlace(3));
  wrapped->GlobalWarningDisplayOn();
}

TEST(VisibleCells, ThoseInARectangleAreFoundAtEveryPixel)
{
  constexpr int width = 70, height = 50;
  const auto grid = makeBox(5, ofPlace);
  VolumeStage stage(grid);
  stage.paint({1.0, 0.5, 0.2}, 0.8);
  stage.mapper->SetVisibleCells(marksOf(grid->GetNumberOfCells(), isEveryThird));
  // A mesh before a corner of it.
  vtkNew<vtkMoteMeshMapper> mesh;
  mesh->SetInputData(polygonAndStrip());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mesh);
  actor->SetPosition(0.9, 0.4, 1.3);
  stage.renderer->AddActor(actor);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetSize(width, height);
  window->AddRenderer(stage.renderer);
  stage.renderer->ResetCameraClippingRange();
  const int x0 = 12, y0 = 8, x1 = 60, y1 = 44;
  std::map<vtkProp*, std::set<vtkIdType>> truth, found;
  vtkNew<vtkMoteParticlePicker> one;
  one->PickCloudsOn();
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x)
      if (one->Pick(x, y, 0, stage.renderer))
      {
        truth[one->GetViewProp()].insert(one->GetCellId());
        low = std::fmin(low, one->GetValue());
        high = std::fmax(high, one->GetValue());
      }
  EXPECT_GT(truth[stage.volume].size(), 10u);
  EXPECT_GT(truth[actor].size(), 0u);
  vtkNew<vtkMoteAreaPicker> picker;
  EXPECT_EQ(picker->Pick(x0, y0, x1, y1, stage.renderer), 0) << "unless asked";
  picker->PickCellsOn();
  const vtkIdType count = picker->Pick(x0, y0, x1, y1, stage.renderer);
  EXPECT_EQ(count, static_cast<vtkIdType>(truth[stage.volume].size() + truth[actor].size()));
  for (int i = 0; i < picker->GetNumberOfProps(); ++i)
  {
    EXPECT_EQ(picker->GetParticles(i), nullptr);
    vtkIdTypeArray* cells = picker->GetCells(i);
    ASSERT_NE(cells, nullptr);
    for (vtkIdType k = 0; k < cells->GetNumberOfValues(); ++k)
      EXPECT_TRUE(found[picker->GetProp(i)].insert(cells->GetValue(k)).second);
  }
  EXPECT_EQ(found, truth);
  EXPECT_TRUE(std::isnan(picker->GetValueRange()[0])) << "unless asked";
  picker->PickValuesOn();
  picker->Pick(x0, y0, x1, y1, stage.renderer);
  EXPECT_LT(low, high);
  EXPECT_EQ(picker->GetValueRange()[0], low);
  EXPECT_EQ(picker->GetValueRange()[1], high);
  picker->PickCellsOff();
  EXPECT_EQ(picker->Pick(x0, y0, x1, y1, stage.renderer), 0) << "values alone";
  EXPECT_EQ(picker->GetValueRange()[0], low);
  picker->Pick(0, 0, 1, 1, stage.renderer); // of the background
  EXPECT_TRUE(std::isnan(picker->GetValueRange()[0]) && std::isnan(picker->GetValueRange()[1]));
}
