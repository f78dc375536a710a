#include "vtkMoteReaderTable.h"
#include "vtkObjectFactory.h"
#include "vtkAlgorithm.h"
vtkStandardNewMacro(vtkMoteReaderTable);
void vtkMoteReaderTable::PrintSelf(ostream& os, vtkIndent indent) { this->Superclass::PrintSelf(os, indent); }
