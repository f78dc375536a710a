#pragma once

#include <base/Messages.h>

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace mote::app
{

/// While it lives, VTK's and Mote's messages are the program's; afterwards those of VTK go where
/// they went. Without `prints` warnings are kept alone, for takeWarnings().
class MessageScope
{
public:
  explicit MessageScope(bool prints = false)
    : before_(vtkOutputWindow::GetInstance())
    , verbosity_(vtkLogger::GetCurrentVerbosityCutoff())
  {
    Messages::install();
    Messages::setPrinting(prints);
    Messages::takeError();
    Messages::takeWarnings();
  }
  ~MessageScope()
  {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
    Messages::setPrinting(true);
  }
  MessageScope(const MessageScope&) = delete;
  MessageScope& operator=(const MessageScope&) = delete;

private:
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
};

} // namespace mote::app
