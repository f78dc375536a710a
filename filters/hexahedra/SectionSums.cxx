#include "SectionSums.h"

#include "data/GridCells.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

IntegratedArray IntegratedArray::of(vtkDataSet* data, const std::string& name)
{
  IntegratedArray found;
  found.name = name;
  vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
  found.ofCells = !array;
  if (!array)
    array = data->GetCellData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() < 1)
    return found;
  found.values = DataArrayView(array);
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    const char* own = array->GetComponentName(k);
    found.columns.push_back(
      array->GetNumberOfComponents() == 1 ? name : name + ":" + (own ? own : std::to_string(k)));
  }
  return found;
}

namespace
{

bool isGhost(vtkUnsignedCharArray* ghosts, vtkIdType cell)
{
  constexpr int out = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  return ghosts && (ghosts->GetValue(cell) & out) != 0;
}

std::shared_ptr<const HiddenCells> ghostsOf(vtkDataSet* data, const HexMesh& mesh)
{
  vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
  if (!ghosts)
    return nullptr;
  std::vector<unsigned char> isVisible(static_cast<std::size_t>(data->GetNumberOfCells()));
  for (std::size_t i = 0; i < isVisible.size(); ++i)
    isVisible[i] = !isGhost(ghosts, static_cast<vtkIdType>(i));
  return std::make_shared<const HiddenCells>(mesh, isVisible.data());
}

} // namespace

SectionSums::SectionSums(
  vtkDataSet* data, const SectionTask& task, const std::vector<std::string>& columns)
  : task_(task)
  , polygons_(vtkPolyData::SafeDownCast(data))
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    mesh_ = HexMesh(GridCells(GridArrays(grid)).input());
    adjacency_ = FaceAdjacency(mesh_);
    hidden_ = ghostsOf(grid, mesh_);
  }
  count_ = 1;
  const auto take = [&](const std::string& name)
  { return name.empty() ? IntegratedArray() : IntegratedArray::of(data, name); };
  velocity_ = take(task.velocity);
  pressure_ = take(task.pressure);
  const bool flows = !task.velocity.empty();
  count_ += flows;
  arrays_.emplace_back(); // that no grid has
  for (const std::string& name : task.arrays)
    arrays_.push_back(take(name));
  for (const std::string& column : columns)
  {
    Component found{0, 0};
    for (std::size_t a = 0; a < arrays_.size(); ++a)
      for (int k = 0; k < arrays_[a].components(); ++k)
        if (arrays_[a].columns[static_cast<std::size_t>(k)] == column)
          found = {a, k};
    columns_.push_back(found);
    count_ += flows ? 2 : 1;
  }
  count_ += !task.pressure.empty();
  count_ += flows && !task.pressure.empty();
  count_ += flows ? 2 : 0;
}

/// A value of cells, or of points, trilinear; that of a middle is the mean of those around it.
double SectionSums::valueAt(
  const IntegratedArray& array, int component, const SurfacePoint& at) const
{
  if (!array.isThere())
    return std::numeric_limits<double>::quiet_NaN();
  if (array.ofCells)
    return array.values.view.value(mesh_.inputCell(at.cell), component);
  const HexMesh::Cell& corners = mesh_.cell(at.cell);
  double sum = 0.0;
  for (std::size_t k = 0; k < 8; ++k)
  {
    if (at.weights[k] == 0.0)
      continue;
    if (corners[k] < mesh_.pointCount())
    {
      sum += at.weights[k] * array.values.view.value(corners[k], component);
      continue;
    }
    const auto around = mesh_.aroundMiddle(corners[k] - mesh_.pointCount());
    double middle = 0.0;
    for (const std::uint32_t point : around)
      middle += array.values.view.value(point, component);
    sum += at.weights[k] * middle / static_cast<double>(around.size());
  }
  return sum;
}

template <typename ValueOf>
void SectionSums::fill(
  const Vec3d& place, const Vec3d& normal, const ValueOf& valueOf, double* values) const
{
  *values++ = 1.0;
  const bool flows = !task_.velocity.empty(), presses = !task_.pressure.empty();
  Vec3d velocity(0.0);
  for (int k = 0; flows && k < 3; ++k)
    velocity[k] = valueOf(velocity_, k);
  const double flow = glm::dot(velocity, normal);
  if (flows)
    *values++ = flow;
  for (const Component& column : columns_)
  {
    const double value = valueOf(arrays_[column.array], column.number);
    *values++ = value;
    if (flows)
      *values++ = value * flow;
  }
  if (presses)
  {
    const double pressure = task_.pressureFactor * valueOf(pressure_, 0);
    *values++ = pressure * glm::dot(glm::cross(place - task_.origin, normal), task_.axis);
    if (flows)
      *values++ = (pressure + 0.5 * task_.density * glm::dot(velocity, velocity)) * flow;
  }
  if (!flows)
    return;
  *values++ = std::abs(flow);
  *values++ = glm::length(velocity);
}

template <typename ValueOf>
void SectionSums::fillSizes(const Vec3d& place, const ValueOf& valueOf, double* values) const
{
  *values++ = 1.0;
  const bool flows = !task_.velocity.empty(), presses = !task_.pressure.empty();
  Vec3d velocity(0.0);
  for (int k = 0; flows && k < 3; ++k)
    velocity[k] = valueOf(velocity_, k);
  const double speed = glm::length(velocity);
  if (flows)
    *values++ = speed;
  for (const Component& column : columns_)
  {
    const double value = std::abs(valueOf(arrays_[column.array], column.number));
    *values++ = value;
    if (flows)
      *values++ = value * speed;
  }
  if (presses)
  {
    const double pressure = task_.pressureFactor * std::abs(valueOf(pressure_, 0));
    *values++ = pressure * glm::length(glm::cross(place - task_.origin, task_.axis));
    if (flows)
      *values++ = (pressure + 0.5 * task_.density * speed * speed) * speed;
  }
  // Whatever these are, no cell is cut for them.
  for (int k = 0; flows && k < 2; ++k)
    *values++ = std::numeric_limits<double>::infinity();
}

SurfaceIntegrals SectionSums::of(const Section& section) const
{
  if (polygons_ && !section.slice)
    return ofPolygons();
  const Integrand integrand = [this](const SurfacePoint& at, double* values)
  {
    fill(
      at.place, at.normal,
      [&](const IntegratedArray& array, int component) { return valueAt(array, component, at); },
      values);
  };
  const Integrand sizes = [this](const SurfacePoint& at, double* values)
  {
    fillSizes(
      at.place,
      [&](const IntegratedArray& array, int component) { return valueAt(array, component, at); },
      values);
  };
  return section.slice ? integrateSlice(mesh_, *section.slice, count_, integrand, hidden_.get(),
                           task_.tolerance, sizes)
                       : integrateBoundary(mesh_, adjacency_, count_, integrand, hidden_.get());
}

namespace
{

/// Rules for triangles, exact to the second and the fourth degree: shares of two corners, the third
/// has the rest, and weights.
struct TrianglePoint
{
  double a, b, weight;
};
constexpr TrianglePoint coarse[] = {
  {0.5, 0.5, 1.0 / 3.0}, {0.5, 0.0, 1.0 / 3.0}, {0.0, 0.5, 1.0 / 3.0}};
constexpr double s = 0.445948490915965, t = 0.091576213509771;
constexpr double ofS = 0.223381589678011, ofT = 0.109951743655322;
constexpr TrianglePoint fine[] = {{s, s, ofS}, {s, 1.0 - 2.0 * s, ofS}, {1.0 - 2.0 * s, s, ofS},
  {t, t, ofT}, {t, 1.0 - 2.0 * t, ofT}, {1.0 - 2.0 * t, t, ofT}};

} // namespace

SurfaceIntegrals SectionSums::ofPolygons() const
{
  SurfaceIntegrals sum;
  sum.values.assign(static_cast<std::size_t>(count_), 0.0);
  sum.errors = sum.values;
  std::vector<double> at(sum.values), rough(sum.values), exact(sum.values);
  vtkCellArray* polygons = polygons_->GetPolys();
  // Cells of the data set are counted over all kinds.
  const vtkIdType before = polygons_->GetNumberOfVerts() + polygons_->GetNumberOfLines();
  const auto placeOf = [&](vtkIdType id)
  {
    double p[3];
    polygons_->GetPoint(id, p);
    return Vec3d(p[0], p[1], p[2]);
  };
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    if (isGhost(polygons_->GetCellGhostArray(), before + cell))
      continue;
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCellAtId(cell, size, ids);
    Vec3d middle(0.0);
    for (vtkIdType i = 0; i < size; ++i)
      middle += placeOf(ids[i]) / double(size);
    std::fill(rough.begin(), rough.end(), 0.0);
    std::fill(exact.begin(), exact.end(), 0.0);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType first = ids[i], second = ids[(i + 1) % size];
      const Vec3d a = placeOf(first), b = placeOf(second);
      const Vec3d across = glm::cross(a - middle, b - middle);
      const double twice = glm::length(across);
      if (!(twice > 0.0))
        continue;
      const auto add = [&](const TrianglePoint& point, std::vector<double>& to)
      {
        const double rest = 1.0 - point.a - point.b;
        const auto valueOf = [&](const IntegratedArray& array, int component)
        {
          if (!array.isThere())
            return std::numeric_limits<double>::quiet_NaN();
          const auto value = [&](vtkIdType id)
          { return array.values.view.value(static_cast<std::size_t>(id), component); };
          if (array.ofCells)
            return value(before + cell);
          double mean = 0.0;
          for (vtkIdType k = 0; k < size; ++k)
            mean += value(ids[k]) / double(size);
          return point.a * value(first) + point.b * value(second) + rest * mean;
        };
        fill(point.a * a + point.b * b + rest * middle, across / twice, valueOf, at.data());
        for (std::size_t k = 0; k < at.size(); ++k)
          to[k] += 0.5 * twice * point.weight * at[k];
      };
      for (const TrianglePoint& point : coarse)
        add(point, rough);
      for (const TrianglePoint& point : fine)
        add(point, exact);
    }
    for (std::size_t k = 0; k < at.size(); ++k)
    {
      sum.values[k] += exact[k];
      sum.errors[k] += std::abs(exact[k] - rough[k]);
    }
    ++sum.cells;
  }
  return sum;
}

} // namespace mote
