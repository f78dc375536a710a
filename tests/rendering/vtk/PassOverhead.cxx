// Prints what vtkMoteRayCastPass costs at 1024 x 1024 besides tracing: median over 20 frames of the
// frame's time less the trace's, for a moving view, a view at rest, and a picture that is shown
// again.
#include "WindowTestSupport.h"

#include "vtkCamera.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>

using namespace mote::testing;

namespace
{

void measure(Drawing& drawing, const char* what, const std::function<void()>& change)
{
  std::vector<double> frame, rest, display;
  for (int i = 0; i < 23; ++i)
  {
    change();
    const auto start = std::chrono::steady_clock::now();
    drawing.window->Render();
    drawing.window->WaitForCompletion();
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (i < 3)
      continue;
    frame.push_back(1e3 * seconds);
    rest.push_back(1e3 * (seconds - drawing.pass->GetTraceTime()));
    display.push_back(1e3 * drawing.pass->GetDisplayTime());
  }
  for (auto* times : {&frame, &rest, &display})
    std::sort(times->begin(), times->end());
  std::printf("%-28s frame %6.1f ms, without tracing %6.1f ms (fastest %5.1f), display %5.1f ms\n",
    what, frame[10], rest[10], rest[0], display[10]);
}

} // namespace

int main()
{
  Drawing drawing(1024, 1024);
  measure(drawing, "nothing to draw", [] {});
  drawing.addParticles(someBalls(100000), {1, 0.7, 0.4});
  drawing.renderer->ResetCameraClippingRange();
  drawing.pass->SetSamplesPerPixel(1);
  measure(drawing, "view at rest, 1 sample", [&] { drawing.camera()->Azimuth(1); });
  measure(drawing, "shown again", [] {});
  drawing.pass->AutoAdjustResolutionOff();
  drawing.window->SetDesiredUpdateRate(15);
  measure(drawing, "moving, full resolution", [&] { drawing.camera()->Azimuth(1); });
  return 0;
}
