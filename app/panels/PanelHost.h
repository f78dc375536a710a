#pragma once

#include <array>
#include <deque>
#include <functional>
#include <string>
#include <vector>

class vtkCommand;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
struct ImGuiContext;

namespace mote::app
{

/// Draws controls of Dear ImGui over a window of VTK, and gives them the window's input. Input that
/// is the controls' does not reach the interactor's style.
class PanelHost
{
public:
  /// `scale` is the size of texts and controls: 1 for a display of 96 dots an inch.
  PanelHost(vtkRenderWindow* window, vtkRenderWindowInteractor* interactor, double scale);
  ~PanelHost();
  PanelHost(const PanelHost&) = delete;
  PanelHost& operator=(const PanelHost&) = delete;

  /// Whether this window's OpenGL can draw controls; asked once the window has drawn.
  bool isSupported();

  /// Another size, from the next layout on. Not within one.
  void setScale(double scale);

  /// Lays out what `controls` asks ImGui for: the input that came works, and nothing is drawn yet.
  void lay(const std::function<void()>& controls);
  /// Whether there is a layout that has not been drawn.
  bool isLaid() const { return isLaid_; }
  /// Draws the layout into the frame that is being made, where it does not stand there from the
  /// last one. Within the EndEvent of a renderer.
  void draw();
  /// What is on the screen in the controls' part is not what was drawn there last.
  void lose() { wasWithin_ = false; }
  enum class Drawn
  {
    Not,  ///< more than the controls' own part is covered, or was: a new frame is needed
    Same, ///< what is there
    Anew  ///< that part is to be shown
  };
  /// Draws the layout over the last frame, in the controls' own part of the window.
  Drawn drawAlone();

  /// Input for the controls has come, or they are not done: they should be drawn again soon.
  std::function<void()> onInput;
  /// A key came before a press of the mouse was seen: they should be drawn at once, as the press
  /// decides whose the key is.
  std::function<void()> onHurry;

  /// The part of the window, from its left edge, that is the controls' own. Where they have none,
  /// all keys and buttons are the view's, whatever list or field is open among them.
  void setWidth(int pixels)
  {
    width_ = pixels;
    if (width_ == 0)
      waiting_.clear();
  }
  int width() const { return width_; }
  /// Draws some frames more: what opens needs them to find its size.
  void drawAgain();
  /// How many presses and releases of the mouse have come, and whether more frames are to come for
  /// what came.
  int inputs() const { return inputs_; }
  bool isWaiting() const { return !waiting_.empty() || framesToCome_ > 0; }
  /// Takes the keys that move between controls from the view, or leaves them to it.
  void setFocused(bool focused) { isFocused_ = focused; }
  /// All keys are texts, and wait for the field that will take them.
  void setTyping(bool typing) { isTyping_ = typing; }

private:
  struct Input
  {
    enum Kind
    {
      Button,
      Place, ///< of the mouse alone
      Key,
      Character,
      Wheel
    };
    Kind kind;
    int number; ///< of the button, the key or the character
    bool isDown = false;
    float wheel = 0.0f;
    int x = 0, y = 0;      ///< where the mouse was
    bool isRepeat = false; ///< the second click of two
    bool hasControl = false, hasShift = false, hasAlt = false;
  };
  void start();
  void observe(unsigned long event, float priority, const std::function<bool()>& handle,
    bool isPassive = false);
  bool move();
  bool press(int button, bool isDown);
  bool turn(float wheel);
  bool type(bool isDown);
  bool ownsMouse() const;
  bool add(Input input);
  static bool isWritten();
  static bool isMovingKeys();
  static bool isForField(const Input& input);
  bool mustWait(const Input& input);
  void placeMouse(int x, int y);
  void settle();
  void feed();
  void paint();
  void clear();
  bool isWithin() const;

  vtkRenderWindow* window_;
  vtkRenderWindowInteractor* interactor_;
  double scale_;
  int width_ = 0;
  bool isFocused_ = false, isTyping_ = false;
  enum class State
  {
    New,
    Ready,
    Unsupported
  };
  State state_ = State::New;
  ImGuiContext* context_ = nullptr;
  std::vector<unsigned long> observers_;
  std::deque<Input> waiting_; ///< one press or release a frame: ImGui looks once a frame
  int heldFrames_ = 0;        ///< that the first of them has waited for a field
  unsigned ownButtons_ = 0, viewButtons_ = 0; ///< held, a bit each: whose presses they were
  double lastTime_ = 0.0;                     ///< of the last frame
  static constexpr int someFrames = 3;
  int framesToCome_ = 0, inputs_ = 0;
  bool isLaid_ = false;
  bool wasWithin_ = false; ///< the controls of the last frame kept to their part, and are there
  std::vector<unsigned char> laid_, painted_; ///< the last layout, and the one that was drawn last
  std::array<int, 2> drawnSize_ = {};         ///< of the window, then
};

} // namespace mote::app
