#include "Probe.h"

#include "ChartFile.h"
#include "OpenedInput.h"
#include "TableFile.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "stage/Arrays.h"
#include "stage/Part.h"

#include <kernels/hexahedra/HexMesh.h>

#include <vtkCharArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkLineSource.h>
#include <vtkMath.h>
#include <vtkMoteColorLegend.h>
#include <vtkMoteCylindricalLocator.h>
#include <vtkMoteImageAxes.h>
#include <vtkMoteImageWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProbeFilter.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>

namespace mote::app
{

namespace
{

/// The columns of the table in their order; values are NaN until they are known.
class LineTable
{
public:
  explicit LineTable(vtkDataSet* line)
    : rows_(line->GetNumberOfPoints())
  {
    vtkDoubleArray* distance = this->column("distance");
    vtkDoubleArray* place[3] = {this->column("x"), this->column("y"), this->column("z")};
    double start[3];
    line->GetPoint(0, start);
    for (vtkIdType i = 0; i < rows_; ++i)
    {
      double p[3];
      line->GetPoint(i, p);
      distance->SetValue(i, std::sqrt(vtkMath::Distance2BetweenPoints(start, p)));
      for (int k = 0; k < 3; ++k)
        place[k]->SetValue(i, p[k]);
    }
    parts_->SetName("part");
    parts_->SetNumberOfValues(rows_);
    table_->AddColumn(parts_);
  }

  /// Takes a part's values at the points that lie in it and in no part before.
  void add(const std::string& name, vtkPointData* values)
  {
    auto* valid = vtkCharArray::SafeDownCast(values->GetArray("vtkValidPointMask"));
    if (!valid)
      return;
    std::vector<vtkIdType> mine;
    for (vtkIdType i = 0; i < rows_; ++i)
      if (valid->GetValue(i) && parts_->GetValue(i).empty())
        mine.push_back(i);
    for (const vtkIdType i : mine)
      parts_->SetValue(i, name);
    for (int a = 0; a < values->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = values->GetArray(a);
      const std::string heading = nameOf(array);
      if (heading.empty() || array == valid)
        continue;
      const int components = array->GetNumberOfComponents();
      for (int k = 0; k < components; ++k)
      {
        const char* component = array->GetComponentName(k);
        vtkDoubleArray* column = this->column(
          heading + (components == 1 ? "" : ":" + (component ? component : std::to_string(k))));
        for (const vtkIdType i : mine)
          column->SetValue(i, array->GetComponent(i, k));
      }
    }
  }

  vtkTable* table() const { return table_; }

  /// Where the points lie along the line.
  vtkDataArray* distances() const
  {
    return vtkDataArray::SafeDownCast(table_->GetColumnByName("distance"));
  }

  /// The values of one choice along the line; NaN where there are none.
  vtkSmartPointer<vtkDoubleArray> values(
    const ArrayChoice& choice, const std::string& heading) const
  {
    auto values = vtkSmartPointer<vtkDoubleArray>::New();
    values->SetNumberOfValues(rows_);
    std::vector<vtkDataArray*> parts;
    for (vtkIdType c = 0; c < table_->GetNumberOfColumns(); ++c)
      if (const std::string name = table_->GetColumnName(c);
          name == heading || (heading == choice.name && name.starts_with(heading + ":")))
        parts.push_back(vtkDataArray::SafeDownCast(table_->GetColumn(c)));
    for (vtkIdType i = 0; i < rows_; ++i)
    {
      double squares = 0.0;
      for (vtkDataArray* part : parts)
        squares += std::pow(part->GetComponent(i, 0), 2);
      values->SetValue(
        i, parts.size() == 1 ? parts.front()->GetComponent(i, 0) : std::sqrt(squares));
    }
    return values;
  }

  bool anyInside() const
  {
    for (vtkIdType i = 0; i < rows_; ++i)
      if (!parts_->GetValue(i).empty())
        return true;
    return false;
  }

private:
  vtkDoubleArray* column(const std::string& name)
  {
    if (auto* known = vtkDoubleArray::SafeDownCast(table_->GetColumnByName(name.c_str())))
      return known;
    vtkNew<vtkDoubleArray> made;
    made->SetName(name.c_str());
    made->SetNumberOfValues(rows_);
    made->Fill(std::nan(""));
    table_->AddColumn(made);
    return made;
  }

  vtkIdType rows_;
  vtkNew<vtkTable> table_;
  vtkNew<vtkStringArray> parts_;
};

/// The heading of a component's column, or the array's name for one without components and for a
/// magnitude.
std::string headingOf(vtkDataArray* array, const std::string& name, int component)
{
  if (array->GetNumberOfComponents() == 1 || component == ArrayChoice::magnitude)
    return name;
  const char* known = array->GetComponentName(component);
  return name + ":" + (known ? known : std::to_string(component));
}

/// The array that a picture shows: what the user says, else the most telling.
struct Shown
{
  ArrayChoice choice;
  std::string heading, title, unit, lengthUnit;
};

Shown shownOf(const std::vector<NamedData>& data, const std::string& asked)
{
  for (const NamedData& one : data)
  {
    const auto ranked = rankedArrays(one.data);
    const ArrayChoice choice = !asked.empty()   ? findArray(one.data, asked)
                               : ranked.empty() ? ArrayChoice()
                                                : ranked.front();
    if (vtkDataArray* array = arrayOf(one.data, choice))
      return {choice, headingOf(array, choice.name, choice.component), describe(one.data, choice),
        unitOf(one.data, choice.name), lengthUnitOf(one.data)};
  }
  throw Failure(asked.empty()
                  ? "there are no values to draw"
                  : "there is no array " + asked + "; there are " + listArrays(data.front().data));
}

/// From the least to the greatest value with some air, or as the user says.
void chooseRange(vtkDataArray* values, const std::vector<double>& asked, double range[2])
{
  if (asked.size() == 2)
  {
    std::copy(asked.begin(), asked.end(), range);
    return;
  }
  values->GetFiniteRange(range, 0);
  const double width = range[1] - range[0];
  const double air = width > 0.0 ? 0.04 * width : std::max(0.1 * std::abs(range[0]), 1e-12);
  range[0] -= air;
  range[1] += air;
}

/// The values over the distance along the line.
void drawLine(
  const LineTable& table, const Shown& shown, const Settings& settings, const std::string& caption)
{
  constexpr int width = 1280, height = 800;
  const auto values = table.values(shown.choice, shown.heading);
  const double scale = settings.picture.fontScale;
  const int letter = vtkMoteImageAxes::LabelSize(width, height, scale);
  double range[2], along[2] = {0.0, 1.0};
  table.distances()->GetFiniteRange(along, 0);
  if (!(along[0] < along[1]))
    throw Failure("--from and --to are one point: there is no line to draw values along");
  chooseRange(values, settings.color.range, range);
  if (!(range[0] < range[1]))
    throw Failure("no point of the line has a finite value of " + shown.title);
  vtkNew<vtkMoteImageAxes> axes;
  axes->SetInputData(whitePaper(width, height));
  axes->SetFrame(7 * letter, width - 2 * letter, 6 * letter + 10, height - 2 * letter);
  axes->SetFontScale(scale);
  axes->SetXRange(along);
  axes->SetYRange(range);
  const auto place = [](const std::vector<double>& at)
  { return asNumber(at[0]) + ", " + asNumber(at[1]) + ", " + asNumber(at[2]); };
  axes->SetXTitle(withUnit("distance", shown.lengthUnit) + " from " + place(settings.probe.from));
  axes->SetYTitle(settings.picture.title.value_or(withUnit(shown.title, shown.unit)));
  axes->AddCurve(table.distances(), values, 0.12, 0.35, 0.65);
  vtkNew<vtkMoteColorLegend> labelled; // for the caption
  labelled->SetInputConnection(axes->GetOutputPort());
  labelled->SetFontScale(scale);
  labelled->SetCaption(caption);
  writeChart(labelled, settings.output.file);
}

/// Whether Mote's locator finds all cells, and sooner than VTK's own search: to build it takes as
/// long as that does for about a point for 50 cells.
bool isWorthALocator(vtkDataSet* data, vtkIdType points)
{
  const vtkIdType cells = data->GetNumberOfCells();
  if (points <= cells / 50)
    return false;
  for (vtkIdType i = 0; i < cells; ++i)
    if (collapsedCorners(data->GetCellType(i)).points == 0)
      return false;
  return true;
}

} // namespace

void probe(const Settings& settings)
{
  const std::string& output = settings.output.file;
  const bool isPicture = vtkMoteImageWriter::CanWriteFile(output.c_str());
  checkOutput(output, settings.data.files);
  OpenedInput opened(settings);
  const int points = settings.probe.points;
  vtkNew<vtkLineSource> line;
  line->SetPoint1(settings.probe.from.data());
  line->SetPoint2(settings.probe.to.data());
  line->SetResolution(points - 1);
  line->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  line->Update();
  LineTable table(line->GetOutput());
  vtkNew<vtkMoteCylindricalLocator> locator;
  vtkIdType cells = 0;
  const std::vector<NamedData> data = opened.read();
  for (const NamedData& one : data)
  {
    cells += Part::isMesh(one.data) ? one.data->GetNumberOfCells() : 0;
    vtkNew<vtkProbeFilter> filter;
    filter->SetInputConnection(line->GetOutputPort());
    filter->SetSourceData(one.data);
    if (isWorthALocator(one.data, points))
      filter->SetCellLocatorPrototype(locator);
    ProgressRelay::Work work(opened.progress, "Probing " + one.name, filter);
    filter->Update();
    work.finish();
    table.add(one.name, filter->GetOutput()->GetPointData());
  }
  if (const std::string error = Messages::takeError(); !error.empty())
    throw Failure(error);
  if (cells == 0)
    throw Failure(opened.input.name() + " holds no cells, in which values could be looked up");
  if (!table.anyInside())
    throw Failure("no point of the line lies in a cell of " + opened.input.name());
  if (isPicture)
    drawLine(table, shownOf(data, settings.color.array), settings, opened.caption());
  else
    writeTable(table.table(), output);
}

} // namespace mote::app
