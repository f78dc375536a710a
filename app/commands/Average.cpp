#include "Average.h"

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
#include <vtkMoteImageWriter.h>
#include <vtkMoteMeridionalAverage.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace mote::app
{

namespace
{

bool isTable(const std::string& file)
{
  return file.empty() || lowerCase(std::filesystem::path(file).extension().string()) == ".csv";
}

/// The bins as squares of one size in a picture 1280 pixels wide and at most 960 high, over white.
vtkSmartPointer<vtkImageData> drawn(
  vtkImageData* bins, vtkDataArray* values, vtkLookupTable* colors)
{
  constexpr int width = 1280, left = 40, right = 300, below = 60, above = 40;
  const int* bounds = bins->GetDimensions();
  const double pixel = std::max(static_cast<double>(bounds[0]) / (width - left - right),
    static_cast<double>(bounds[1]) / (960 - below - above));
  // The legend needs some height, too.
  const int height = std::max(480, static_cast<int>(bounds[1] / pixel) + below + above);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  vtkNew<vtkFloatArray> pixels;
  pixels->SetName("color");
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(image->GetNumberOfPoints());
  pixels->Fill(1.0);
  for (int y = 0; y < static_cast<int>(bounds[1] / pixel); ++y)
    for (int x = 0; x < static_cast<int>(bounds[0] / pixel); ++x)
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
  image->GetPointData()->SetScalars(pixels);
  return image;
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

void writePicture(vtkImageData* bins, const Settings& settings, const std::string& caption)
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
  vtkNew<vtkMoteColorLegend> legend;
  legend->SetInputData(drawn(bins, column, colors));
  legend->SetLookupTable(colors);
  legend->SetTitle(settings.picture.title.value_or(column->GetName()));
  applyLook(legend, settings.picture);
  legend->SetCaption(caption);
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetFileName(settings.output.file.c_str());
  writer->SetInputConnection(legend->GetOutputPort());
  Messages::takeError();
  if (!writer->Write())
    throw Failure(writer->GetErrorMessage());
}

} // namespace

void average(const Settings& settings)
{
  const AverageSettings& wanted = settings.average;
  if (!isTable(settings.output.file) &&
      !vtkMoteImageWriter::CanWriteFile(settings.output.file.c_str()))
    throw Failure("cannot write " + settings.output.file +
                  ": the name must end in .csv for a table, or .png, .jpg, .tif or .exr for a "
                  "picture");
  checkOutput(settings.output.file, settings.data.files);
  OpenedInput opened(settings);
  vtkNew<vtkMultiBlockDataSet> blocks;
  std::vector<std::string> known;
  for (const NamedData& one : opened.read())
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), one.data);
    known.push_back(listArrays(one.data));
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
  const std::vector<double>& times = opened.input.times();
  if (isTable(settings.output.file))
    writeTable(filter->GetOutput(), settings.output.file);
  else
    writePicture(filter->GetImage(), settings,
      name + (times.empty() ? "" : ", t = " + asNumber(times[opened.step], 10)));
}

} // namespace mote::app
