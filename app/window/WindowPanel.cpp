// The panel at the window's side.

#include "Window.h"

#include "Observe.h"
#include "base/Failure.h"
#include "panels/ControlPlaces.h"

#include <vtkCommand.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mote::app
{

namespace
{

constexpr double panelWidth = 320.0; // pixels of a display of 96 dots an inch
constexpr unsigned long soon = 1;    // ms

} // namespace

void Window::setUpPanel()
{
  this->updateScale();
  panelHost_ = std::make_unique<PanelHost>(window_, interactor_, scale_);
  if (!panelHost_->isSupported())
  {
    panelHost_.reset();
    return;
  }
  panelHost_->onInput = [this]
  {
    if (panelTimer_ == 0)
      this->startTimer(panelTimer_, soon);
  };
  panelHost_->onHurry = [this]
  {
    if (!busy_)
      this->takeWish();
  };
  // After all else, before the window shows the frame.
  observe(overlay_.renderer(), vtkCommand::EndEvent, [this](void*) { this->drawPanel(); });
}

/// Gives all texts the size that the settings ask for, or the display.
void Window::updateScale()
{
  static const double usual = displayScale();
  const double scale = this->settings().output.uiScale.value_or(usual);
  // A slider that is dragged would go away from under the mouse.
  if (scale == scale_ || beforeHold_)
    return;
  scale_ = scale;
  overlay_.setScale(scale);
  views_.setScale(scale);
  props_.setScale(scale);
  bar_.setScale(scale);
  if (!panelHost_)
    return;
  panelHost_->setScale(scale);
  this->updatePanel();
}

/// Pixels that the panel would have of a window that is wide enough.
int Window::widthOfPanel() const
{
  return static_cast<int>(panelWidth * scale_);
}

/// Pixels that the panel has of the window; 0 where there is no room for one.
int Window::widthOfPanelNow() const
{
  constexpr double least = 0.6; // of its width: narrower, its texts are cut
  const int* size = window_->GetSize();
  const int width = std::min(this->widthOfPanel(), size[0] / 2);
  return width < least * this->widthOfPanel() || size[1] < least * this->widthOfPanel() ? 0 : width;
}

/// The view has what the panel leaves of the window.
void Window::updatePanel()
{
  const int* size = window_->GetSize();
  const int width = panelHost_ && panelOn_ ? this->widthOfPanelNow() : 0;
  const bool isStart = panelHost_ && panelOn_ && this->isEmpty();
  const double left = isStart ? 0.0 : static_cast<double>(width) / std::max(1, size[0]);
  for (vtkRenderer* renderer : {stage_.renderer(), overlay_.renderer()})
    renderer->SetViewport(left, 0.0, 1.0, 1.0);
  props_.placeAxes();
  if (panelHost_)
    panelHost_->setWidth(isStart ? size[0] : width);
}

std::array<int, 2> Window::viewSize() const
{
  const int* size = window_->GetSize();
  const double left = stage_.renderer()->GetViewport()[0];
  return {size[0] - static_cast<int>(std::lround(left * size[0])), size[1]};
}

void Window::drawPanel()
{
  const double start = vtkTimerLog::GetUniversalTime();
  this->drawPanelNow();
  panelTime_ += vtkTimerLog::GetUniversalTime() - start;
}

void Window::drawPanelNow()
{
  if (!panelHost_)
    return;
  if (busy_ || !panelOn_ || panelHost_->width() == 0)
    return panelHost_->lose();
  if (!panelHost_->isLaid())
    this->layPanel();
  // The views have what the panel leaves.
  if (this->isEmpty())
    panelHost_->lose();
  panelHost_->draw();
}

/// Draws the panel alone, where nothing else has changed.
void Window::renderPanel()
{
  if (!panelHost_ || !panelOn_ || panelHost_->width() == 0)
    return this->renderOverlays();
  this->layPanel();
  const PanelHost::Drawn drawn = panelHost_->drawAlone();
  if (drawn == PanelHost::Drawn::Not)
    this->renderOverlays();
  else if (drawn == PanelHost::Drawn::Anew)
    presenter_.presentLeft(panelHost_->width());
}

void Window::layPanel()
{
  PanelFacts facts;
  facts.step = wantedStep_ >= 0 ? wantedStep_ : step_;
  facts.shownStep = step_;
  if (cache_)
    facts.cache = cache_->facts();
  facts.steps = input_.numberOfSteps();
  facts.hasTimes = !input_.times().empty();
  facts.time = facts.hasTimes ? input_.times()[static_cast<std::size_t>(step_)] : 0.0;
  facts.isPlaying = playing_;
  facts.costs = costs_;
  facts.messages = messages_;
  facts.picked = {
    &picked_, &picksThrough_, overTime_.get(), input_.times(), step_, input_.numberOfSteps()};
  facts.quality = views_.numberOfSamples() > 0 ? this->qualityText() : "";
  facts.isRecording = recorder_.isOn();
  if (player_)
    facts.played = player_->progress();
  panelHost_->lay(
    [&]
    {
      const int* size = window_->GetSize();
      wish_ = panel_.draw(
        facts, wish_, static_cast<float>(panelHost_->width()), static_cast<float>(size[1]));
    });
  panelHost_->setFocused(panel_.hasFocus());
  panelHost_->setTyping(panel_.awaitsKeys());
  const bool isOver = beforeHold_ && !wish_.isHeld && !grip_ && !player_;
  hasOtherHandles_ = views_.offerHandles(panel_.showsCuts()) || hasOtherHandles_;
  if ((wish_.settings || wish_.open || wish_.action != Action::None || isOver ||
        hasOtherHandles_) &&
      panelTimer_ == 0)
    this->startTimer(panelTimer_, soon);
  writeControls(panelHost_->inputs(), panelTimer_ != 0);
}

/// Does what the user asked for by the panel, and draws the panel anew.
void Window::takeWish()
{
  const PanelWish wish = std::exchange(wish_, {});
  if (wish.settings)
    this->takeSettings(*wish.settings, wish.isHeld);
  else if (!wish.isHeld && !grip_ && !player_)
    this->endHold();
  if (wish.open)
  {
    this->endHold();
    this->open(*wish.open);
  }
  else if (wish.action != Action::None)
  {
    this->endHold();
    Binding binding;
    binding.action = wish.action;
    try
    {
      this->act(binding);
    }
    catch (const Failure& failure)
    {
      this->say(failure.what());
      this->render();
    }
  }
  else if (std::exchange(hasOtherHandles_, false))
    this->renderOverlays();
  else if (!wish.settings)
    this->renderPanel(); // controls answer while the view is traced
}

void Window::takeSettings(Settings next, bool isHeld)
{
  if (next.color.array != this->settings().color.array)
    this->fitToArray(next);
  if (!isHeld)
  {
    // What comes with the release is the end of the drag, and is undone with it.
    if (wantedStep_ >= 0)
    {
      if (next.data == this->settings().data)
        next.data.step = std::to_string(wantedStep_ + 1);
      wantedStep_ = -1;
      cache_->want(-1);
    }
    const bool isShown = !beforeHold_ || this->follow(next);
    this->endHold();
    failure_.clear();
    if (isShown)
      this->change(next);
    if (!failure_.empty())
      panel_.refuse(this->settings(), next, failure_);
    return this->render();
  }
  // What is dragged is seen at once, coarsely, and undone as one.
  if (!beforeHold_)
    beforeHold_ = this->settingsAsSeen();
  if (cache_ && next.data != this->settings().data)
  {
    const int step = input_.chosenStep(next);
    if (step != step_ && !cache_->has(step))
      return this->scrub(next, step);
    wantedStep_ = -1;
    cache_->want(-1);
  }
  this->follow(next);
  this->renderMoving();
}

void Window::endHold()
{
  if (!beforeHold_)
    return;
  this->endScrub();
  if (*beforeHold_ != this->settings())
    history_.add(*beforeHold_);
  beforeHold_.reset();
  this->updateScale();
  this->note({.kind = RecordedEvent::Kind::Release});
}

/// A control that was held while the panel went, as in a window that became too small for it, is
/// let go of: nobody would say so any more, and what the view chooses from then on was not noted.
void Window::letGoWithoutPanel()
{
  const bool isThere = panelHost_ && panelOn_ && panelHost_->width() > 0;
  if (!beforeHold_ || isThere || grip_ || player_ || panelTimer_ != 0)
    return;
  wish_ = {};
  this->startTimer(panelTimer_, soon);
}

void Window::togglePanel()
{
  if (!panelHost_)
    return this->say("This window's OpenGL is older than 3.2 and cannot draw the panel");
  if (!this->isEmpty() && this->widthOfPanelNow() == 0)
    return this->say("This window is too small for the panel");
  // Folded away only by whom it has the keys of: so that one key does both.
  const bool isShown = panelOn_;
  panelOn_ = !isShown || !panel_.hasFocus();
  panel_.setFocus(panelOn_);
  if (!panelOn_)
    panelHost_->setFocused(false);
}

} // namespace mote::app
