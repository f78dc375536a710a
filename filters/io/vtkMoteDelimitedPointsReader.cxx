#include "vtkMoteDelimitedPointsReader.h"

#include "PointTable.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMoteDelimitedPointsReader);

vtkMoteDelimitedPointsReader::vtkMoteDelimitedPointsReader() = default;
vtkMoteDelimitedPointsReader::~vtkMoteDelimitedPointsReader() = default;

int vtkMoteDelimitedPointsReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  mote::offerPieces(outputVector->GetInformationObject(0));
  return 1;
}

int vtkMoteDelimitedPointsReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  vtkNew<vtkPolyData> result;
  const bool good = this->Attempt(
    [&](const ProgressFunction& progress)
    {
      this->RequireFileName();
      mote::checkPointTable(this->GetFileName());
      mote::TextCursor cursor(this->GetFileName(), mote::TextCursor::OpenEnd::Accept);
      mote::PointRows rows = mote::readTableHead(cursor);
      rows.space = this->GetScratchSpace();
      rows.rows = mote::countRows(cursor, rows.format);
      rows.piece = mote::requestedPiece(outputVector->GetInformationObject(0));
      mote::readPointRows(cursor, std::move(rows), progress, result);
    });
  if (good)
    output->ShallowCopy(result);
  return 1;
}

void vtkMoteDelimitedPointsReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
