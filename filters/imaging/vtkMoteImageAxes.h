/**
 * @class   vtkMoteImageAxes
 * @brief   Draws axes around a rectangle of an image, and curves in it, without OpenGL or a
 * display.
 *
 * Input and output are a vtkImageData as that of vtkMoteColorLegend. Around the rectangle comes a
 * frame with ticks, the numbers of the ticks left of it and below, and titles. Ticks are multiples
 * of 1, 2 or 5 times a power of ten; a power that all numbers of an axis have in common
 * stands at its title. Text is at a size in proportion to the image's height, dark or light,
 * whichever stands out.
 *
 * Curves are drawn within the rectangle; values that are not finite are gaps. Several of these
 * filters, one behind the other, draw rectangles one above the other.
 *
 * An empty rectangle, or a range whose ends are not finite and ascending, is reported by
 * vtkErrorMacro and nothing is drawn.
 */

#ifndef vtkMoteImageAxes_h
#define vtkMoteImageAxes_h

#include "MoteFiltersImagingModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for arrays

#include <array>  // for colours
#include <string> // for texts
#include <vector> // for ticks and curves

class vtkDataArray;

namespace mote
{
namespace imaging // in two steps, for VTK's wrappers
{
struct AxesContent;
} // namespace imaging
} // namespace mote

class MOTEFILTERSIMAGING_EXPORT vtkMoteImageAxes : public vtkImageAlgorithm
{
public:
  static vtkMoteImageAxes* New();
  vtkTypeMacro(vtkMoteImageAxes, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The pixels that the axes go around, {x min, x max, y min, y max}, both ends included. Labels
   * and titles need about 4 times LabelSize() below and 7 times it at the left.
   */
  vtkSetVector4Macro(Frame, int);
  vtkGetVector4Macro(Frame, int);
  //@}

  //@{
  /**
   * Values at the frame's outer edges. Default 0 to 1.
   */
  vtkSetVector2Macro(XRange, double);
  vtkGetVector2Macro(XRange, double);
  vtkSetVector2Macro(YRange, double);
  vtkGetVector2Macro(YRange, double);
  //@}

  //@{
  /**
   * What the axes mean, with its unit: "radius (m)". UTF-8. Default empty.
   */
  vtkSetMacro(XTitle, std::string);
  vtkGetMacro(XTitle, std::string);
  vtkSetMacro(YTitle, std::string);
  vtkGetMacro(YTitle, std::string);
  //@}

  //@{
  /**
   * Factor on the size of the text, in [0.25, 4]. Default 1.
   */
  vtkSetClampMacro(FontScale, double, 0.25, 4.0);
  vtkGetMacro(FontScale, double);
  //@}

  //@{
  /**
   * Whether the numbers and the title of the x axis stand below it. Default on. Off for all but
   * the lowest of several rectangles over one axis.
   */
  vtkSetMacro(XLabels, bool);
  vtkGetMacro(XLabels, bool);
  vtkBooleanMacro(XLabels, bool);
  //@}

  //@{
  /**
   * Whether faint lines go through the rectangle at the ticks, and dots stand at the points of
   * curves. Default off.
   */
  vtkSetMacro(Grid, bool);
  vtkGetMacro(Grid, bool);
  vtkBooleanMacro(Grid, bool);
  vtkSetMacro(Dots, bool);
  vtkGetMacro(Dots, bool);
  vtkBooleanMacro(Dots, bool);
  //@}

  //@{
  /**
   * The pixels in which the names of the curves are listed from the top, as in Frame; 1.6 times
   * LabelSize() for each. What does not fit is counted. Default none.
   */
  vtkSetVector4Macro(NamesFrame, int);
  vtkGetVector4Macro(NamesFrame, int);
  //@}

  /** The em of the labels in an image of that size, in pixels. */
  static int LabelSize(int width, int height, double fontScale);

  /**
   * Draws a line through the values of two arrays of one component, in this colour. The shorter of
   * both counts.
   */
  void AddCurve(vtkDataArray* x, vtkDataArray* y, double red, double green, double blue);
  /** The same, with a name, and dashed or not. */
  void AddNamedCurve(const std::string& name, vtkDataArray* x, vtkDataArray* y, double red,
    double green, double blue, bool isDashed);
  /** Takes away all curves. */
  void RemoveAllCurves();

  /**
   * What the last update drew, as elements of SVG: coordinates are pixels from the image's upper
   * left corner, texts are text, and each curve is a group with its name for a title.
   */
  const std::string& GetSvgElements() const { return this->SvgElements; }

  //@{
  /**
   * Value and text of the ticks of the last update, i in [0, GetNumberOfXTicks()). Outside that
   * NaN and an empty text.
   */
  int GetNumberOfXTicks() const { return static_cast<int>(this->Ticks[0].size()); }
  double GetXTickValue(int i) const { return this->TickValue(0, i); }
  std::string GetXTickLabel(int i) const { return this->TickLabel(0, i); }
  int GetNumberOfYTicks() const { return static_cast<int>(this->Ticks[1].size()); }
  double GetYTickValue(int i) const { return this->TickValue(1, i); }
  std::string GetYTickLabel(int i) const { return this->TickLabel(1, i); }
  //@}

protected:
  vtkMoteImageAxes();
  ~vtkMoteImageAxes() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int Frame[4] = {0, -1, 0, -1};
  double XRange[2] = {0.0, 1.0};
  double YRange[2] = {0.0, 1.0};
  std::string XTitle;
  std::string YTitle;
  double FontScale = 1.0;
  int NamesFrame[4] = {0, -1, 0, -1};
  bool XLabels = true;
  bool Grid = false;
  bool Dots = false;

private:
  vtkMoteImageAxes(const vtkMoteImageAxes&) = delete;
  void operator=(const vtkMoteImageAxes&) = delete;

  struct Curve
  {
    std::string Name;
    vtkSmartPointer<vtkDataArray> X, Y;
    std::array<double, 3> Color;
    bool IsDashed;
  };

  mote::imaging::AxesContent MakeContent() const;
  double TickValue(int axis, int i) const;
  std::string TickLabel(int axis, int i) const;

  std::vector<Curve> Curves;
  std::vector<std::pair<double, std::string>> Ticks[2];
  std::string SvgElements;
};

#endif
