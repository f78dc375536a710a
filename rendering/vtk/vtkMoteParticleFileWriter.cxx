#include "vtkMoteParticleFileWriter.h"

#include "DataArrayView.h"
#include "ParticleModel.h"
#include "vtkMoteParticleMapper.h"

#include "kernels/core/AtomicFile.h"
#include "kernels/core/Error.h"
#include "kernels/particles/PkdTreeFile.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkGarbageCollector.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace
{

constexpr const char* originalIds = "vtkOriginalPointIds";

/// Arrays as the kernels see them, and what keeps them in memory.
struct Arrays
{
  std::vector<mote::NamedArray> named;
  std::vector<mote::DataArrayView> views;
  std::string leftOut;

  /// All arrays of numbers of the field but the one of a name.
  Arrays(vtkFieldData* field, const char* unwanted)
  {
    for (int i = 0; i < field->GetNumberOfArrays(); ++i)
    {
      const char* name = field->GetArrayName(i);
      vtkDataArray* array = field->GetArray(i);
      if (name && std::strcmp(name, unwanted) == 0)
        continue;
      if (array && name && *name)
        this->add(array);
      else
        leftOut += (leftOut.empty() ? "" : ", ") + std::string(name && *name ? name : "(unnamed)");
    }
  }

  bool has(const char* name) const
  {
    return std::any_of(named.begin(), named.end(), [&](const auto& a) { return a.name == name; });
  }

private:
  void add(vtkDataArray* array)
  {
    views.emplace_back(array);
    mote::NamedArray one{array->GetName(), views.back().view, {}};
    if (array->HasAComponentName())
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
        one.components.emplace_back(array->GetComponentName(k) ? array->GetComponentName(k) : "");
    named.push_back(std::move(one));
  }
};

} // namespace

vtkStandardNewMacro(vtkMoteParticleFileWriter);

vtkMoteParticleFileWriter::vtkMoteParticleFileWriter()
  : Mapper(vtkSmartPointer<vtkMoteParticleMapper>::New())
{
}

vtkMoteParticleFileWriter::~vtkMoteParticleFileWriter()
{
  this->SetFileName(nullptr);
}

int vtkMoteParticleFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

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

int vtkMoteParticleFileWriter::Write()
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  this->SetAbortExecute(0);
  unsigned long code = vtkErrorCode::UserError;
  const std::string name = this->FileName ? this->FileName : "";
  try
  {
    mote::checkWritable(name); // before hours of building
    this->InvokeEvent(vtkCommand::StartEvent, nullptr);
    const bool complete = this->WriteParticles();
    this->InvokeEvent(vtkCommand::EndEvent, nullptr);
    if (complete)
      return 1;
    this->ErrorMessage = "Cannot write \"" + name + "\": it was stopped.";
    this->SetErrorCode(code); // not reported: the user's own wish
    return 0;
  }
  catch (const mote::WriteError& error)
  {
    const bool full = error.kind() == mote::WriteError::Kind::NoSpace;
    code = full ? vtkErrorCode::OutOfDiskSpaceError : vtkErrorCode::CannotOpenFileError;
    this->ErrorMessage = error.what();
  }
  catch (const std::bad_alloc&)
  {
    this->ErrorMessage = "Cannot write \"" + name + "\": there is not enough memory for it.";
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = "Cannot write \"" + name + "\": " + error.what();
  }
  this->SetErrorCode(code);
  vtkErrorMacro(<< this->ErrorMessage);
  return 0;
}

bool vtkMoteParticleFileWriter::WriteParticles()
{
  if (this->GetNumberOfInputConnections(0) > 0)
    this->Mapper->SetInputConnection(this->GetInputConnection(0, 0));
  this->Mapper->SetStructureName("pkd-tree");
  this->Mapper->FinishBuild();
  if (this->Mapper->GetAbortExecute())
    return false;
  vtkPointSet* input = this->Mapper->GetInput();
  const std::shared_ptr<const mote::PkdTree> tree = this->Mapper->GetModel().tree();
  if (!input || !tree)
    throw mote::Error("there are no particles to write.");

  const Arrays particles(input->GetPointData(), ""), facts(input->GetFieldData(), "TimeValue");
  if (!particles.leftOut.empty())
    vtkWarningMacro(<< "\"" << this->FileName << "\" is without the arrays that hold no numbers: "
                    << particles.leftOut << ".");
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
  return mote::writePkdTreeFile(this->FileName, *tree, contents,
    [this](double done)
    {
      this->UpdateProgress(done);
      return this->GetAbortExecute() == 0;
    });
}

void vtkMoteParticleFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WriteOriginalIds: " << (this->WriteOriginalIds ? "On" : "Off") << "\n";
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
