// VTK's own filters through the locator: the same answers as through vtkStaticCellLocator.
//
// Values are compared to 1e-5 of the array's range: both locators have VTK's filter interpolate
// in the cell that they found, so that they differ only where a point lies on a face, for which
// either neighbour may be named, and VTK's cells find their coordinates to about 1e-6.

#include "LocatorTools.h"

#include <vtkCellArray.h>
#include <vtkCellLocatorInterpolatedVelocityField.h>
#include <vtkCharArray.h>
#include <vtkImageData.h>
#include <vtkMoteCylindricalLocator.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkResampleToImage.h>
#include <vtkResampleWithDataSet.h>
#include <vtkStaticCellLocator.h>
#include <vtkStreamTracer.h>
#include <vtkStructuredGrid.h>

#include <gtest/gtest.h>

namespace
{

vtkSmartPointer<vtkPolyData> pointsOf(const std::vector<Vec>& places)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec& p : places)
    points->InsertNextPoint(p.data());
  data->SetPoints(points);
  return data;
}

/// The points of an image, in a grid: of images VTK's probes look up no point at all, but go
/// through the source's cells and the points in each one's bounds.
vtkSmartPointer<vtkStructuredGrid> latticeOver(const double b[6], int n)
{
  auto lattice = vtkSmartPointer<vtkStructuredGrid>::New();
  lattice->SetDimensions(n, n, n);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        points->InsertNextPoint(b[0] + (b[1] - b[0]) * i / (n - 1),
          b[2] + (b[3] - b[2]) * j / (n - 1), b[4] + (b[5] - b[4]) * k / (n - 1));
  lattice->SetPoints(points);
  return lattice;
}

template <class Filter>
vtkSmartPointer<vtkDataSet> probed(
  vtkDataSet* places, vtkDataObject* source, vtkAbstractCellLocator* prototype)
{
  vtkNew<Filter> filter;
  filter->SetInputData(places);
  filter->SetSourceData(source);
  filter->SetCellLocatorPrototype(prototype);
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

/// Whether a filter had a locator of the prototype's search the data set: what it built is there.
bool hasSearched(vtkMoteCylindricalLocator* prototype, vtkDataSet* data)
{
  vtkNew<vtkObject> now;
  now->Modified();
  const auto locator = vtkSmartPointer<vtkMoteCylindricalLocator>::Take(prototype->NewInstance());
  locator->SetDataSet(data);
  locator->Update();
  return locator->GetStructureTime() < now->GetMTime();
}

/// VTK's wedges, pyramids and tetrahedra claim what is up to a thousandth of them outside.
double toleranceOf(const std::string& mesh)
{
  return mesh == "mixed" ? 2e-4 : 1e-5;
}

/// Compares all arrays, and which points are in a cell. Tells how many are.
int expectSame(vtkDataSet* found, vtkDataSet* expected, const std::string& mesh, double relative)
{
  vtkPointData *a = found->GetPointData(), *b = expected->GetPointData();
  auto* valid = vtkCharArray::SafeDownCast(a->GetArray("vtkValidPointMask"));
  auto* theirs = vtkCharArray::SafeDownCast(b->GetArray("vtkValidPointMask"));
  int inside = 0, other = 0;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    inside += valid->GetValue(i);
    other += valid->GetValue(i) != theirs->GetValue(i);
  }
  EXPECT_EQ(other, 0) << mesh << ": in a cell by one locator only, of " << inside;
  EXPECT_GE(a->GetNumberOfArrays(), 3) << mesh;
  for (int k = 0; k < a->GetNumberOfArrays(); ++k)
  {
    vtkDataArray *mine = a->GetArray(k), *array = b->GetArray(a->GetArrayName(k));
    if (mine == valid)
      continue;
    int wrong = 0;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double *range = array->GetRange(c), tolerance = relative * (range[1] - range[0]);
      for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
        wrong += valid->GetValue(i) && theirs->GetValue(i) &&
                 !(std::abs(mine->GetComponent(i, c) - array->GetComponent(i, c)) <= tolerance);
    }
    EXPECT_EQ(wrong, 0) << mesh << " " << array->GetName();
  }
  return inside;
}

TEST(LocatorFilters, ProbesAreThoseOfVTKsLocator)
{
  vtkNew<vtkMoteCylindricalLocator> mine;
  vtkNew<vtkStaticCellLocator> theirs;
  for (const auto& [mesh, grid] : locatorMeshes())
  {
    const auto places = pointsOf(placesFor(grid, 4000, 11));
    const int inside = expectSame(probed<vtkProbeFilter>(places, grid, mine),
      probed<vtkProbeFilter>(places, grid, theirs), mesh, toleranceOf(mesh));
    EXPECT_GT(inside, 2900) << mesh;
    EXPECT_TRUE(hasSearched(mine, grid)) << mesh;
  }
}

TEST(LocatorFilters, ImagesAreThoseOfResampleToImage)
{
  constexpr int n = 23;
  for (const auto& [mesh, grid] : locatorMeshes())
  {
    vtkNew<vtkResampleToImage> resample; // takes no locator
    resample->SetInputDataObject(grid);
    resample->SetUseInputBounds(true);
    resample->SetSamplingDimensions(n, n, n);
    resample->Update();
    vtkImageData* image = resample->GetOutput();
    vtkNew<vtkMoteCylindricalLocator> mine;
    const auto lattice = latticeOver(image->GetBounds(), n);
    const int inside =
      expectSame(probed<vtkProbeFilter>(lattice, grid, mine), image, mesh, toleranceOf(mesh));
    EXPECT_GT(inside, 500) << mesh;
    EXPECT_TRUE(hasSearched(mine, grid)) << mesh;
  }
}

TEST(LocatorFilters, AWholePumpIsResampledOnce)
{
  vtkNew<vtkMotePumpSource> pump;
  setSmall(pump);
  pump->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(pump->GetOutputDataObject(0));
  vtkNew<vtkMoteCylindricalLocator> mine;
  vtkNew<vtkStaticCellLocator> theirs;
  const double bounds[6] = {-0.15, 0.15, -0.15, 0.15, -0.15, 0.15};
  const auto lattice = latticeOver(bounds, 40);
  const auto resampled = probed<vtkResampleWithDataSet>(lattice, blocks, mine);
  const int inside =
    expectSame(resampled, probed<vtkResampleWithDataSet>(lattice, blocks, theirs), "pump", 1e-5);
  EXPECT_GT(inside, 4000);
  // What was built serves other values in the same cells, too.
  for (const double time : {0.0, 0.013})
  {
    pump->UpdateTimeStep(time);
    blocks = vtkMultiBlockDataSet::SafeDownCast(pump->GetOutputDataObject(0));
    for (unsigned i = 0; i < 3; ++i)
      EXPECT_TRUE(hasSearched(mine, vtkDataSet::SafeDownCast(blocks->GetBlock(i)))) << time;
  }
}

vtkSmartPointer<vtkPolyData> traced(
  vtkDataObject* source, vtkPolyData* seeds, double length, vtkAbstractCellLocator* prototype)
{
  vtkNew<vtkCellLocatorInterpolatedVelocityField> field;
  field->SetCellLocatorPrototype(prototype);
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInterpolatorPrototype(field);
  tracer->SetInputDataObject(source);
  tracer->SetSourceData(seeds);
  tracer->SetIntegratorTypeToRungeKutta4();
  tracer->SetIntegrationStepUnit(vtkStreamTracer::LENGTH_UNIT);
  tracer->SetInitialIntegrationStep(length / 200.0);
  tracer->SetMaximumPropagation(length);
  tracer->SetMaximumNumberOfSteps(400);
  tracer->SetIntegrationDirectionToBoth();
  tracer->SetComputeVorticity(false);
  tracer->Update();
  return tracer->GetOutput();
}

/// The same lines: as many points each, at places to within 1e-4 of the length.
void expectSameLines(vtkPolyData* found, vtkPolyData* expected, double length, vtkIdType least,
  const std::string& mesh)
{
  ASSERT_EQ(found->GetNumberOfLines(), expected->GetNumberOfLines()) << mesh;
  EXPECT_GE(found->GetNumberOfPoints(), least) << mesh;
  vtkNew<vtkIdList> a, b;
  found->GetLines()->InitTraversal();
  expected->GetLines()->InitTraversal();
  int other = 0;
  while (found->GetLines()->GetNextCell(a) && expected->GetLines()->GetNextCell(b))
  {
    ASSERT_NEAR(double(a->GetNumberOfIds()), double(b->GetNumberOfIds()), 1.0) << mesh;
    other += a->GetNumberOfIds() != b->GetNumberOfIds();
    const vtkIdType common = std::min(a->GetNumberOfIds(), b->GetNumberOfIds());
    for (vtkIdType i = 0; i < common; ++i)
    {
      Vec p, q;
      found->GetPoint(a->GetId(i), p.data());
      expected->GetPoint(b->GetId(i), q.data());
      ASSERT_LT(::length(p - q), 1e-4 * length) << mesh << " point " << i;
    }
  }
  EXPECT_LE(other, found->GetNumberOfLines() / 20) << mesh;
}

TEST(LocatorFilters, StreamLinesAreThoseOfVTKsLocator)
{
  vtkNew<vtkMoteCylindricalLocator> mine;
  vtkNew<vtkStaticCellLocator> theirs;
  for (const auto& [mesh, grid] : locatorMeshes())
  {
    const auto seeds = pointsOf(placesFor(grid, 40, 12));
    const double length = 0.4 * grid->GetLength();
    expectSameLines(
      traced(grid, seeds, length, mine), traced(grid, seeds, length, theirs), length, 1000, mesh);
    EXPECT_TRUE(hasSearched(mine, grid)) << mesh;
  }
}

TEST(LocatorFilters, StreamLinesGoThroughAllPartsOfThePump)
{
  vtkNew<vtkMotePumpSource> pump;
  setSmall(pump);
  pump->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(pump->GetOutputDataObject(0));
  std::vector<Vec> places;
  for (unsigned i = 0; i < 3; ++i)
  {
    const auto more = placesFor(vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(i)), 12, 13);
    places.insert(places.end(), more.begin(), more.end());
  }
  const auto seeds = pointsOf(places);
  vtkNew<vtkMoteCylindricalLocator> mine;
  vtkNew<vtkStaticCellLocator> theirs;
  expectSameLines(
    traced(blocks, seeds, 0.2, mine), traced(blocks, seeds, 0.2, theirs), 0.2, 1000, "pump");
  for (unsigned i = 0; i < 3; ++i)
    EXPECT_TRUE(hasSearched(mine, vtkDataSet::SafeDownCast(blocks->GetBlock(i))));
}

} // namespace
