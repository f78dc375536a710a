#ifndef MoteXMLReaders_h
#define MoteXMLReaders_h

// VTK's readers of XML files, mended where files of users need it.

#include "FileError.h"
#include "PieceWelds.h"
#include "TimeSteps.h"
#include "XMLCheck.h"

#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPImageDataReader.h"
#include "vtkXMLPPolyDataReader.h"
#include "vtkXMLPRectilinearGridReader.h"
#include "vtkXMLPStructuredGridReader.h"
#include "vtkXMLPUnstructuredGridReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <optional>
#include <string>
#include <vector>

#include <vtksys/SystemTools.hxx>

namespace mote
{

/// A reader of one of VTK's XML files. Where cell data are too short, VTK 9.1 names the element of
/// the point data in its message, and crashes where there is none: this adds an empty one. Where a
/// time step is damaged, VTK 9.1 takes what it has left of that for another step, and crashes:
/// after one, this has each step read by a reader of its own.
template <class Reader>
class WithPointData : public Reader
{
public:
  static WithPointData* New() { VTK_STANDARD_NEW_BODY(WithPointData); }

protected:
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    try
    {
      if (this->GetFileName())
        checkVTKXMLValues(this->GetFileName());
    }
    catch (const FileError& error)
    {
      outputs->GetInformationObject(0)->Get(vtkDataObject::DATA_OBJECT())->Initialize();
      vtkErrorMacro(<< error.what());
      return 1; // a failed request would leave old data downstream
    }
    if (m_hasFailed)
      return this->readAnew(outputs->GetInformationObject(0));
    const int done = this->Reader::RequestData(request, inputs, outputs);
    m_hasFailed = this->DataError != 0;
    return done;
  }

  int ReadPiece(vtkXMLDataElement* piece) override
  {
    if (!piece->FindNestedElementWithName("PointData"))
    {
      vtkNew<vtkXMLDataElement> none;
      none->SetName("PointData");
      piece->AddNestedElement(none);
    }
    return Reader::ReadPiece(piece);
  }

private:
  int readAnew(vtkInformation* asked)
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkNew<WithPointData> other;
    other->SetFileName(this->GetFileName());
    other->GetPointDataArraySelection()->CopySelections(this->GetPointDataArraySelection());
    other->GetCellDataArraySelection()->CopySelections(this->GetCellDataArraySelection());
    vtkNew<vtkInformation> same;
    for (vtkInformationIntegerKey* key : {Pipeline::UPDATE_PIECE_NUMBER(),
           Pipeline::UPDATE_NUMBER_OF_PIECES(), Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()})
      same->CopyEntry(asked, key);
    same->CopyEntry(asked, Pipeline::UPDATE_TIME_STEP());
    other->Update(same);
    vtkDataObject* data = other->GetOutputDataObject(0);
    asked->Get(vtkDataObject::DATA_OBJECT())->ShallowCopy(data);
    return other->m_hasFailed ? 0 : 1;
  }

  bool m_hasFailed = false;
};

/// A reader of cells. VTK 9.1 trusts what is said of where cells begin: this looks at it first.
template <class Reader>
class WithCells : public Reader
{
protected:
  /// Whether the cells of an element ascend and are no more than the file can hold.
  bool areCellsWhole(vtkXMLDataElement* cells, vtkIdType count);
  int refuse(const char* what);
};

class PolygonsReader : public WithCells<vtkXMLPolyDataReader>
{
protected:
  int ReadPieceData() override;
};

/// It trusts the numbers of faces that polyhedra have, too.
class GridReader : public WithCells<vtkXMLUnstructuredGridReader>
{
protected:
  int ReadPieceData() override;

private:
  bool areFacesWhole();
};

/// The time that the first one tells of the files that an index of pieces or blocks names.
std::optional<double> timeOfFiles(const std::string& index);

/// A reader of such an index, which by VTK itself has no time.
template <class Reader>
class WithTimeOfFiles : public Reader
{
protected:
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    if (!this->Reader::RequestInformation(request, inputs, outputs))
      return 0;
    vtkInformation* information = outputs->GetInformationObject(0);
    if (!information->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
      if (const auto time = timeOfFiles(this->GetFileName()))
        offerTimeSteps(information, {*time});
    return 1;
  }
};

/// A reader of pieces that reads each as a file by itself, with WithPointData.
template <class Reader, class PieceReader>
class InPieces : public WithTimeOfFiles<Reader>
{
public:
  static InPieces* New() { VTK_STANDARD_NEW_BODY(InPieces); }

protected:
  vtkXMLDataReader* CreatePieceReader() override { return WithPointData<PieceReader>::New(); }
};

/// Puts pieces together with one point where each has a copy.
class WeldingGridReader : public InPieces<vtkXMLPUnstructuredGridReader, GridReader>
{
public:
  static WeldingGridReader* New() { VTK_STANDARD_NEW_BODY(WeldingGridReader); }

protected:
  void ReadXMLData() override
  {
    this->Superclass::ReadXMLData();
    if (this->DataError)
      return; // some points are not there
    vtkUnstructuredGrid* grid = this->GetOutput();
    std::vector<vtkIdType> ends;
    for (int piece = this->StartPiece; piece < this->EndPiece; ++piece)
      ends.push_back((ends.empty() ? 0 : ends.back()) + this->GetNumberOfPointsInPiece(piece));
    if (const auto whole = welded(grid, ends); whole != grid)
      grid->ShallowCopy(whole);
  }
};

/// A reader of blocks that reads each of VTK's XML files as one by itself, with WithPointData.
class BlocksReader : public WithTimeOfFiles<vtkXMLMultiBlockDataReader>
{
public:
  static BlocksReader* New() { VTK_STANDARD_NEW_BODY(BlocksReader); }

protected:
  vtkDataObject* ReadDataObject(vtkXMLDataElement* element, const char* folder) override
  {
    const std::string file = this->GetFileNameFromXML(element, folder);
    const std::string ending = vtksys::SystemTools::GetFilenameLastExtension(file);
    return ending == ".vtp"   ? this->readBy<PolygonsReader>(file)
           : ending == ".vtu" ? this->readBy<GridReader>(file)
           : ending == ".vti" ? this->readBy<vtkXMLImageDataReader>(file)
           : ending == ".vts" ? this->readBy<vtkXMLStructuredGridReader>(file)
           : ending == ".vtr" ? this->readBy<vtkXMLRectilinearGridReader>(file)
                              : this->Superclass::ReadDataObject(element, folder);
  }

private:
  template <class Reader>
  vtkDataObject* readBy(const std::string& file)
  {
    vtkNew<WithPointData<Reader>> reader;
    reader->SetFileName(file.c_str());
    reader->GetPointDataArraySelection()->CopySelections(this->GetPointDataArraySelection());
    reader->GetCellDataArraySelection()->CopySelections(this->GetCellDataArraySelection());
    reader->Update();
    vtkDataObject* data = reader->GetOutputDataObject(0);
    vtkDataObject* own = data->NewInstance();
    own->ShallowCopy(data);
    return own;
  }
};

} // namespace mote

#endif
