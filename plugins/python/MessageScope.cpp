#include "MessageScope.h"

#include <base/Messages.h>

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <mutex>

namespace mote::app
{

namespace
{

std::mutex guard; ///< of all below
int living = 0;
vtkSmartPointer<vtkOutputWindow> before;
vtkLogger::Verbosity verbosity;

} // namespace

MessageScope::MessageScope(bool prints)
{
  const std::lock_guard lock(guard);
  if (living++ == 0)
  {
    before = vtkOutputWindow::GetInstance();
    verbosity = vtkLogger::GetCurrentVerbosityCutoff();
    Messages::install();
    Messages::takeWarnings();
  }
  Messages::setPrinting(prints);
  Messages::takeError();
}

MessageScope::~MessageScope()
{
  const std::lock_guard lock(guard);
  if (--living > 0)
    return;
  vtkOutputWindow::SetInstance(before);
  before = nullptr;
  vtkLogger::SetStderrVerbosity(verbosity);
  Messages::setPrinting(true);
}

} // namespace mote::app
