#include "Average.h"

#include "ChartFile.h"
#include "OpenedInput.h"
#include "TableFile.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "stage/Arrays.h"
#include "stage/ColorMaps.h"
#include "stage/Picture.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkMoteColorLegend.h>
#include <vtkMoteImageAxes.h>
#include <vtkMoteImageWriter.h>
#include <vtkMoteMeridionalAverage.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mote::app
{

namespace
{

/// A picture and the pixels of it that hold the bins: {x min, x max, y min, y max}.
struct Drawn
{
  vtkSmartPointer<vtkImageData> image;
  std::array<int, 4> frame;
  double fontScale; ///< factor that flat pictures, too, are read with
};

/// The bins as squares of one size in a picture 1280 pixels wide and at most 960 high, over white.
Drawn drawn(vtkImageData* bins, vtkDataArray* values, vtkLookupTable* colors, double fontScale)
{
  constexpr int width = 1280, most = 960, above = 40, legend = 300;
  const int letter = vtkMoteImageAxes::LabelSize(width, most, fontScale);
  const int left = 7 * letter, below = 6 * letter + 10; // the caption, and the axis
  const int* bounds = bins->GetDimensions();
  const double pixel = std::max(static_cast<double>(bounds[0]) / (width - left - legend),
    static_cast<double>(bounds[1]) / (most - below - above));
  // The legend needs some height, too.
  const int height = std::max(480, static_cast<int>(bounds[1] / pixel) + below + above);
  const auto image = whitePaper(width, height);
  auto* pixels = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  const int columns = std::max(1, static_cast<int>(bounds[0] / pixel));
  const int rows = std::max(1, static_cast<int>(bounds[1] / pixel));
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
    {
      const int i = std::min(bounds[0] - 1, static_cast<int>((x + 0.5) * pixel));
      const int j = std::min(bounds[1] - 1, static_cast<int>((y + 0.5) * pixel));
      const double value = values->GetComponent(vtkIdType(j) * bounds[0] + i, 0);
      if (!std::isfinite(value))
        continue;
      double rgb[3];
      colors->GetColor(value, rgb);
      const vtkIdType at = vtkIdType(y + below) * width + x + left;
      for (int k = 0; k < 3; ++k)
        pixels->SetTypedComponent(at, k, static_cast<float>(rgb[k]));
    }
  return {image, {left, left + columns - 1, below, below + rows - 1},
    fontScale * std::clamp(720.0 / height, 1.0, 1.4)};
}

/// The column that colours: what the user says, else the average, of a vector its magnitude.
vtkDataArray* columnOf(vtkImageData* bins, const Settings& settings)
{
  const std::string& asked = settings.color.array;
  vtkPointData* columns = bins->GetPointData();
  const std::string magnitude = settings.average.array + "_magnitude";
  const std::string name = !asked.empty()                         ? asked
                           : columns->HasArray(magnitude.c_str()) ? magnitude
                                                                  : settings.average.array;
  if (vtkDataArray* column = columns->GetArray(name.c_str()))
    return column;
  throw Failure("the average has no column " + name + " to colour by; it has " + listArrays(bins));
}

/// What is averaged, in words for pictures.
struct Meaning
{
  std::string caption;
  std::string unit, lengthUnit; ///< empty where the data do not say
};

/// The picture's axes: along the axis of the machine, and away from it.
void aimAxes(vtkMoteImageAxes* axes, vtkImageData* bins, const std::string& unit)
{
  const auto range = [&](int axis, double to[2])
  {
    const double side = bins->GetSpacing()[axis];
    to[0] = bins->GetOrigin()[axis] - 0.5 * side;
    to[1] = to[0] + bins->GetDimensions()[axis] * side;
  };
  double along[2], away[2];
  range(0, along);
  range(1, away);
  axes->SetXRange(along);
  axes->SetYRange(away);
  axes->SetXTitle(withUnit("axial", unit));
  axes->SetYTitle(withUnit("radial", unit));
}

void writePicture(vtkImageData* bins, const Settings& settings, const Meaning& meaning)
{
  vtkDataArray* column = columnOf(bins, settings);
  double range[2];
  if (settings.color.range.size() == 2)
    std::copy(settings.color.range.begin(), settings.color.range.end(), range);
  else
    column->GetFiniteRange(range, 0);
  if (!(range[0] < range[1]))
    range[1] = range[0] + 1.0;
  const std::string map = settings.color.map.empty() ? "viridis" : settings.color.map;
  const auto colors = makeColorMap(map, range, settings.color.logarithmic);
  const Drawn picture = drawn(bins, column, colors, settings.picture.fontScale);
  vtkNew<vtkMoteImageAxes> axes;
  axes->SetInputData(picture.image);
  axes->SetFrame(picture.frame[0], picture.frame[1], picture.frame[2], picture.frame[3]);
  axes->SetFontScale(picture.fontScale);
  aimAxes(axes, bins, meaning.lengthUnit);
  vtkNew<vtkMoteColorLegend> legend;
  legend->SetInputConnection(axes->GetOutputPort());
  legend->SetLookupTable(colors);
  const std::string name = column->GetName();
  legend->SetTitle(settings.picture.title.value_or(
    withUnit(name, name.starts_with(settings.average.array) ? meaning.unit : "")));
  applyLook(legend, settings.picture);
  legend->SetFontScale(picture.fontScale);
  legend->SetCaption(meaning.caption);
  writeChart(legend, settings.output.file);
}

} // namespace

void average(const Settings& settings)
{
  const AverageSettings& wanted = settings.average;
  if (!isTableFile(settings.output.file) &&
      !vtkMoteImageWriter::CanWriteFile(settings.output.file.c_str()))
    throw Failure("cannot write " + settings.output.file +
                  ": the name must end in .csv for a table, or .png, .jpg, .tif or .exr for a "
                  "picture");
  checkOutput(settings.output.file, settings.data.files);
  OpenedInput opened(settings);
  vtkNew<vtkMultiBlockDataSet> blocks;
  std::vector<std::string> known;
  Meaning meaning;
  for (const NamedData& one : opened.read())
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), one.data);
    known.push_back(listArrays(one.data));
    if (meaning.unit.empty())
      meaning.unit = unitOf(one.data, wanted.array);
    if (meaning.lengthUnit.empty())
      meaning.lengthUnit = lengthUnitOf(one.data);
  }
  vtkNew<vtkMoteMeridionalAverage> filter;
  filter->SetInputData(blocks);
  filter->SetArrayName(wanted.array);
  filter->SetResolution(wanted.resolution);
  filter->SetAxisFromInput(wanted.axis.empty() && wanted.origin.empty());
  if (!wanted.axis.empty())
    filter->SetAxis(wanted.axis.data());
  if (!wanted.origin.empty())
    filter->SetOrigin(wanted.origin.data());
  {
    ProgressRelay::Work work(opened.progress, "Averaging", filter);
    filter->Update();
    work.finish();
  }
  Messages::takeError(); // the filter keeps it
  const std::string name = opened.input.name();
  if (const std::string& error = filter->GetErrorMessage(); !error.empty())
    throw Failure(
      name + ": " + error +
      (error.starts_with("there is no array") && !known.empty() ? "; it has " + known.front()
                                                                : ""));
  if (isTableFile(settings.output.file))
    writeTable(filter->GetOutput(), settings.output.file);
  else
  {
    meaning.caption = opened.caption();
    writePicture(filter->GetImage(), settings, meaning);
  }
}

} // namespace mote::app
