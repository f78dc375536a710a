#include "vtkMotePeriodicPositions.h"

#include "vtkMoteSourcePoints.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkMotePeriodicPositions);

namespace
{

/// Where points lie in units of the box's edges, and back.
struct PeriodicBox
{
  double origin[3] = {0.0, 0.0, 0.0};
  double edges[9];   ///< by columns: vectors of the box
  double inverse[9]; ///< of that matrix
  bool isPeriodic[3] = {true, true, true};
};

/// What is wrong, or nothing.
std::string readBox(vtkFieldData* fields, PeriodicBox& box)
{
  vtkDataArray* vectors = fields->GetArray("box");
  if (!vectors || vectors->GetNumberOfValues() != 9)
    return "there is no simulation box in the data";
  const auto value = [](vtkDataArray* array, int i)
  {
    const int components = array->GetNumberOfComponents();
    return array->GetComponent(i / components, i % components);
  };
  for (int i = 0; i < 9; ++i)
    box.edges[3 * (i % 3) + i / 3] = value(vectors, i);
  vtkDataArray* origin = fields->GetArray("box_origin");
  for (int i = 0; origin && origin->GetNumberOfValues() == 3 && i < 3; ++i)
    box.origin[i] = value(origin, i);
  vtkMatrix3x3::Invert(box.edges, box.inverse);
  const double volume = vtkMatrix3x3::Determinant(box.edges);
  if (!std::isfinite(volume) || volume == 0.0)
    return "the simulation box has no volume";
  auto* boundary = vtkStringArray::SafeDownCast(fields->GetAbstractArray("boundary"));
  if (boundary && boundary->GetNumberOfValues() > 0)
  {
    std::istringstream words(boundary->GetValue(0));
    std::string word;
    for (int edge = 0; edge < 3 && words >> word; ++edge)
      box.isPeriodic[edge] = word[0] == 'p';
  }
  return {};
}

/// How many edges of each kind the point goes back.
std::array<double, 3> edgesAway(const PeriodicBox& box, const double point[3])
{
  double place[3], share[3];
  for (int i = 0; i < 3; ++i)
    place[i] = point[i] - box.origin[i];
  vtkMatrix3x3::MultiplyPoint(box.inverse, place, share);
  std::array<double, 3> count{};
  for (int i = 0; i < 3; ++i)
    if (box.isPeriodic[i] && std::isfinite(share[i]))
      count[i] = std::floor(share[i]);
  return count;
}

struct MovePoints
{
  const PeriodicBox& box;
  std::array<vtkDataArray*, 3> images; ///< null: points are wrapped
  vtkDataArray* result;

  template <typename Array>
  void operator()(Array* points) const
  {
    using Value = vtk::GetAPIType<Array>;
    const auto from = vtk::DataArrayTupleRange<3>(points);
    auto to = vtk::DataArrayTupleRange<3>(static_cast<Array*>(result)); // made like `points`
    tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, points->GetNumberOfTuples(), 4096),
      [&](const tbb::blocked_range<vtkIdType>& some)
      {
        for (vtkIdType id = some.begin(); id != some.end(); ++id)
        {
          const double point[3] = {double(from[id][0]), double(from[id][1]), double(from[id][2])};
          const std::array<double, 3> moved = this->moved(id, point);
          for (int i = 0; i < 3; ++i)
            to[id][i] = static_cast<Value>(moved[i]);
        }
      });
  }

  std::array<double, 3> moved(vtkIdType id, const double point[3]) const
  {
    std::array<double, 3> count{};
    if (images[0])
      for (int i = 0; i < 3; ++i)
        count[i] = -images[i]->GetComponent(id, 0);
    else
      count = edgesAway(box, point);
    double way[3];
    vtkMatrix3x3::MultiplyPoint(box.edges, count.data(), way);
    return {point[0] - way[0], point[1] - way[1], point[2] - way[2]};
  }
};

} // namespace

std::string vtkMotePeriodicPositions::Move(vtkPointSet* data, int mode)
{
  if (!data || !data->GetPoints())
    return "there are no points";
  if (vtkMoteSourcePoints::SafeDownCast(data->GetPoints()))
    return "the positions stay in their file and cannot be moved";
  PeriodicBox box;
  if (const std::string problem = readBox(data->GetFieldData(), box); !problem.empty())
    return problem;
  vtkDataArray* points = data->GetPoints()->GetData();
  MovePoints move{box, {}, nullptr};
  if (mode == UNWRAPPED)
  {
    const char* const names[] = {"ix", "iy", "iz"};
    for (int i = 0; i < 3; ++i)
    {
      move.images[i] = data->GetPointData()->GetArray(names[i]);
      if (!move.images[i])
        return std::string("there is no array '") + names[i] +
               "', which says how many boxes away a particle is";
    }
  }
  vtkSmartPointer<vtkDataArray> result;
  result.TakeReference(points->NewInstance());
  result->SetNumberOfComponents(3);
  result->SetNumberOfTuples(points->GetNumberOfTuples());
  move.result = result;
  using RealArrays = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>;
  if (!RealArrays::Execute(points, move))
    return "the positions are of a type that cannot be moved";
  vtkNew<vtkPoints> moved;
  moved->SetData(result);
  data->SetPoints(moved);
  return {};
}

int vtkMotePeriodicPositions::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkMotePeriodicPositions::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* output = vtkPointSet::GetData(outputs);
  output->ShallowCopy(vtkPointSet::GetData(inputs[0]));
  const std::string problem = Move(output, this->Mode);
  if (problem.empty())
    return 1;
  vtkErrorMacro(<< problem);
  return 0;
}

void vtkMotePeriodicPositions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << (this->Mode == WRAPPED ? "wrapped" : "unwrapped") << "\n";
}
