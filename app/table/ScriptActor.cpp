#include "ScriptActor.h"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkProperty.h>

namespace mote::app
{

void writeActor(Script& script, vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  script.call("mapper", "SetScalarVisibility", mapper->GetScalarVisibility() != 0);
  if (mapper->GetScalarVisibility())
  {
    script.call("mapper", "SetScalarMode", mapper->GetScalarMode());
    script.call("mapper", "SelectColorArray", mapper->GetArrayName());
    script.line("mapper.SetLookupTable(colors)");
    script.call("mapper", "SetUseLookupTableScalarRange", true);
  }
  script.line("prop = vtkActor()");
  script.line("prop.SetMapper(mapper)");
  vtkProperty* look = actor->GetProperty();
  script.line("look = prop.GetProperty()");
  script.vector("look", "SetColor", look->GetColor());
  script.call("look", "SetAmbient", look->GetAmbient());
  script.call("look", "SetDiffuse", look->GetDiffuse());
  script.call("look", "SetSpecular", look->GetSpecular());
  script.call("look", "SetSpecularPower", look->GetSpecularPower());
  if (look->GetOpacity() < 1.0)
    script.call("look", "SetOpacity", look->GetOpacity());
  if (vtkProperty* back = actor->GetBackfaceProperty())
  {
    script.line("back = vtkProperty()");
    script.call("back", "SetOpacity", back->GetOpacity());
    script.line("prop.SetBackfaceProperty(back)");
  }
  if (!look->GetEdgeVisibility())
    return;
  script.line("look.EdgeVisibilityOn()");
  script.call("look", "SetLineWidth", double(look->GetLineWidth()));
  script.vector("look", "SetEdgeColor", look->GetEdgeColor());
}

} // namespace mote::app
