#include "TreePositions.h"

#include "vtkObjectFactory.h"

namespace mote
{

vtkStandardNewMacro(TreePositions);

void TreePositions::SetTree(const PkdTree& tree)
{
  this->Tree = tree;
  this->Size = static_cast<vtkIdType>(3 * tree.size());
  this->MaxId = this->Size - 1;
  this->Modified();
}

void* TreePositions::GetVoidPointer(vtkIdType i)
{
  std::call_once(this->Copied,
    [this]
    {
      this->Copy.resize(3 * this->Tree.size());
      for (vtkIdType k = 0; k < this->GetNumberOfTuples(); ++k)
        this->GetTypedTuple(k, &this->Copy[static_cast<std::size_t>(3 * k)]);
    });
  return this->Copy.data() + i;
}

} // namespace mote
