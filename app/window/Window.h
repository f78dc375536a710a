#pragma once

#include "Clipboard.h"
#include "Display.h"
#include "FrameTime.h"
#include "Overlay.h"
#include "Presenter.h"
#include "Recorder.h"
#include "Views.h"
#include "WindowPaths.h"
#include "WindowProgress.h"
#include "WindowProps.h"
#include "panels/Panel.h"
#include "panels/PanelHost.h"
#include "settings/History.h"
#include "settings/KeptSession.h"
#include "stage/CutGrip.h"
#include "stage/FollowedFiles.h"
#include "stage/PickedSet.h"
#include "stage/Stage.h"
#include "stage/StepCache.h"
#include "stage/ValuesOverTime.h"
#include "table/Keys.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace mote::app
{

class InteractorStyle;

/// Opens a window on the files, or one that offers some where there are none, and returns when the
/// user closes it. Throws Failure where there is no display or nothing can be shown, and
/// Interrupted.
void showWindow(const Settings& settings);

/// The window: what it shows and how it answers. Window.cpp has set-up and drawing, WindowTime.cpp
/// time steps, WindowActions.cpp what keys do, WindowPicking.cpp what is picked, WindowOpening.cpp
/// files and messages, WindowSettings.cpp how settings change, WindowPanel.cpp the panel,
/// WindowRecording.cpp what is recorded and played. All that can be chosen is in the stage's
/// settings.
class Window
{
public:
  Window(const Settings& settings, Input& input);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Reads, shows and handles events until the user quits.
  void run();

private:
  // Set-up
  void setUpWindow();
  void setUpEvents();

  // Time
  void load(int step);
  bool perform(const std::function<void()>& work);
  void play();
  void advance();
  void startCache();
  void endCache();
  void keepStep();
  void awaitStep(int step);
  void planCache();
  void scrub(Settings next, int step);
  void endScrub();
  void watchCache();
  void startFollowing();
  void watchFiles();
  void takeNewSteps();
  void changePaths();
  void followPaths();
  void watchPaths();
  void plotOverTime();
  void readOverTime(Followed followed);
  void watchOverTime();
  void saveOverTime();
  void leave();
  void quit();

  // Drawing
  void render();
  void renderMoving();
  void shareFrameTime();
  void followProps();
  void look();
  void rememberView();
  void updatePreview();
  void nameWindow();
  void onRenderStart();
  void onRenderEnd();
  void onTimer(int timer);
  bool isResting() const;
  void startTimer(int& timer, unsigned long milliseconds);
  std::string statusText() const;
  std::string qualityText() const;

  // Panel
  void setUpPanel();
  int widthOfPanel() const;
  int widthOfPanelNow() const;
  void updateScale();
  void updatePanel();
  void layPanel();
  void drawPanel();
  void drawPanelNow();
  void renderPanel();
  void takeWish();
  void takeSettings(Settings next, bool isHeld);
  void endHold();
  void letGoWithoutPanel();
  void togglePanel();
  std::array<int, 2> viewSize() const;

  // Files
  void setUpOpening();
  void open(const OpenChoice& choice);
  void readFiles(const Settings& wanted);
  void showOpenDialog();
  bool isEmpty() const { return this->settings().data.files.empty(); }
  void takeMessages();
  void tell(const std::string& message);

  // Settings
  const Settings& settings() const { return stage_.settings(); }
  Settings withStep(int step) const;
  Settings settingsOf(const std::function<void(Settings&)>& change) const;
  void change(const Settings& next, const std::function<std::string()>& message = {});
  bool follow(const Settings& next, RecordedEvent::Kind how = RecordedEvent::Kind::Pass);
  Settings settingsAsSeen() const;
  void recordCamera();
  void goBack(bool undo);
  Settings settingsInForce();
  Settings pictureInForce();
  void saveSession(const std::string& file);

  // What is recorded, and played
  void startRecording(const std::string& file);
  void toggleRecording();
  void togglePlaying();
  bool actOnRecording(Action action);
  WindowState state() const;
  void note(RecordedEvent::Kind how, const Settings& next);
  void note(RecordedEvent event);
  void noteRest();
  void takePlayer(const std::string& file, const std::vector<std::string>& data);
  void startPlaying();
  void playNext();
  void endPlaying();
  void playEvent(const RecordedEvent& event);
  void playAction(const RecordedEvent& event);
  void playWindow(const WindowState& state);
  bool takePlayersKey(Action action);
  std::array<double, 2> shareOf(const std::array<int, 2>& place) const;
  std::array<int, 2> placeOf(const std::array<double, 2>& share) const;
  std::array<int, 2> cursor() const;

  // Actions
  void act(const Binding& binding);
  void actOnRow(const Binding& binding);
  void fitToArray(Settings& next) const;
  void resetView();
  bool actOnView(Action action);
  bool actOnFiles(Action action);
  void goTo(int step);
  Settings otherProjection() const;
  Settings scaledRadius(double factor) const;
  Settings otherBackground() const;
  void zoom(double factor);
  void turnWheel(double factor);
  void savePicture();
  void saveShown();
  void saveData(
    const std::function<std::vector<unsigned char>(std::size_t part)>& marks, const char* what);
  void savePlot(const std::string& ending);
  bool changeKeyFrames(Action action);
  bool doElsewhere(const std::function<void()>& work);
  void saveFilm();
  void takeRange(const std::vector<double>& range, const std::string& from);
  void takeRangeOfAllSteps();
  void takeRangeOfView();
  std::string makeFilm(const std::string& file);
  std::array<int, 2> savedSize() const;
  double savedScale() const;
  std::string unusedName(const std::string& ending) const;
  std::string coloringText() const;
  void say(const std::string& message);

  // What is under the cursor
  struct Hit
  {
    Picked picked;
    std::array<double, 3> at;
    double distance;     ///< along the view axis
    double value;        ///< of the iso-surface, or of the volume there
    double cloudOpacity; ///< of the ray where a volume's cell was picked for it, else 0
  };
  std::optional<Hit> hitAt(int x, int y);
  std::string factsOf(const Hit& hit, int mostArrays) const;
  void setUpPicking();
  void setUpGrips();
  void dragGrip(bool isDone);
  void pick(bool adds);
  void tellPickedAgain();
  void pickRectangle(
    const std::array<int, 2>& from, const std::array<int, 2>& to, bool isThrough, bool adds);
  void addWithin(View& view, const std::array<int, 2>& from, const std::array<int, 2>& to,
    bool isThrough, std::vector<Picked>& found);
  void addAll(View& view, const std::array<int, 4>& rectangle, std::vector<Picked>& found) const;
  void drawRectangle(const std::array<int, 2>& from, const std::array<int, 2>& to);
  bool actOnPicked(Action action);
  bool requirePicked();
  void showOnly(const std::function<void(SelectionSettings&)>& change, const std::string& told);
  void copyPicked();
  void savePicked(const char* ending);
  void savePickedData();
  void center();
  void setUpHover();
  void moveCursor();
  void hoverAgain();
  void hover();
  void leaveWindow();
  void renderOverlays();

  /// What tells one view from another.
  std::array<double, 10> viewNow();

  Settings asked_;         ///< what the command line, or the session, said
  std::string arrayAsked_; ///< the array that this, or the data, chose
  Input& input_;
  Stage stage_;
  vtkNew<vtkRenderWindow> window_;
  Presenter presenter_{window_};
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<InteractorStyle> style_;
  Views views_;
  Overlay overlay_;
  WindowProps props_;
  PickedSet picked_;
  Clipboard clipboard_;
  std::optional<CutGrip> grip_; ///< that the mouse holds
  bool picksThrough_ = false;   ///< rectangles take what others hide, too
  TerminalProgress terminal_;
  WindowProgress bar_;
  ProgressRelay progress_;

  Recorder recorder_;
  std::unique_ptr<Player> player_; ///< while a recording is played
  History history_;
  KeptSession kept_;
  std::optional<Settings> askedToLeave_;  ///< with these, while the message stands
  std::vector<std::string> adviceBefore_; ///< that was given already
  std::vector<std::string> messages_;     ///< warnings and failures so far
  std::array<double, 10> view_{};         // as the settings had it last
  Settings lookedAt_;                     // when the camera was set last, by itself or by hand
  std::vector<double> camera_;            // as it was then
  std::array<int, 2> viewedSize_{};       // of the view, when it was looked at
  Panel panel_;
  std::unique_ptr<PanelHost> panelHost_; ///< null: the window's OpenGL cannot draw it
  bool panelOn_ = true;
  double scale_ = 1.0;                 ///< of texts
  bool hasOtherHandles_ = false;       ///< than the last frame showed
  PanelWish wish_;                     ///< what the user did in the last frame
  std::optional<Settings> beforeHold_; ///< as the settings were when a control was taken hold of
  std::shared_ptr<StepCache> cache_;   ///< null: nothing is read ahead
  StepCache::Facts cacheShown_;        ///< as the panel has it
  std::string cacheSize_;              ///< as the settings said when it was made
  WindowPaths paths_;
  std::unique_ptr<ValuesOverTime> overTime_; ///< of what was picked
  std::optional<FollowedFiles> followed_;    ///< while steps are read that are written
  std::string followProblem_;                ///< that was told last
  int step_ = 0;
  int loadedStep_ = -1; ///< that the stage shows; -1 while it changes
  int direction_ = 1;   ///< of the last change of the step
  int wantedStep_ = -1; ///< that the slider asks for while a nearer one is shown
  bool playing_ = false;
  bool busy_ = false; // in long work: events wait
  bool wheeling_ = false;
  bool quit_ = false;
  double frameStart_ = 0.0;
  FrameCosts costs_;       ///< of the last frame that was traced
  double panelTime_ = 0.0; ///< of the present frame
  FrameTime frameTime_;
  double stepTime_ = 0.0;  ///< from one step that is played to the next: s, smoothed
  double stepStart_ = 0.0; ///< when the last one began to be shown
  std::string failure_;    // what perform() told last
  bool previewed_ = false; // the picture shown last was a preview
  int sharpenTimer_ = 0, restTimer_ = 0, playTimer_ = 0, messageTimer_ = 0, panelTimer_ = 0,
      hoverTimer_ = 0, cacheTimer_ = 0, followTimer_ = 0, pathTimer_ = 0, overTimeTimer_ = 0,
      recordTimer_ = 0;
};

} // namespace mote::app
