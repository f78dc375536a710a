#include "Overlay.h"

#include "base/Text.h"
#include "settings/Colors.h"
#include "table/Keys.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <vector>

namespace mote::app
{

namespace
{

constexpr double margin = 0.012; // of texts at the edges: shares of the view
constexpr int statusSize = 16, messageSize = 15, tipSize = 13; // pixels, at a scale of 1

vtkTextProperty* place(vtkTextActor* text, double x, double y, int size, bool top)
{
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(x, y);
  vtkTextProperty* property = text->GetTextProperty();
  property->SetFontSize(size);
  if (top)
    property->SetVerticalJustificationToTop();
  return property;
}

void onPanel(vtkTextProperty* property)
{
  property->SetFontFamilyToCourier();
  property->SetColor(0.97, 0.97, 0.97);
  property->SetBackgroundColor(0.09, 0.10, 0.12);
  property->SetBackgroundOpacity(0.82);
  property->SetLineSpacing(1.15);
}

} // namespace

Overlay::Overlay(vtkRenderWindow* window, vtkRenderer* view)
  : view_(view)
{
  constexpr int layer = 2; // the axes' is 1, and so is the view's above several
  window->SetNumberOfLayers(layer + 1);
  renderer_->SetLayer(layer);
  renderer_->InteractiveOff();
  renderer_->AutomaticLightCreationOff();
  window->AddRenderer(renderer_);
  place(statusText_, margin, margin, statusSize, false);
  onPanel(place(messageText_, margin, 0.98, messageSize, true));
  onPanel(place(helpText_, margin, 0.988, messageSize, true));
  helpText_->VisibilityOff();
  messageText_->VisibilityOff();
  onPanel(place(previewText_, 0.5, 0.98, messageSize, true));
  previewText_->GetTextProperty()->SetJustificationToCentered();
  previewText_->VisibilityOff();
  onPanel(place(tipText_, 0.0, 0.0, tipSize, true));
  tipText_->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  tipText_->VisibilityOff();
  for (vtkTextActor* text :
    {statusText_.Get(), messageText_.Get(), previewText_.Get(), helpText_.Get(), tipText_.Get()})
    renderer_->AddActor2D(text);
}

vtkRenderer* Overlay::renderer()
{
  return renderer_;
}

void Overlay::setStatus(const std::string& text)
{
  if (helpOn_)
    this->layHelp();
  const int width = renderer_->GetSize()[0];
  if (text == status_ && width == statusWidth_)
    return;
  status_ = text;
  statusWidth_ = width;
  std::vector<std::string> facts;
  for (std::size_t from = 0; from <= text.size();)
  {
    const std::size_t end = std::min(text.find(dot, from), text.size());
    facts.push_back(text.substr(from, end - from));
    from = end + std::strlen(dot);
  }
  statusText_->SetInput(text.c_str());
  while (facts.size() > 1 && !this->fits(statusText_))
  {
    facts.erase(facts.end() - (facts.size() > 3 ? 2 : 1));
    statusText_->SetInput(joined(facts, dot).c_str());
  }
}

bool Overlay::fits(vtkTextActor* text) const
{
  double box[4];
  text->GetBoundingBox(renderer_, box);
  return box[1] - box[0] <= (1.0 - 2.0 * margin) * renderer_->GetSize()[0] &&
         box[3] - box[2] <= (1.0 - 2.0 * margin) * renderer_->GetSize()[1];
}

int Overlay::pixels(int size) const
{
  return std::max(1, static_cast<int>(std::lround(scale_ * size)));
}

void Overlay::setScale(double scale)
{
  scale_ = scale;
  statusText_->GetTextProperty()->SetFontSize(this->pixels(statusSize));
  messageText_->GetTextProperty()->SetFontSize(this->pixels(messageSize));
  previewText_->GetTextProperty()->SetFontSize(this->pixels(messageSize));
  tipText_->GetTextProperty()->SetFontSize(this->pixels(tipSize));
  helpSize_ = {};
  statusWidth_ = 0;
}

/// As large as fits into the view, but to be read; lines that are too long go on below.
void Overlay::layHelp()
{
  constexpr int smallest = 11; // pixels, at a scale of 1
  const int* view = renderer_->GetSize();
  if (helpSize_ == std::array{view[0], view[1]})
    return;
  helpSize_ = {view[0], view[1]};
  helpLines_.clear();
  std::string text;
  for (int size = this->pixels(messageSize); size >= this->pixels(smallest); --size)
  {
    helpText_->GetTextProperty()->SetFontSize(size);
    constexpr int some = 40; // letters, which all are as wide, in whole pixels
    helpText_->SetInput(std::string(some, 'm').c_str());
    double line[4];
    helpText_->GetBoundingBox(renderer_, line);
    const double letters = (1.0 - 2.0 * margin) * view[0] / ((line[1] - line[0]) / some);
    text = keysHelp(static_cast<std::size_t>(letters));
    helpText_->SetInput(text.c_str());
    if (this->fits(helpText_))
      return;
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    helpLines_.push_back(line);
  double box[4];
  helpText_->GetBoundingBox(renderer_, box);
  const double height = (box[3] - box[2]) / static_cast<double>(helpLines_.size());
  helpRows_ = static_cast<int>((1.0 - 2.0 * margin) * view[1] / height) - 2;
  if (helpRows_ >= 3 && box[1] - box[0] <= (1.0 - margin) * view[0])
    return this->showHelpLines();
  helpLines_.clear();
  helpText_->SetInput(" This window is too small for the keys: \n mote help keys prints them. ");
}

/// As many lines as there is room for, and how to come to the others.
void Overlay::showHelpLines()
{
  const auto count = static_cast<int>(helpLines_.size());
  helpFirst_ = std::clamp(helpFirst_, 0, std::max(0, count - helpRows_));
  const int last = std::min(count, helpFirst_ + helpRows_);
  std::string text;
  for (int i = helpFirst_; i < last; ++i)
    text += helpLines_[static_cast<std::size_t>(i)] + "\n";
  text += " \n lines " + std::to_string(helpFirst_ + 1) + " to " + std::to_string(last) + " of " +
          std::to_string(count) + ": wheel, Page Up, Page Down ";
  helpText_->SetInput(text.c_str());
}

bool Overlay::scrollHelp(int lines)
{
  if (!helpOn_ || helpLines_.empty())
    return false;
  helpFirst_ += lines;
  this->showHelpLines();
  return true;
}

void Overlay::setTop(int pixels)
{
  if (top_ == pixels && topOf_ == renderer_->GetSize()[1])
    return;
  top_ = pixels;
  topOf_ = renderer_->GetSize()[1];
  const double y = 1.0 - std::max(0.02, double(pixels) / std::max(1, topOf_));
  messageText_->SetPosition(margin, y);
  previewText_->SetPosition(0.5, y);
}

void Overlay::setMessage(const std::string& text, bool isOfPicked)
{
  messageOn_ = !text.empty();
  tellsPicked_ = messageOn_ && isOfPicked;
  messageText_->SetInput(text.c_str());
  messageText_->SetVisibility(messageOn_);
}

void Overlay::setPreview(const std::string& text)
{
  previewText_->SetInput(text.c_str());
  previewText_->SetVisibility(!text.empty());
}

void Overlay::setTip(const std::string& text, int x, int y, const std::array<int, 2>& size)
{
  const int away = this->pixels(14); // the cursor hides nothing of it
  const int least = this->pixels(9);
  constexpr int edge = 4;
  tipText_->SetInput(text.c_str());
  double box[4];
  for (int letters = this->pixels(tipSize); letters >= least; --letters)
  {
    tipText_->GetTextProperty()->SetFontSize(letters);
    tipText_->GetBoundingBox(renderer_, box);
    if (box[1] - box[0] <= size[0] - 2 * edge)
      break;
  }
  // Beside the cursor, where there is more room, and whole if the view is wide enough for it.
  const int width = static_cast<int>(box[1] - box[0]), height = static_cast<int>(box[3] - box[2]);
  const int left = 2 * x > size[0] ? x - away - width : x + away;
  const int top = 2 * y < size[1] ? y + away + height : y - away;
  tipText_->SetPosition(std::max(edge, std::min(left, size[0] - width - edge)),
    std::min(size[1] - edge, std::max(top, height + edge)));
  tipText_->VisibilityOn();
  tipOn_ = true;
}

void Overlay::hideTip()
{
  tipText_->VisibilityOff();
  tipOn_ = false;
}

bool Overlay::hasMessage() const
{
  return messageOn_;
}

void Overlay::toggleHelp()
{
  helpOn_ = !helpOn_;
  helpFirst_ = 0;
  helpSize_ = {};
  if (helpOn_)
  {
    this->hideTip();
    this->layHelp();
  }
  helpText_->SetVisibility(helpOn_);
}

void Overlay::hideHelp()
{
  helpOn_ = false;
  helpText_->VisibilityOff();
}

void Overlay::followBackground()
{
  const Color ink = inkOn(view_);
  vtkTextProperty* status = statusText_->GetTextProperty();
  status->SetColor(ink[0], ink[1], ink[2]);
  // A veil that is seen over data alone.
  status->SetBackgroundColor(view_->GetBackground());
  status->SetBackgroundOpacity(veilOpacity);
}

} // namespace mote::app
