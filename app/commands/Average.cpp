#include "Average.h"

#include "TableFile.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "stage/Arrays.h"
#include "stage/ColorMaps.h"
#include "stage/Input.h"

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

#include <CLI/CLI.hpp>

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
vtkDataArray* columnOf(vtkImageData* bins, const AverageOptions& options)
{
  const std::string& asked = options.given.settings.color.array;
  vtkPointData* columns = bins->GetPointData();
  const std::string magnitude = options.array + "_magnitude";
  const std::string name = !asked.empty()                         ? asked
                           : columns->HasArray(magnitude.c_str()) ? magnitude
                                                                  : options.array;
  if (vtkDataArray* column = columns->GetArray(name.c_str()))
    return column;
  throw Failure("the average has no column " + name + " to colour by; it has " + listArrays(bins));
}

void writePicture(vtkImageData* bins, const AverageOptions& options, const std::string& caption)
{
  vtkDataArray* column = columnOf(bins, options);
  double range[2];
  if (options.given.settings.color.range.size() == 2)
    std::copy(
      options.given.settings.color.range.begin(), options.given.settings.color.range.end(), range);
  else
    column->GetFiniteRange(range, 0);
  if (!(range[0] < range[1]))
    range[1] = range[0] + 1.0;
  const std::string map =
    options.given.settings.color.map.empty() ? "viridis" : options.given.settings.color.map;
  const auto colors = makeColorMap(map, range, options.given.settings.color.logarithmic);
  vtkNew<vtkMoteColorLegend> legend;
  legend->SetInputData(drawn(bins, column, colors));
  legend->SetLookupTable(colors);
  legend->SetTitle(column->GetName());
  legend->SetCaption(caption);
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetFileName(options.output.c_str());
  writer->SetInputConnection(legend->GetOutputPort());
  Messages::takeError();
  if (!writer->Write())
    throw Failure(writer->GetErrorMessage());
}

} // namespace

void addAverageOptions(CLI::App& app, AverageOptions& options)
{
  addFiles(app, options.given.settings);
  addSettings(app, options.given, {"Data"});
  app
    .add_option("--array,-a", options.array,
      "Array to average, on points or cells: of numbers, or of vectors, of which the parts along "
      "axis, radius and circumference are averaged")
    ->required()
    ->type_name("NAME");
  app
    .add_option("--output,-o", options.output,
      "Table to write, .csv, or picture, .png, .jpg or .tif: along the axis to the right, away "
      "from "
      "it upwards. By default the table goes to standard output")
    ->type_name("FILE");
  app.add_option("--resolution", options.resolution, "Bins along the longer edge")
    ->check(CLI::Range(1, 4096).description(""))
    ->capture_default_str()
    ->type_name("N");
  addVectorOption(
    app, "--axis", options.axis, "Direction of the axis. By default what the data say, else z");
  addVectorOption(app, "--origin", options.origin,
    "A point of the axis. By default what the data say, else 0,0,0");
  addSettings(app, options.given, {"Colour"});
  app.get_option("--color-by")->description("Column of the table that colours the picture");
  app.get_option("--color-map")->description("Colours: " + joined(colorMapNames(), ", "));
}

void average(const AverageOptions& options)
{
  checkOutput(options.output, options.given.settings.data.files);
  TerminalProgress terminal;
  ProgressRelay progress;
  progress.add(terminal);
  Input input(options.given.settings.data.files);
  input.open(progress);
  const int step = input.chosenStep(options.given.settings);
  vtkNew<vtkMultiBlockDataSet> blocks;
  std::vector<std::string> known;
  for (const NamedData& one : input.read(step, progress))
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), one.data);
    known.push_back(listArrays(one.data));
  }
  vtkNew<vtkMoteMeridionalAverage> filter;
  filter->SetInputData(blocks);
  filter->SetArrayName(options.array);
  filter->SetResolution(options.resolution);
  filter->SetAxisFromInput(!options.axis && !options.origin);
  if (options.axis)
    filter->SetAxis(options.axis->data());
  if (options.origin)
    filter->SetOrigin(options.origin->data());
  {
    ProgressRelay::Work work(progress, "Averaging", filter);
    filter->Update();
    work.finish();
  }
  Messages::takeError(); // the filter keeps it
  if (const std::string& error = filter->GetErrorMessage(); !error.empty())
    throw Failure(
      input.name() + ": " + error +
      (error.starts_with("there is no array") && !known.empty() ? "; it has " + known.front()
                                                                : ""));
  if (isTable(options.output))
    writeTable(filter->GetOutput(), options.output);
  else
    writePicture(filter->GetImage(), options,
      input.name() + (input.times().empty() ? "" : ", t = " + asNumber(input.times()[step], 10)));
}

} // namespace mote::app
