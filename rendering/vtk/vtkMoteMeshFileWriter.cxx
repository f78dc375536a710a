#include "vtkMoteMeshFileWriter.h"

#include "FieldArrays.h"
#include "MeshGeometry.h"
#include "vtkMoteMeshMapper.h"

#include "kernels/core/Error.h"
#include "kernels/meshes/RlodTreeFile.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkGarbageCollector.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace
{

constexpr const char* originalPoints = "vtkOriginalPointIds";
constexpr const char* originalCells = "vtkOriginalCellIds";

} // namespace

vtkStandardNewMacro(vtkMoteMeshFileWriter);

vtkMoteMeshFileWriter::vtkMoteMeshFileWriter()
  : Mapper(vtkSmartPointer<vtkMoteMeshMapper>::New())
{
}

vtkMoteMeshFileWriter::~vtkMoteMeshFileWriter() = default;

void vtkMoteMeshFileWriter::ReportReferences(vtkGarbageCollector* collector)
{
  this->Superclass::ReportReferences(collector);
  // It has the same input: without this the two would keep that alive for ever.
  vtkGarbageCollectorReport(collector, this->Mapper, "Mapper");
}

void vtkMoteMeshFileWriter::SetMapper(vtkMoteMeshMapper* mapper)
{
  if (mapper == this->Mapper)
    return;
  this->Mapper = mapper ? mapper : vtkSmartPointer<vtkMoteMeshMapper>::New().Get();
  this->Modified();
}

vtkMoteMeshMapper* vtkMoteMeshFileWriter::GetMapper()
{
  return this->Mapper;
}

bool vtkMoteMeshFileWriter::WriteFile()
{
  if (this->GetNumberOfInputConnections(0) > 0)
    this->Mapper->SetInputConnection(this->GetInputConnection(0, 0));
  this->Mapper->Update();
  if (this->Mapper->GetAbortExecute())
    return false;
  vtkPointSet* input = this->Mapper->GetInput();
  const auto built = this->Mapper->GetBuilt();
  if (!input || !built)
    throw mote::Error("there are no triangles to write.");
  if (!built->geometry.mesh())
    throw mote::Error("the triangles come from such a file, which can be copied.");
  mote::MeshGeometry geometry = built->geometry;
  geometry.makeLods();

  const mote::FieldArrays points(input->GetPointData()), cells(input->GetCellData()),
    facts(input->GetFieldData(), {"TimeValue"});
  this->WarnOfLeftOut(points);
  this->WarnOfLeftOut(cells);
  const mote::DataArrayView places(input->GetPoints()->GetData());
  mote::RlodTreeFileContents contents;
  contents.places = places.view;
  contents.points = points.named;
  contents.cells = cells.named;
  contents.cellOf = geometry.cells();
  contents.facts = facts.named;
  if (this->WriteOriginalIds && !points.has(originalPoints))
    contents.pointIndices = originalPoints;
  if (this->WriteOriginalIds && !cells.has(originalCells))
    contents.cellIndices = originalCells;
  if (vtkDataArray* normals = input->GetPointData()->GetNormals(); normals && normals->GetName())
    contents.normals = normals->GetName();
  if (input->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    contents.time = input->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  return mote::writeRlodTreeFile(
    this->FileName, *geometry.tree(), *geometry.mesh(), contents, this->ProgressOfWrite());
}

void vtkMoteMeshFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
