#include "vtkMoteLineTubes.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTubeFilter.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkMoteLineTubes);

namespace
{

using Place = std::array<double, 3>;

constexpr const char* radii = "MoteTubeRadii";

// Points of a line that are nearer together than this share of its bounds are one.
constexpr double coincident = 1e-9;
// A line that turns further than this, as a cosine, ends and begins anew.
constexpr double turnsBack = -0.8;

bool isFinite(const Place& place)
{
  return std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); });
}

bool isLine(int type)
{
  return type == VTK_LINE || type == VTK_POLY_LINE;
}

double sizeOf(vtkPointSet* points)
{
  vtkBoundingBox box;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Place place;
    points->GetPoint(i, place.data());
    if (isFinite(place))
      box.AddPoint(place.data());
  }
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

/// Calls visit(cell, points) for each line.
template <typename Visit>
void forLines(vtkPointSet* from, const Visit& visit)
{
  vtkNew<vtkIdList> points;
  if (auto* polygons = vtkPolyData::SafeDownCast(from)) // whose cells may not be built
  {
    vtkCellArray* const lines = polygons->GetLines();
    for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
    {
      lines->GetCellAtId(i, points);
      visit(polygons->GetNumberOfVerts() + i, points);
    }
    return;
  }
  for (vtkIdType cell = 0; cell < from->GetNumberOfCells(); ++cell)
    if (isLine(from->GetCellType(cell)))
    {
      from->GetCellPoints(cell, points);
      visit(cell, points);
    }
}

/// The lines of a data set without what tubes cannot follow, and which cells they are of.
class Paths
{
public:
  explicit Paths(vtkPointSet* from)
    : from_(from)
    , size_(sizeOf(from))
  {
    forLines(from,
      [this](vtkIdType cell, vtkIdList* points)
      {
        const std::size_t before = cells_.size();
        this->follow(cell, points);
        leftOut_ += cells_.size() == before;
      });
  }

  vtkCellArray* lines() const { return lines_; }
  const std::vector<vtkIdType>& cells() const { return cells_; }
  vtkIdType leftOut() const { return leftOut_; }
  double usualRadius() const
  {
    const double meanLength =
      length_ / static_cast<double>(std::max<std::size_t>(1, cells_.size()));
    return std::min(0.0015 * size_, 0.05 * meanLength);
  }

private:
  void follow(vtkIdType cell, vtkIdList* points)
  {
    Place last{}, direction{};
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      const vtkIdType point = points->GetId(i);
      Place place;
      from_->GetPoint(point, place.data());
      if (!isFinite(place))
      {
        this->end(cell);
        continue;
      }
      if (!path_.empty())
      {
        Place step;
        vtkMath::Subtract(place.data(), last.data(), step.data());
        const double length = vtkMath::Normalize(step.data());
        if (!(length > coincident * size_))
          continue;
        if (path_.size() > 1 && vtkMath::Dot(step.data(), direction.data()) < turnsBack)
        {
          const vtkIdType corner = path_.back();
          this->end(cell);
          path_.push_back(corner);
        }
        length_ += length;
        direction = step;
      }
      path_.push_back(point);
      last = place;
    }
    this->end(cell);
  }

  void end(vtkIdType cell)
  {
    if (path_.size() > 1)
    {
      lines_->InsertNextCell(static_cast<vtkIdType>(path_.size()), path_.data());
      cells_.push_back(cell);
    }
    path_.clear();
  }

  vtkPointSet* from_;
  double size_, length_ = 0.0;
  vtkNew<vtkCellArray> lines_;
  std::vector<vtkIdType> cells_, path_;
  vtkIdType leftOut_ = 0;
};

/// What vtkTubeFilter takes as its radii.
vtkSmartPointer<vtkDoubleArray> scaled(vtkDataArray* values, double scale)
{
  auto scaledValues = vtkSmartPointer<vtkDoubleArray>::New();
  scaledValues->SetName(radii);
  scaledValues->SetNumberOfValues(values->GetNumberOfTuples());
  double most = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    if (const double value = values->GetComponent(i, 0); std::isfinite(value))
      most = std::max(most, value);
  const double least = 1e-3 * most;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    scaledValues->SetValue(i, scale * (std::isfinite(value) && value > 0.0 ? value : least));
  }
  return scaledValues;
}

int usualSides(vtkCellArray* lines)
{
  constexpr vtkIdType mostCorners = 8'000'000;
  const vtkIdType points = std::max<vtkIdType>(1, lines->GetNumberOfConnectivityIds());
  return static_cast<int>(std::clamp<vtkIdType>(mostCorners / points, 3, 8));
}

vtkSmartPointer<vtkPolyData> polylines(vtkPointSet* from, const Paths& paths)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->SetPoints(from->GetPoints());
  lines->GetPointData()->ShallowCopy(from->GetPointData());
  // Normals of the data may lie along the lines; the filter makes its own.
  lines->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
  lines->SetLines(paths.lines());
  vtkCellData* const values = lines->GetCellData();
  const auto count = static_cast<vtkIdType>(paths.cells().size());
  values->CopyAllOn();
  values->CopyAllocate(from->GetCellData(), count);
  for (vtkIdType i = 0; i < count; ++i)
    values->CopyData(from->GetCellData(), paths.cells()[static_cast<std::size_t>(i)], i);
  return lines;
}

} // namespace

bool vtkMoteLineTubes::IsOfLines(vtkDataSet* data)
{
  if (auto* lines = vtkPolyData::SafeDownCast(data))
    return lines->GetNumberOfLines() > 0 && lines->GetNumberOfCells() == lines->GetNumberOfLines();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid || grid->GetNumberOfCells() == 0)
    return false;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    if (!isLine(grid->GetCellType(i)))
      return false;
  return true;
}

int vtkMoteLineTubes::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkMoteLineTubes::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* const input = vtkPointSet::GetData(inputVector[0]);
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  this->NumberOfLinesLeftOut = 0;
  if (!input->GetPoints() || input->GetNumberOfCells() == 0)
    return 1;
  vtkDataArray* radiusArray = nullptr;
  if (!this->RadiusArrayName.empty())
  {
    radiusArray = input->GetPointData()->GetArray(this->RadiusArrayName.c_str());
    if (!radiusArray || radiusArray->GetNumberOfComponents() != 1)
    {
      vtkErrorMacro(
        "The points have no array '" << this->RadiusArrayName << "' with one component");
      return 0;
    }
  }
  const Paths paths(input);
  this->NumberOfLinesLeftOut = paths.leftOut();
  if (paths.cells().empty())
    return 1;
  const vtkSmartPointer<vtkPolyData> lines = polylines(input, paths);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetNumberOfSides(
    this->NumberOfSides >= 3 ? this->NumberOfSides : usualSides(paths.lines()));
  tubes->CappingOn();
  if (radiusArray)
  {
    lines->GetPointData()->AddArray(scaled(radiusArray, this->RadiusScale));
    lines->GetPointData()->SetActiveScalars(radii);
    tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  }
  else
    tubes->SetRadius(this->RadiusScale * (this->Radius > 0.0 ? this->Radius : paths.usualRadius()));
  tubes->Update();
  output->ShallowCopy(tubes->GetOutput());
  output->GetPointData()->RemoveArray(radii);
  return 1;
}

void vtkMoteLineTubes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "NumberOfSides: " << this->NumberOfSides << "\n";
  os << indent << "NumberOfLinesLeftOut: " << this->NumberOfLinesLeftOut << "\n";
}
