#include "OpenDialog.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "base/UserFiles.h"
#include "settings/UserState.h"
#include "table/Session.h"

#include <vtkAlgorithm.h>
#include <vtkMoteReaderTable.h>

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* title = "Open files";

bool isPressed(ImGuiKey key)
{
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

/// What a line says at its right end.
std::string factsOf(const FolderEntry& entry)
{
  if (entry.isFolder)
    return "folder";
  const std::string size = asBytes(static_cast<double>(entry.bytes));
  return entry.files.size() > 1
           ? counted(static_cast<long>(entry.files.size()), "file") + ", " + size
           : size;
}

} // namespace

void OpenDialog::show(const fs::path& folder)
{
  toOpen_ = isOpen_ = true;
  isListing_ = false;
  recent_ = readUserState().recent;
  chosenRecent_.reset();
  if (!folder.empty() || folder_.empty())
  {
    std::error_code error;
    this->goTo(folder.empty() ? fs::current_path(error) : folder);
  }
  else
    this->goTo(folder_); // files may have come
}

void OpenDialog::list(const fs::path& folder)
{
  folder_ = folder.lexically_normal();
  if (!folder_.has_filename() && folder_.has_relative_path())
    folder_ = folder_.parent_path(); // "a/" is "a"
  entries_ = listFolder(folder_, problem_);
  marked_.clear();
}

void OpenDialog::goTo(const fs::path& folder)
{
  const std::string from = folder_.filename().string();
  const bool isAbove = folder == folder_.parent_path();
  this->list(folder);
  filter_.clear();
  this->find();
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (isAbove && entries_[i].name == from)
      cursor_ = i; // where the user came from
  toCursor_ = true;
}

/// The lines that have what is written. Of a path the last part is a part of a name, in the folder
/// that the rest names.
void OpenDialog::find()
{
  std::string name = filter_;
  if (const fs::path typed = this->typedPath(); !typed.empty())
  {
    std::error_code error;
    const fs::path folder = typed.parent_path();
    if (fs::is_directory(folder, error) && folder.lexically_normal() != folder_)
      this->list(folder);
    name = typed.filename().string();
  }
  cursor_ = 0;
  lines_.clear();
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (isFound(entries_[i].name, name))
      lines_.push_back(i);
}

void OpenDialog::drawPlaces()
{
  const auto place = [this](const char* label, const fs::path& folder, const char* help)
  {
    if (buttonOf(label))
      this->goTo(folder);
    explainKey(help);
    ImGui::SameLine();
  };
  place("Up", folder_.parent_path(), "The folder above\nBackspace");
  place("Home", homeFolder(), "Your own folder\n~");
  if (const fs::path demo = demoFolder(); !demo.empty())
    place("Demo data", demo, "Small simulations that come with Mote");
  this->drawRecent();
  // The end of a long path tells more than its beginning.
  std::string path = folder_.string();
  const float room = ImGui::GetContentRegionAvail().x;
  while (path.size() > 8 && ImGui::CalcTextSize(("..." + path).c_str()).x > room)
    path.erase(0, 4);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(
    path.size() < folder_.string().size() ? ("..." + path).c_str() : path.c_str());
}

/// A list of what was opened last.
void OpenDialog::drawRecent()
{
  isListing_ = false;
  if (recent_.empty())
    return;
  ImGui::SetNextItemWidth(6.0f * ImGui::GetFontSize());
  isListing_ = ImGui::BeginCombo("##recent", "Recent", ImGuiComboFlags_HeightLarge);
  noteControl("Recent");
  explainKey("Files that were opened last");
  if (isListing_)
  {
    for (std::size_t i = 0; i < recent_.size(); ++i)
    {
      const std::vector<std::string>& files = recent_[i];
      const std::string more =
        files.size() > 1 ? " and " + std::to_string(files.size() - 1) + " more" : "";
      ImGui::PushID(static_cast<int>(i));
      const bool isPressed = ImGui::Selectable((files.front() + more).c_str());
      noteControl("recent " + baseName(files.front()));
      ImGui::PopID();
      if (isPressed)
        chosenRecent_ = OpenChoice{files, false};
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
}

/// The field that has the keys. Returns whether Return was pressed in it.
bool OpenDialog::drawFilter()
{
  if (!ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0) && !isListing_)
    ImGui::SetKeyboardFocusHere();
  // Arrows would leave the field, were they not its own.
  const auto onArrow = [](ImGuiInputTextCallbackData* data)
  {
    auto& self = *static_cast<OpenDialog*>(data->UserData);
    if (data->EventKey == ImGuiKey_UpArrow && self.cursor_ > 0)
      --self.cursor_;
    if (data->EventKey == ImGuiKey_DownArrow)
      ++self.cursor_;
    self.toCursor_ = true;
    return 0;
  };
  const std::string before = filter_;
  ImGui::SetNextItemWidth(-1.0f);
  const bool isEntered = ImGui::InputTextWithHint("##filter",
    "part of a name, a path from / or ~, or pump:0.02", &filter_,
    textFlags | ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory, onArrow,
    this);
  noteControl("filter");
  if (before.empty() && filter_.empty() && isPressed(ImGuiKey_Backspace))
    this->goTo(folder_.parent_path());
  else if (before != filter_)
    this->find();
  if (!lines_.empty())
    cursor_ = std::min(cursor_, lines_.size() - 1);
  if (isPressed(ImGuiKey_Insert))
  {
    this->toggle(cursor_);
    cursor_ = std::min(cursor_ + 1, lines_.empty() ? 0 : lines_.size() - 1);
    toCursor_ = true;
  }
  return isEntered;
}

void OpenDialog::toggle(std::size_t line)
{
  if (line >= lines_.size() || entries_[lines_[line]].isFolder)
    return;
  if (!marked_.insert(lines_[line]).second)
    marked_.erase(lines_[line]);
}

bool OpenDialog::drawLine(std::size_t line) const
{
  const FolderEntry& entry = entries_[lines_[line]];
  const std::string label = entry.isFolder ? entry.name + "/" : entry.name;
  const std::string facts = factsOf(entry);
  const bool isMarked = marked_.count(lines_[line]) > 0;
  ImGui::PushID(static_cast<int>(line));
  const bool isClicked =
    ImGui::Selectable("##line", isMarked || line == cursor_, ImGuiSelectableFlags_AllowDoubleClick);
  noteControl(label);
  ImGui::SameLine(0.0f, 0.0f);
  ImGui::Text("%s %s", isMarked ? "+" : " ", label.c_str());
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(facts.c_str()).x);
  ImGui::TextDisabled("%s", facts.c_str());
  ImGui::PopID();
  return isClicked;
}

void OpenDialog::scrollToCursor()
{
  const float height = ImGui::GetTextLineHeightWithSpacing();
  const float y = static_cast<float>(cursor_) * height, top = ImGui::GetScrollY();
  if (toCursor_ && (y < top || y + 2.0f * height > top + ImGui::GetWindowHeight()))
    ImGui::SetScrollY(std::max(0.0f, y - 0.4f * ImGui::GetWindowHeight()));
  toCursor_ = false;
}

/// Returns whether a line was clicked twice.
bool OpenDialog::drawList()
{
  const float below = 2.9f * ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("list", ImVec2(0.0f, -below), true, ImGuiWindowFlags_NoNav);
  if (!problem_.empty())
    ImGui::TextWrapped("%s", problem_.c_str());
  else if (lines_.empty())
    ImGui::TextDisabled(
      entries_.empty() ? "Nothing here that Mote can read" : "Nothing of that name");
  this->scrollToCursor();
  std::optional<std::size_t> clicked;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines_.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      if (this->drawLine(static_cast<std::size_t>(i)))
        clicked = static_cast<std::size_t>(i);
  ImGui::EndChild();
  if (clicked)
    this->click(*clicked);
  return clicked && ImGui::IsMouseDoubleClicked(0);
}

void OpenDialog::click(std::size_t line)
{
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl && marked_.empty())
    this->toggle(cursor_); // the one that was chosen before is meant, too
  if (io.KeyCtrl && line != cursor_)
    this->toggle(line);
  if (io.KeyShift)
    for (std::size_t i = std::min(cursor_, line); i <= std::max(cursor_, line); ++i)
      if (marked_.count(lines_[i]) == 0)
        this->toggle(i);
  if (!io.KeyCtrl && !io.KeyShift)
    marked_.clear();
  cursor_ = line;
}

/// The path that is written in the field; empty where that is a part of a name.
fs::path OpenDialog::typedPath() const
{
  if (filter_.starts_with('/'))
    return filter_;
  if (filter_.starts_with('~'))
    return homeFolder() / filter_.substr(std::min<std::size_t>(2, filter_.size()));
  return {};
}

std::vector<std::string> OpenDialog::chosen() const
{
  std::error_code error;
  if (const fs::path typed = this->typedPath(); fs::is_regular_file(typed, error))
    return {typed.string()};
  // What is made and no file, such as pump:0.02.
  if (std::string problem; lines_.empty() && filter_.find(':') != std::string::npos &&
                           vtkMoteReaderTable::MakeReader({filter_}, problem))
    return {filter_};
  std::vector<std::string> files;
  for (const std::size_t entry : marked_)
    files.insert(files.end(), entries_[entry].files.begin(), entries_[entry].files.end());
  if (files.empty() && cursor_ < lines_.size() && !entries_[lines_[cursor_]].isFolder)
    files = entries_[lines_[cursor_]].files;
  return files;
}

/// Goes where the written path or the cursor's folder says; false where there is none to go to.
bool OpenDialog::enter()
{
  std::error_code error;
  fs::path to = this->typedPath();
  if (!fs::exists(to, error) && marked_.empty() && cursor_ < lines_.size() &&
      entries_[lines_[cursor_]].isFolder)
    to = entries_[lines_[cursor_]].files.front();
  if (!fs::is_directory(to, error))
    return false;
  this->goTo(to);
  return true;
}

std::optional<OpenChoice> OpenDialog::draw(bool canAdd)
{
  if (toOpen_)
    ImGui::OpenPopup(title);
  toOpen_ = false;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float text = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(
    ImVec2(0.5f * window.x, 0.5f * window.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(
    ImVec2(std::min(0.94f * window.x, 46.0f * text), std::min(0.92f * window.y, 40.0f * text)));
  if (!ImGui::BeginPopupModal(title, nullptr,
        ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
  {
    isOpen_ = isListing_ = false;
    return {};
  }
  const bool wasListing = isListing_; // Escape has left that list by now
  this->drawPlaces();
  bool isEntered = this->drawFilter();
  isEntered = this->drawList() || isEntered;
  ImGui::TextDisabled(
    "Type a part of the name; up, down, Return. Ctrl+click or Insert marks several;");
  ImGui::TextDisabled(
    "Ctrl+Return adds to what is open. Backspace goes to the folder above, Escape back.");
  bool isAdded = isEntered && ImGui::GetIO().KeyCtrl;
  if (isEntered && this->enter())
    isEntered = false;
  const std::vector<std::string> files = this->chosen();
  const bool isSession = std::any_of(files.begin(), files.end(), isSessionFile);
  ImGui::BeginDisabled(files.empty());
  isEntered = buttonOf("Open") || isEntered;
  explainKey("Show these files in the place of those that are open\nReturn");
  ImGui::SameLine();
  ImGui::BeginDisabled(!canAdd || isSession);
  if (buttonOf("Add"))
    isEntered = isAdded = true;
  explainKey("Show the files beside those that are open, in one scene");
  ImGui::EndDisabled();
  ImGui::EndDisabled();
  ImGui::SameLine();
  std::optional<OpenChoice> choice;
  if (isEntered && !files.empty())
    choice = OpenChoice{files, isAdded && canAdd && !isSession};
  if (chosenRecent_)
    choice = std::move(chosenRecent_);
  chosenRecent_.reset();
  if (buttonOf("Cancel") || (isPressed(ImGuiKey_Escape) && !wasListing) || choice)
  {
    ImGui::CloseCurrentPopup();
    isOpen_ = false;
  }
  explainKey("Leave the list\nEscape");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  if (marked_.size() > 1)
    ImGui::Text("%s marked", counted(static_cast<long>(marked_.size()), "line").c_str());
  ImGui::EndPopup();
  return choice;
}

} // namespace mote::app
