// Files that are opened in the window, and what the window tells of them.

#include "Window.h"

#include "Observe.h"
#include "base/Background.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "settings/UserState.h"
#include "table/Opening.h"
#include "table/Session.h"

#include <vtkCommand.h>
#include <vtkStringArray.h>

namespace mote::app
{

void Window::setUpOpening()
{
  observe(interactor_, vtkCommand::DropFilesEvent,
    [this](void* data)
    {
      std::vector<std::string> files;
      auto* names = static_cast<vtkStringArray*>(data);
      for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
        files.push_back(names->GetValue(i));
      if (!busy_ && !files.empty())
        this->open({files, false});
    });
}

void Window::open(const OpenChoice& choice)
{
  playing_ = false;
  this->note({.kind = RecordedEvent::Kind::Open, .adds = choice.isAdded, .files = choice.files});
  const Recorder::Doing doing(recorder_);
  try
  {
    const bool wasEmpty = this->isEmpty();
    const Settings next = settingsToOpen(this->settings(), choice.files, choice.isAdded);
    this->change(next,
      [&]
      {
        return (choice.isAdded ? "Added " : "Opened ") + nameOf(choice.files) +
               (wasEmpty ? "; press h for the keys" : "; Ctrl+Z brings back what was there");
      });
    if (input_.files() == next.data.files)
    {
      noteRecent(next.data.files);
      if (isSessionFile(choice.files.front()))
        kept_.keep(this->settings());
      else if (!choice.isAdded)
        kept_.forget();
    }
  }
  catch (const Failure& failure)
  {
    this->say(failure.what());
  }
  this->render();
}

/// Reads other files, in the place of those that are there. Where they cannot be recognised those
/// stay; where they cannot be read follow() brings those back.
void Window::readFiles(const Settings& wanted)
{
  Input next(wanted.data.files);
  next.open(progress_);
  this->endCache();
  followed_.reset();
  input_ = std::move(next);
  picked_.clear();
  overTime_ = nullptr;
  stage_.clear();
  giveBackMemory();
  stage_.apply(wanted);
  this->load(input_.chosenStep(wanted));
  giveBackMemory(); // what readers took
  picked_.addNamed(stage_.parts(), wanted.marks.picked);
  this->startCache();
  asked_ = wanted;
  arrayAsked_ = stage_.settingsInForce().color.array;
  adviceBefore_.clear();
  previewed_ = !stage_.preview().empty();
  this->nameWindow();
}

void Window::showOpenDialog()
{
  if (!panelHost_)
    return this->say("This window's OpenGL is older than 3.2 and has no list of files: mote FILE "
                     "opens one");
  panelOn_ = true;
  this->updatePanel();
  if (panelHost_->width() == 0)
    return this->say(
      "This window is too small for the list of files: make it larger, or drop files on it");
  panel_.showOpenDialog();
  panelHost_->setTyping(true);
  panelHost_->drawAgain();
}

/// The warnings that have come go into the window, too.
void Window::takeMessages()
{
  for (const std::string& warning : Messages::takeWarnings())
    this->tell(warning);
}

void Window::tell(const std::string& message)
{
  constexpr std::size_t most = 100;
  constexpr unsigned long longEnough = 12000; // ms
  if (messages_.size() == most)
    messages_.erase(messages_.begin());
  messages_.push_back(message);
  this->say(message);
  this->startTimer(messageTimer_, longEnough);
}

} // namespace mote::app
