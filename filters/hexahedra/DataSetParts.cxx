#include "DataSetParts.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkSmartPointer.h"

namespace mote
{

std::vector<DataSetPart> partsOf(vtkDataObject* object)
{
  if (auto* data = vtkDataSet::SafeDownCast(object))
    return {{"", data}};
  std::vector<DataSetPart> parts;
  auto* composite = vtkCompositeDataSet::SafeDownCast(object);
  if (!composite)
    return parts;
  const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    vtkInformation* facts = blocks->HasCurrentMetaData() ? blocks->GetCurrentMetaData() : nullptr;
    const char* name = facts && facts->Has(vtkCompositeDataSet::NAME())
                         ? facts->Get(vtkCompositeDataSet::NAME())
                         : nullptr;
    if (auto* data = vtkDataSet::SafeDownCast(blocks->GetCurrentDataObject()))
      parts.push_back({name ? name : "", data});
  }
  return parts;
}

} // namespace mote
