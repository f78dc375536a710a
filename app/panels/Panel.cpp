#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/Coloring.h"

#include <vtkLookupTable.h>

#include <imgui.h>

#include <algorithm>
#include <filesystem>

namespace mote::app
{

namespace
{

/// Settings that have no control: others do the same, or they are for the terminal.
const std::set<std::string>& withoutControl()
{
  static const std::set<std::string> names = {"step", "time", "threads", "camera", "azimuth",
    "elevation", "view", "size", "show-by", "show-range", "picked", "trajectories"};
  return names;
}

} // namespace

Panel::Panel(const Stage& stage)
  : stage_(stage)
{
}

void Panel::setFocus(bool on)
{
  focus_ = on;
  takesKeys_ = on;
}

/// Looks the data over where they are others than the last time.
void Panel::find()
{
  std::vector<std::pair<vtkDataSet*, unsigned long>> key;
  for (const auto& part : stage_.parts())
    key.emplace_back(part->data(), part->data()->GetMTime());
  if (key == found_.key)
    return;
  found_ = {};
  found_.key = key;
  for (const auto& part : stage_.parts())
  {
    found_.hasParticles = found_.hasParticles || part->kind() == Part::Kind::Particles;
    found_.hasVolumes = found_.hasVolumes || part->kind() == Part::Kind::Volume;
    for (const ArrayChoice& choice : rankedArrays(part->data()))
    {
      const std::string text = asText(part->data(), choice);
      if (std::none_of(found_.arrays.begin(), found_.arrays.end(),
            [&](const NamedArray& array) { return array.text == text; }))
        found_.arrays.push_back({choice, text, describe(part->data(), choice)});
    }
  }
}

const Histogram& Panel::histogramOf(const std::string& name)
{
  constexpr int bins = 100;
  const auto known = found_.histograms.find(name);
  if (known != found_.histograms.end())
    return known->second;
  Histogram& histogram = found_.histograms[name];
  for (int axis = 0; axis < 3; ++axis)
    if (name == std::string(1, "xyz"[axis]))
      return histogram = histogramOfPlaces(stage_.parts(), axis, bins);
  ArrayChoice choice;
  for (const auto& part : stage_.parts())
    if (!choice)
      choice = findArray(part->data(), name);
  if (choice)
    histogram = mote::app::histogramOf(stage_.parts(), choice, bins);
  return histogram;
}

std::string Panel::coloredBy() const
{
  const ArrayChoice& choice = stage_.coloring().choice();
  for (const auto& part : stage_.parts())
    if (arrayOf(part->data(), choice))
      return asText(part->data(), choice);
  return "none";
}

void Panel::beginFrame(float width, float height)
{
  ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  if (focus_ && !*focus_)
    ImGui::SetWindowFocus(nullptr);
  ImGui::Begin("Mote", nullptr,
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysVerticalScrollbar |
      ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus |
      ImGuiWindowFlags_NoBackground); // which the host clears
  if (focus_ && *focus_)
    ImGui::SetWindowFocus();
  focus_.reset();
}

PanelWish Panel::draw(const PanelFacts& facts, const PanelWish& earlier, float width, float height)
{
  this->find();
  next_ = earlier.settings.value_or(stage_.settings());
  wish_ = {};
  wish_.action = earlier.action;
  wish_.open = earlier.open;
  drawn_ = withoutControl();
  this->beginFrame(width, height);
  if (stage_.settings().data.files.empty())
    this->drawStart();
  else
    this->drawGroups(facts);
  this->drawDialog();
  // Clicks focus the window, too: only who asked for it gives it the keys, until a click elsewhere.
  takesKeys_ = takesKeys_ && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  ImGui::End();
  wish_.isHeld = ImGui::IsAnyItemActive() && !dialog_.isOpen();
  if (next_ != stage_.settings())
    wish_.settings = next_;
  return wish_;
}

void Panel::drawGroups(const PanelFacts& facts)
{
  this->drawTop(facts);
  hints_.draw();
  drawMessages(facts.messages);
  if (facts.steps > 1 || next_.output.follow)
    this->drawTime(facts);
  drawn_.insert({"hide-data", "side-by-side"}); // which Data has
  this->drawGroup("Data", &Panel::drawData);
  this->drawGroup("Colour", &Panel::drawColour);
  this->drawGroup("Selection", &Panel::drawSelection);
  this->drawPicked(facts.picked);
  this->drawPlot(facts.picked);
  if (found_.hasVolumes)
    this->drawGroup("Volume", &Panel::drawVolume);
  if (found_.hasParticles)
    this->drawGroup("Radius", nullptr);
  this->drawGroup("Light", &Panel::drawLight);
  this->drawGroup("Silhouettes", nullptr);
  this->drawGroup("Camera", &Panel::drawCamera);
  this->drawGroup("Picture", nullptr);
  // Groups that come to the table later are seen without a word here.
  std::vector<std::string> known = {"Volume", "Radius", "Structure"};
  for (const Row& row : settingsTable())
    if (drawn_.count(row.name) == 0 &&
        std::find(known.begin(), known.end(), row.group) == known.end())
    {
      known.push_back(row.group);
      this->drawGroup(row.group, nullptr);
    }
  if (found_.hasParticles)
    this->drawGroup("Structure", nullptr);
  this->drawFilm();
  this->drawRecording(facts);
  this->drawCosts(facts);
}

void Panel::showOpenDialog()
{
  const std::vector<std::string>& files = stage_.settings().data.files;
  std::error_code error;
  const bool isFile = !files.empty() && std::filesystem::exists(files.front(), error);
  dialog_.show(isFile ? std::filesystem::absolute(files.front(), error).parent_path()
                      : std::filesystem::path());
}

void Panel::drawDialog()
{
  if (auto choice = dialog_.draw(!stage_.settings().data.files.empty()))
    wish_.open = std::move(choice);
}

/// In the middle of a window that has nothing else to show.
void Panel::drawStart()
{
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float width = std::min(room.x, 48.0f * ImGui::GetFontSize());
  ImGui::SetCursorPos(ImVec2(0.5f * (room.x - width) + ImGui::GetCursorPosX(), 0.08f * room.y));
  ImGui::BeginChild("start", ImVec2(width, 0.0f), false, ImGuiWindowFlags_NavFlattened);
  bool wantsDialog = false;
  if (auto choice = startPage_.draw(wantsDialog))
    wish_.open = std::move(choice);
  ImGui::EndChild();
  if (wantsDialog)
    this->showOpenDialog();
}

void Panel::drawMessages(const std::vector<std::string>& messages)
{
  if (messages.empty())
    return;
  const bool isOpen = ImGui::CollapsingHeader(
    (counted(static_cast<long>(messages.size()), "message") + "###messages").c_str());
  noteControl("messages");
  if (!isOpen)
    return;
  for (auto message = messages.rbegin(); message != messages.rend(); ++message)
  {
    ImGui::Bullet();
    ImGui::TextWrapped("%s", message->c_str());
    noteControl("message");
  }
}

bool Panel::drawRow(const std::string& name, const std::string& label)
{
  drawn_.insert(name);
  const Row* row = rowNamed(name);
  return row && rows_.draw(*row, next_, label);
}

void Panel::drawGroup(const std::string& group, void (Panel::*first)())
{
  const bool isFirst = group == "Colour" || group == "Selection" || group == "Volume" ||
                       (group == "Data" && stage_.parts().size() > 1);
  const bool isOpen = ImGui::CollapsingHeader((group + "##group").c_str(),
    isFirst ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
  noteControl("group " + group);
  ImGui::PushID(group.c_str());
  if (first && isOpen)
    (this->*first)();
  for (const Row& row : settingsTable())
    if (row.group == group && drawn_.insert(row.name).second && isOpen)
      rows_.draw(row, next_);
  if (isOpen)
    ImGui::Spacing();
  ImGui::PopID();
}

//------------------------------------------------------------------------------------------------
// What is more than a row each

void Panel::drawTop(const PanelFacts& facts)
{
  if (buttonOf("Open..."))
    this->showOpenDialog();
  explainKey("Open other files, or add some\nCtrl+O");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextWrapped("%s", stage_.contents().c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.35f * ImGui::GetFontSize(), 4.0f));
  const auto button = [this](const char* label, Action action, const char* help)
  {
    if (buttonOf(label))
      this->wish(action);
    explainKey(help);
  };
  button("Undo", Action::Undo, "Ctrl+Z");
  ImGui::SameLine();
  button("Redo", Action::Redo, "Ctrl+Y");
  ImGui::SameLine();
  button("Picture", Action::SavePicture, "Save a picture of the view, as mote render makes it\ns");
  ImGui::SameLine();
  button("Session", Action::SaveSession,
    "Save data, view and all settings as a session, which mote opens again\nCtrl+S");
  ImGui::SameLine();
  button("Command", Action::PrintCommand,
    "Print a mote render command that makes this picture\nk; K for a Python script");
  ImGui::PopStyleVar();
  ImGui::Spacing();
}

void Panel::drawColour()
{
  const Coloring& coloring = stage_.coloring();
  const Row& row = *rowNamed("color-by");
  drawn_.insert(row.name);
  ImGui::SetNextItemWidth(-1.0f);
  const bool isOpen = ImGui::BeginCombo("##color-by",
    coloring.choice() ? coloring.title().c_str() : "one colour", ImGuiComboFlags_HeightLarge);
  RowControls::explain(row);
  if (isOpen)
  {
    for (const NamedArray& array : found_.arrays)
      if (lineOf(array.title.c_str(), array.choice == coloring.choice()))
        next_.color.array = array.text;
    if (!found_.hasVolumes && lineOf("one colour", !coloring.choice()))
      next_.color.array = "none";
    ImGui::EndCombo();
  }
  const auto present = std::find_if(found_.arrays.begin(), found_.arrays.end(),
    [&](const NamedArray& array) { return array.choice.name == coloring.choice().name; });
  if (present != found_.arrays.end() && coloring.componentCount(stage_.parts()) > 1)
  {
    if (buttonOf("Next component"))
      next_.color.array = coloring.nextComponent(stage_.parts());
    explainKey("C");
  }
  if (vtkLookupTable* table = coloring.table(); table && !coloring.isTyped())
  {
    colorStrip(table, ImGui::GetContentRegionAvail().x, 0.9f * ImGui::GetFontSize());
    this->drawColourRange();
  }
  this->drawRow("color-map", "map");
  this->drawRow("nan-color", "no number");
  this->drawRow("calculate");
  if (coloring.isTyped())
    drawn_.insert({"range", "reverse", "log"});
  else
    drawn_.insert({"types", "type-names"});
}

void Panel::drawColourRange()
{
  drawn_.insert("range");
  const Coloring& coloring = stage_.coloring();
  const double* present = coloring.table()->GetRange();
  Interval range = {present[0], present[1]};
  if (rangeFields("range", range) && range.low < range.high)
    next_.color.range = {range.low, range.high};
  RowControls::explain(*rowNamed("range"));
  if (!next_.color.range.empty())
  {
    if (buttonOf("Range of the data"))
      next_.color.range.clear();
  }
  else
    ImGui::TextDisabled("range of the data");
  if (!next_.selection.ranges.empty())
  {
    // What is shown of the array that colours.
    const std::string name = this->coloredBy();
    for (const ShowRange& shown : next_.selection.ranges)
      if (shown.name == name && !shown.intervals.empty())
      {
        ImGui::SameLine();
        const Interval all = {shown.intervals.front().low, shown.intervals.back().high};
        const Histogram& histogram = this->histogramOf(name);
        if (buttonOf("Range of what is shown"))
          next_.color.range = {
            std::max(all.low, histogram.least), std::min(all.high, histogram.most)};
      }
  }
}

void Panel::drawVolume()
{
  drawn_.insert("opacity");
  const Coloring& coloring = stage_.coloring();
  const std::vector<OpacityPoint>& inForce = coloring.opacity();
  if (!coloring.table() || inForce.empty())
    return;
  const double* range = coloring.table()->GetRange();
  std::vector<OpacityPoint> points = inForce;
  for (OpacityPoint& point : points)
    if (point.isShare)
      point = {range[0] + 0.01 * point.value * (range[1] - range[0]), false, point.opacity};
  std::stable_sort(points.begin(), points.end(),
    [](const OpacityPoint& a, const OpacityPoint& b) { return a.value < b.value; });
  const Histogram& histogram = this->histogramOf(this->coloredBy());
  if (opacityControl("opacity", histogram, coloring.table(), points))
    next_.volume.opacity = points;
  const auto preset = [&](const char* label, std::vector<OpacityPoint> wanted)
  {
    if (buttonOf(label))
      next_.volume.opacity = std::move(wanted);
    ImGui::SameLine();
  };
  preset("Usual", {});
  preset("Rising", {{0.0, true, 0.0}, {100.0, true, 0.8}});
  preset("Falling", {{0.0, true, 0.8}, {100.0, true, 0.0}});
  preset("Even", {{0.0, true, 0.2}, {100.0, true, 0.2}});
  ImGui::NewLine();
  this->drawIsosurfaces(histogram);
}

/// Values of isosurfaces as lines over the histogram.
void Panel::drawIsosurfaces(const Histogram& histogram)
{
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("isosurfaces");
  ImGui::SameLine(0.42f * ImGui::GetWindowContentRegionMax().x);
  if (buttonOf("Add isosurface") && !histogram.isEmpty())
    next_.volume.isoValues.push_back(newIsoValue(histogram, next_.volume.isoValues));
  explainKey("One more, between the others; then drag its line\n--iso");
  if (!next_.volume.isoValues.empty())
    isoControl("iso lines", histogram, stage_.coloring().table(), next_.volume.isoValues);
  this->drawRow("iso", "values");
}

void Panel::drawCamera()
{
  for (const char* side : {"+x", "-x", "+y", "-y", "+z", "-z"})
  {
    if (buttonOf(side))
    {
      const bool isParallel = next_.camera.orthographic;
      next_.camera = CameraSettings();
      next_.camera.view = side;
      next_.camera.orthographic = isParallel;
    }
    RowControls::explain(*rowNamed("view"));
    ImGui::SameLine();
  }
  if (buttonOf("Reset"))
    this->wish(Action::ResetView);
  explainKey("r");
  this->drawViews();
}

void Panel::drawCosts(const PanelFacts& facts)
{
  if (!ImGui::CollapsingHeader("Costs"))
    return;
  const auto line = [](const char* what, const std::string& value)
  {
    ImGui::TextUnformatted(what);
    ImGui::SameLine(0.42f * ImGui::GetWindowContentRegionMax().x);
    ImGui::TextUnformatted(value.c_str());
  };
  if (facts.frameTime > 0.0)
    line("frame", asDuration(facts.frameTime));
  line("quality", facts.quality);
  line("structure", asBytes(static_cast<double>(stage_.structureBytes())));
  line("built in", asDuration(stage_.buildTime()));
  if (found_.hasParticles)
    line("particles", withThousands(stage_.numberOfParticles()));
  if (stage_.numberOfCells() > 0)
    line("cells", withThousands(stage_.numberOfCells()));
  if (stage_.numberOfTriangles(false) > 0)
    line("triangles", withThousands(stage_.numberOfTriangles(false)));
}

} // namespace mote::app
