#include "ReadInside.h"

#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"

namespace mote
{

vtkSmartPointer<vtkDataObject> readInside(vtkAlgorithm* self, vtkAlgorithm* reader,
  std::optional<double> time, std::string& error, std::string& warnings)
{
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(self);
  progress->SetCallback(
    [](vtkObject* object, unsigned long, void* data, void*)
    {
      auto* inner = static_cast<vtkAlgorithm*>(object);
      auto* outer = static_cast<vtkAlgorithm*>(data);
      outer->UpdateProgress(inner->GetProgress());
      inner->SetAbortExecute(outer->GetAbortExecute());
    });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, progress);
  auto data = time ? vtkMoteReaderTable::Read(reader, *time, error, &warnings)
                   : vtkMoteReaderTable::Read(reader, error, &warnings);
  reader->RemoveObserver(tag);
  return data;
}

} // namespace mote
