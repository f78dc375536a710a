#include "Colors.h"

#include <vtkColor.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace mote::app
{

namespace
{

// Dim enough for the bright end of every colour map, bright enough for its dark end.
constexpr Color defaultBottom = {0.255, 0.275, 0.310};
constexpr Color defaultTop = {0.420, 0.450, 0.495};

double luminance(const double* c)
{
  return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

} // namespace

bool parseColor(const std::string& text, Color& color)
{
  // Making the list of names takes a millisecond, and no two threads share one.
  thread_local const vtkNew<vtkNamedColors> names;
  if (names->ColorExists(text))
  {
    const vtkColor3d c = names->GetColor3d(text);
    color = {c[0], c[1], c[2]};
    return true;
  }
  const bool hexadecimal = (text.size() == 4 || text.size() == 7) && text.front() == '#' &&
                           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!hexadecimal)
    return false;
  const vtkColor3ub bytes = names->HTMLColorToRGB(text);
  color = {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
  return true;
}

void setBackground(vtkRenderer* renderer, const std::vector<Color>& colors)
{
  const Color bottom = colors.empty() ? defaultBottom : colors.front();
  const Color top = colors.empty() ? defaultTop : colors.back();
  renderer->SetBackground(bottom[0], bottom[1], bottom[2]);
  renderer->SetBackground2(top[0], top[1], top[2]);
  renderer->SetGradientBackground(bottom != top);
}

Color inkOn(vtkRenderer* renderer)
{
  double light = luminance(renderer->GetBackground());
  if (renderer->GetGradientBackground())
    light = 0.5 * (light + luminance(renderer->GetBackground2()));
  return light > 0.55 ? Color{0.08, 0.09, 0.1} : Color{0.97, 0.97, 0.97};
}

Color groundAt(vtkRenderer* renderer, double share)
{
  const double* bottom = renderer->GetBackground();
  const double* top = renderer->GetGradientBackground() ? renderer->GetBackground2() : bottom;
  Color ground{};
  for (std::size_t i = 0; i < ground.size(); ++i)
    ground[i] = bottom[i] + share * (top[i] - bottom[i]);
  return ground;
}

} // namespace mote::app
