#include "vtkMoteStructuredCells.h"

#include "GridSeams.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <vector>

vtkStandardNewMacro(vtkMoteStructuredCells);

namespace
{

using Corner = std::array<double, 3>;

/// How many points a structured grid has along its axes; zeros for other data sets.
std::array<vtkIdType, 3> pointsAlong(vtkDataSet* data)
{
  int dimensions[3] = {0, 0, 0};
  if (auto* image = vtkImageData::SafeDownCast(data))
    image->GetDimensions(dimensions);
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
    rectilinear->GetDimensions(dimensions);
  else if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
    grid->GetDimensions(dimensions);
  return {dimensions[0], dimensions[1], dimensions[2]};
}

vtkSmartPointer<vtkPoints> pointsOf(vtkDataSet* data)
{
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
    return grid->GetPoints();
  const vtkIdType count = data->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(count);
  double place[3];
  data->GetPoint(0, place); // what VTK makes when it is first asked
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, 4096),
    [&, to = places->GetPointer(0)](const tbb::blocked_range<vtkIdType>& range)
    {
      for (vtkIdType i = range.begin(); i < range.end(); ++i)
        data->GetPoint(i, to + 3 * i);
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(places);
  return points;
}

/// Whether its cells are along the axes of space, from the least corner to the greatest.
bool isOfVoxels(vtkDataSet* data)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    const double* spacing = image->GetSpacing();
    return image->GetDirectionMatrix()->IsIdentity() &&
           std::all_of(spacing, spacing + 3, [](double step) { return step > 0.0; });
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (!grid)
    return false;
  for (vtkDataArray* along :
    {grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()})
    for (vtkIdType i = 1; i < along->GetNumberOfTuples(); ++i)
      if (!(along->GetComponent(i - 1, 0) < along->GetComponent(i, 0)))
        return false;
  return true;
}

/// The eight points of a cell in the order of the grid: along the first axis, the second, the
/// third.
std::array<vtkIdType, 8> cornersOf(vtkIdType cell, const std::array<vtkIdType, 3>& along)
{
  const vtkIdType nx = along[0] - 1, ny = along[1] - 1;
  const vtkIdType row = along[0], layer = along[0] * along[1];
  const vtkIdType first = cell % nx + row * (cell / nx % ny) + layer * (cell / nx / ny);
  return {first, first + 1, first + row, first + row + 1, first + layer, first + layer + 1,
    first + layer + row, first + layer + row + 1};
}

/// Whether a grid's axes are left-handed, as most of some cells in it tell.
bool isLeftHanded(vtkPoints* points, vtkIdType cells, const std::array<vtkIdType, 3>& along)
{
  const vtkIdType stride = std::max<vtkIdType>(1, cells / 64);
  vtkIdType inverted = 0;
  vtkIdType looked = 0;
  for (vtkIdType cell = 0; cell < cells; cell += stride, ++looked)
  {
    const auto corners = cornersOf(cell, along);
    std::array<Corner, 8> at;
    for (std::size_t i = 0; i < 8; ++i)
      points->GetPoint(corners[i], at[i].data());
    // Between the middles of opposite faces.
    Corner axes[3] = {};
    for (std::size_t i = 0; i < 8; ++i)
      for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 3; ++k)
          axes[axis][k] += (i >> axis & 1) ? at[i][k] : -at[i][k];
    const Corner &a = axes[0], &b = axes[1], &c = axes[2];
    const double volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                          a[2] * (b[0] * c[1] - b[1] * c[0]);
    inverted += volume < 0.0;
  }
  return 2 * inverted > looked;
}

template <class Ids>
void fill(vtkCellArray* cells, vtkIdType count, const std::array<vtkIdType, 3>& along,
  const std::array<int, 8>& order, const std::vector<vtkIdType>& seams)
{
  vtkNew<Ids> offsets;
  vtkNew<Ids> connectivity;
  offsets->SetNumberOfValues(count + 1);
  connectivity->SetNumberOfValues(8 * count);
  auto* const begins = offsets->GetPointer(0);
  auto* const ids = connectivity->GetPointer(0);
  using Id = typename Ids::ValueType;
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, 4096),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      for (vtkIdType cell = range.begin(); cell < range.end(); ++cell)
      {
        begins[cell] = static_cast<Id>(8 * cell);
        const auto corners = cornersOf(cell, along);
        for (int i = 0; i < 8; ++i)
        {
          const vtkIdType id = corners[order[i]];
          ids[8 * cell + i] =
            static_cast<Id>(seams.empty() ? id : seams[static_cast<std::size_t>(id)]);
        }
      }
    });
  begins[count] = static_cast<Id>(8 * count);
  cells->SetData(offsets, connectivity);
}

/// What tells of a cell or point that it is not to be shown.
constexpr unsigned char isHidden = vtkDataSetAttributes::DUPLICATECELL | // of another piece
                                   vtkDataSetAttributes::HIDDENCELL;

bool hasMarks(vtkUnsignedCharArray* ghosts, unsigned char marks)
{
  if (!ghosts)
    return false;
  const unsigned char* begin = ghosts->GetPointer(0);
  return std::any_of(begin, begin + ghosts->GetNumberOfValues(),
    [=](unsigned char value) { return (value & marks) != 0; });
}

/// Marks the cells of blanked points, too.
void hideCellsOfHiddenPoints(vtkUnstructuredGrid* grid)
{
  constexpr unsigned char pointMark = vtkDataSetAttributes::HIDDENPOINT;
  vtkUnsignedCharArray* points = grid->GetPointGhostArray();
  if (!hasMarks(points, pointMark))
    return;
  vtkUnsignedCharArray* before = grid->GetCellGhostArray();
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(grid->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    unsigned char mark = before ? before->GetValue(cell) : 0;
    grid->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
      if (points->GetValue(corners->GetId(i)) & pointMark)
        mark |= vtkDataSetAttributes::HIDDENCELL;
    marks->SetValue(cell, mark);
  }
  grid->GetCellData()->AddArray(marks);
}

/// The data without the cells that are marked; the data themselves where none is.
vtkSmartPointer<vtkDataSet> withoutGhosts(vtkDataSet* data)
{
  if (!hasMarks(data->GetCellGhostArray(), isHidden))
    return data;
  auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(copy))
    grid->RemoveGhostCells();
  else if (auto* surface = vtkPolyData::SafeDownCast(copy))
    surface->RemoveGhostCells();
  return copy;
}

vtkSmartPointer<vtkUnstructuredGrid> cellsOf(
  vtkDataSet* data, const std::array<vtkIdType, 3>& along, vtkIdType count)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto points = pointsOf(data);
  const bool isVoxels = isOfVoxels(data);
  std::array<int, 8> order = {0, 1, 2, 3, 4, 5, 6, 7};
  if (!isVoxels)
    order = isLeftHanded(points, count, along) ? std::array<int, 8>{4, 5, 7, 6, 0, 1, 3, 2}
                                               : std::array<int, 8>{0, 1, 3, 2, 4, 5, 7, 6};
  std::vector<vtkIdType> seams;
  if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
    seams = mote::seamsOf(structured, along);
  vtkNew<vtkCellArray> cells;
  if (8 * count < VTK_INT_MAX)
    fill<vtkTypeInt32Array>(cells, count, along, order, seams);
  else
    fill<vtkTypeInt64Array>(cells, count, along, order, seams);
  grid->SetPoints(points);
  grid->SetCells(isVoxels ? VTK_VOXEL : VTK_HEXAHEDRON, cells);
  grid->GetPointData()->ShallowCopy(data->GetPointData());
  grid->GetCellData()->ShallowCopy(data->GetCellData());
  grid->GetFieldData()->ShallowCopy(data->GetFieldData());
  hideCellsOfHiddenPoints(grid);
  return grid;
}

} // namespace

vtkDataSet* vtkMoteStructuredCells::Of(vtkDataSet* data, vtkTypeUInt64 mostBytes)
{
  if (!data)
    return nullptr;
  const auto along = pointsAlong(data);
  vtkSmartPointer<vtkDataSet> result = data;
  if (*std::min_element(along.begin(), along.end()) > 1)
  {
    const vtkIdType count = (along[0] - 1) * (along[1] - 1) * (along[2] - 1);
    // Corners of cells and their places, points.
    const auto bytes = static_cast<vtkTypeUInt64>(count) * (9 * 4 + 1 + 24);
    if (mostBytes == 0 || bytes <= mostBytes)
      result = cellsOf(data, along, count);
  }
  result = withoutGhosts(result);
  result->Register(nullptr); // the caller's reference
  return result;
}
