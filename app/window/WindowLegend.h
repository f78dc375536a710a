#pragma once

#include "settings/Settings.h"

#include <vtkMoteColorLegend.h>
#include <vtkNew.h>

#include <array>
#include <string>

class vtkActor2D;
class vtkImageData;
class vtkImageMapper;
class vtkRenderer;
class vtkScalarsToColors;

namespace mote::app
{

/// The colour legend of the window: the one that `mote render` draws, as a prop.
class WindowLegend
{
public:
  explicit WindowLegend(vtkRenderer* renderer);
  ~WindowLegend();

  /// What to explain, in which look; no table to show nothing.
  void set(vtkScalarsToColors* table, const std::string& title, const PictureSettings& look);
  void setInk(const Color& ink);

  /// Draws anew where something has changed, the size of the window too. Call before each frame.
  void update();

  /// Pixels that it takes from the edge that it is at; 0 where there is none.
  int widthAtSide();

private:
  vtkRenderer* renderer_;
  vtkNew<vtkImageData> canvas_;
  vtkNew<vtkMoteColorLegend> legend_;
  vtkNew<vtkImageMapper> mapper_;
  vtkNew<vtkActor2D> actor_;
  vtkMTimeType drawn_ = 0;
  std::array<Color, 2> ground_{}; ///< of the view: at its bottom, and at its top
  bool isLeftOut_ = false;        ///< as the view is too narrow
};

} // namespace mote::app
