#include "PanelHost.h"

#include "PanelKeys.h"
#include "PanelLook.h"
#include "TypedLetter.h"

#include <vtk_glew.h> // before what includes OpenGL

#include <vtkCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTimerLog.h>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <utility>

namespace mote::app
{

namespace
{

/// All that makes the pixels of a layout.
std::vector<unsigned char> bytesOf(const ImDrawData& data)
{
  std::vector<unsigned char> bytes;
  const auto add = [&](const void* from, std::size_t size)
  {
    const auto* first = static_cast<const unsigned char*>(from);
    bytes.insert(bytes.end(), first, first + size);
  };
  for (int i = 0; i < data.CmdListsCount; ++i)
  {
    const ImDrawList& list = *data.CmdLists[i];
    add(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
    add(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
    for (const ImDrawCmd& command : list.CmdBuffer)
      add(&command.ClipRect, sizeof(command.ClipRect));
  }
  return bytes;
}

} // namespace

PanelHost::PanelHost(vtkRenderWindow* window, vtkRenderWindowInteractor* interactor, double scale)
  : window_(window)
  , interactor_(interactor)
  , scale_(scale)
{
  constexpr float first = 10.0f; // before the interactor's style
  this->observe(vtkCommand::MouseMoveEvent, first, [this] { return this->move(); });
  this->observe(vtkCommand::LeaveEvent, first, [this] { return this->move(); });
  const unsigned long buttons[][2] = {
    {vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent},
    {vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent},
    {vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent}};
  for (int i = 0; i < 3; ++i)
  {
    this->observe(buttons[i][0], first, [this, i] { return this->press(i, true); });
    this->observe(buttons[i][1], first, [this, i] { return this->press(i, false); });
    // What is pressed in the view has the releases to itself: only passive observers see them, too.
    this->observe(
      buttons[i][1], first,
      [this, i]
      {
        viewButtons_ &= ~(1U << i);
        return false;
      },
      true);
  }
  this->observe(vtkCommand::MouseWheelForwardEvent, first, [this] { return this->turn(1.0f); });
  this->observe(vtkCommand::MouseWheelBackwardEvent, first, [this] { return this->turn(-1.0f); });
  this->observe(vtkCommand::KeyPressEvent, first, [this] { return this->type(true); });
  this->observe(vtkCommand::KeyReleaseEvent, first, [this] { return this->type(false); });
}

PanelHost::~PanelHost()
{
  for (const unsigned long observer : observers_)
    interactor_->RemoveObserver(observer);
  if (!context_)
    return;
  ImGui::SetCurrentContext(context_);
  window_->MakeCurrent();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void PanelHost::observe(
  unsigned long event, float priority, const std::function<bool()>& handle, bool isPassive)
{
  /// Keeps an event from others where `handle` says that it was for the controls.
  class Command : public vtkCommand
  {
  public:
    explicit Command(const std::function<bool()>& handle)
      : handle_(handle)
    {
    }
    void Execute(vtkObject*, unsigned long, void*) override
    {
      this->SetAbortFlag(handle_() ? 1 : 0);
    }

  private:
    std::function<bool()> handle_;
  };
  auto* command = new Command(handle);
  command->SetPassiveObserver(isPassive);
  observers_.push_back(interactor_->AddObserver(event, command, priority));
  command->Delete();
}

bool PanelHost::isSupported()
{
  if (state_ == State::New)
    this->start();
  return state_ == State::Ready;
}

void PanelHost::start()
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(window_);
  int major = 0, minor = 0;
  if (window)
    window->GetOpenGLVersion(major, minor);
  state_ = State::Unsupported;
  if (major < 3 || (major == 3 && minor < 2))
    return;
  IMGUI_CHECKVERSION();
  context_ = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr; // sessions keep what is to be kept
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  mapKeys(io);
  setPanelLook(scale_);
  window_->MakeCurrent();
  if (ImGui_ImplOpenGL3_Init("#version 150"))
    state_ = State::Ready;
}

void PanelHost::setScale(double scale)
{
  if (scale == scale_)
    return;
  scale_ = scale;
  if (state_ != State::Ready)
    return;
  ImGui::SetCurrentContext(context_);
  setPanelLook(scale_);
  window_->MakeCurrent();
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  isLaid_ = false; // by letters that are gone
  this->lose();
  this->drawAgain();
}

void PanelHost::lay(const std::function<void()>& controls)
{
  ImGui::SetCurrentContext(context_);
  this->feed();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  controls();
  ImGui::Render();
  isLaid_ = true;
  std::vector<unsigned char> laid = bytesOf(*ImGui::GetDrawData());
  // A press and its release take a frame each, and what comes or changes needs one to find its
  // size.
  framesToCome_ = std::max(laid == laid_ ? 0 : 1, framesToCome_ - 1);
  laid_ = std::move(laid);
  if (this->isWaiting() && onInput)
    onInput();
}

/// Whether a field takes texts. ImGui's own word, WantTextInput, is a frame old, and the field may
/// have been left, or got the keys back, since.
bool PanelHost::isWritten()
{
  return ImGui::IsAnyItemActive() && ImGui::GetInputTextState(ImGui::GetActiveID());
}

/// Whether the next frame gives the keys to another control.
bool PanelHost::isMovingKeys()
{
  return ImGui::GetCurrentContext()->NavMoveSubmitted;
}

bool PanelHost::isForField(const Input& input)
{
  return input.kind == Input::Character || (input.kind == Input::Key && input.isDown);
}

void PanelHost::drawAgain()
{
  framesToCome_ = someFrames;
  if (onInput)
    onInput();
}

void PanelHost::draw()
{
  ImGui::SetCurrentContext(context_);
  const int* size = window_->GetSize();
  const bool wasThere = wasWithin_ && drawnSize_ == std::array{size[0], size[1]};
  drawnSize_ = {size[0], size[1]};
  wasWithin_ = this->isWithin();
  if (wasThere && wasWithin_ && painted_ == laid_)
    isLaid_ = false; // as it stands in the frame
  else
    this->paint();
}

PanelHost::Drawn PanelHost::drawAlone()
{
  ImGui::SetCurrentContext(context_);
  auto* window = static_cast<vtkOpenGLRenderWindow*>(window_);
  const int* size = window->GetSize();
  vtkOpenGLFramebufferObject* rendered = window->GetRenderFramebuffer();
  if (!rendered || !wasWithin_ || !this->isWithin() || drawnSize_ != std::array{size[0], size[1]})
    return Drawn::Not;
  if (painted_ == laid_)
  {
    isLaid_ = false;
    return Drawn::Same;
  }
  // The last frame is there, all of it.
  window->MakeCurrent();
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  rendered->Bind(GL_DRAW_FRAMEBUFFER);
  rendered->ActivateDrawBuffer(0);
  this->paint();
  state->PopFramebufferBindings();
  return Drawn::Anew;
}

void PanelHost::paint()
{
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(window_)->GetState();
  state->Push();
  this->clear();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  painted_ = laid_;
  state->Reset();
  state->Pop();
  isLaid_ = false;
}

/// Gives the controls' part its background: where the processor does OpenGL's work a rectangle of
/// ImGui's would take as long as all controls.
void PanelHost::clear()
{
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(window_)->GetState();
  const ImVec4 color = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, 0, width_, window_->GetSize()[1]);
  state->vtkglClearColor(color.x, color.y, color.z, 1.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

/// Whether the layout keeps to the controls' part: no popup or tooltip reaches over the view.
bool PanelHost::isWithin() const
{
  const ImDrawData* data = ImGui::GetDrawData();
  const auto edge = static_cast<float>(width_) + 1.0f; // which smooth lines reach
  for (int list = 0; list < data->CmdListsCount; ++list)
  {
    const ImDrawList& drawn = *data->CmdLists[list];
    for (const ImDrawCmd& command : drawn.CmdBuffer)
      for (unsigned i = 0; command.ClipRect.z > edge && i < command.ElemCount; ++i)
      {
        const ImDrawIdx index = drawn.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
        if (drawn.VtxBuffer[static_cast<int>(command.VtxOffset + index)].pos.x > edge)
          return false;
      }
  }
  return true;
}

/// Whether input waits for the next frame, which gives the keys to a field that asked for them:
/// keys are for that field, and it would take a press of the mouse from the control that this was
/// for. A field that never gets them must not hold up all that comes after.
bool PanelHost::mustWait(const Input& input)
{
  constexpr int most = 10; // frames
  const bool waits = input.kind == Input::Button ? input.isDown && isMovingKeys()
                                                 : isTyping_ && !isWritten() && isForField(input);
  heldFrames_ = waits ? heldFrames_ + 1 : 0;
  return waits && heldFrames_ < most;
}

/// Gives ImGui what came since the last frame, up to the first change of a button or a key.
void PanelHost::feed()
{
  ImGuiIO& io = ImGui::GetIO();
  const int* size = window_->GetSize();
  io.DisplaySize = ImVec2(static_cast<float>(size[0]), static_cast<float>(size[1]));
  const double now = vtkTimerLog::GetUniversalTime();
  io.DeltaTime = static_cast<float>(std::clamp(now - lastTime_, 1e-4, 1.0));
  lastTime_ = now;
  const int* at = interactor_->GetEventPosition();
  this->placeMouse(at[0], at[1]);
  io.KeyCtrl = interactor_->GetControlKey() != 0;
  io.KeyShift = interactor_->GetShiftKey() != 0;
  io.KeyAlt = interactor_->GetAltKey() != 0;
  while (!waiting_.empty())
  {
    const Input input = waiting_.front();
    if (this->mustWait(input))
      return;
    waiting_.pop_front();
    framesToCome_ = someFrames; // from here on, however long it has waited
    const auto number = static_cast<std::size_t>(input.number);
    if (input.kind == Input::Character)
      io.AddInputCharacter(static_cast<unsigned>(input.number));
    else if (input.kind == Input::Wheel)
      io.MouseWheel += input.wheel;
    else if (input.kind == Input::Place)
    {
      this->placeMouse(input.x, input.y);
      // The last frame's; a frame of its own lets what is dragged follow.
      if (io.MousePosPrev.x != io.MousePos.x || io.MousePosPrev.y != io.MousePos.y)
        return;
    }
    else
    {
      bool& isDown = input.kind == Input::Button ? io.MouseDown[number] : io.KeysDown[number];
      const bool isChange = isDown != input.isDown;
      isDown = input.isDown;
      if (!isChange)
        continue;
      // All these may be others by now.
      io.KeyCtrl = input.hasControl;
      io.KeyShift = input.hasShift;
      io.KeyAlt = input.hasAlt;
      if (input.kind == Input::Button)
      {
        this->placeMouse(input.x, input.y);
        // The X server knows when both clicks were; they may have come here long after.
        io.MouseDoubleClickTime = input.isRepeat ? FLT_MAX : 0.0f;
      }
      return;
    }
  }
}

void PanelHost::placeMouse(int x, int y)
{
  const int height = window_->GetSize()[1];
  ImGui::GetIO().MousePos = viewButtons_ != 0
                              ? ImVec2(-1e9f, -1e9f)
                              : ImVec2(static_cast<float>(x), static_cast<float>(height - 1 - y));
}

/// Has the controls take all presses of the mouse that wait.
void PanelHost::settle()
{
  const auto isPress = [](const Input& input) { return input.kind == Input::Button; };
  const auto isWaiting = [&] { return std::any_of(waiting_.begin(), waiting_.end(), isPress); };
  if (!onHurry || !isWaiting())
    return;
  for (int tries = 0; tries < 20 && isWaiting(); ++tries)
    onHurry();
  onHurry(); // does what the last one asked for
}

bool PanelHost::add(Input input)
{
  const int* at = interactor_->GetEventPosition();
  input.x = at[0];
  input.y = at[1];
  input.isRepeat = interactor_->GetRepeatCount() > 0;
  input.hasControl = interactor_->GetControlKey() != 0;
  input.hasShift = interactor_->GetShiftKey() != 0;
  input.hasAlt = interactor_->GetAltKey() != 0;
  waiting_.push_back(input);
  this->drawAgain();
  return true;
}

/// Whether the mouse is over controls, or holds one.
bool PanelHost::ownsMouse() const
{
  if (state_ != State::Ready || width_ == 0 || viewButtons_ != 0)
    return false;
  if (ownButtons_ != 0 || interactor_->GetEventPosition()[0] < width_)
    return true;
  // ImGui's own word, WantCaptureMouse, is of the last frame, when the mouse was elsewhere.
  ImGui::SetCurrentContext(context_);
  return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool PanelHost::move()
{
  const bool wasOver = interactor_->GetLastEventPosition()[0] < width_;
  const bool isOwn = this->ownsMouse();
  if (state_ == State::Ready && viewButtons_ == 0 && (isOwn || wasOver) && onInput)
  {
    framesToCome_ = std::max(framesToCome_, 1);
    onInput();
  }
  return isOwn;
}

bool PanelHost::press(int button, bool isDown)
{
  if (state_ != State::Ready)
    return false;
  ++inputs_;
  const unsigned bit = 1U << button;
  if (isDown && ownButtons_ == 0)
    this->settle(); // a popup may have opened or closed
  if (isDown)
    (this->ownsMouse() ? ownButtons_ : viewButtons_) |= bit;
  const bool isOwn = (ownButtons_ & bit) != 0;
  if (!isDown)
  {
    ownButtons_ &= ~bit;
    viewButtons_ &= ~bit;
  }
  // Where it was dragged to counts, however far that is from where the last frame saw it.
  if (isOwn && !isDown)
    this->add({Input::Place, 0});
  if (isOwn)
    return this->add({Input::Button, button, isDown});
  if (isDown && isFocused_)
    this->add({Input::Button, button, true}), this->add({Input::Button, button, false});
  return false;
}

bool PanelHost::turn(float wheel)
{
  return this->ownsMouse() && this->add({Input::Wheel, 0, false, wheel});
}

bool PanelHost::type(bool isDown)
{
  const char* symbol = interactor_->GetKeySym();
  if (state_ != State::Ready || width_ == 0 || !symbol)
    return false;
  ImGui::SetCurrentContext(context_);
  if (isDown)
    this->settle();
  const bool isText = isTyping_ || isWritten();
  const int place = placeOfKey(symbol);
  if (!isDown)
    return place >= 0 && this->add({Input::Key, place, false}) && isText;
  const bool isPopup =
    ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  // Letters beside an open list are not the view's.
  if (!isText && !isPopup && !(isFocused_ && isForMoving(symbol)))
    return false;
  if (place >= 0)
    this->add({Input::Key, place, true});
  const char character = interactor_->GetKeyCode();
  const unsigned letter =
    character >= 32 && character < 127 ? static_cast<unsigned>(character) : letterOf(symbol);
  if (isText && letter != 0 && !interactor_->GetControlKey())
    this->add({Input::Character, static_cast<int>(letter)});
  return true;
}

} // namespace mote::app
