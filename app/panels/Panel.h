#pragma once

#include "Hints.h"
#include "OpenDialog.h"
#include "PickedPanel.h"
#include "PlotPanel.h"
#include "RowControls.h"
#include "StartPage.h"
#include "ValueControls.h"
#include "stage/Histogram.h"
#include "stage/Stage.h"
#include "stage/StepCache.h"
#include "table/Keys.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mote::app
{

/// Seconds that a frame took, and of these what its stages took.
struct FrameCosts
{
  double frame = 0.0, trace = 0.0, silhouettes = 0.0, panel = 0.0, present = 0.0;
};

/// What the panel tells of besides the stage.
struct PanelFacts
{
  int step = 0, steps = 1; ///< that is wanted; counts from 0
  int shownStep = 0;       ///< until that is read
  StepCache::Facts cache;  ///< of the steps that are read ahead
  double time = 0.0;
  bool hasTimes = false, isPlaying = false;
  FrameCosts costs;
  std::string quality;
  bool isRecording = false;
  std::string played;                ///< "3 of 80 steps" while a recording is played, else empty
  std::vector<std::string> messages; ///< warnings and failures so far
  PickedFacts picked;
};

/// What the user asks for by the panel's controls.
struct PanelWish
{
  std::optional<Settings> settings; ///< others than those that are in force
  Action action = Action::None;     ///< what a key would do
  bool isHeld = false;              ///< a control is dragged or written in: more may come
  std::optional<OpenChoice> open;   ///< files
};

/// The panel at the window's side: every choice of the table of settings, group after group. It
/// keeps nothing of what is chosen; what it draws follows from the stage.
class Panel
{
public:
  explicit Panel(const Stage& stage);

  /// Draws the controls and takes what the user does with them, beside what is still wished from
  /// earlier frames. `width` and `height` in pixels.
  PanelWish draw(const PanelFacts& facts, const PanelWish& earlier, float width, float height);

  /// Whether the lists of cuts or slices were open when it was drawn.
  bool showsCuts() const { return showsCuts_; }

  /// Settings that were asked for could not be shown: `sentence` says why, below the control of
  /// what differs from those before.
  void refuse(const Settings& before, const Settings& refused, std::string sentence);

  /// What was refused is not to be mended any more.
  void forgetRefused() { rows_.forgetRefused(); }

  /// The next draw() puts the keys to the panel, or leaves them to the view.
  void setFocus(bool on);
  /// Whether keys are the panel's, as of the last draw().
  bool hasFocus() const { return takesKeys_; }

  /// The plot that the settings in force ask for, drawn or not.
  const PlotPanel& plotNow(const PickedSet& picked)
  {
    plot_.update(stage_, picked);
    return plot_;
  }

  /// The next draw() opens the list of folders and files.
  void showOpenDialog();
  /// Whether keys are for a field: one of a list of files that comes, or one whose text was entered
  /// and may be refused.
  bool awaitsKeys() const { return dialog_.awaitsKeys() || awaitsAnswer_; }

private:
  struct NamedArray
  {
    ArrayChoice choice;
    std::string text, title; ///< for the settings, and for people
  };
  /// What the data are, found once for them.
  struct Found
  {
    std::vector<std::pair<vtkDataSet*, unsigned long>> key; ///< with their times of change
    std::vector<NamedArray> arrays;     ///< that tell of what happens, the most telling first
    std::vector<NamedArray> others;     ///< ids, radii, places
    std::map<std::string, Kinds> kinds; ///< by the array's text; none where it has no types
    std::map<std::string, TypeNames> typeNames;  ///< by the array's text
    std::map<int, double> radii;                 ///< by type
    unsigned long radiiTime = 0;                 ///< of the structures that have them
    std::map<std::string, Histogram> histograms; ///< by the array's text, or a place
    std::map<std::pair<vtkDataSet*, std::string>, std::string> ranges; ///< of arrays, in words
    bool hasParticles = false, hasVolumes = false, hasSurfaces = false;
    bool hasLines = false; ///< and nothing else, in one of the parts
    bool hasCells = false; ///< that may be shown as a volume, too
  };

  void find();
  void offerArrays();
  void addOther(const NamedArray& other);
  const Histogram& histogramOf(const std::string& name);
  /// The array that colours, as the settings would name it.
  std::string coloredBy() const;
  void beginFrame(float width, float height);
  void drawStart();
  void drawTop(const PanelFacts& facts);
  static void drawMessages(const std::vector<std::string>& messages);
  void drawDialog();
  void drawTime(const PanelFacts& facts);
  void drawCache(const PanelFacts& facts);
  void drawStep(const PanelFacts& facts);
  void drawData();
  void drawArrays(const Part& part, const std::string& name);
  void drawColour();
  void drawComponents();
  void drawMaps();
  void drawMapList(bool hasField);
  void drawColourRange();
  void setRange(double low, double high);
  void drawRangeOfShown();
  void drawEvenRange(const Interval& range);
  void drawRangeOfMost();
  void drawSelection();
  std::string titleOfRange(const ShowRange& range) const;
  bool drawShownHead(ShowRange& range);
  bool drawShown(ShowRange& range);
  void drawWhere();
  const Kinds& kindsOf(const NamedArray& array);
  bool hasList(const ArrayChoice& types);
  std::string nameOf(const NamedArray& array, int kind) const;
  void drawKindShown(
    const NamedArray& array, int kind, std::vector<bool>& shown, std::size_t i) const;
  void drawKindColour(const NamedArray& array, int kind);
  void drawKindName(const NamedArray& array, int kind);
  void drawKindRadius(const NamedArray& array, int kind);
  const std::map<int, double>& radiiOf(const NamedArray& array);
  float widthOfRadii(const NamedArray& array);
  void drawKindsHead(const NamedArray& array, std::vector<bool>& shown);
  void drawKinds(const NamedArray& array, const Kinds& kinds);
  void drawNewRange();
  void tellShown() const;
  void drawCuts();
  bool drawCut(ShowRange& cut, const Interval& extent);
  bool dragCut(const std::string& name, const Interval& extent, Interval& shown);
  std::string chooseCut(const char* label, const char* row, const std::vector<ShowRange>& taken);
  void drawNewCut(const double bounds[6]);
  void drawSlices();
  void changeSlices(std::vector<ShowRange>& slices, const double bounds[6]);
  static bool drawSlice(
    const std::string& name, std::size_t number, const Interval& extent, Interval& place);
  void drawPicked(const PickedFacts& facts);
  void drawPlot(const PickedFacts& facts);
  void drawVolume();
  void drawCells();
  void drawIsosurfaces(const Histogram& histogram);
  void drawLight();
  void drawCamera();
  void drawViews();
  void drawPictureSize();
  void drawFilm();
  void drawKeyFrames();
  void drawRecording(const PanelFacts& facts);
  void drawWindow();
  void drawCosts(const PanelFacts& facts);
  void drawGroups(const PanelFacts& facts);
  void drawGroup(const std::string& group, void (Panel::*first)());
  bool drawRow(const std::string& name, const std::string& label = {});
  void wish(Action action) { wish_.action = action; }

  const Stage& stage_;
  RowControls rows_;
  OpenDialog dialog_;
  StartPage startPage_;
  Hints hints_;
  PickedPanel picked_;
  PlotPanel plot_;
  Found found_;
  std::string viewName_; ///< that is written for a view to be saved
  Settings next_;        ///< while drawing
  PanelWish wish_;
  bool showsCuts_ = false;
  bool asksForMap_ = false;     ///< whether a colour map's file is to be named
  std::set<std::string> drawn_; ///< rows that have a control of their own
  int steps_ = 1;               ///< of the data, while drawing
  bool takesKeys_ = false, awaitsAnswer_ = false;
  std::optional<bool> focus_; ///< to be set
};

} // namespace mote::app
