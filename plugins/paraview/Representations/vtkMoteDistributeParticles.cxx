#include "vtkMoteDistributeParticles.h"

#include "PointParts.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMoteDistributeParticles);

vtkSmartPointer<vtkPolyData> vtkMoteDistributeParticles::Collect(
  const std::vector<vtkPointSet*>& parts)
{
  return mote::withoutGhosts(mote::collectPoints(parts));
}
