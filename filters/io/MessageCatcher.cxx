#include "MessageCatcher.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkLogger.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <mutex>

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
  // Advice on the menus of another program.
  message.erase(std::min(message.find(" If you are trying to read a parallel"), message.size()));
  const char* const blanks = " \t\r\n";
  message.erase(message.find_last_not_of(blanks) + 1);
  message.erase(0, message.find_first_not_of(blanks));
  for (std::size_t at = message.find('\n'); at != message.npos; at = message.find('\n', at))
    message[at] = ' ';
  return message;
}

} // namespace

/// What the process's one output window says goes to the catcher of the thread that said it. There
/// is one observer for all catchers, as VTK's lists of observers are not made for several threads.
class WindowWatch
{
public:
  static void begin(MessageCatcher* catcher, MessageCatcher*& before)
  {
    before = s_current;
    s_current = catcher;
    const std::lock_guard lock(s_mutex);
    if (s_catchers++ > 0)
      return;
    s_window = vtkOutputWindow::GetInstance();
    if (s_window)
    {
      auto command = vtkSmartPointer<vtkCallbackCommand>::New();
      command->SetCallback(
        [](vtkObject*, unsigned long event, void*, void* text)
        {
          if (s_current)
            s_current->take(event, static_cast<const char*>(text));
        });
      s_tags = {s_window->AddObserver(vtkCommand::ErrorEvent, command),
        s_window->AddObserver(vtkCommand::WarningEvent, command)};
      s_displayMode = s_window->GetDisplayMode();
      s_window->SetDisplayModeToNever();
    }
    // VTK's logger prints by itself what no observer takes.
    s_verbosity = vtkLogger::GetCurrentVerbosityCutoff();
    if (s_verbosity != vtkLogger::VERBOSITY_OFF)
      vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }

  static void end(MessageCatcher* before)
  {
    s_current = before;
    const std::lock_guard lock(s_mutex);
    if (--s_catchers > 0)
      return;
    if (s_window)
    {
      for (const unsigned long tag : s_tags)
        s_window->RemoveObserver(tag);
      s_window->SetDisplayMode(s_displayMode);
    }
    s_window = nullptr;
    if (s_verbosity != vtkLogger::VERBOSITY_OFF)
      vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(s_verbosity));
  }

private:
  static inline thread_local MessageCatcher* s_current = nullptr;
  static inline std::mutex s_mutex; ///< of all that follows
  static inline int s_catchers = 0;
  static inline vtkSmartPointer<vtkOutputWindow> s_window;
  static inline std::array<unsigned long, 2> s_tags{};
  static inline int s_displayMode = 0;
  static inline int s_verbosity = 0; ///< of the logger
};

MessageCatcher::MessageCatcher(vtkAlgorithm* algorithm)
{
  m_command->SetClientData(this);
  m_command->SetCallback([](vtkObject*, unsigned long event, void* self, void* text)
    { static_cast<MessageCatcher*>(self)->take(event, static_cast<const char*>(text)); });
  this->watch(algorithm);
  this->watch(algorithm->GetExecutive());
  WindowWatch::begin(this, m_before);
}

MessageCatcher::~MessageCatcher()
{
  WindowWatch::end(m_before);
  for (const auto& [object, tag] : m_watches)
    if (object)
      object->RemoveObserver(tag);
}

void MessageCatcher::take(unsigned long event, const char* text)
{
  auto& list = event == vtkCommand::ErrorEvent ? m_errors : m_warnings;
  const std::string message = withoutDecoration(text ? text : "");
  if (!message.empty())
    list.push_back(message);
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
