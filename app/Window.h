#pragma once

#include "Display.h"
#include "Keys.h"
#include "Overlay.h"
#include "Stage.h"
#include "WindowProgress.h"
#include "WindowProps.h"

#include <vtkMoteRayCastPass.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <array>
#include <functional>
#include <string>

namespace mote::app
{

class InteractorStyle;

/// What the window may be told.
struct WindowOptions
{
  ViewOptions view;
};

/// Declares the options of the window.
void addWindowOptions(CLI::App& app, WindowOptions& options);

/// Opens a window on the files and returns when the user closes it. Throws Failure where there is
/// no display or nothing can be shown, and Interrupted.
void showWindow(const WindowOptions& options);

/// The window: what it shows and how it answers. Window.cpp has set-up, drawing and time;
/// WindowActions.cpp what keys do.
class Window
{
public:
  Window(const ViewOptions& options, Input& input);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Reads, shows and handles events until the user quits.
  void run();

private:
  // Set-up
  void setUpWindow();
  void setUpEvents();
  void choosePass();

  // Time
  bool load(int step);
  bool buildAgain();
  bool perform(const std::function<void()>& work);
  void advance();
  void quit();

  // Drawing
  void render();
  void renderMoving();
  void look(const std::string& side);
  void updateProps();
  void updatePreview();
  void nameWindow();
  void onRenderStart();
  void onRenderEnd();
  void onTimer(int timer);
  void startTimer(int& timer, unsigned long milliseconds);
  std::string statusText() const;
  std::string qualityText() const;

  // Actions
  void act(Action action);
  bool actOnView(Action action);
  bool actOnLook(Action action); ///< how things look
  bool actOnTime(Action action);
  void goTo(int step);
  void toggleProjection();
  void zoom(double factor);
  void scaleRadius(double factor);
  void pick();
  void center();
  void toggleBackground();
  void savePicture();
  void sayColoring();
  void say(const std::string& message);
  std::string particleFacts(const Part& part, vtkIdType id) const;

  /// What tells one view from another.
  std::array<double, 10> viewNow();

  const ViewOptions& options_;
  Input& input_;
  Stage stage_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<InteractorStyle> style_;
  vtkNew<vtkMoteRayCastPass> pass_;
  Overlay overlay_;
  WindowProps props_;
  TerminalProgress terminal_;
  WindowProgress bar_;
  ProgressRelay progress_;

  std::string side_;              // that was looked from last
  std::array<double, 10> view_{}; // as it was then
  std::array<int, 2> viewSize_{}; // of the window
  int step_ = 0;
  bool traced_ = true; // something that is seen is Mote's
  bool playing_ = false;
  bool busy_ = false; // in long work: events wait
  bool wheeling_ = false;
  bool quit_ = false;
  double radiusScale_ = 1.0;
  double frameStart_ = 0.0, frameTime_ = 0.0;
  bool previewed_ = false; // the picture shown last was a preview
  int sharpenTimer_ = 0, restTimer_ = 0, playTimer_ = 0, messageTimer_ = 0;
};

} // namespace mote::app
