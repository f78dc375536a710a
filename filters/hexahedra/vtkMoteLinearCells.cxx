#include "vtkMoteLinearCells.h"

#include "CellLattice.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <vector>

vtkStandardNewMacro(vtkMoteLinearCells);

namespace
{

constexpr const char* originalName = "OriginalCellIds";

/// The corners of a face, in ascending order.
using Face = std::array<vtkIdType, 4>;

struct FaceHash
{
  std::size_t operator()(const Face& face) const
  {
    std::size_t hash = 0;
    for (const vtkIdType corner : face)
      hash = (hash ^ static_cast<std::size_t>(corner)) * 0x9e3779b97f4a7c15;
    return hash ^ hash >> 32;
  }
};

/// Which cells of a grid are cut, and into how many.
class Orders
{
public:
  explicit Orders(vtkUnstructuredGrid* grid)
    : grid_(grid)
    , types_(grid->GetCellTypesArray())
    , degrees_(grid->GetCellData()->GetHigherOrderDegrees())
  {
    if (degrees_ && degrees_->GetNumberOfComponents() != 3)
      degrees_ = nullptr;
    // Most grids have none, which their types tell fast.
    for (int type = 0; type < 256; ++type)
      isCut_[type] = CellLattice::cuts(type);
  }

  std::optional<CellLattice::Order> of(vtkIdType cell) const
  {
    const int type = types_->GetValue(cell);
    if (!isCut_[type])
      return std::nullopt;
    return CellLattice::orderOf(type, grid_->GetCells()->GetCellSize(cell), this->toldOf(cell));
  }

private:
  /// As the file has it: other cells of it have zeros.
  std::optional<CellLattice::Order> toldOf(vtkIdType cell) const
  {
    if (!degrees_)
      return std::nullopt;
    CellLattice::Order order;
    for (int k = 0; k < 3; ++k)
      order[k] = static_cast<int>(std::clamp(degrees_->GetComponent(cell, k), 0.0, 1000.0));
    return order;
  }

  vtkUnstructuredGrid* grid_;
  vtkUnsignedCharArray* types_;
  vtkDataArray* degrees_;
  bool isCut_[256];
};

/// Points and cells of a grid with its cells cut.
class Cutter
{
public:
  explicit Cutter(vtkUnstructuredGrid* grid)
    : grid_(grid)
    , orders_(grid)
  {
  }

  vtkSmartPointer<vtkUnstructuredGrid> cut()
  {
    this->beginPoints();
    for (vtkIdType cell = 0; cell < grid_->GetNumberOfCells(); ++cell)
      if (const auto order = orders_.of(cell))
        this->addCells(cell, *order);
      else
        this->copy(cell);
    return this->finish();
  }

private:
  void beginPoints()
  {
    const vtkIdType count = grid_->GetNumberOfPoints();
    points_->SetDataType(grid_->GetPoints()->GetDataType());
    points_->SetNumberOfPoints(count);
    points_->InsertPoints(0, count, 0, grid_->GetPoints());
    values_->InterpolateAllocate(grid_->GetPointData(), count);
    values_->CopyData(grid_->GetPointData(), 0, count, 0);
    original_->SetName(originalName);
    made_->SetPoints(points_);
    made_->Allocate(8 * grid_->GetNumberOfCells());
  }

  void copy(vtkIdType cell)
  {
    const int type = grid_->GetCellType(cell);
    if (type == VTK_POLYHEDRON)
      grid_->GetFaceStream(cell, ids_);
    else
      grid_->GetCellPoints(cell, ids_);
    made_->InsertNextCell(type, ids_);
    original_->InsertNextValue(cell);
  }

  void addCells(vtkIdType cell, const CellLattice::Order& order)
  {
    grid_->GetCell(cell, cell_);
    const CellLattice& lattice = lattices_.of(cell_->GetRepresentativeCell(), order);
    numbers_.clear();
    for (const CellLattice::Point& point : lattice.points)
      numbers_.push_back(point.node >= 0 ? cell_->GetPointId(point.node) : this->pointFor(point));
    for (const CellLattice::Cell& part : lattice.cells)
    {
      ids_->SetNumberOfIds(0);
      for (const int point : part.points)
        ids_->InsertNextId(numbers_[static_cast<std::size_t>(point)]);
      made_->InsertNextCell(part.type, ids_);
      original_->InsertNextValue(cell);
    }
  }

  /// The point in the middle of a face, which two cells have, or of the cell at hand.
  vtkIdType pointFor(const CellLattice::Point& point)
  {
    if (point.corners[0] < 0)
      return this->makePoint(point);
    Face face;
    std::transform(point.corners.begin(), point.corners.end(), face.begin(),
      [&](int corner) { return cell_->GetPointId(corner); });
    std::sort(face.begin(), face.end());
    const auto [found, isNew] = faces_.try_emplace(face, 0);
    if (isNew)
      found->second = this->makePoint(point);
    return found->second;
  }

  vtkIdType makePoint(const CellLattice::Point& point)
  {
    double place[3] = {};
    for (std::size_t node = 0; node < point.weights.size(); ++node)
    {
      double of[3];
      cell_->GetPoints()->GetPoint(static_cast<vtkIdType>(node), of);
      for (int k = 0; k < 3; ++k)
        place[k] += point.weights[node] * of[k];
    }
    const vtkIdType id = points_->InsertNextPoint(place);
    weights_ = point.weights;
    values_->InterpolatePoint(grid_->GetPointData(), id, cell_->GetPointIds(), weights_.data());
    return id;
  }

  vtkSmartPointer<vtkUnstructuredGrid> finish()
  {
    made_->Squeeze();
    made_->GetPointData()->ShallowCopy(values_);
    vtkNew<vtkIdList> from, to;
    const vtkIdType count = original_->GetNumberOfValues();
    from->SetNumberOfIds(count);
    to->SetNumberOfIds(count);
    std::copy_n(original_->GetPointer(0), count, from->GetPointer(0));
    for (vtkIdType i = 0; i < count; ++i)
      to->SetId(i, i);
    vtkCellData* cells = made_->GetCellData();
    cells->CopyAllOn();
    cells->CopyAllocate(grid_->GetCellData(), count);
    cells->CopyData(grid_->GetCellData(), from, to);
    // The cells are of order 1 now.
    if (cells->GetHigherOrderDegrees())
      cells->RemoveArray(cells->GetHigherOrderDegrees()->GetName());
    if (!cells->HasArray(originalName))
      cells->AddArray(original_);
    made_->GetFieldData()->ShallowCopy(grid_->GetFieldData());
    return made_;
  }

  vtkUnstructuredGrid* grid_;
  Orders orders_;
  vtkSmartPointer<vtkUnstructuredGrid> made_ = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points_;
  vtkNew<vtkPointData> values_;
  vtkNew<vtkIdTypeArray> original_;
  vtkNew<vtkGenericCell> cell_;
  vtkNew<vtkIdList> ids_;
  CellLattices lattices_;
  std::unordered_map<Face, vtkIdType, FaceHash> faces_; ///< the points made in their middles
  std::vector<vtkIdType> numbers_;
  std::vector<double> weights_;
};

/// About the memory that the cut grid takes: its linear cells and its points.
vtkTypeUInt64 bytesOf(vtkUnstructuredGrid* grid)
{
  const Orders orders(grid);
  vtkTypeUInt64 cells = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const auto order = orders.of(cell);
    cells += order ? static_cast<vtkTypeUInt64>((*order)[0] * (*order)[1] * (*order)[2]) : 1;
  }
  return cells * (9 * 8 + 1 + 8) + static_cast<vtkTypeUInt64>(grid->GetNumberOfPoints()) * 24;
}

} // namespace

vtkIdType vtkMoteLinearCells::CountIn(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid || grid->GetNumberOfCells() == 0)
    return 0;
  const Orders orders(grid);
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    count += orders.of(cell).has_value();
  return count;
}

vtkDataSet* vtkMoteLinearCells::Of(vtkDataSet* data, vtkTypeUInt64 mostBytes)
{
  vtkSmartPointer<vtkDataSet> result = data;
  if (vtkMoteLinearCells::CountIn(data) > 0)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    if (mostBytes == 0 || bytesOf(grid) <= mostBytes)
      result = Cutter(grid).cut();
  }
  if (result)
    result->Register(nullptr); // the caller's reference
  return result;
}
