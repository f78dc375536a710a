#include "Probe.h"

#include "OpenedInput.h"
#include "TableFile.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "stage/Arrays.h"
#include "stage/Part.h"

#include <kernels/hexahedra/HexMesh.h>

#include <vtkCharArray.h>
#include <vtkDoubleArray.h>
#include <vtkLineSource.h>
#include <vtkMath.h>
#include <vtkMoteCylindricalLocator.h>
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
  if (vtkMoteImageWriter::CanWriteFile(output.c_str()))
    throw Failure(
      "mote probe writes a table, such as values.csv, and no picture such as " + output);
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
  for (const NamedData& one : opened.read())
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
  writeTable(table.table(), output);
}

} // namespace mote::app
