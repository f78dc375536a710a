#include "ScriptCuts.h"

#include <vtkAbstractMapper.h>
#include <vtkMoteClipCylinder.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

namespace mote::app
{

void writeCuts(Script& script, vtkAbstractMapper* mapper, vtkMoteClipCylinder* cylinder)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    script.line("plane = vtkPlane()");
    script.vector("plane", "SetOrigin", plane->GetOrigin());
    script.vector("plane", "SetNormal", plane->GetNormal());
    script.line("mapper.AddClippingPlane(plane)");
  }
  if (!cylinder)
    return;
  script.line("piece = mote.vtkMoteClipCylinder()");
  script.vector("piece", "SetCenter", cylinder->GetCenter());
  script.vector("piece", "SetAxis", cylinder->GetAxis());
  script.vector("piece", "SetRadiusRange", cylinder->GetRadiusRange(), 2);
  script.vector("piece", "SetHeightRange", cylinder->GetHeightRange(), 2);
  script.vector("piece", "SetAngleRange", cylinder->GetAngleRange(), 2);
  script.line("mapper.SetClipCylinder(piece)");
}

} // namespace mote::app
