#pragma once

#include <vtkOutputWindow.h>

#include <mutex>
#include <string>
#include <vector>

namespace mote::app
{

/// Keeps what VTK and Mote would print: the first error of each thread since its last takeError()
/// as a plain sentence. Warnings of Mote's own classes go to the terminal once each, those of VTK
/// nowhere.
class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  /// Makes this kind of window the process's one.
  static void install();

  /// This thread's first error since its last call, without file, line and class; empty if there
  /// was none.
  static std::string takeError();

  /// Throws this thread's first error since then, if there was one: as std::bad_alloc where it says
  /// that (VTK's pipeline lets no exception through), else as Failure with `what` before it.
  static void throwError(const std::string& what = {});

  /// Prints a warning on the terminal and keeps it for takeWarnings(). From any thread.
  static void warn(const std::string& sentence);

  /// Whether warn() prints. Default yes; they are kept in any case.
  static void setPrinting(bool prints);

  /// The warnings since the last call, at most the last hundred.
  static std::vector<std::string> takeWarnings();

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char*) override {}

private:
  std::mutex mutex_;     ///< of `warnings_`
  std::string warnings_; ///< those printed so far, one after the other
};

} // namespace mote::app
