#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace mote::app
{

/// Whether a chart can be written to a file of this name: a picture, or .svg.
bool isChartFile(const std::string& file);

/// White paper with the array `color`, on which filters draw, as pixels and as SVG.
class ChartPaper
{
public:
  ChartPaper(int width, int height);

  /// What is drawn so far.
  vtkImageData* image() { return image_; }

  /// Takes the pixels of a frame, {x min, x max, y min, y max}, which were changed in the image.
  void keepPixels(const std::array<int, 4>& frame);

  /// Draws what a vtkMoteImageAxes or vtkMoteColorLegend draws.
  template <class Filter>
  void draw(Filter* filter)
  {
    filter->SetInputData(image_);
    filter->Update();
    image_ = vtkSmartPointer<vtkImageData>::New();
    image_->ShallowCopy(filter->GetOutput());
    elements_ += filter->GetSvgElements();
  }

  /// The file's ending says which picture. Throws Failure.
  void write(const std::string& file);

private:
  std::string svg() const;

  vtkSmartPointer<vtkImageData> image_;
  std::string elements_; ///< of SVG
};

} // namespace mote::app
