#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Memory.h"
#include "base/Text.h"
#include "stage/Coloring.h"
#include "stage/Framing.h"
#include "stage/Volume.h"

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

void Panel::refuse(const Settings& before, const Settings& refused, std::string sentence)
{
  const Row* other = nullptr;
  for (const Row& row : settingsTable())
    if (row.get(before) != row.get(refused))
    {
      if (other)
        return; // no control's own
      other = &row;
    }
  if (!other)
    return;
  if (const std::string option = other->option() + ": "; sentence.starts_with(option))
    sentence.erase(0, option.size());
  rows_.refuse(*other, before, refused, sentence);
}

/// Looks the data over where they are others than the last time.
void Panel::find()
{
  std::vector<std::pair<vtkDataSet*, unsigned long>> key;
  for (const auto& part : stage_.parts())
    key.emplace_back(part->data(), 4 * part->data()->GetMTime() + static_cast<int>(part->kind()));
  if (key == found_.key)
    return;
  found_ = {};
  found_.key = key;
  for (const auto& part : stage_.parts())
  {
    found_.hasParticles = found_.hasParticles || part->kind() == Part::Kind::Particles;
    found_.hasSurfaces = found_.hasSurfaces || part->kind() == Part::Kind::Surface;
    found_.hasVolumes = found_.hasVolumes || part->kind() == Part::Kind::Volume;
    found_.hasLines = found_.hasLines || Part::isLines(part->data());
    found_.hasCells = found_.hasCells || Volume::canShow(part->data());
    for (const ArrayChoice& choice : rankedArrays(part->data()))
    {
      const std::string text = asText(part->data(), choice);
      if (std::none_of(found_.arrays.begin(), found_.arrays.end(),
            [&](const NamedArray& array) { return array.text == text; }))
        found_.arrays.push_back({choice, text, describe(part->data(), choice)});
    }
  }
  for (const auto& part : stage_.parts())
    for (const ArrayChoice& choice : otherArrays(part->data()))
      this->addOther({choice, asText(part->data(), choice), describe(part->data(), choice)});
  if (found_.hasParticles)
    for (const char* axis : {"x", "y", "z"})
      this->addOther({{axis, 0, false}, axis, axis});
  this->offerArrays();
}

/// Gives the fields that take an array's name lists of those that they can have.
void Panel::offerArrays()
{
  std::vector<std::string> values, vectors, groups;
  const auto add = [](std::vector<std::string>& to, const std::string& name)
  {
    if (std::find(to.begin(), to.end(), name) == to.end())
      to.push_back(name);
  };
  for (const auto& part : stage_.parts())
    for (const ArrayChoice& choice : rankedArrays(part->data()))
    {
      if (isTypes(part->data(), choice))
        add(groups, choice.name);
      if (part->kind() != Part::Kind::Volume)
        continue;
      add(values, asText(part->data(), choice));
      if (arrayOf(part->data(), choice)->GetNumberOfComponents() == 3)
        add(vectors, choice.name);
    }
  rows_.offer("iso-array", std::move(values));
  rows_.offer("flow-array", std::move(vectors));
  rows_.offer("silhouette-groups", std::move(groups));
}

void Panel::addOther(const NamedArray& other)
{
  const auto isSame = [&](const NamedArray& array) { return array.text == other.text; };
  if (std::none_of(found_.arrays.begin(), found_.arrays.end(), isSame) &&
      std::none_of(found_.others.begin(), found_.others.end(), isSame))
    found_.others.push_back(other);
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
  rightOfPanel = width < ImGui::GetIO().DisplaySize.x ? width : 0.0f;
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
  showsCuts_ = false;
  steps_ = facts.steps;
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
  const bool isEntered = rows_.takeEntered();
  awaitsAnswer_ = wish_.settings && (awaitsAnswer_ || isEntered);
  return wish_;
}

void Panel::drawGroups(const PanelFacts& facts)
{
  this->drawTop(facts);
  hints_.draw(found_.hasVolumes);
  drawMessages(facts.messages);
  if (facts.steps > 1 || next_.output.follow)
    this->drawTime(facts);
  drawn_.insert({"hide-data", "hide-part", "show-part", "side-by-side",
    "nan-color"}); // which Data and Colour have
  if (!found_.hasSurfaces && !found_.hasParticles)
    drawn_.insert("lod-error");
  this->drawGroup("Data", &Panel::drawData);
  this->drawGroup("Colour", &Panel::drawColour);
  this->drawGroup("Selection", &Panel::drawSelection);
  this->drawGroup("Cuts", &Panel::drawCuts);
  this->drawPicked(facts.picked);
  this->drawPlot(facts.picked);
  if (found_.hasVolumes)
  {
    this->drawGroup("Slices", &Panel::drawSlices);
    this->drawGroup("Volume", &Panel::drawVolume);
    this->drawGroup("Flow", nullptr);
  }
  else if (found_.hasCells)
    this->drawGroup("Volume", &Panel::drawCells);
  if (found_.hasParticles || found_.hasLines)
    this->drawGroup("Radius", nullptr);
  this->drawGroup("Light", &Panel::drawLight);
  this->drawGroup("Silhouettes", nullptr);
  this->drawGroup("Camera", &Panel::drawCamera);
  this->drawGroup("Picture", &Panel::drawPictureSize);
  // Groups that come to the table later are seen without a word here.
  std::vector<std::string> known = {"Volume", "Radius", "Structure", "Slices", "Flow"};
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
  this->drawWindow();
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
  explainKey("What was told so far, the last first");
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
  showsCuts_ = showsCuts_ || (isOpen && (group == "Cuts" || group == "Slices"));
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

namespace
{

/// How much there is, always in one line: what stands below stays where it is while ranges are
/// dragged and the count changes.
void drawContents(const std::string& contents)
{
  const float room = ImGui::GetContentRegionAvail().x;
  const auto fits = [room](const std::string& text)
  { return ImGui::CalcTextSize(text.c_str()).x <= room; };
  std::string text = contents;
  constexpr std::string_view least = " shown"; // which the numbers say, too
  if (const std::size_t at = text.find(least); !fits(text) && at != std::string::npos)
    text.erase(at, least.size());
  for (std::string head = text; !fits(text) && !head.empty();)
  {
    head.pop_back();
    text = head + "...";
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  if (text != contents)
    explainKey(contents.c_str());
}

} // namespace

void Panel::drawTop(const PanelFacts& facts)
{
  if (buttonOf("Open..."))
    this->showOpenDialog();
  explainKey("Open other files, or add some\nCtrl+O");
  ImGui::SameLine();
  drawContents(stage_.contents());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.35f * ImGui::GetFontSize(), 4.0f));
  const auto button = [this](const char* label, Action action, const char* help)
  {
    if (buttonOf(label))
      this->wish(action);
    explainKey(help);
  };
  button("Undo", Action::Undo, "Go back before the last change\nCtrl+Z");
  ImGui::SameLine();
  button("Redo", Action::Redo, "Do again what was undone last\nCtrl+Y");
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

void Panel::drawCamera()
{
  // Those along an axis have a line of their own.
  for (const std::string& name : viewNames())
  {
    if (buttonOf(name.c_str()))
    {
      const bool isParallel = next_.camera.orthographic;
      next_.camera = CameraSettings();
      next_.camera.view = name;
      next_.camera.orthographic = isParallel;
    }
    RowControls::explain(*rowNamed("view"));
    if (name != "iso-y")
      ImGui::SameLine();
  }
  if (buttonOf("Reset"))
    this->wish(Action::ResetView);
  explainKey("Frame what is shown, from the view of the beginning\nr");
  this->drawViews();
}

/// What holds for the window itself.
void Panel::drawWindow()
{
  const bool isOpen = ImGui::CollapsingHeader("Window##group");
  noteControl("group Window");
  if (!isOpen)
    return;
  ImGui::PushID("Window");
  rows_.draw(*commandRow("mote", "ui-scale"), next_, "size of texts");
  ImGui::Spacing();
  ImGui::PopID();
}

void Panel::drawCosts(const PanelFacts& facts)
{
  const bool isOpen = ImGui::CollapsingHeader("Costs");
  noteControl("group Costs");
  if (!isOpen)
    return;
  const auto line = [](const char* what, const std::string& value)
  {
    ImGui::TextUnformatted(what);
    ImGui::SameLine(0.42f * ImGui::GetWindowContentRegionMax().x);
    ImGui::TextWrapped("%s", value.c_str());
    noteControl(std::string(what) + ' ' + value);
  };
  const FrameCosts& costs = facts.costs;
  const auto ofFrame = [&](const char* what, double seconds)
  { line(what, asDuration(seconds) + ", " + asNumber(100.0 * seconds / costs.frame, 2) + " %"); };
  if (costs.frame > 0.0)
  {
    line("frame", asDuration(costs.frame));
    ofFrame("- rays", costs.trace);
    if (costs.silhouettes > 0.0)
      ofFrame("- silhouettes", costs.silhouettes);
    ofFrame("- panel", costs.panel);
    ofFrame("- to the screen", costs.present);
    ofFrame("- the rest",
      std::max(0.0, costs.frame - costs.trace - costs.silhouettes - costs.panel - costs.present));
  }
  line("quality", facts.quality);
  line("structure", asBytes(static_cast<double>(stage_.structureBytes())));
  line("built in", asDuration(stage_.buildTime()));
  if (const std::uint64_t bytes = residentMemory(); bytes > 0)
    line("process", asBytes(static_cast<double>(bytes)) + " of memory");
  if (found_.hasParticles)
    line("particles", withThousands(stage_.numberOfParticles()));
  if (stage_.numberOfCells() > 0)
    line("cells", withThousands(stage_.numberOfCells()));
  if (stage_.numberOfTriangles(false) > 0)
    line("triangles", withThousands(stage_.numberOfTriangles(false)));
  if (stage_.numberOfLines(false) > 0)
    line("lines", withThousands(stage_.numberOfLines(false)));
}

} // namespace mote::app
