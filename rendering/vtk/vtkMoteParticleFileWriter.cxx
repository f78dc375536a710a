#include "vtkMoteParticleFileWriter.h"

#include "FieldArrays.h"
#include "ParticleModel.h"
#include "vtkMoteParticleMapper.h"

#include "kernels/core/Error.h"
#include "kernels/particles/PkdTreeFile.h"

#include "vtkGarbageCollector.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>

namespace
{

constexpr const char* originalIds = "vtkOriginalPointIds";

} // namespace

vtkStandardNewMacro(vtkMoteParticleFileWriter);

vtkMoteParticleFileWriter::vtkMoteParticleFileWriter()
  : Mapper(vtkSmartPointer<vtkMoteParticleMapper>::New())
{
}

vtkMoteParticleFileWriter::~vtkMoteParticleFileWriter() = default;

void vtkMoteParticleFileWriter::ReportReferences(vtkGarbageCollector* collector)
{
  this->Superclass::ReportReferences(collector);
  // It has the same input: without this the two would keep that alive for ever.
  vtkGarbageCollectorReport(collector, this->Mapper, "Mapper");
}

void vtkMoteParticleFileWriter::SetMapper(vtkMoteParticleMapper* mapper)
{
  if (mapper == this->Mapper)
    return;
  this->Mapper = mapper ? mapper : vtkSmartPointer<vtkMoteParticleMapper>::New().Get();
  this->Modified();
}

vtkMoteParticleMapper* vtkMoteParticleFileWriter::GetMapper()
{
  return this->Mapper;
}

bool vtkMoteParticleFileWriter::WriteFile()
{
  if (this->GetNumberOfInputConnections(0) > 0)
    this->Mapper->SetInputConnection(this->GetInputConnection(0, 0));
  this->Mapper->SetStructureName("pkd-tree");
  this->Mapper->FinishBuild();
  if (this->Mapper->GetAbortExecute())
    return false;
  vtkPointSet* input = this->Mapper->GetInput();
  this->Mapper->GetModel().makeLods();
  const std::shared_ptr<const mote::PkdTree> tree = this->Mapper->GetModel().tree();
  if (!input || !tree)
    throw mote::Error("there are no particles to write.");

  const mote::FieldArrays particles(input->GetPointData()),
    facts(input->GetFieldData(), {"TimeValue"});
  this->WarnOfLeftOut(particles);
  mote::PkdTreeFileContents contents;
  contents.arrays = particles.named;
  contents.facts = facts.named;
  if (this->WriteOriginalIds && !particles.has(originalIds))
    contents.indexArray = originalIds;
  if (input->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    contents.time = input->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  contents.spacing = mote::spacingOf(input);
  // What lies in files because memory is short is not read here and there.
  if (const auto space = this->Mapper->GetScratchSpace(); space && space->usesFiles())
    contents.workBytes = std::max<std::size_t>(space->budget() / 3, 1);
  contents.space = this->Mapper->GetScratchSpace();
  return mote::writePkdTreeFile(this->FileName, *tree, contents, this->ProgressOfWrite());
}

void vtkMoteParticleFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
