#include "Blocks.h"

#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"
#include "kernels/core/MemoryLimit.h"

#include <DataParts.h>
#include <vtkCellTypes.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkInformation.h>
#include <vtkMoteLinearCells.h>
#include <vtkMoteStructuredCells.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace mote::app
{

namespace
{

/// A data set with the names of the blocks that it lies in, its own last.
struct Leaf
{
  std::vector<std::string> path;
  vtkDataSet* data = nullptr;
  bool isNamed = true; ///< and not only numbered
};

const char* nameIn(vtkInformation* facts)
{
  const bool isNamed = facts && facts->Has(vtkCompositeDataSet::NAME());
  const char* name = isNamed ? facts->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name && *name ? name : nullptr;
}

/// What a block is called that has no name, or several data sets under one.
std::string numbered(std::size_t index)
{
  return "block " + std::to_string(index + 1);
}

void collectLeaves(vtkCompositeDataSet* composite, const std::vector<std::string>& path,
  bool isNamed, std::vector<Leaf>& leaves)
{
  const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  blocks->SkipEmptyNodesOff();
  if (auto* levels = vtkDataObjectTreeIterator::SafeDownCast(blocks))
  {
    levels->VisitOnlyLeavesOff();
    levels->TraverseSubTreeOff();
  }
  std::size_t index = 0;
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem(), ++index)
  {
    const char* name =
      nameIn(blocks->HasCurrentMetaData() ? blocks->GetCurrentMetaData() : nullptr);
    std::vector<std::string> own = path;
    own.push_back(name ? name : numbered(index));
    const bool isOwnNamed = isNamed || name;
    vtkDataObject* block = blocks->GetCurrentDataObject();
    if (auto* data = vtkDataSet::SafeDownCast(block))
      leaves.push_back({own, data, isOwnNamed});
    else if (auto* inner = vtkCompositeDataSet::SafeDownCast(block))
      collectLeaves(inner, own, isOwnNamed, leaves);
  }
}

/// The largest dimension of the cells: 3 of a volume, 2 of a surface.
int dimensionOf(vtkDataSet* data)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
    return surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0 ? 2 : 0;
  vtkNew<vtkCellTypes> types;
  data->GetCellTypes(types);
  vtkNew<vtkGenericCell> cell;
  int dimension = 0;
  for (vtkIdType i = 0; i < types->GetNumberOfTypes(); ++i)
  {
    cell->SetCellType(types->GetCellType(i));
    dimension = std::max(dimension, cell->GetCellDimension());
  }
  return dimension;
}

/// Hexahedra in place of structured grids, and linear cells in place of those of higher order,
/// unless they take too much of the machine's memory; and of particles none that are marked as
/// copies, such as those of files that were written in pieces.
vtkSmartPointer<vtkDataSet> withCells(vtkDataSet* data, const std::string& name)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  if (points && points->GetPointGhostArray() && dimensionOf(points) == 0)
    return withoutMarkedPoints(points);
  const auto most = static_cast<vtkTypeUInt64>(physicalMemory() / 4);
  const auto plain = vtkSmartPointer<vtkDataSet>::Take(vtkMoteStructuredCells::Of(data, most));
  const auto cells = vtkSmartPointer<vtkDataSet>::Take(vtkMoteLinearCells::Of(plain, most));
  const bool isStructured = !vtkUnstructuredGrid::SafeDownCast(cells);
  if ((isStructured && dimensionOf(data) == 3) || vtkMoteLinearCells::CountIn(cells) > 0)
    Messages::warn(name + ": " + counted(data->GetNumberOfCells(), "cell") +
                   " are more than fit into memory as a volume, so their surface is shown");
  return cells;
}

/// A block has the time of the whole, unless it has one of its own.
void passTime(vtkDataObject* whole, vtkDataObject* block)
{
  auto* key = vtkDataObject::DATA_TIME_STEP();
  if (whole->GetInformation()->Has(key) && !block->GetInformation()->Has(key))
    block->GetInformation()->Set(key, whole->GetInformation()->Get(key));
}

} // namespace

vtkSmartPointer<vtkDataObject> sharingCopy(vtkDataObject* object)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(object->NewInstance());
  if (auto* composite = vtkDataObjectTree::SafeDownCast(copy))
    composite->RecursiveShallowCopy(object);
  else
    copy->ShallowCopy(object);
  return copy;
}

std::vector<NamedData> dataSetsOf(vtkDataObject* object, const std::string& name)
{
  if (auto* data = vtkDataSet::SafeDownCast(object))
    return {{name, withCells(data, name)}};
  auto* composite = vtkCompositeDataSet::SafeDownCast(object);
  if (!composite)
    throw Failure(
      name + " holds a " + object->GetClassName() + ", which has no points in space to show");
  std::vector<Leaf> leaves;
  collectLeaves(composite, {}, false, leaves);
  if (leaves.size() == 1 && !leaves.front().isNamed)
    return {{name, withCells(leaves.front().data, name)}};
  std::vector<std::vector<std::string>> paths;
  for (const Leaf& leaf : leaves)
    paths.push_back(leaf.path);
  const std::vector<std::string> blocks = shortestEnds(paths);
  std::vector<NamedData> all;
  std::vector<int> dimensions;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const std::string full = name + ": " + blocks[i];
    NamedData one{full, withCells(leaves[i].data, full)};
    one.block = blocks[i];
    passTime(composite, one.data);
    dimensions.push_back(dimensionOf(one.data));
    all.push_back(std::move(one));
  }
  const bool hasVolume = std::find(dimensions.begin(), dimensions.end(), 3) != dimensions.end();
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].isBoundary = hasVolume && dimensions[i] == 2;
  return all;
}

} // namespace mote::app
