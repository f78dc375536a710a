#include "MessageCatcher.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkOutputWindow.h"

namespace mote
{
namespace
{

/// "ERROR: In foo.cxx, line 7\nvtkFoo (0x55): cannot read\n\n" is "cannot read".
std::string withoutDecoration(const std::string& text)
{
  std::string message = text;
  const std::size_t address = message.find(" (0x");
  const std::size_t close = address == message.npos ? message.npos : message.find("): ", address);
  if (close != message.npos)
  {
    message.erase(0, close + 3);
  }
  const char* const blanks = " \t\r\n";
  message.erase(message.find_last_not_of(blanks) + 1);
  message.erase(0, message.find_first_not_of(blanks));
  for (std::size_t at = message.find('\n'); at != message.npos; at = message.find('\n', at))
  {
    message[at] = ' ';
  }
  return message;
}

} // namespace

MessageCatcher::MessageCatcher(vtkAlgorithm* algorithm) : m_window(vtkOutputWindow::GetInstance())
{
  m_command->SetClientData(this);
  m_command->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        auto* catcher = static_cast<MessageCatcher*>(self);
        auto& list = event == vtkCommand::ErrorEvent ? catcher->m_errors : catcher->m_warnings;
        const std::string message = withoutDecoration(text ? static_cast<const char*>(text) : "");
        if (!message.empty())
        {
          list.push_back(message);
        }
      });
  this->watch(algorithm);
  this->watch(algorithm->GetExecutive());
  if (m_window)
  {
    this->watch(m_window);
    m_displayMode = m_window->GetDisplayMode();
    m_window->SetDisplayModeToNever();
  }
}

MessageCatcher::~MessageCatcher()
{
  for (const auto& [object, tag] : m_watches)
  {
    if (object)
    {
      object->RemoveObserver(tag);
    }
  }
  if (m_window)
  {
    m_window->SetDisplayMode(m_displayMode);
  }
}

void MessageCatcher::watch(vtkObject* object)
{
  for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent})
  {
    m_watches.emplace_back(object, object->AddObserver(event, m_command));
  }
}

} // namespace mote
