#include "vtkMoteDistributeMesh.h"

#include "PolygonCutter.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMoteDistributeMesh);

vtkSmartPointer<vtkPolyData> vtkMoteDistributeMesh::Collect(const std::vector<vtkPointSet*>& parts)
{
  return mote::collectPolygons(parts);
}
