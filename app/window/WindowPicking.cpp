// What is under the cursor.

#include "Window.h"

#include "InteractorStyle.h"
#include "Observe.h"
#include "base/Text.h"

#include <vtkAbstractArray.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkMath.h>
#include <vtkMoteParticlePicker.h>
#include <vtkPointData.h>
#include <vtkProp3D.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr unsigned long hoverAfter = 500; // ms that the cursor rests
constexpr int mostFacts = 20, fewFacts = 7;

/// A line of what is known of what was picked.
std::string factLine(std::string what, const std::string& value)
{
  what.resize(std::max<std::size_t>(what.size(), 12), ' ');
  return "\n " + what + " " + value + " ";
}

std::string asTuple(const double* values, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
    text += (i > 0 ? ", " : "") + asNumber(values[i]);
  return text;
}

std::string particleFacts(const Part& part, vtkIdType id, int most)
{
  double position[3];
  part.data()->GetPoint(id, position);
  std::string text = factLine("particle", withThousands(id) + " of " + part.name()).substr(1);
  text += factLine("position", asTuple(position, 3));
  vtkPointData* arrays = part.data()->GetPointData();
  int told = 0;
  for (int i = 0; i < arrays->GetNumberOfArrays() && told < most; ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (nameOf(array).empty() || id >= array->GetNumberOfTuples())
      continue;
    ++told;
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
      text += factLine(array->GetName(),
        asTuple(numbers->GetTuple(id), std::min(9, numbers->GetNumberOfComponents())));
    else if (auto* words = vtkStringArray::SafeDownCast(array))
      text += factLine(array->GetName(), words->GetValue(id));
  }
  return text;
}

} // namespace

std::optional<Window::Hit> Window::hitAt(int x, int y) const
{
  vtkNew<vtkMoteParticlePicker> picker;
  if (!picker->Pick(x, y, 0.0, stage_.renderer()))
    return {};
  for (const auto& part : stage_.parts())
    if (part->prop() == picker->GetViewProp())
    {
      Hit hit{part.get(), picker->GetParticleId(), picker->GetCellId(), picker->GetValue(), {}};
      picker->GetPickPosition(hit.at.data());
      return hit;
    }
  return {};
}

std::string Window::factsOf(const Hit& hit, int mostArrays)
{
  if (hit.cell < 0)
    return particleFacts(*hit.part, hit.particle, mostArrays);
  return factLine("iso-surface", asNumber(hit.value)).substr(1) +
         factLine("cell", withThousands(hit.cell) + " of " + hit.part->name()) +
         factLine("position", asTuple(hit.at.data(), 3));
}

void Window::pick()
{
  const int* cursor = interactor_->GetEventPosition();
  props_.unmark();
  overlay_.setMessage("");
  overlay_.hideTip();
  const std::optional<Hit> hit = this->hitAt(cursor[0], cursor[1]);
  if (!hit)
    return this->say("There is neither a particle nor an iso-surface under the cursor");
  if (hit->cell < 0)
  {
    double center[3];
    hit->part->data()->GetPoint(hit->particle, center);
    props_.mark(center, std::sqrt(vtkMath::Distance2BetweenPoints(center, hit->at.data())));
  }
  overlay_.setMessage(factsOf(*hit, mostFacts));
  overlay_.hideHelp();
  if (messageTimer_ > 0)
    interactor_->DestroyTimer(messageTimer_);
  messageTimer_ = 0;
}

void Window::center()
{
  const int* cursor = interactor_->GetEventPosition();
  const std::optional<Hit> hit = this->hitAt(cursor[0], cursor[1]);
  if (!hit)
    return this->say("There is no particle under the cursor");
  double focus[3], position[3];
  vtkCamera* camera = stage_.renderer()->GetActiveCamera();
  camera->GetFocalPoint(focus);
  camera->GetPosition(position);
  for (std::size_t i = 0; i < 3; ++i)
    position[i] += hit->at[i] - focus[i];
  camera->SetFocalPoint(hit->at.data());
  camera->SetPosition(position);
  stage_.renderer()->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------------------------
// The cursor at rest

void Window::setUpHover()
{
  constexpr float first = 20.0f; // before the panel, which keeps its events
  observe(
    interactor_, vtkCommand::MouseMoveEvent, [this](void*) { this->moveCursor(); }, first);
}

void Window::moveCursor()
{
  if (busy_ || quit_)
    return;
  const bool wasTold = overlay_.hasTip();
  overlay_.hideTip();
  const int left = window_->GetSize()[0] - this->viewSize()[0];
  const bool isInView = interactor_->GetEventPosition()[0] >= left;
  if (isInView && style_->GetState() == VTKIS_NONE)
    this->startTimer(hoverTimer_, hoverAfter);
  else
    hoverTimer_ = 0;
  if (wasTold)
    this->renderOverlays();
}

void Window::hover()
{
  const int* cursor = interactor_->GetEventPosition();
  const int left = window_->GetSize()[0] - this->viewSize()[0];
  if (playing_ || style_->GetState() != VTKIS_NONE || cursor[0] < left)
    return;
  const std::optional<Hit> hit = this->hitAt(cursor[0], cursor[1]);
  if (!hit)
    return;
  overlay_.setTip(factsOf(*hit, fewFacts), cursor[0] - left, cursor[1], this->viewSize());
  this->renderOverlays();
}

/// A frame in which the view itself waits for its own turn.
void Window::renderOverlays()
{
  pass_->RefiningOff();
  this->render();
  pass_->RefiningOn();
}

} // namespace mote::app
