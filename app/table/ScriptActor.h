#pragma once

#include "ScriptText.h"

class vtkActor;

namespace mote::app
{

/// Writes the colours of a mapper, and its actor with what it looks like.
void writeActor(Script& script, vtkActor* actor);

/// Writes how often a mapper draws its input around an axis.
template <typename Mapper>
void writeRepetitions(Script& script, Mapper* mapper)
{
  if (mapper->GetRepetitions() == 1)
    return;
  script.call("mapper", "SetRepetitions", mapper->GetRepetitions());
  script.vector("mapper", "SetRepetitionCenter", mapper->GetRepetitionCenter());
  script.vector("mapper", "SetRepetitionAxis", mapper->GetRepetitionAxis());
  script.line("mapper.TurnVectorsOn()");
}

} // namespace mote::app
