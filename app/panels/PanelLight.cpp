// Where the main light stands: a ball to drag it over, and two sliders.

#include "Panel.h"

#include "PanelColors.h"
#include "PanelWidgets.h"
#include "settings/Values.h"

#include <vtkMath.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr ImU32 edge = IM_COL32(120, 126, 136, 255), sun = IM_COL32(255, 220, 120, 255),
                farSun = IM_COL32(150, 130, 80, 255);

/// Degrees to the right and up, as the viewer sees it.
using Angles = std::array<double, 2>;

/// A ball as the viewer sees it, lit where the light stands. Whether the light was dragged.
bool ballControl(std::optional<Angles>& light, float size)
{
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float radius = 0.5f * size;
  const ImVec2 middle(from.x + radius, from.y + radius);
  ImGui::InvisibleButton("ball", ImVec2(size, size));
  noteControl("light ball");
  explainKey(
    "Drag the light around what is seen; over the rim it goes behind\n--light AZIMUTH,ELEVATION");
  bool isDragged = false;
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (ImGui::IsItemActive() && (ImGui::IsItemActivated() || moved.x != 0.0f || moved.y != 0.0f))
  {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    double x = (mouse.x - middle.x) / radius, y = (middle.y - mouse.y) / radius;
    // Over the rim the light goes on behind the ball, and at twice the radius is right behind it.
    const double away = std::hypot(x, y);
    const bool isBehind = away > 1.0;
    const double onBall = isBehind ? std::max(0.0, 2.0 - away) / away : 1.0;
    const double elevation = std::asin(std::clamp(onBall * y, -1.0, 1.0));
    const double across = std::clamp(onBall * x / std::max(1e-6, std::cos(elevation)), -1.0, 1.0);
    const double angle = vtkMath::DegreesFromRadians(std::asin(across));
    const double azimuth = !isBehind ? angle : x < 0.0 ? -180.0 - angle : 180.0 - angle;
    light = Angles{std::round(azimuth), std::round(vtkMath::DegreesFromRadians(elevation))};
    isDragged = true;
  }
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircleFilled(middle, radius, drawingGround, 48);
  if (light)
  {
    const double azimuth = vtkMath::RadiansFromDegrees((*light)[0]);
    const double elevation = vtkMath::RadiansFromDegrees((*light)[1]);
    const ImVec2 at(middle.x + radius * static_cast<float>(std::sin(azimuth) * std::cos(elevation)),
      middle.y - radius * static_cast<float>(std::sin(elevation)));
    const bool isBehind = std::cos(azimuth) * std::cos(elevation) < 0.0;
    for (int ring = 6; ring > 0 && !isBehind; --ring) // a glow
      list->AddCircleFilled(
        at, 0.1f * size * static_cast<float>(ring) / 2.0f, IM_COL32(255, 220, 120, 18), 24);
    list->AddCircleFilled(at, 0.07f * size, isBehind ? farSun : sun, 24);
  }
  list->AddCircle(middle, radius, edge, 48, 1.5f);
  return isDragged;
}

bool angleSlider(const char* label, double& angle, float most)
{
  auto value = static_cast<float>(angle);
  ImGui::SetNextItemWidth(-1.0f);
  const bool isChanged = ImGui::SliderFloat((std::string("##") + label).c_str(), &value, -most,
    most, (std::string(label) + " %.0f\u00b0").c_str(), ImGuiSliderFlags_AlwaysClamp);
  noteControl(std::string("light ") + label);
  if (isChanged)
    angle = std::round(static_cast<double>(value));
  return isChanged;
}

} // namespace

void Panel::drawLight()
{
  std::optional<Angles> light = stage_.lighting().angles();
  const float size = 5.0f * ImGui::GetFontSize();
  bool isChanged = ballControl(light, size);
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::TextUnformatted("main light, as you see it");
  Angles angles = light.value_or(Angles{0.0, 0.0});
  isChanged = angleSlider("azimuth", angles[0], 180.0f) || isChanged;
  explainKey("To the right\n--light AZIMUTH,ELEVATION");
  isChanged = angleSlider("elevation", angles[1], 90.0f) || isChanged;
  explainKey("Upwards\n--light AZIMUTH,ELEVATION");
  if (!light)
    ImGui::TextDisabled("it stays with the data now");
  ImGui::EndGroup();
  if (isChanged)
    next_.light.place = exactText(angles[0]) + "," + exactText(angles[1]);
}

} // namespace mote::app
