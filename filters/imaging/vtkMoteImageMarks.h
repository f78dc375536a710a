/**
 * @class   vtkMoteImageMarks
 * @brief   Draws lines, balls and labels into a traced image, behind what is nearer, without OpenGL
 *          or a display.
 *
 * Input and output are a vtkImageData as that of vtkMoteRendererSource: the point array `color`
 * and, for marks to be hidden by what is nearer, `depth`, the distance along the view axis.
 * Places are in pixels from the lower left corner of the image, with that distance as third.
 * Lines come first, then balls, then labels, each in the order in which they were added.
 */

#ifndef vtkMoteImageMarks_h
#define vtkMoteImageMarks_h

#include "MoteFiltersImagingModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <array>  // for places
#include <string> // for labels
#include <vector> // for marks

class MOTEFILTERSIMAGING_EXPORT vtkMoteImageMarks : public vtkImageAlgorithm
{
public:
  static vtkMoteImageMarks* New();
  vtkTypeMacro(vtkMoteImageMarks, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Whether the view is a parallel projection: distances along a line are linear in pixels then,
   * and their inverses else. Default off.
   */
  vtkSetMacro(ParallelProjection, vtkTypeBool);
  vtkGetMacro(ParallelProjection, vtkTypeBool);
  vtkBooleanMacro(ParallelProjection, vtkTypeBool);
  //@}

  /**
   * A line of some width in pixels. With `onTop` nothing hides it.
   */
  void AddLine(const double from[3], const double to[3], const double color[3], double width,
    bool onTop = false);
  /**
   * A ball whose middle lies there: `radius` in pixels, `reach` the same in units of distance. It
   * is brightest in the middle, and lets 1 - `opacity` of what is behind through.
   */
  void AddBall(
    const double middle[3], double radius, double reach, const double color[3], double opacity);
  /**
   * A text above the place, in the middle, or below it, on a dark ground. UTF-8.
   */
  void AddLabel(const double place[2], const std::string& text, const double color[3], bool below);
  /** Takes away all marks. */
  void RemoveAll();

  /** How many marks there are. */
  int GetNumberOfMarks() const;

protected:
  vtkMoteImageMarks();
  ~vtkMoteImageMarks() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  vtkTypeBool ParallelProjection = 0;

private:
  vtkMoteImageMarks(const vtkMoteImageMarks&) = delete;
  void operator=(const vtkMoteImageMarks&) = delete;

  struct Line
  {
    std::array<double, 3> From, To, Color;
    double Width;
    bool OnTop;
  };
  struct Ball
  {
    std::array<double, 3> Middle, Color;
    double Radius, Reach, Opacity;
  };
  struct Label
  {
    std::array<double, 2> Place;
    std::string Text;
    std::array<double, 3> Color;
    bool Below;
  };
  class Painter;

  std::vector<Line> Lines;
  std::vector<Ball> Balls;
  std::vector<Label> Labels;
};

#endif
