#include "MessageCatcher.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkLogger.h"
#include "vtkOutputWindow.h"

#include <algorithm>

namespace mote
{
namespace
{

/// "ERROR: In foo.cxx, line 7\nvtkFoo (0x55): cannot read\n\n" is "cannot read".
std::string withoutDecoration(const std::string& text)
{
  std::string message = text;
  for (const char* kind : {"ERROR: In ", "Warning: In ", "Generic Warning: In "})
    if (message.starts_with(kind))
      message.erase(0, std::min(message.find('\n'), message.size()));
  const std::size_t address = message.find(" (0x");
  const std::size_t close = address == message.npos ? message.npos : message.find("): ", address);
  if (close != message.npos)
    message.erase(0, close + 3);
  const char* const blanks = " \t\r\n";
  message.erase(message.find_last_not_of(blanks) + 1);
  message.erase(0, message.find_first_not_of(blanks));
  for (std::size_t at = message.find('\n'); at != message.npos; at = message.find('\n', at))
    message[at] = ' ';
  return message;
}

} // namespace

MessageCatcher::MessageCatcher(vtkAlgorithm* algorithm)
  : m_window(vtkOutputWindow::GetInstance())
{
  m_command->SetClientData(this);
  m_command->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void* text)
    {
      auto* catcher = static_cast<MessageCatcher*>(self);
      auto& list = event == vtkCommand::ErrorEvent ? catcher->m_errors : catcher->m_warnings;
      const std::string message = withoutDecoration(text ? static_cast<const char*>(text) : "");
      if (!message.empty())
        list.push_back(message);
    });
  this->watch(algorithm);
  this->watch(algorithm->GetExecutive());
  if (m_window)
  {
    this->watch(m_window);
    m_displayMode = m_window->GetDisplayMode();
    m_window->SetDisplayModeToNever();
  }
  // VTK's logger prints by itself what no observer takes.
  m_verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

MessageCatcher::~MessageCatcher()
{
  for (const auto& [object, tag] : m_watches)
    if (object)
      object->RemoveObserver(tag);
  if (m_window)
    m_window->SetDisplayMode(m_displayMode);
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(m_verbosity));
}

std::string MessageCatcher::firstError() const
{
  for (const std::string& error : m_errors)
    if (!error.starts_with("Algorithm "))
      return error;
  for (const std::string& warning : m_warnings)
    if (!m_errors.empty() || warning.starts_with("Error"))
      return warning;
  return m_errors.empty() ? "" : "the file is damaged, or of another format";
}

void MessageCatcher::watch(vtkObject* object)
{
  for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent})
    m_watches.emplace_back(object, object->AddObserver(event, m_command));
}

} // namespace mote
