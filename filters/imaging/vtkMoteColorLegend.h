/**
 * @class   vtkMoteColorLegend
 * @brief   Draws a colour legend and a caption into an image, without OpenGL or a display.
 *
 * Input and output are a vtkImageData of one slice whose row 0 is the bottom row, with the point
 * array `color` (or, without it, the active scalars): float RGBA in [0, 1], alpha premultiplied,
 * or RGB. The legend is drawn over it; every other array passes through untouched. Text is
 * antialiased, in a sans serif font (see FontFile), at a size in proportion to the image's
 * height, so that a figure looks alike at 256 and at 4096 rows.
 *
 * The legend is a vertical bar of the table's colours with tick labels, below a title that
 * wraps, then shrinks, to fit. Ticks are round values inside the range: multiples of 1, 2 or
 * 5 times a power of ten; for a table with a log scale powers of ten, with 2 and 5 times these
 * where there are few, and both ends. The bar has swatches for values below and above the range if
 * the table has colours for them, and for NaN if NanSwatch is on. A table with IndexedLookup gets
 * one labelled swatch for each annotated value instead. A log scale whose range is not positive is
 * reported by vtkErrorMacro and draws no legend. Colours are shown opaque, whatever their opacity
 * in the table.
 *
 * Without a lookup table only the caption is drawn; without a caption, too, the input passes.
 */

#ifndef vtkMoteColorLegend_h
#define vtkMoteColorLegend_h

#include "MoteFiltersImagingModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for LookupTable

#include <string> // for texts
#include <vector> // for ticks

class vtkDataArray;
class vtkImageData;
class vtkScalarsToColors;

namespace mote
{
namespace imaging // in two steps, for VTK's wrappers
{
struct LegendContent;
struct TickScale;
} // namespace imaging
} // namespace mote

class MOTEFILTERSIMAGING_EXPORT vtkMoteColorLegend : public vtkImageAlgorithm
{
public:
  static vtkMoteColorLegend* New();
  vtkTypeMacro(vtkMoteColorLegend, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The colours to explain, with their range: a vtkLookupTable, vtkColorTransferFunction or
   * any other; none, the default, for no legend.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLookupTable();
  //@}

  //@{
  /**
   * What the colours mean, with its unit: "speed (km/s)". UTF-8. Default empty.
   */
  vtkSetMacro(Title, std::string);
  vtkGetMacro(Title, std::string);
  //@}

  //@{
  /**
   * A line at the lower left, such as file name, time and number of particles. UTF-8; line
   * breaks are kept. It shrinks to fit the width. Default empty.
   */
  vtkSetMacro(Caption, std::string);
  vtkGetMacro(Caption, std::string);
  //@}

  //@{
  /**
   * Whether the caption stands at the upper left instead. Default off.
   */
  vtkSetMacro(CaptionOnTop, vtkTypeBool);
  vtkGetMacro(CaptionOnTop, vtkTypeBool);
  vtkBooleanMacro(CaptionOnTop, vtkTypeBool);
  //@}

  //@{
  /**
   * A printf format for one double, such as "%.3g". Empty, the default, for the fewest digits
   * that tell the ticks apart, with a common power of ten where the numbers are long.
   * A format that does not take exactly one double is reported and not used.
   */
  vtkSetMacro(LabelFormat, std::string);
  vtkGetMacro(LabelFormat, std::string);
  //@}

  /** Whether a text is such a format, or empty. */
  static bool IsLabelFormat(const std::string& text);

  //@{
  /**
   * About how many ticks to aim at, in [2, 20]. Default 5. Fewer if they would collide.
   */
  vtkSetClampMacro(NumberOfLabels, int, 2, 20);
  vtkGetMacro(NumberOfLabels, int);
  //@}

  //@{
  /**
   * A TrueType or Type 1 font to use. Empty, the default, for DejaVu Sans, or, where that is not
   * installed, the sans serif font that VTK carries. Characters that a font lacks come from
   * the next in this order; raised and lowered digits are always there: "km s⁻¹". What no font
   * has is drawn as a question mark, and reported.
   */
  vtkSetMacro(FontFile, std::string);
  vtkGetMacro(FontFile, std::string);
  //@}

  enum SideType
  {
    RIGHT = 0,
    LEFT = 1
  };

  //@{
  /**
   * The side of the image to draw at. Default right.
   */
  vtkSetClampMacro(Side, int, RIGHT, LEFT);
  vtkGetMacro(Side, int);
  void SetSideToRight() { this->SetSide(RIGHT); }
  void SetSideToLeft() { this->SetSide(LEFT); }
  //@}

  //@{
  /**
   * Whether text is dark or light, whichever stands out against what is behind it, instead
   * of TextColor. Transparent pixels count as white paper. Default on.
   */
  vtkSetMacro(AutomaticTextColor, vtkTypeBool);
  vtkGetMacro(AutomaticTextColor, vtkTypeBool);
  vtkBooleanMacro(AutomaticTextColor, vtkTypeBool);
  //@}

  //@{
  /**
   * Colour of text, ticks and frame if AutomaticTextColor is off. Default black.
   */
  vtkSetVector3Macro(TextColor, double);
  vtkGetVector3Macro(TextColor, double);
  //@}

  enum PanelType
  {
    PANEL_AUTOMATIC = 0,
    PANEL_ON = 1,
    PANEL_OFF = 2
  };

  //@{
  /**
   * Whether a translucent panel lies behind legend and caption. Default automatic: where what is
   * behind is not a plain background.
   */
  vtkSetClampMacro(Panel, int, PANEL_AUTOMATIC, PANEL_OFF);
  vtkGetMacro(Panel, int);
  void SetPanelToAutomatic() { this->SetPanel(PANEL_AUTOMATIC); }
  void SetPanelToOn() { this->SetPanel(PANEL_ON); }
  void SetPanelToOff() { this->SetPanel(PANEL_OFF); }
  //@}

  //@{
  /**
   * Factor on the size of the text and of all that goes with it, in [0.25, 4]. Default 1.
   */
  vtkSetClampMacro(FontScale, double, 0.25, 4.0);
  vtkGetMacro(FontScale, double);
  //@}

  //@{
  /**
   * Whether to show the colour of NaN. Default off.
   */
  vtkSetMacro(NanSwatch, vtkTypeBool);
  vtkGetMacro(NanSwatch, vtkTypeBool);
  vtkBooleanMacro(NanSwatch, vtkTypeBool);
  //@}

  //@{
  /**
   * What the last update drew, as pixels {x min, x max, y min, y max}, both ends included; an
   * empty rectangle, max < min, if nothing. No pixel outside the legend's and the caption's
   * rectangles changes; the bar's rectangle holds nothing but the table's colours.
   */
  vtkGetVector4Macro(LegendRectangle, int);
  vtkGetVector4Macro(CaptionRectangle, int);
  vtkGetVector4Macro(BarRectangle, int);
  //@}

  //@{
  /**
   * Value and text of the ticks of the last update, from the bottom up, i in
   * [0, GetNumberOfTicks()). Outside that NaN and an empty text.
   */
  int GetNumberOfTicks() const;
  double GetTickValue(int i) const;
  std::string GetTickLabel(int i) const;
  //@}

  /**
   * What the last update drew, as elements of SVG: coordinates are pixels from the image's upper
   * left corner, and texts are text.
   */
  const std::string& GetSvgElements() const { return this->SvgElements; }

  vtkMTimeType GetMTime() override;

protected:
  vtkMoteColorLegend();
  ~vtkMoteColorLegend() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  std::string Title;
  std::string Caption;
  vtkTypeBool CaptionOnTop = 0;
  std::string LabelFormat;
  std::string FontFile;
  int NumberOfLabels = 5;
  int Side = RIGHT;
  vtkTypeBool AutomaticTextColor = 1;
  double TextColor[3] = {0.0, 0.0, 0.0};
  int Panel = PANEL_AUTOMATIC;
  double FontScale = 1.0;
  vtkTypeBool NanSwatch = 0;
  int LegendRectangle[4] = {0, -1, 0, -1};
  int CaptionRectangle[4] = {0, -1, 0, -1};
  int BarRectangle[4] = {0, -1, 0, -1};
  vtkSmartPointer<vtkScalarsToColors> LookupTable;

private:
  vtkMoteColorLegend(const vtkMoteColorLegend&) = delete;
  void operator=(const vtkMoteColorLegend&) = delete;

  void Draw(vtkImageData* image, vtkDataArray* colors);
  bool MakeContent(mote::imaging::LegendContent& content, mote::imaging::TickScale& scale,
    double minimumTickShare);

  std::vector<double> TickValues;
  std::vector<std::string> TickLabels;
  std::string SvgElements;
};

#endif
