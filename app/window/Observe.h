#pragma once

#include <vtkCommand.h>
#include <vtkObject.h>

namespace mote::app
{

/// Calls a function, with the event's data, whenever the object fires the event. While a button is
/// held down in the view the interactor's style has its events to itself, timers too: only passive
/// observers are told of them, before all others.
template <class Function>
void observe(vtkObject* object, unsigned long event, const Function& function,
  float priority = 0.0f, bool isPassive = false)
{
  class Command : public vtkCommand
  {
  public:
    explicit Command(const Function& f)
      : function_(f)
    {
    }
    void Execute(vtkObject*, unsigned long, void* data) override { function_(data); }

  private:
    Function function_;
  };
  auto* command = new Command(function);
  command->SetPassiveObserver(isPassive);
  object->AddObserver(event, command, priority);
  command->Delete();
}

} // namespace mote::app
