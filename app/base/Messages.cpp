#include "Messages.h"

#include "Failure.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <cstdio>
#include <new>
#include <utility>

namespace mote::app
{

namespace
{

vtkSmartPointer<Messages> installed;
thread_local std::string firstError;

std::mutex guard; ///< of `kept`
std::vector<std::string> kept;
std::atomic<bool> printing = true;

/// The sentence in "ERROR: In FILE, line N\nvtkClass (0x5581): SENTENCE\n\n".
std::string sentenceOf(const std::string& text)
{
  std::size_t begin = 0;
  const std::size_t object = text.find("): ");
  if (text.find("In ") != std::string::npos && object != std::string::npos)
    begin = object + 3;
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  return end == std::string::npos || end < begin ? "" : text.substr(begin, end + 1 - begin);
}

} // namespace

vtkStandardNewMacro(Messages);

void Messages::install()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it would print on its own
  installed = vtkSmartPointer<Messages>::New();
  vtkOutputWindow::SetInstance(installed);
}

std::string Messages::takeError()
{
  return std::exchange(firstError, {});
}

void Messages::throwError(const std::string& what)
{
  const std::string error = takeError();
  if (error == std::bad_alloc().what())
    throw std::bad_alloc();
  if (!error.empty())
    throw Failure(what + error);
}

void Messages::warn(const std::string& sentence)
{
  constexpr std::size_t most = 100;
  if (printing)
    std::fprintf(stderr, "mote: warning: %s\n", sentence.c_str());
  const std::lock_guard lock(guard);
  if (kept.size() == most)
    kept.erase(kept.begin());
  kept.push_back(sentence);
}

void Messages::setPrinting(bool prints)
{
  printing = prints;
}

std::vector<std::string> Messages::takeWarnings()
{
  const std::lock_guard lock(guard);
  return std::exchange(kept, {});
}

void Messages::DisplayText(const char*) {}

void Messages::DisplayErrorText(const char* text)
{
  if (firstError.empty())
    firstError = sentenceOf(text);
}

void Messages::DisplayWarningText(const char* text)
{
  const std::string whole = text;
  if (whole.find("vtkMote") == std::string::npos)
    return;
  const std::string sentence = sentenceOf(whole);
  const std::lock_guard lock(this->mutex_);
  if (this->warnings_.find(sentence) != std::string::npos)
    return;
  this->warnings_ += sentence;
  warn(sentence);
}

void Messages::DisplayGenericWarningText(const char* text)
{
  this->DisplayWarningText(text);
}

} // namespace mote::app
