#ifndef MoteDataSetParts_h
#define MoteDataSetParts_h

#include "vtkDataSet.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace mote
{

/// A data set with the name of its block; none for one that is no block.
struct DataSetPart
{
  std::string name;
  vtkDataSet* data;
};

/// The data set itself, or all that a composite one holds. They live as long as the object.
std::vector<DataSetPart> partsOf(vtkDataObject* object);

} // namespace mote

#endif
