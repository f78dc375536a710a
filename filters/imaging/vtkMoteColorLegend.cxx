#include "vtkMoteColorLegend.h"

#include "Canvas.h"
#include "LegendLayout.h"
#include "LegendPainter.h"
#include "LegendTable.h"
#include "SvgDrawing.h"
#include "TextMask.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkScalarsToColors.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// VTK's rectangles include both ends.
void storeRectangle(const mote::imaging::Rect& rect, const mote::imaging::Canvas& canvas, int to[4])
{
  const mote::imaging::Rect inside = rect.clipped(canvas.width(), canvas.height());
  to[0] = inside.x0;
  to[1] = inside.x1 - 1;
  to[2] = inside.y0;
  to[3] = inside.y1 - 1;
}

void clearRectangle(int rectangle[4])
{
  rectangle[0] = rectangle[2] = 0;
  rectangle[1] = rectangle[3] = -1;
}

void printRectangle(ostream& os, vtkIndent indent, const char* name, const int r[4])
{
  os << indent << name << ": " << r[0] << " " << r[1] << " " << r[2] << " " << r[3] << "\n";
}

} // namespace

vtkStandardNewMacro(vtkMoteColorLegend);

vtkMoteColorLegend::vtkMoteColorLegend() = default;

vtkMoteColorLegend::~vtkMoteColorLegend() = default;

void vtkMoteColorLegend::SetLookupTable(vtkScalarsToColors* table)
{
  if (this->LookupTable != table)
  {
    this->LookupTable = table;
    this->Modified();
  }
}

vtkScalarsToColors* vtkMoteColorLegend::GetLookupTable()
{
  return this->LookupTable;
}

bool vtkMoteColorLegend::IsLabelFormat(const std::string& text)
{
  return text.empty() || mote::imaging::isDoubleFormat(text);
}

vtkMTimeType vtkMoteColorLegend::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->LookupTable ? std::max(own, this->LookupTable->GetMTime()) : own;
}

int vtkMoteColorLegend::GetNumberOfTicks() const
{
  return static_cast<int>(this->TickValues.size());
}

double vtkMoteColorLegend::GetTickValue(int i) const
{
  return i >= 0 && i < this->GetNumberOfTicks() ? this->TickValues[i]
                                                : std::numeric_limits<double>::quiet_NaN();
}

std::string vtkMoteColorLegend::GetTickLabel(int i) const
{
  return i >= 0 && i < this->GetNumberOfTicks() ? this->TickLabels[i] : std::string();
}

int vtkMoteColorLegend::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->ShallowCopy(input);
  clearRectangle(this->LegendRectangle);
  clearRectangle(this->CaptionRectangle);
  clearRectangle(this->BarRectangle);
  this->TickValues.clear();
  this->TickLabels.clear();
  this->SvgElements.clear();
  if ((!this->LookupTable && this->Caption.empty()) || input->GetNumberOfPoints() == 0)
    return 1;
  vtkDataArray* colors = input->GetPointData()->GetArray("color");
  colors = colors ? colors : input->GetPointData()->GetScalars();
  int size[3];
  input->GetDimensions(size);
  const int components = colors ? colors->GetNumberOfComponents() : 0;
  const int type = colors ? colors->GetDataType() : VTK_VOID;
  if (size[2] != 1 || components < 3 || components > 4 ||
      (type != VTK_FLOAT && type != VTK_DOUBLE && type != VTK_UNSIGNED_CHAR))
  {
    vtkErrorMacro(<< "A legend needs an image of one slice, with an array of RGB or RGBA colours"
                  << " that are float, double or unsigned char.");
    return 0;
  }
  this->Draw(output, colors);
  return 1;
}

void vtkMoteColorLegend::Draw(vtkImageData* image, vtkDataArray* colors)
{
  using namespace mote::imaging;
  int size[3];
  image->GetDimensions(size);
  const auto drawn = vtk::TakeSmartPointer(colors->NewInstance());
  drawn->DeepCopy(colors);
  SvgDrawing svg(size[1]);
  Canvas canvas(drawn, size[0], size[1], &svg);
  TextFont font(this->FontFile);
  Placement placement;
  placement.imageWidth = size[0];
  placement.imageHeight = size[1];
  placement.unit = labelSize(size[0], size[1], this->FontScale);
  placement.isLeft = this->Side == LEFT;
  placement.isCaptionOnTop = this->CaptionOnTop != 0;
  LegendStyle style;
  style.panel = static_cast<PanelUse>(this->Panel);
  if (!this->AutomaticTextColor)
    style.text = Color{this->TextColor[0], this->TextColor[1], this->TextColor[2], 1.0};
  if (!this->Caption.empty())
  {
    const LegendLayout layout = layOutCaption(font, this->Caption, placement);
    placement.reserved = this->CaptionOnTop ? 0 : layout.panel.y1;
    storeRectangle(layout.panel, canvas, this->CaptionRectangle);
    paintLegend(canvas, layout, style, {});
  }
  LegendContent content;
  TickScale scale;
  if (this->LookupTable &&
      this->MakeContent(content, scale, 1.4 * placement.unit / barHeight(size[1])))
  {
    const LegendLayout layout = layOutLegend(font, content, placement);
    storeRectangle(layout.panel, canvas, this->LegendRectangle);
    storeRectangle(layout.bar, canvas, this->BarRectangle);
    std::function<Color(double)> barColor;
    if (content.categories.empty())
      barColor = [&](double share) { return colorOf(this->LookupTable, scale.valueAt(share)); };
    paintLegend(canvas, layout, style, barColor);
  }
  this->SvgElements = svg.elements();
  if (!font.missing().empty())
  {
    vtkWarningMacro(<< "No font has the characters \"" << font.missing()
                    << "\"; they are drawn as question marks. FontFile can name another font.");
  }
  const bool isActive = image->GetPointData()->GetScalars() == colors;
  if (colors->GetName())
    image->GetPointData()->AddArray(drawn); // replaces that of the same name
  if (isActive || !colors->GetName())
    image->GetPointData()->SetScalars(drawn);
}

bool vtkMoteColorLegend::MakeContent(
  mote::imaging::LegendContent& content, mote::imaging::TickScale& scale, double minimumTickShare)
{
  using namespace mote::imaging;
  vtkScalarsToColors* table = this->LookupTable;
  table->Build();
  content.title = this->Title;
  if (this->NanSwatch)
    content.nan = nanColorOf(table);
  if (table->GetIndexedLookup())
  {
    content.categories = categoriesOf(table);
    for (std::size_t i = 0; i < content.categories.size(); ++i)
    {
      bool isNumber = false;
      const double value = table->GetAnnotatedValue(static_cast<vtkIdType>(i)).ToDouble(&isNumber);
      this->TickValues.push_back(isNumber ? value : std::numeric_limits<double>::quiet_NaN());
      this->TickLabels.push_back(content.categories[i].label);
    }
    return !content.categories.empty();
  }
  std::string problem;
  scale = scaleOf(table, problem);
  if (!problem.empty())
  {
    vtkErrorMacro(<< "The lookup table gets no legend: " << problem << ".");
    return false;
  }
  std::string format = this->LabelFormat;
  if (!IsLabelFormat(format))
  {
    vtkWarningMacro(<< "\"" << format << "\" is not a format for one number, such as \"%.3g\".");
    format.clear();
  }
  addRangeColors(table, content);
  content.ticks = makeTicks(scale, this->NumberOfLabels, minimumTickShare, format);
  for (const Tick& tick : content.ticks.ticks)
  {
    this->TickValues.push_back(tick.value);
    this->TickLabels.push_back(tick.label);
  }
  return true;
}

void vtkMoteColorLegend::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LookupTable: " << this->LookupTable.Get() << "\n";
  os << indent << "Title: " << this->Title << "\n";
  os << indent << "Caption: " << this->Caption << "\n";
  os << indent << "CaptionOnTop: " << this->CaptionOnTop << "\n";
  os << indent << "LabelFormat: " << this->LabelFormat << "\n";
  os << indent << "FontFile: " << this->FontFile << "\n";
  os << indent << "NumberOfLabels: " << this->NumberOfLabels << "\n";
  os << indent << "Side: " << (this->Side == LEFT ? "left" : "right") << "\n";
  os << indent << "AutomaticTextColor: " << this->AutomaticTextColor << "\n";
  os << indent << "TextColor: " << this->TextColor[0] << " " << this->TextColor[1] << " "
     << this->TextColor[2] << "\n";
  os << indent << "Panel: " << this->Panel << "\n";
  os << indent << "FontScale: " << this->FontScale << "\n";
  os << indent << "NanSwatch: " << this->NanSwatch << "\n";
  printRectangle(os, indent, "LegendRectangle", this->LegendRectangle);
  printRectangle(os, indent, "CaptionRectangle", this->CaptionRectangle);
  printRectangle(os, indent, "BarRectangle", this->BarRectangle);
}
