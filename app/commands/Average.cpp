#include "Average.h"

#include "AverageProfile.h"
#include "ChartFile.h"
#include "DataUnits.h"
#include "OpenedInput.h"
#include "TableFile.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
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
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mote::app
{

namespace
{

/// A picture and the pixels of it that hold the bins: {x min, x max, y min, y max}.
struct Drawn
{
  ChartPaper paper;
  std::array<int, 4> frame;
  double fontScale; ///< factor that flat pictures, too, are read with
};

/// The bins as squares of one size in a picture at most 1280 pixels wide and 960 high, over white.
Drawn drawn(vtkImageData* bins, vtkDataArray* values, vtkLookupTable* colors, double fontScale)
{
  constexpr int least = 640, widest = 1280, most = 960, above = 40;
  const int letter = vtkMoteImageAxes::LabelSize(widest, most, fontScale);
  const int legend = 11 * letter;
  int left = 7 * letter;
  const int below = 6 * letter + 10; // the caption, and the axis
  const int* bounds = bins->GetDimensions();
  const double pixel = std::max(static_cast<double>(bounds[0]) / (widest - left - legend),
    static_cast<double>(bounds[1]) / (most - below - above));
  // The legend needs some height, too.
  const int height = std::max(480, static_cast<int>(bounds[1] / pixel) + below + above);
  const int columns = std::max(1, static_cast<int>(bounds[0] / pixel));
  const int rows = std::max(1, static_cast<int>(bounds[1] / pixel));
  // The legend stands beside the bins; what is too narrow for a caption has its room at the left.
  const int width = std::max(least, left + columns + legend);
  left = width - legend - columns;
  ChartPaper paper(width, height);
  auto* pixels = vtkFloatArray::SafeDownCast(paper.image()->GetPointData()->GetScalars());
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
  const std::array<int, 4> frame = {left, left + columns - 1, below, below + rows - 1};
  paper.keepPixels(frame);
  return {paper, frame, fontScale * std::clamp(720.0 / height, 1.0, 1.4)};
}

/// The column that colours: what the user says, else the average, of a vector its magnitude.
vtkDataArray* columnOf(vtkImageData* bins, const Settings& settings)
{
  const std::string& asked = settings.color.array;
  vtkPointData* columns = bins->GetPointData();
  const std::string average = columns->GetScalars()->GetName(); // of a vector its first part
  const std::string magnitude = average.substr(0, average.rfind("_axial")) + "_magnitude";
  const std::string name = !asked.empty()                         ? asked
                           : columns->HasArray(magnitude.c_str()) ? magnitude
                                                                  : average;
  if (vtkDataArray* column = columns->GetArray(name.c_str()))
    return column;
  throw Failure("the average has no column " + name + " to colour by; it has " + listArrays(bins));
}

/// What is averaged, in words for pictures.
struct Meaning
{
  std::string caption, array;
  std::string unit, lengthUnit, timeUnit; ///< empty where the data do not say
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
  Drawn picture = drawn(bins, column, colors, settings.picture.fontScale);
  vtkNew<vtkMoteImageAxes> axes;
  axes->SetFrame(picture.frame[0], picture.frame[1], picture.frame[2], picture.frame[3]);
  axes->SetFontScale(picture.fontScale);
  aimAxes(axes, bins, meaning.lengthUnit);
  picture.paper.draw(axes.Get());
  vtkNew<vtkMoteColorLegend> legend;
  legend->SetLookupTable(colors);
  const std::string name = column->GetName();
  legend->SetTitle(settings.picture.title.value_or(
    withUnit(name, name.starts_with(meaning.array) ? meaning.unit : "")));
  applyLook(legend, settings.picture);
  legend->SetFontScale(picture.fontScale);
  legend->SetCaption(meaning.caption);
  picture.paper.draw(legend.Get());
  picture.paper.write(settings.output.file);
}

/// The mean of bins over time steps, of those of them in which there is a value.
class MeanOfSteps
{
public:
  void add(vtkImageData* bins, int step)
  {
    ++steps_;
    if (!image_)
    {
      image_ = vtkSmartPointer<vtkImageData>::New();
      image_->DeepCopy(bins);
      counts_.resize(static_cast<std::size_t>(image_->GetPointData()->GetNumberOfArrays()));
    }
    if (!isLike(bins))
      throw Failure("time step " + std::to_string(step + 1) +
                    " has its bins elsewhere; --axial-range and --radial-range keep them in place");
    for (std::size_t k = 0; k < counts_.size(); ++k)
      this->add(bins->GetPointData()->GetArray(static_cast<int>(k)),
        image_->GetPointData()->GetArray(static_cast<int>(k)), counts_[k]);
  }
  vtkImageData* image() const { return image_; }
  int steps() const { return steps_; }

private:
  bool isLike(vtkImageData* bins) const
  {
    constexpr double near = 1e-3; // of a bin
    for (int k = 0; k < 2; ++k)
      if (bins->GetDimensions()[k] != image_->GetDimensions()[k] ||
          std::abs(bins->GetOrigin()[k] - image_->GetOrigin()[k]) > near * image_->GetSpacing()[k])
        return false;
    return bins->GetPointData()->GetNumberOfArrays() == static_cast<int>(counts_.size());
  }
  static void add(vtkDataArray* from, vtkDataArray* mean, std::vector<int>& counts)
  {
    const vtkIdType size = mean->GetNumberOfValues();
    counts.resize(static_cast<std::size_t>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      const int parts = mean->GetNumberOfComponents(), part = static_cast<int>(i % parts);
      const double value = from->GetComponent(i / parts, part);
      if (!std::isfinite(value))
        continue;
      const int count = ++counts[static_cast<std::size_t>(i)];
      const double before = count > 1 ? mean->GetComponent(i / parts, part) : 0.0;
      mean->SetComponent(i / parts, part, before + (value - before) / count);
    }
  }

  vtkSmartPointer<vtkImageData> image_;
  std::vector<std::vector<int>> counts_; ///< of each array, a number for each value
  int steps_ = 0;
};

/// Tells the filter which array is meant, as --color-by would be. Returns its name.
std::string chooseArray(
  vtkMoteMeridionalAverage* filter, const std::vector<NamedData>& data, const std::string& text)
{
  ArrayChoice choice;
  for (std::size_t k = 0; k < data.size() && !choice; ++k)
    choice = findArray(data[k].data, text);
  filter->SetArrayName(choice ? choice.name : text);
  if (!choice || text == choice.name)
    return filter->GetArrayName();
  const bool isPrefixed = text.starts_with("cell:") || text.starts_with("point:");
  if (isPrefixed)
    filter->SetAssociation(choice.ofCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                                          : vtkDataObject::FIELD_ASSOCIATION_POINTS);
  if (!isPrefixed || text.substr(text.find(':') + 1) != choice.name)
    filter->SetComponent(choice.component == ArrayChoice::magnitude
                           ? vtkMoteMeridionalAverage::MAGNITUDE
                           : choice.component);
  return choice.name;
}

/// Where and how finely is averaged.
void aimFilter(vtkMoteMeridionalAverage* filter, const AverageSettings& wanted)
{
  if (!wanted.axial.empty())
    filter->SetAxialRange(wanted.axial.data());
  if (!wanted.radial.empty())
    filter->SetRadialRange(wanted.radial.data());
  filter->SetResolution(wanted.resolution);
  filter->SetAxisFromInput(wanted.axis.empty() && wanted.origin.empty());
  if (!wanted.axis.empty())
    filter->SetAxis(wanted.axis.data());
  if (!wanted.origin.empty())
    filter->SetOrigin(wanted.origin.data());
}

/// Averages one step, and notes what it means.
void averageStep(vtkMoteMeridionalAverage* filter, OpenedInput& opened, Meaning& meaning)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  std::vector<std::string> known;
  const std::vector<NamedData> data = opened.read();
  meaning.array = chooseArray(filter, data, opened.settings.average.array);
  for (const NamedData& one : data)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), one.data);
    known.push_back(listArrays(one.data));
    if (meaning.unit.empty())
      meaning.unit = unitText(unitOf(one.data, meaning.array));
    if (meaning.lengthUnit.empty())
      meaning.lengthUnit = unitText(lengthUnitOf(one.data));
  }
  if (meaning.timeUnit.empty())
    meaning.timeUnit = timeUnitOf(data);
  filter->SetInputData(blocks);
  {
    ProgressRelay::Work work(opened.progress, "Averaging", filter);
    filter->Update();
    work.finish();
  }
  Messages::takeError(); // the filter keeps it
  if (const std::string& error = filter->GetErrorMessage(); !error.empty())
    throw Failure(
      opened.input.name() + ": " + error +
      (error.starts_with("there is no array") && !known.empty() ? "; it has " + known.front()
                                                                : ""));
}

} // namespace

void average(const Settings& settings)
{
  const std::string& output = settings.output.file;
  const std::string& over = settings.chart.over;
  const bool isTable = isTableFile(output);
  if (!isTable && !isChartFile(output))
    throw Failure("cannot write " + output +
                  ": the name must end in .csv for a table, or .png, .jpg, .tif, .exr or .svg for "
                  "a picture");
  checkOutput(output, settings.data.files);
  OpenedInput opened(settings);
  vtkNew<vtkMoteMeridionalAverage> filter;
  aimFilter(filter, settings.average);
  Meaning meaning;
  MeanOfSteps mean;
  vtkSmartPointer<vtkTable> all;
  opened.forSteps(
    [&](int step)
    {
      averageStep(filter, opened, meaning);
      if (over.empty() && !isTable)
        return mean.add(filter->GetImage(), step);
      vtkSmartPointer<vtkTable> table = vtkSmartPointer<vtkTable>::New();
      table->DeepCopy(
        over.empty() ? filter->GetOutput() : profileOf(filter->GetOutput(), over).Get());
      if (settings.output.allSteps)
        table = withTime(table, opened.timeOf(step));
      if (!appendRows(all, table))
        throw Failure(opened.input.name() + ": time step " + std::to_string(step + 1) +
                      " has an array of other components");
    });
  meaning.caption = opened.chartCaption();
  if (isTable)
    writeTable(all, output);
  else if (over.empty())
  {
    if (mean.steps() > 1)
      meaning.caption += "   mean of " + counted(mean.steps(), "time step");
    writePicture(mean.image(), settings, meaning);
  }
  else
  {
    Chart chart = profileChart(all, meaning.array, meaning.unit, settings);
    chart.xTitle = withUnit(over, meaning.lengthUnit);
    chart.caption = meaning.caption;
    if (!chart.colorTitle.empty())
      chart.colorTitle = withUnit(chart.colorTitle, meaning.timeUnit);
    writeChart(chart, output);
  }
}

} // namespace mote::app
