#include "StartPage.h"

#include "PanelWidgets.h"
#include "base/UserFiles.h"
#include "settings/UserState.h"
#include "stage/Input.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;

struct Demo
{
  const char* title;
  const char* about;
  std::vector<const char*> files;
};

const std::vector<Demo>& demos()
{
  static const std::vector<Demo> all = {
    {"Hopper", "5,518 grains of mixed size run out of a funnel and pile up, in 7 time steps",
      {"hopper.dump.gz"}},
    {"Scratched copper", "24,480 atoms of a crystal that a ball has ploughed, in 7 time steps",
      {"copper-scratch.dump.gz"}},
    {"Fracture", "19,875 atoms of a notched plate that is torn apart, in 7 time steps",
      {"lj-fracture.dump.gz"}},
    {"Swirling flow", "a volume of cells with pressure and velocity, in 2 time steps",
      {"swirl.0.vtu", "swirl.1.vtu"}},
  };
  return all;
}

bool areThere(const std::vector<std::string>& files)
{
  return std::all_of(files.begin(), files.end(),
    [](const std::string& file)
    {
      std::error_code error;
      return fs::exists(file, error) || file.find('/') == std::string::npos;
    });
}

} // namespace

StartPage::StartPage()
{
  const fs::path folder = demoFolder();
  for (const Demo& demo : demos())
  {
    Offer offer{demo.title, demo.about, {}};
    for (const char* file : demo.files)
      offer.files.push_back((folder / file).string());
    if (!folder.empty() && areThere(offer.files))
      demos_.push_back(offer);
  }
  for (const auto& files : readUserState().recent)
  {
    if (!areThere(files))
      continue;
    std::string title = nameOf({files.front()}), about = fs::path(files.front()).parent_path();
    if (files.size() > 1)
      title += " and " + std::to_string(files.size() - 1) + " more";
    recent_.push_back({title, about, files});
  }
}

std::optional<OpenChoice> StartPage::drawOffers(
  const char* heading, const std::vector<Offer>& offers)
{
  std::optional<OpenChoice> choice;
  if (offers.empty())
    return choice;
  ImGui::Spacing();
  ImGui::Spacing();
  ImGui::TextUnformatted(heading);
  ImGui::Separator();
  ImGui::PushID(heading);
  for (std::size_t i = 0; i < offers.size(); ++i)
  {
    const Offer& offer = offers[i];
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable("##offer"))
      choice = OpenChoice{offer.files};
    noteControl(std::string(heading) + ": " + offer.title);
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::TextColored(ImVec4(0.55f, 0.78f, 1.0f, 1.0f), "%s", offer.title.c_str());
    ImGui::SameLine(0.0f, ImGui::GetFontSize());
    ImGui::TextDisabled("%s", offer.about.c_str());
    ImGui::PopID();
  }
  ImGui::PopID();
  return choice;
}

std::optional<OpenChoice> StartPage::draw(bool& wantsDialog) const
{
  ImGui::SetWindowFontScale(2.2f);
  ImGui::TextUnformatted("Mote");
  ImGui::SetWindowFontScale(1.0f);
  ImGui::TextWrapped("shows what simulations write: particles as spheres, and meshes of hexahedra "
                     "and other cells as "
                     "volumes. It reads LAMMPS dumps, XYZ, PDB, tables of points, VTK files, "
                     "OpenFOAM cases and triangle "
                     "meshes.");
  ImGui::Spacing();
  if (buttonOf("Open..."))
    wantsDialog = true;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Ctrl+O, or drop files on this window, or start as: mote FILE");
  std::optional<OpenChoice> choice = drawOffers("Try", demos_);
  if (auto recent = drawOffers("Opened last", recent_))
    choice = recent;
  ImGui::Spacing();
  ImGui::Spacing();
  ImGui::TextDisabled("h lists the keys, q closes the window. Pictures without a window: mote "
                      "render FILE -o picture.png");
  return choice;
}

} // namespace mote::app
