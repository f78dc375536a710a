// The panel's section of films.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "commands/FilmPlan.h"
#include "commands/VideoFile.h"

#include <imgui.h>

#include <algorithm>

namespace mote::app
{

/// Of pictures, and of films, which have it, too.
void Panel::drawPictureSize()
{
  rows_.draw(*commandRow("mote", "picture-size"), next_, "size");
}

void Panel::drawFilm()
{
  const bool isOpen = ImGui::CollapsingHeader("Film##group");
  noteControl("group Film");
  if (!isOpen)
    return;
  ImGui::PushID("Film");
  const auto draw = [this](const char* command, const char* name, const char* label)
  { rows_.draw(*commandRow(command, name), next_, label); };
  draw("animate", "orbit", "orbit, degrees");
  this->drawKeyFrames();
  draw("animate", "steps", "time steps");
  draw("animate", "frames-per-step", "frames a step");
  draw("animate", "frames", "frames");
  draw("animate", "rate", "frames a second");
  this->drawPictureSize();
  draw("animate", "quality", "quality");
  draw("animate", "output", "file");
  const std::string& file = next_.output.file;
  const FilmForecast film =
    forecast(stage_.settings().keyFrames, steps_, next_.film, file.empty() || isVideoName(file));
  for (const std::string& line : {film.length, film.steps})
    if (!line.empty())
    {
      ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
      ImGui::TextWrapped("%s", line.c_str());
      ImGui::PopStyleColor();
      noteControl(line);
    }
  if (buttonOf("Save film"))
    this->wish(Action::SaveFilm);
  explainKey(
    "Make the film, with a bar that tells how far it is. Escape stops, and keeps what there "
    "is.\nmote animate makes it without a window");
  ImGui::Spacing();
  ImGui::PopID();
}

namespace
{

/// The settings of a view of the film; the film's own stay.
Settings withKeyFrame(const Settings& now, std::size_t number)
{
  Settings next = now.keyFrames[number];
  next.keyFrames = now.keyFrames;
  next.film = now.film;
  next.output = now.output;
  next.plot = now.plot;
  return next;
}

} // namespace

void Panel::drawKeyFrames()
{
  const std::vector<Settings>& keyFrames = stage_.settings().keyFrames;
  ImGui::AlignTextToFramePadding();
  const std::string count = "key frames: " + std::to_string(keyFrames.size());
  ImGui::TextUnformatted(count.c_str());
  noteControl(count);
  ImGui::SameLine();
  if (buttonOf("Add this view"))
    this->wish(Action::AddKeyFrame);
  explainKey("The film goes smoothly from view to view: camera, and settings that are numbers");
  for (std::size_t i = 0; i < keyFrames.size(); ++i)
  {
    ImGui::PushID(static_cast<int>(i));
    if (i % 4 != 0)
      ImGui::SameLine();
    const std::string label = "view " + std::to_string(i + 1);
    if (buttonOf(label.c_str()))
      next_ = withKeyFrame(stage_.settings(), i);
    explainKey("Come back to this view of the film");
    ImGui::PopID();
  }
  if (keyFrames.empty())
    return;
  if (buttonOf("Forget the last"))
    this->wish(Action::ForgetKeyFrame);
  explainKey("Take the last view of the film away");
  ImGui::SameLine();
  if (buttonOf("Forget all"))
    this->wish(Action::ForgetKeyFrames);
  explainKey("Take all views of the film away: it has the one that is shown");
}

} // namespace mote::app
