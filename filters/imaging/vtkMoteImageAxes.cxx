#include "vtkMoteImageAxes.h"

#include "AxesPainter.h"
#include "Canvas.h"
#include "LegendLayout.h"
#include "SvgDrawing.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

bool isAscending(const double range[2])
{
  return std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1];
}

/// Of pixels whose ends are both included.
mote::imaging::Rect rectOf(const int pixels[4])
{
  return {pixels[0], pixels[2], pixels[1] + 1, pixels[3] + 1};
}

} // namespace

vtkStandardNewMacro(vtkMoteImageAxes);

vtkMoteImageAxes::vtkMoteImageAxes() = default;

vtkMoteImageAxes::~vtkMoteImageAxes() = default;

int vtkMoteImageAxes::LabelSize(int width, int height, double fontScale)
{
  return mote::imaging::labelSize(width, height, fontScale);
}

void vtkMoteImageAxes::AddCurve(
  vtkDataArray* x, vtkDataArray* y, double red, double green, double blue)
{
  this->AddNamedCurve({}, x, y, red, green, blue, false);
}

void vtkMoteImageAxes::AddNamedCurve(const std::string& name, vtkDataArray* x, vtkDataArray* y,
  double red, double green, double blue, bool isDashed)
{
  this->Curves.push_back({name, x, y, {red, green, blue}, isDashed});
  this->Modified();
}

mote::imaging::AxesContent vtkMoteImageAxes::MakeContent() const
{
  mote::imaging::AxesContent content;
  content.frame = rectOf(this->Frame);
  content.namesFrame = rectOf(this->NamesFrame);
  std::copy(this->XRange, this->XRange + 2, content.xRange);
  std::copy(this->YRange, this->YRange + 2, content.yRange);
  content.xTitle = this->XTitle;
  content.yTitle = this->YTitle;
  content.fontScale = this->FontScale;
  content.hasXLabels = this->XLabels;
  content.hasGrid = this->Grid;
  content.hasDots = this->Dots;
  for (const Curve& curve : this->Curves)
  {
    const auto& [red, green, blue] = curve.Color;
    mote::imaging::Curve one;
    one.name = curve.Name;
    one.color = {red, green, blue, 1.0};
    one.isDashed = curve.IsDashed;
    const vtkIdType count = std::min(curve.X->GetNumberOfTuples(), curve.Y->GetNumberOfTuples());
    for (vtkIdType i = 0; i < count; ++i)
    {
      one.x.push_back(curve.X->GetComponent(i, 0));
      one.y.push_back(curve.Y->GetComponent(i, 0));
    }
    content.curves.push_back(std::move(one));
  }
  return content;
}

void vtkMoteImageAxes::RemoveAllCurves()
{
  this->Curves.clear();
  this->Modified();
}

double vtkMoteImageAxes::TickValue(int axis, int i) const
{
  return i >= 0 && i < static_cast<int>(this->Ticks[axis].size())
           ? this->Ticks[axis][i].first
           : std::numeric_limits<double>::quiet_NaN();
}

std::string vtkMoteImageAxes::TickLabel(int axis, int i) const
{
  return i >= 0 && i < static_cast<int>(this->Ticks[axis].size()) ? this->Ticks[axis][i].second
                                                                  : std::string();
}

int vtkMoteImageAxes::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->ShallowCopy(input);
  this->Ticks[0].clear();
  this->Ticks[1].clear();
  this->SvgElements.clear();
  vtkDataArray* colors = input->GetPointData()->GetArray("color");
  colors = colors ? colors : input->GetPointData()->GetScalars();
  int size[3];
  input->GetDimensions(size);
  if (size[2] != 1 || !colors || colors->GetNumberOfComponents() < 3)
  {
    vtkErrorMacro(<< "Axes need an image of one slice with an array of colours.");
    return 0;
  }
  if (this->Frame[1] <= this->Frame[0] || this->Frame[3] <= this->Frame[2] ||
      !isAscending(this->XRange) || !isAscending(this->YRange))
  {
    vtkErrorMacro(<< "Axes need a rectangle of pixels, and ranges from less to more.");
    return 0;
  }
  const auto drawn = vtk::TakeSmartPointer(colors->NewInstance());
  drawn->DeepCopy(colors);
  mote::imaging::SvgDrawing svg(size[1]);
  mote::imaging::Canvas canvas(drawn, size[0], size[1], &svg);
  const auto ticks = mote::imaging::paintAxes(canvas, this->MakeContent());
  for (const auto& tick : ticks.x)
    this->Ticks[0].emplace_back(tick.value, tick.label);
  for (const auto& tick : ticks.y)
    this->Ticks[1].emplace_back(tick.value, tick.label);
  this->SvgElements = svg.elements();
  const bool isActive = output->GetPointData()->GetScalars() == colors;
  if (colors->GetName())
    output->GetPointData()->AddArray(drawn); // replaces that of the same name
  if (isActive || !colors->GetName())
    output->GetPointData()->SetScalars(drawn);
  return 1;
}

void vtkMoteImageAxes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frame: " << this->Frame[0] << " " << this->Frame[1] << " " << this->Frame[2]
     << " " << this->Frame[3] << "\n";
  os << indent << "XRange: " << this->XRange[0] << " " << this->XRange[1] << "\n";
  os << indent << "YRange: " << this->YRange[0] << " " << this->YRange[1] << "\n";
  os << indent << "XTitle: " << this->XTitle << "\n";
  os << indent << "YTitle: " << this->YTitle << "\n";
  os << indent << "FontScale: " << this->FontScale << "\n";
  os << indent << "NamesFrame: " << this->NamesFrame[0] << " " << this->NamesFrame[1] << " "
     << this->NamesFrame[2] << " " << this->NamesFrame[3] << "\n";
  os << indent << "XLabels: " << this->XLabels << "\n";
  os << indent << "Grid: " << this->Grid << "\n";
  os << indent << "Dots: " << this->Dots << "\n";
  os << indent << "Curves: " << this->Curves.size() << "\n";
}
