#ifndef MoteMessageCatcher_h
#define MoteMessageCatcher_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkCallbackCommand;
class vtkObject;

namespace mote
{

/// While it lives, collects what an algorithm, its executive and, through the output window,
/// anything that they use on this thread say as VTK errors and warnings; none of it is printed.
/// Several threads may have one each; those of one thread end in the reverse order of their
/// beginning.
class MessageCatcher
{
public:
  explicit MessageCatcher(vtkAlgorithm* algorithm);
  ~MessageCatcher();
  MessageCatcher(const MessageCatcher&) = delete;
  MessageCatcher& operator=(const MessageCatcher&) = delete;

  /// The first error that says what is wrong; empty if all is well. Readers of VTK say some things
  /// as warnings ("Error reading ascii data"), and leave others to the executive's "Algorithm ...
  /// returned failure".
  std::string firstError() const;

  /// The warnings, each without VTK's decoration ("ERROR: In f.cxx, line 1 vtkFoo (0x1): "), on one
  /// line.
  const std::vector<std::string>& warnings() const { return m_warnings; }

private:
  void watch(vtkObject* object);
  void take(unsigned long event, const char* text);
  friend class WindowWatch;

  std::vector<std::string> m_errors;
  std::vector<std::string> m_warnings;
  vtkNew<vtkCallbackCommand> m_command;
  std::vector<std::pair<vtkWeakPointer<vtkObject>, unsigned long>> m_watches;
  MessageCatcher* m_before = nullptr; ///< that this thread had
};

} // namespace mote

#endif
