// Ranges of colours that are found by looking.

#include "Window.h"

#include "base/Text.h"
#include "commands/Film.h"
#include "stage/Plot.h"

#include <vtkLookupTable.h>
#include <vtkMoteAreaPicker.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mote::app
{

/// Has the colours go from the least to the greatest value that any time step has.
void Window::takeRangeOfAllSteps()
{
  std::vector<double> range;
  const Coloring::SeenRange seen = stage_.coloring().seenRange();
  const bool done = this->doElsewhere(
    [&]
    {
      Settings free = this->settings();
      free.color.range.clear();
      free.color.percentiles.clear();
      stage_.apply(free);
      std::vector<int> steps(static_cast<std::size_t>(input_.numberOfSteps()));
      std::iota(steps.begin(), steps.end(), 0);
      includeColors(stage_, input_, steps, progress_);
      stage_.applyColors();
      if (vtkLookupTable* table = stage_.coloring().table(); table && !stage_.coloring().isTyped())
        range.assign(table->GetRange(), table->GetRange() + 2);
      stage_.coloring().goBackTo(seen); // these steps were not shown
    });
  if (done && !range.empty())
    this->takeRange(range, "in all " + counted(input_.numberOfSteps(), "time step"));
}

/// Has the colours go through this range, and tells where it is from.
void Window::takeRange(const std::vector<double>& range, const std::string& from)
{
  double shown[2] = {range[0], range[1]};
  makeRoom(shown);
  this->change(this->settingsOf(
                 [&](Settings& s)
                 {
                   s.color.range.assign(shown, shown + 2);
                   s.color.percentiles.clear();
                 }),
    [&]
    {
      return stage_.coloring().title() + " goes from " + asNumber(range[0]) + " to " +
             asNumber(range[1]) + " " + from;
    });
}

/// Has the colours go from the least to the greatest value that the views show.
void Window::takeRangeOfView()
{
  std::vector<double> range = {HUGE_VAL, -HUGE_VAL};
  vtkNew<vtkMoteAreaPicker> picker;
  picker->PickValuesOn();
  picker->SetSamplesPerPixel(1);
  picker->SetNumberOfThreads(asked_.data.threads);
  for (View* view : views_.shown())
  {
    const int* origin = view->renderer()->GetOrigin();
    const int* size = view->renderer()->GetSize();
    picker->Pick(
      origin[0], origin[1], origin[0] + size[0] - 1, origin[1] + size[1] - 1, view->renderer());
    if (const double* own = picker->GetValueRange(); own[0] <= own[1])
      range = {std::min(range[0], own[0]), std::max(range[1], own[1])};
  }
  if (range[0] > range[1])
    return this->say("Nothing in this view has a value of " + stage_.coloring().title());
  this->takeRange(range, "in this view");
}

} // namespace mote::app
