#include "MeshGeometry.h"

#include "GridParts.h"
#include "SurfaceSeams.h"
#include "SurfaceTriangles.h"

#include "kernels/meshes/RlodTreeFile.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMoteMeshFilePoints.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <mutex>

namespace mote
{

namespace
{

/// A refitted tree is built anew where rays meet so many times as many boxes as when it was built:
/// a build takes as long as some frames.
constexpr double worstRefit = 2.0;

void addTime(InputKey& key, vtkObject* object)
{
  key.push_back(object ? static_cast<double>(object->GetMTime()) : -1.0);
}

void addCells(InputKey& key, vtkCellArray* cells)
{
  addTime(key, cells);
  addArray(key, cells ? cells->GetOffsetsArray() : nullptr);
  addArray(key, cells ? cells->GetConnectivityArray() : nullptr);
}

/// Whether cells are hidden in a tree that has all of them.
bool hidesInTree(vtkPointSet* data)
{
  return vtkPolyData::SafeDownCast(data) != nullptr;
}

SurfaceChoice alone(const SurfaceChoice::Neighbor& one)
{
  SurfaceChoice choice;
  choice.isVisible = one.isVisible;
  choice.visible = one.visible;
  return choice;
}

/// The times of all that triangles are made of.
InputKey keyOfMesh(vtkPointSet* data, const SurfaceChoice& choice)
{
  InputKey key;
  if (!hidesInTree(data))
  {
    key = choice.visible;
    for (const SurfaceChoice::Neighbor& one : choice.neighbors)
    {
      const InputKey own = keyOfMesh(one.data, alone(one));
      key.insert(key.end(), own.begin(), own.end());
    }
    key.push_back(choice.withOtherSides);
    const SectorCopies& copies = choice.copies;
    key.push_back(copies.count);
    for (int k = 0; copies.count > 1 && k < 3; ++k)
      key.insert(key.end(), {copies.center[k], copies.axis[k]});
  }
  addTime(key, data->GetPoints());
  addArray(key, data->GetPoints() ? data->GetPoints()->GetData() : nullptr);
  addArray(key, data->GetCellGhostArray());
  key.push_back(choice.withGhosts && data->GetCellGhostArray() ? 1.0 : 0.0);
  addArray(key, data->GetPointGhostArray());
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells : {surface->GetVerts(), surface->GetLines()})
      key.push_back(cells ? static_cast<double>(cells->GetNumberOfCells()) : 0.0);
    addCells(key, surface->GetPolys());
    addCells(key, surface->GetStrips());
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    addCells(key, grid->GetCells());
    addArray(key, grid->GetCellTypesArray());
  }
  else
    addTime(key, data);
  return key;
}

/// Whether the triangles are those of the mesh, one by one.
bool areTheSame(const TriangleMesh& mesh, const ArrayView& triangles)
{
  if (mesh.size() != triangles.count())
    return false;
  using Range = tbb::blocked_range<std::size_t>;
  return tbb::parallel_reduce(
    Range(0, mesh.size(), 1 << 14), true,
    [&](const Range& range, bool same)
    {
      for (std::size_t t = range.begin(); same && t != range.end(); ++t)
        for (int k = 0; k < 3; ++k)
          same = same && triangles.value(t, k) == mesh.triangles()[t][static_cast<std::size_t>(k)];
      return same;
    },
    std::logical_and<>());
}

ContentHash contentOf(const DataArrayView& points)
{
  if (points.view.empty())
    return {};
  const std::size_t numbers =
    points.view.count() * static_cast<std::size_t>(points.view.components());
  return hashOf(
    points.view.data(), numbers * static_cast<std::size_t>(points.owner->GetDataTypeSize()));
}

std::string sentence(vtkIdType count, const char* one, const char* many)
{
  if (count == 0)
    return {};
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

} // namespace

/// The faces of cells as they are without neighbors and copies, for whoever asks for them.
struct SharedFaces
{
  SurfaceTriangles triangles;
  SeamSurface seams;

  SharedFaces(vtkPointSet* data, vtkUnsignedCharArray* isVisible)
    : triangles(surfaceTrianglesOf(data, isVisible))
    , seams(triangles, data->GetPoints())
  {
  }
};

namespace
{

/// Those that somebody holds already, if any.
std::shared_ptr<const SharedFaces> sharedFaces(vtkPointSet* data, const SurfaceChoice& choice)
{
  static std::mutex mutex;
  static std::map<InputKey, std::weak_ptr<const SharedFaces>> known;
  const InputKey key = keyOfMesh(data, choice);
  {
    const std::lock_guard lock(mutex);
    std::erase_if(known, [](const auto& one) { return one.second.expired(); });
    if (const auto found = known.find(key); found != known.end())
      if (auto faces = found->second.lock())
        return faces;
  }
  auto faces = std::make_shared<const SharedFaces>(data, choice.isVisible);
  const std::lock_guard lock(mutex);
  known[key] = faces;
  return faces;
}

bool mayTouch(vtkPointSet* a, vtkPointSet* b)
{
  const double margin = 1e-5 * std::max(a->GetLength(), b->GetLength());
  double of[2][6];
  a->GetBounds(of[0]);
  b->GetBounds(of[1]);
  bool may = true;
  for (int axis = 0; axis < 3; ++axis)
    may = may && of[0][2 * axis] <= of[1][2 * axis + 1] + margin &&
          of[1][2 * axis] <= of[0][2 * axis + 1] + margin;
  return may;
}

/// Adds the sheets of a grid, flat cells beside cells with a volume, the other way round. Returns
/// of how many triangles they are, the last ones then.
std::size_t addOtherSides(SurfaceTriangles& triangles, vtkPointSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  const std::size_t count = triangles.cells.size();
  std::vector<std::size_t> sheets;
  for (std::size_t t = 0; grid && t < count; ++t)
    if (isFlatType(grid->GetCellType(triangles.cells[t])))
      sheets.push_back(t);
  if (sheets.empty() || sheets.size() == count)
    return 0;
  vtkNew<vtkIdTypeArray> corners;
  const auto add = [&](std::size_t t, const std::array<std::size_t, 3>& order)
  {
    for (const std::size_t k : order)
      corners->InsertNextValue(static_cast<vtkIdType>(triangles.view().value(t, k)));
  };
  for (std::size_t t = 0; t < count; ++t)
    add(t, {0, 1, 2});
  for (const std::size_t t : sheets)
  {
    add(t, {0, 2, 1});
    triangles.cells.push_back(triangles.cells[t]);
    if (!triangles.edges.empty())
    {
      const unsigned sides = triangles.edges[t];
      triangles.edges.push_back(
        static_cast<std::uint8_t>((sides & 1) << 2 | (sides & 2) | (sides & 4) >> 2));
    }
  }
  triangles.corners = DataArrayView(corners);
  return sheets.size();
}

} // namespace

/// Faces of cells without those that copies cover, or neighbors.
SurfaceTriangles MeshGeometry::uncoveredFaces(vtkPointSet* data, const SurfaceChoice& choice)
{
  std::vector<SurfaceChoice::Neighbor> neighbors = choice.neighbors;
  std::erase_if(neighbors, [&](const auto& one) { return !mayTouch(data, one.data); });
  if (neighbors.empty())
  {
    shared_.clear();
    return surfaceTrianglesOf(data, choice.isVisible, choice.copies);
  }
  std::vector<std::shared_ptr<const SharedFaces>> shared = {
    sharedFaces(data, alone({data, choice.isVisible, choice.visible}))};
  SurfaceTriangles faces = shared.front()->triangles;
  std::vector<std::uint8_t> isCovered = coveredByCopies(faces, data->GetPoints(), choice.copies);
  isCovered.resize(faces.view().count(), 0);
  for (const SurfaceChoice::Neighbor& one : neighbors)
  {
    shared.push_back(sharedFaces(one.data, alone(one)));
    const auto marks = coveredByOther(shared.front()->seams, shared.back()->seams);
    for (std::size_t t = 0; t < marks.size(); ++t)
      isCovered[t] |= marks[t];
  }
  shared_ = std::move(shared); // those of before until now
  dropTriangles(faces, isCovered);
  return faces;
}

bool MeshGeometry::holds(vtkPointSet* data, const SurfaceChoice& choice) const
{
  return !key_.empty() && key_ == keyOfMesh(data, choice);
}

bool MeshGeometry::fits(vtkPointSet* data, const SurfaceChoice& choice) const
{
  return this->holds(data, choice) && (!hidesInTree(data) || visible_ == choice.visible);
}

MeshGeometry::Change MeshGeometry::update(
  vtkPointSet* data, const SurfaceChoice& choice, const Progress& progress)
{
  const bool hides = hidesInTree(data);
  Change change = Change::None;
  if (!this->holds(data, choice))
  {
    InputKey key = keyOfMesh(data, choice);
    key_.clear(); // until all has gone well
    change = this->updateAll(data, choice, progress);
    if (!tree_ && !mesh_)
      return change; // it was stopped
    key_ = std::move(key);
  }
  if (hides && (change != Change::None || visible_ != choice.visible))
  {
    this->hide(choice.isVisible);
    visible_ = choice.visible;
    change = change == Change::None ? Change::Hidden : change;
  }
  if (sides_ > 0 && tree_ && change != Change::None)
    this->hideOtherSides();
  this->count();
  return change;
}

/// Takes all triangles, or those of visible cells where they are not hidden in the tree.
MeshGeometry::Change MeshGeometry::updateAll(
  vtkPointSet* data, const SurfaceChoice& choice, const Progress& progress)
{
  if (const auto file = vtkMoteMeshFilePoints::FileOf(data))
  {
    this->forget();
    tree_ = file->tree();
    corners_ = file->corners();
    return Change::Built;
  }
  SurfaceTriangles triangles =
    !choice.neighbors.empty() && !hidesInTree(data)
      ? this->uncoveredFaces(data, choice)
      : surfaceTrianglesOf(
          data, hidesInTree(data) ? nullptr : choice.isVisible, choice.copies, choice.withGhosts);
  const std::size_t sides = choice.withOtherSides ? addOtherSides(triangles, data) : 0;
  const DataArrayView points(data->GetPoints() ? data->GetPoints()->GetData() : nullptr);
  const ContentHash content = contentOf(points);
  const bool moved = tree_ && mesh_ && mesh_->pointCount() == points.view.count() &&
                     areTheSame(*mesh_, triangles.view());
  cells_ = std::make_shared<const std::vector<vtkIdType>>(triangles.cells);
  edges_ = triangles.edges.empty()
             ? nullptr
             : std::make_shared<const std::vector<std::uint8_t>>(triangles.edges);
  thin_ = triangles.thin;
  flat_ = triangles.flat;
  sides_ = sides;
  if (moved && content == points_)
    return Change::None;
  points_ = content;
  part_ = nullptr; // which is of the tree as it was
  if (moved && this->moveTo(points.view))
    return Change::Refitted;
  if (this->build(points.view, triangles.view(), progress))
    return Change::Built;
  this->forget();
  return Change::None;
}

/// Makes the tree of what is visible, where that is not all.
void MeshGeometry::hide(vtkUnsignedCharArray* isVisible)
{
  std::shared_ptr<RlodTree> last = std::move(part_);
  part_ = nullptr;
  if (!tree_ || !isVisible)
    return;
  const unsigned char* marks = isVisible->GetPointer(0);
  const vtkIdType* cells = cells_ && !cells_->empty() ? cells_->data() : nullptr;
  part_ = RlodTree::partOf(
    tree_,
    [=](std::uint64_t triangle)
    { return marks[cells ? static_cast<std::size_t>(cells[triangle]) : triangle] != 0; },
    std::move(last));
}

/// Makes the tree without the other sides of sheets.
void MeshGeometry::hideOtherSides()
{
  const std::size_t first = mesh_->size() - sides_;
  part_ = RlodTree::partOf(
    tree_, [=](std::uint64_t triangle) { return triangle < first; }, std::move(part_));
}

/// Gives the points other places. False where the tree has become too bad by that.
bool MeshGeometry::moveTo(const ArrayView& points)
{
  // What others hold stays as it is: a copy takes a tenth of the time of a build, a refit too.
  if (mesh_.use_count() > 1)
    mesh_ = std::make_shared<TriangleMesh>(*mesh_);
  if (tree_.use_count() > 1)
    tree_ = std::make_shared<RlodTree>(tree_->copyWithoutLods());
  mesh_->movePoints(points);
  return tree_->refit(*mesh_) && tree_->cost() <= worstRefit * builtCost_;
}

/// False where `progress` stopped it.
bool MeshGeometry::build(
  const ArrayView& points, const ArrayView& triangles, const Progress& progress)
{
  tree_ = nullptr; // before the next one takes memory
  mesh_ = nullptr;
  corners_ = nullptr;
  mesh_ = std::make_shared<TriangleMesh>(points, triangles);
  corners_ = mesh_->corners();
  if (mesh_->validCount() == 0)
    return true;
  auto tree = std::make_shared<RlodTree>();
  tree->build(*mesh_, progress);
  if (tree->size() == 0)
    return false;
  tree_ = std::move(tree);
  builtCost_ = tree_->cost();
  return true;
}

ArrayView MeshGeometry::cells() const
{
  if (!cells_ || cells_->empty())
    return {};
  constexpr auto type = sizeof(vtkIdType) == 8 ? ArrayView::Type::Int64 : ArrayView::Type::Int32;
  return {cells_->data(), type, cells_->size(), 1};
}

void MeshGeometry::makeLods()
{
  if (!tree_->hasLods())
    tree_->makeLods();
  if (part_ && !part_->hasLods())
    part_->takeLodsOfWhole();
  this->count();
}

void MeshGeometry::count()
{
  bytes_ = (mesh_       ? mesh_->bytes()
             : corners_ ? corners_->bytes()
                        : 0) +
           (tree_ ? tree_->bytes() : 0) + (cells_ ? cells_->size() * sizeof(vtkIdType) : 0);
  bytesOfPart_ = part_ ? part_->bytes() : 0;
}

vtkIdType MeshGeometry::invalidTriangles() const
{
  return mesh_ ? static_cast<vtkIdType>(mesh_->size() - mesh_->validCount()) : 0;
}

std::string MeshGeometry::report() const
{
  std::string text;
  for (const std::string& part :
    {sentence(thin_, "line or vertex, which has no area", "lines and vertices, which have no area"),
      sentence(flat_, "polygon without a triangle", "polygons without a triangle"),
      sentence(this->invalidTriangles(), "triangle with a corner that is not finite",
        "triangles with a corner that is not finite")})
    text += part.empty() ? "" : (text.empty() ? "Left out: " : "; ") + part;
  return text.empty() ? text : text + '.';
}

} // namespace mote
