#pragma once

#include "settings/Settings.h"

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <array>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace mote::app
{

/// The texts that lie over the view: the status line, the help, a message.
class Overlay
{
public:
  /// Over the view and all else in the window.
  Overlay(vtkRenderWindow* window, vtkRenderer* view);

  /// What is drawn last. Its viewport is to be that of the view.
  vtkRenderer* renderer();

  /// Stands between what the status line tells.
  static constexpr const char* dot = "   \u00b7   ";

  /// What the line at the bottom says. In a narrow view the first and the last of what dots part
  /// are told before those between.
  void setStatus(const std::string& text);
  const std::string& status() const { return status_; }

  /// A text at the upper left; none to take it away. Words of equal length stand one over the
  /// other. `isOfPicked`: it lists values of what was picked, which other data have otherwise.
  void setMessage(const std::string& text, bool isOfPicked = false);
  bool hasMessage() const;
  bool tellsPicked() const { return tellsPicked_; }

  /// The line at the top that says that this is a preview; none to take it away.
  void setPreview(const std::string& text);

  /// A text beside a place in pixels from the lower left corner of a view of this size, on the side
  /// where there is room.
  void setTip(const std::string& text, int x, int y, const std::array<int, 2>& size);
  void hideTip();
  bool hasTip() const { return tipOn_; }
  bool hasHelp() const { return helpOn_; }

  /// Pixels at the upper edge that are no place for messages.
  void setTop(int pixels);

  void toggleHelp();
  void hideHelp();
  /// Goes on in a list of keys that does not fit into the view, by so many lines; false where there
  /// is none.
  bool scrollHelp(int lines);

  /// The size of all texts: 1 for a display of 96 dots an inch.
  void setScale(double scale);

  /// Follows the view's background.
  void followBackground();

private:
  bool fits(vtkTextActor* text) const;
  int pixels(int size) const;
  void layHelp();
  void showHelpLines();

  vtkRenderer* view_;
  vtkNew<vtkRenderer> renderer_;
  std::string status_;
  int statusWidth_ = 0;      ///< of the view
  int top_ = -1, topOf_ = 0; ///< pixels without messages, and the height of the view then
  double scale_ = 1.0;
  std::array<int, 2> helpSize_ = {};   ///< of the view, when the help was laid out
  std::vector<std::string> helpLines_; ///< where they do not all fit, else none
  int helpFirst_ = 0, helpRows_ = 0;   ///< of those lines, that are shown
  bool helpOn_ = false;
  bool messageOn_ = false;
  bool tellsPicked_ = false;
  bool tipOn_ = false;
  vtkNew<vtkTextActor> statusText_;
  vtkNew<vtkTextActor> messageText_;
  vtkNew<vtkTextActor> helpText_;
  vtkNew<vtkTextActor> previewText_;
  vtkNew<vtkTextActor> tipText_;
};

} // namespace mote::app
