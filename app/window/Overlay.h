#pragma once

#include "settings/Settings.h"

#include <vtkNew.h>
#include <vtkTextActor.h>

#include <string>

class vtkRenderer;

namespace mote::app
{

/// The texts that lie over the view: the status line, the help, a message.
class Overlay
{
public:
  explicit Overlay(vtkRenderer* renderer);

  /// What the line at the bottom says.
  void setStatus(const std::string& text);
  const std::string& status() const { return status_; }

  /// A text at the upper left; none to take it away. Words of equal length stand one over the
  /// other.
  void setMessage(const std::string& text);
  bool hasMessage() const;

  /// The line at the top that says that this is a preview; none to take it away.
  void setPreview(const std::string& text);

  void toggleHelp();
  void hideHelp();

  /// Without texts, for pictures of the view.
  void setVisible(bool visible);

  /// Follows a change of background.
  void setInk(const Color& ink);

private:
  std::string status_;
  bool helpOn_ = false;
  bool messageOn_ = false;
  bool previewOn_ = false;
  vtkNew<vtkTextActor> statusText_;
  vtkNew<vtkTextActor> messageText_;
  vtkNew<vtkTextActor> helpText_;
  vtkNew<vtkTextActor> previewText_;
};

} // namespace mote::app
