#include "vtkMoteStructureFileWriter.h"

#include "FieldArrays.h"

#include "vtkInformation.h"

vtkMoteStructureFileWriter::vtkMoteStructureFileWriter() = default;

vtkMoteStructureFileWriter::~vtkMoteStructureFileWriter() = default;

int vtkMoteStructureFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkMoteStructureFileWriter::WarnOfLeftOut(const mote::FieldArrays& arrays)
{
  if (!arrays.leftOut.empty())
    vtkWarningMacro(<< "\"" << this->FileName
                    << "\" is without the arrays that hold no numbers: " << arrays.leftOut << ".");
}

void vtkMoteStructureFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WriteOriginalIds: " << (this->WriteOriginalIds ? "On" : "Off") << "\n";
}
