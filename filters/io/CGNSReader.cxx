#include "CGNSReader.h"

#include "CGNSCheck.h"
#include "FileError.h"

#include "vtkCGNSReader.h"
#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtk_cgns.h"

// clang-format off
#include VTK_CGNS(cgnslib.h)
#include VTK_CGNS(cgns_io.h)
// clang-format on

#include <dlfcn.h>
#include <mutex>

namespace
{

std::mutex oneAtATime; // CGNS's library keeps one state

/// Has the library to itself while it lives, and closes what a reader left open after an error:
/// another reader of the file would find that in place of the file.
class UseOfLibrary
{
public:
  UseOfLibrary()
  {
    // At the end of the program HDF5 would complain of what damaged files left open in it. It is
    // the library that CGNS's brings, whichever that is; files are read alone, and nothing is lost.
    static const bool isAsked = []
    {
      using Function = int (*)();
      if (const auto ask = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, "H5dont_atexit")))
        ask();
      return true;
    }();
    static_cast<void>(isAsked);
  }
  ~UseOfLibrary() { cgio_cleanup(); }
  UseOfLibrary(const UseOfLibrary&) = delete;
  UseOfLibrary& operator=(const UseOfLibrary&) = delete;

private:
  std::lock_guard<std::mutex> lock_{oneAtATime};
};

const char* nameOf(vtkMultiBlockDataSet* blocks, unsigned int index)
{
  vtkInformation* facts = blocks->HasMetaData(index) ? blocks->GetMetaData(index) : nullptr;
  return facts && facts->Has(vtkCompositeDataSet::NAME()) ? facts->Get(vtkCompositeDataSet::NAME())
                                                          : nullptr;
}

/// Gives the cells of the zones in a base, which are all called Internal, the zones' names.
void nameZones(vtkMultiBlockDataSet* base)
{
  for (unsigned int i = 0; base && i < base->GetNumberOfBlocks(); ++i)
  {
    auto* zone = vtkMultiBlockDataSet::SafeDownCast(base->GetBlock(i));
    const char* name = nameOf(base, i);
    for (unsigned int k = 0; zone && name && k < zone->GetNumberOfBlocks(); ++k)
      if (const char* own = nameOf(zone, k); own && std::string(own) == "Internal")
        zone->GetMetaData(k)->Set(vtkCompositeDataSet::NAME(), name);
  }
}

class vtkMoteCGNSReader : public vtkCGNSReader
{
public:
  static vtkMoteCGNSReader* New();
  vtkTypeMacro(vtkMoteCGNSReader, vtkCGNSReader);

protected:
  vtkMoteCGNSReader() { this->LoadBndPatchOn(); }

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const UseOfLibrary use;
    this->IsWhole = false;
    try
    {
      mote::checkCGNSIsWhole(this->GetFileName());
      this->IsWhole = true;
    }
    catch (const mote::FileError& error)
    {
      vtkErrorMacro(<< error.what());
      return 1; // a failed request would leave old data downstream
    }
    const int result = this->Superclass::RequestInformation(request, inputs, outputs);
    // What there is to choose from is known now.
    this->BaseSelection->EnableAllArrays();
    this->FamilySelection->EnableAllArrays();
    this->PointDataArraySelection->EnableAllArrays();
    this->CellDataArraySelection->EnableAllArrays();
    return result;
  }

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const UseOfLibrary use;
    auto* output = vtkMultiBlockDataSet::GetData(outputs);
    output->Initialize();
    if (!this->IsWhole)
      return 1; // the error has been reported
    const int result = this->Superclass::RequestData(request, inputs, outputs);
    for (unsigned int i = 0; i < output->GetNumberOfBlocks(); ++i)
      nameZones(vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(i)));
    return result;
  }

private:
  bool IsWhole = false; ///< as the last RequestInformation found
};

vtkStandardNewMacro(vtkMoteCGNSReader);

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makeCGNSReader(const std::string& fileName)
{
  auto reader = vtkSmartPointer<vtkMoteCGNSReader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

} // namespace mote
