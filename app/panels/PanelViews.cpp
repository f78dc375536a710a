// Views that are saved, to come back to.

#include "Panel.h"

#include "PanelWidgets.h"
#include "stage/Framing.h"

#include <vtkCamera.h>

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace mote::app
{

namespace
{

/// Returns the name that a new view gets: what was written, or the first number that is free.
std::string newName(const std::vector<NamedView>& views, const std::string& written)
{
  if (!written.empty())
    return written;
  for (int number = 1;; ++number)
  {
    const std::string name = "view " + std::to_string(number);
    if (std::none_of(
          views.begin(), views.end(), [&](const NamedView& view) { return view.name == name; }))
      return name;
  }
}

} // namespace

/// A name to write, a button that saves the view, and a line for each that is saved.
void Panel::drawViews()
{
  drawn_.insert("saved-view");
  std::vector<NamedView>& views = next_.views.saved;
  ImGui::SetNextItemWidth(0.55f * ImGui::GetContentRegionAvail().x);
  ImGui::InputTextWithHint("##name", "name of this view", &viewName_, textFlags);
  RowControls::explain(*rowNamed("saved-view"));
  ImGui::SameLine();
  if (buttonOf("Save view"))
  {
    const std::string name = newName(views, viewName_);
    std::erase_if(views, [&](const NamedView& view) { return view.name == name; });
    vtkCamera* camera = stage_.renderer()->GetActiveCamera();
    views.push_back({name, camera->GetParallelProjection() != 0, cameraOf(camera)});
    viewName_.clear();
  }
  explainKey("Keeps where the camera stands, here and in sessions; a name that is there already "
             "is given to this view");
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    ImGui::PushID(static_cast<int>(i));
    const bool isLeft = buttonOf("x");
    noteControl("forget " + views[i].name);
    explainKey("Forget this view");
    ImGui::SameLine();
    if (ImGui::Selectable(views[i].name.c_str()))
    {
      next_.camera = CameraSettings();
      next_.camera.camera = views[i].camera;
      next_.camera.orthographic = views[i].orthographic;
    }
    noteControl("go to " + views[i].name);
    explainKey("Come back to this view");
    ImGui::PopID();
    if (isLeft)
    {
      views.erase(views.begin() + static_cast<long>(i));
      break;
    }
  }
}

} // namespace mote::app
