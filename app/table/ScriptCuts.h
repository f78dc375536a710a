#pragma once

#include "ScriptText.h"

class vtkAbstractMapper;
class vtkMoteClipCylinder;

namespace mote::app
{

/// The planes and the cylinder that cut a mapper's picture, in lines about "mapper".
void writeCuts(Script& script, vtkAbstractMapper* mapper, vtkMoteClipCylinder* cylinder);

} // namespace mote::app
