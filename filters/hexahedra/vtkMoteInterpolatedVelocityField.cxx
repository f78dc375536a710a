#include "vtkMoteInterpolatedVelocityField.h"

#include "FlowInCells.h"
#include "LocatorStructure.h"

#include "kernels/core/Error.h"
#include "kernels/hexahedra/HexStructure.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMoteInterpolatedVelocityField);

vtkMoteInterpolatedVelocityField::vtkMoteInterpolatedVelocityField()
  : Shared(std::make_shared<mote::SharedStructures>())
{
}

vtkMoteInterpolatedVelocityField::~vtkMoteInterpolatedVelocityField() = default;

/// Finds or builds the structure of a data set.
void vtkMoteInterpolatedVelocityField::TakeDataSet(vtkDataSet* data)
{
  std::shared_ptr<const mote::LocatorStructure> structure;
  try
  {
    mote::HexStructureOptions options;
    options.kind = mote::structureKindNamed(this->StructureName);
    structure = this->Shared->get(data, options);
  }
  catch (const mote::Error& error)
  {
    vtkErrorMacro(<< error.what());
  }
  this->Flows.push_back(std::make_unique<mote::FlowInCells>(data, std::move(structure)));
}

// VTK 9.2 keeps cells and weights in other members, makes copies of a field for its threads, and
// has its own way of finding cells, which this class does without.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)

void vtkMoteInterpolatedVelocityField::AddDataSet(vtkDataSet* data)
{
  if (!data)
  {
    vtkErrorMacro("There is no data set to add.");
    return;
  }
  this->TakeDataSet(data);
  this->DataSets->push_back(data);
  if (const int size = data->GetMaxCellSize(); size > this->WeightsSize)
  {
    this->WeightsSize = size;
    delete[] this->Weights;
    this->Weights = new double[static_cast<std::size_t>(size)];
  }
}

void vtkMoteInterpolatedVelocityField::EnterCell(vtkDataSet* data, vtkIdType cell)
{
  if (this->LastDataSet != data || this->LastCellId != cell)
    data->GetCell(cell, this->GenCell);
}

#else

void vtkMoteInterpolatedVelocityField::AddDataSet(vtkDataSet* data, size_t maxCellSize)
{
  if (!data)
  {
    vtkErrorMacro("There is no data set to add.");
    return;
  }
  this->TakeDataSet(data);
  this->DataSetsBoundsInfo.emplace_back(data);
  const std::size_t size =
    maxCellSize > 0 ? maxCellSize : static_cast<std::size_t>(data->GetMaxCellSize());
  this->Weights.resize(std::max(this->Weights.size(), size));
}

void vtkMoteInterpolatedVelocityField::Initialize(vtkCompositeDataSet*, int)
{
  this->InitializationState = SELF_INITIALIZE;
}

void vtkMoteInterpolatedVelocityField::EnterCell(vtkDataSet* data, vtkIdType cell)
{
  if (this->LastDataSet == data && this->LastCellId == cell)
    return;
  data->GetCell(cell, this->CurrentCell);
  data->GetCell(cell, this->LastCell);
  this->PointIds->DeepCopy(this->CurrentCell->GetPointIds());
}

#endif

void vtkMoteInterpolatedVelocityField::SetLastCellId(vtkIdType cell, int dataSet)
{
  this->LastCellId = cell;
  this->LastDataSetIndex = dataSet;
  if (dataSet >= 0 && dataSet < static_cast<int>(this->Flows.size()))
    this->LastDataSet = this->Flows[static_cast<std::size_t>(dataSet)]->data();
}

void vtkMoteInterpolatedVelocityField::CopyParameters(vtkAbstractInterpolatedVelocityField* from)
{
  this->Superclass::CopyParameters(from);
  if (auto* ours = vtkMoteInterpolatedVelocityField::SafeDownCast(from))
  {
    this->StructureName = ours->StructureName;
    this->Shared = ours->Shared;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
    this->Flows.clear();
    for (const auto& flow : ours->Flows)
      this->TakeDataSet(flow->data());
    this->Weights.resize(ours->Weights.size());
#endif
  }
}

/// Takes cell, weights and velocity of one of the data sets; false where that holds not the point.
bool vtkMoteInterpolatedVelocityField::TakeFrom(int number, double* x, double* f)
{
  mote::FlowInCells& flow = *this->Flows[static_cast<std::size_t>(number)];
  vtkFieldData* fields = flow.data()->GetAttributesAsFieldData(this->VectorsType);
  vtkDataArray* vectors =
    fields && this->VectorsSelection ? fields->GetArray(this->VectorsSelection) : nullptr;
  if (vectors && vectors->GetNumberOfComponents() != 3)
    vectors = nullptr;
  flow.select(vectors, this->VectorsType == vtkDataObject::CELL);
  if (!flow.find({x[0], x[1], x[2]}))
    return false;
  this->EnterCell(flow.data(), flow.cell());
  this->LastDataSetIndex = number;
  this->LastDataSet = flow.data();
  this->LastCellId = flow.cell();
  this->LastSubId = 0;
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  flow.weights(this->GenCell, this->LastPCoords, this->Weights);
#else
  flow.weights(this->CurrentCell, this->LastPCoords, this->Weights.data());
#endif
  flow.velocity(f);
  if (const double length = std::hypot(f[0], f[1], f[2]); this->NormalizeVector && length > 0.0)
    for (int k = 0; k < 3; ++k)
      f[k] /= length;
  return true;
}

int vtkMoteInterpolatedVelocityField::FunctionValues(double* x, double* f)
{
  const int count = static_cast<int>(this->Flows.size());
  const int last = std::clamp(this->LastDataSetIndex, 0, std::max(0, count - 1));
  for (int k = 0; k < count; ++k)
    if (this->TakeFrom((last + k) % count, x, f))
      return 1;
  this->LastCellId = -1;
  this->LastDataSet = nullptr;
  std::fill_n(f, 3, 0.0);
  return 0;
}

void vtkMoteInterpolatedVelocityField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StructureName: " << this->StructureName << "\n";
}
