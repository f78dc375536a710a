#include "WindowLegend.h"

#include "settings/Colors.h"
#include "stage/Picture.h"

#include <vtkActor2D.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageMapper.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarsToColors.h>

#include <algorithm>
#include <functional>

namespace mote::app
{

namespace
{

/// The rectangle {x min, x max, y min, y max} of an image, on a veil in the background's colours.
/// Both hold bytes that are not premultiplied, as OpenGL blends them.
vtkSmartPointer<vtkImageData> cutOut(
  vtkImageData* image, const int rectangle[4], const std::function<Color(int y)>& ground)
{
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->SetDimensions(rectangle[1] - rectangle[0] + 1, rectangle[3] - rectangle[2] + 1, 1);
  part->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const auto byte = [](double value)
  { return static_cast<unsigned char>(255.0 * std::clamp(value, 0.0, 1.0) + 0.5); };
  for (int y = rectangle[2]; y <= rectangle[3]; ++y)
  {
    const Color behind = ground(y);
    const auto* from =
      static_cast<const unsigned char*>(image->GetScalarPointer(rectangle[0], y, 0));
    auto* to = static_cast<unsigned char*>(part->GetScalarPointer(0, y - rectangle[2], 0));
    for (int x = rectangle[0]; x <= rectangle[1]; ++x, from += 4, to += 4)
    {
      const double own = from[3] / 255.0, veil = veilOpacity * (1.0 - own), alpha = own + veil;
      for (int c = 0; c < 3; ++c)
        to[c] =
          byte((own * (from[c] / 255.0) + veil * behind[static_cast<std::size_t>(c)]) / alpha);
      to[3] = byte(alpha);
    }
  }
  return part;
}

} // namespace

WindowLegend::WindowLegend(vtkRenderer* renderer)
  : renderer_(renderer)
{
  legend_->SetInputData(canvas_);
  legend_->AutomaticTextColorOff();
  legend_->SetPanel(vtkMoteColorLegend::PANEL_OFF);
  mapper_->SetColorWindow(255.0);
  mapper_->SetColorLevel(127.5);
  actor_->SetMapper(mapper_);
  actor_->VisibilityOff();
  renderer->AddActor2D(actor_);
}

WindowLegend::~WindowLegend() = default;

void WindowLegend::set(
  vtkScalarsToColors* table, const std::string& title, const PictureSettings& look)
{
  legend_->SetLookupTable(look.legend ? table : nullptr);
  legend_->SetTitle(look.title.value_or(title));
  applyLook(legend_, look);
}

void WindowLegend::setInk(const Color& ink)
{
  legend_->SetTextColor(ink[0], ink[1], ink[2]);
  if (const std::array ground = {groundAt(renderer_, 0.0), groundAt(renderer_, 1.0)};
      ground != ground_)
  {
    ground_ = ground;
    drawn_ = 0;
  }
}

void WindowLegend::update()
{
  const int* size = renderer_->GetSize();
  const bool wanted = legend_->GetLookupTable() && size[0] >= 64 && size[1] >= 64;
  actor_->SetVisibility(wanted && !isLeftOut_);
  if (!wanted)
    return;
  const int* present = canvas_->GetDimensions();
  if (size[0] != present[0] || size[1] != present[1])
  {
    canvas_->SetDimensions(size[0], size[1], 1);
    canvas_->AllocateScalars(VTK_UNSIGNED_CHAR, 4); // which the legend copies at each new label
    canvas_->GetPointData()->GetScalars()->SetName("color");
    canvas_->GetPointData()->GetScalars()->Fill(0.0);
  }
  const vtkMTimeType changed = std::max(legend_->GetMTime(), canvas_->GetMTime());
  if (changed <= drawn_)
    return;
  drawn_ = changed;
  legend_->Update();
  int rectangle[4];
  legend_->GetLegendRectangle(rectangle);
  // In a narrow view the data are worth more than what their colours mean.
  constexpr double most = 0.3; // of the view's width
  const bool fits = rectangle[1] - rectangle[0] < most * size[0];
  actor_->SetVisibility(rectangle[0] <= rectangle[1] && rectangle[2] <= rectangle[3] && fits);
  isLeftOut_ = !actor_->GetVisibility();
  if (isLeftOut_)
    return;
  mapper_->SetInputData(cutOut(legend_->GetOutput(), rectangle,
    [&](int y) { return groundAt(renderer_, (y + 0.5) / size[1]); }));
  actor_->SetPosition(rectangle[0], rectangle[2]);
}

int WindowLegend::widthAtSide()
{
  this->update();
  if (!actor_->GetVisibility())
    return 0;
  int rectangle[4];
  legend_->GetLegendRectangle(rectangle);
  return legend_->GetSide() == vtkMoteColorLegend::LEFT ? rectangle[1]
                                                        : renderer_->GetSize()[0] - rectangle[0];
}

} // namespace mote::app
