#include "vtkMoteDistributeParticles.h"

#include "DataParts.h"
#include "PointParts.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMoteDistributeParticles);

vtkSmartPointer<vtkPolyData> vtkMoteDistributeParticles::Collect(
  const std::vector<vtkPointSet*>& parts)
{
  return vtkPolyData::SafeDownCast(mote::withoutMarkedPoints(mote::collectPoints(parts)));
}
