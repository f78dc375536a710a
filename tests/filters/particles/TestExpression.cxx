// Arrays from expressions: each value is what the expression says of its point or cell.

#include <vtkMoteExpression.h>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSOADataArrayTemplate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

constexpr int many = 5000; // several blocks, the last of them not full

/// Points with a type, an energy and a velocity each.
vtkSmartPointer<vtkPolyData> somePoints()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> types;
  types->SetName("type");
  vtkNew<vtkFloatArray> energies;
  energies->SetName("potential energy");
  vtkNew<vtkSOADataArrayTemplate<double>> velocities; // which is no block of memory
  velocities->SetName("v");
  velocities->SetNumberOfComponents(3);
  velocities->SetNumberOfTuples(many);
  for (int c = 0; c < 3; ++c)
    velocities->SetComponentName(c, c == 0 ? "vx" : c == 1 ? "vy" : "vz");
  for (int i = 0; i < many; ++i)
  {
    points->InsertNextPoint(1e9 + i, std::sin(i), 0.25 * i);
    types->InsertNextValue(i % 4);
    energies->InsertNextValue(static_cast<float>(std::cos(0.1 * i)));
    for (int c = 0; c < 3; ++c)
      velocities->SetTypedComponent(i, c, std::sin(i + 0.5 * c));
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(types);
  data->GetPointData()->AddArray(energies);
  data->GetPointData()->AddArray(velocities);
  return data;
}

using Reference = std::function<double(vtkPolyData*, vtkIdType)>;

double value(vtkPolyData* data, const char* array, vtkIdType i, int component = 0)
{
  return data->GetPointData()->GetArray(array)->GetComponent(i, component);
}

double speed(vtkPolyData* data, vtkIdType i)
{
  double square = 0.0;
  for (int c = 0; c < 3; ++c)
    square += value(data, "v", i, c) * value(data, "v", i, c);
  return std::sqrt(square);
}

struct Case
{
  const char* expression;
  Reference reference;
};

const Case cases[] = {
  {"x", [](vtkPolyData* d, vtkIdType i) { return d->GetPoint(i)[0]; }},
  {"x - 1e9 + 2*z^2", [](vtkPolyData*, vtkIdType i) { return i + 2.0 * 0.0625 * i * i; }},
  {"type", [](vtkPolyData*, vtkIdType i) { return double(i % 4); }},
  {"-type^2", [](vtkPolyData*, vtkIdType i) { return -double((i % 4) * (i % 4)); }},
  {"type == 2 || type == 3 && z > 100", [](vtkPolyData*, vtkIdType i)
    { return double(i % 4 == 2 || (i % 4 == 3 && 0.25 * double(i) > 100.0)); }},
  {"!(type >= 1)", [](vtkPolyData*, vtkIdType i) { return double(i % 4 < 1); }},
  {"type != 1 ? 10 : 20", [](vtkPolyData*, vtkIdType i) { return i % 4 != 1 ? 10.0 : 20.0; }},
  {"abs('potential energy')",
    [](vtkPolyData* d, vtkIdType i) { return std::abs(value(d, "potential energy", i)); }},
  {"\"potential energy\" * 2 + 'potential energy'",
    [](vtkPolyData* d, vtkIdType i) { return 3.0 * value(d, "potential energy", i); }},
  {"v.x + v.2", [](vtkPolyData* d, vtkIdType i) { return value(d, "v", i) + value(d, "v", i, 2); }},
  {"'v'.y", [](vtkPolyData* d, vtkIdType i) { return value(d, "v", i, 1); }},
  {"v.vy - vy", [](vtkPolyData*, vtkIdType) { return 0.0; }},
  {"v", [](vtkPolyData* d, vtkIdType i) { return speed(d, i); }},
  {"v.magnitude / max(1, 2, 3)", [](vtkPolyData* d, vtkIdType i) { return speed(d, i) / 3.0; }},
  {"mag(v) + mag (v.x)",
    [](vtkPolyData* d, vtkIdType i) { return speed(d, i) + std::abs(value(d, "v", i)); }},
  {"2 * pi", [](vtkPolyData*, vtkIdType) { return 2.0 * 3.14159265358979323846; }},
};

std::string problemOf(const std::string& expression)
{
  return vtkMoteExpression::AddTo(somePoints(), expression, "result");
}

} // namespace

TEST(Expression, IsWhatItSaysOfEachPoint)
{
  const auto data = somePoints();
  for (const auto& [expression, reference] : cases)
  {
    ASSERT_EQ(vtkMoteExpression::AddTo(data, expression, "result"), "") << expression;
    vtkDataArray* result = data->GetPointData()->GetArray("result");
    ASSERT_NE(result, nullptr);
    ASSERT_EQ(result->GetNumberOfTuples(), many);
    for (vtkIdType i = 0; i < many; ++i)
      ASSERT_DOUBLE_EQ(result->GetComponent(i, 0), reference(data, i)) << expression << " at " << i;
  }
}

TEST(Expression, HasTheTypeThatIsAskedFor)
{
  const auto data = somePoints();
  data->GetPointData()->GetArray("type")->SetComponent(3, 0, 0.0);
  const char* expression = "type > 0 ? sqrt(-1) * 0 + ln(type - 5) : 7"; // nan but where it is 0
  ASSERT_EQ(vtkMoteExpression::AddTo(data, expression, "double"), "");
  ASSERT_EQ(vtkMoteExpression::AddTo(data, expression, "float", VTK_FLOAT), "");
  ASSERT_EQ(vtkMoteExpression::AddTo(data, expression, "holds", VTK_UNSIGNED_CHAR), "");
  EXPECT_EQ(data->GetPointData()->GetArray("double")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(data->GetPointData()->GetArray("float")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(data->GetPointData()->GetArray("holds")->GetDataType(), VTK_UNSIGNED_CHAR);
  for (vtkIdType i = 0; i < many; ++i)
  {
    const bool isNumber = value(data, "type", i) == 0.0;
    EXPECT_EQ(std::isnan(value(data, "double", i)), !isNumber);
    EXPECT_EQ(value(data, "holds", i), isNumber ? 1.0 : 0.0) << i;
  }
  EXPECT_NE(vtkMoteExpression::AddTo(data, "x", "int", VTK_INT), "");
}

TEST(Expression, OfGridsAndOfCells)
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(4, 5, 6);
  grid->SetSpacing(0.5, 2.0, 1.0);
  ASSERT_EQ(vtkMoteExpression::AddTo(grid, "x + 10*y + 100*z", "place"), "");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* at = grid->GetPoint(i);
    EXPECT_EQ(grid->GetPointData()->GetArray("place")->GetComponent(i, 0),
      at[0] + 10.0 * at[1] + 100.0 * at[2]);
  }
  vtkNew<vtkDoubleArray> pressure;
  pressure->SetName("p");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    pressure->InsertNextValue(static_cast<double>(i));
  grid->GetCellData()->AddArray(pressure);
  ASSERT_EQ(vtkMoteExpression::AddTo(grid, "p / 2", "half"), "");
  EXPECT_EQ(grid->GetPointData()->GetArray("half"), nullptr);
  ASSERT_EQ(grid->GetCellData()->GetArray("half")->GetNumberOfTuples(), grid->GetNumberOfCells());
  EXPECT_EQ(grid->GetCellData()->GetArray("half")->GetComponent(7, 0), 3.5);
  EXPECT_NE(vtkMoteExpression::AddTo(grid, "p + x", "mixed"), "") << "of points and of cells";
}

TEST(Expression, DerivativesOfALinearFieldAreExact)
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(5, 4, 6);
  grid->SetSpacing(0.5, 0.25, 1.0);
  grid->SetOrigin(10.0, -3.0, 2.0);
  const vtkIdType points = grid->GetNumberOfPoints(), cells = grid->GetNumberOfCells();
  vtkNew<vtkDoubleArray> velocity, pressure, count;
  velocity->SetName("U");
  velocity->SetNumberOfComponents(3);
  pressure->SetName("p'"); // which wants the other quotes
  count->SetName("n");
  for (vtkIdType i = 0; i < points; ++i)
  {
    const double* at = grid->GetPoint(i);
    // A rotation at 2 about z, and what flows away at 0.5.
    velocity->InsertNextTuple3(-2.0 * at[1] + 0.5 * at[0], 2.0 * at[0] + 0.5 * at[1], 0.5 * at[2]);
    pressure->InsertNextValue(3.0 * at[0] - at[2]);
  }
  for (vtkIdType i = 0; i < cells; ++i)
    count->InsertNextValue(7.0);
  grid->GetPointData()->AddArray(velocity);
  grid->GetPointData()->AddArray(pressure);
  grid->GetCellData()->AddArray(count);
  const auto isEverywhere = [&](const char* expression, double expected)
  {
    ASSERT_EQ(vtkMoteExpression::Check(expression), "");
    ASSERT_EQ(vtkMoteExpression::AddTo(grid, expression, "result"), "") << expression;
    for (vtkIdType i = 0; i < points; ++i)
      ASSERT_NEAR(grid->GetPointData()->GetArray("result")->GetComponent(i, 0), expected, 1e-9)
        << expression << " at " << i;
  };
  isEverywhere("vorticity(U).z", 4.0);
  isEverywhere("vorticity( U )", 4.0);
  isEverywhere("divergence(U)", 1.5);
  isEverywhere("q_criterion('U') * 2 + vorticity(U).x", 2.0 * (4.0 - 0.5 * 0.75));
  isEverywhere("gradient(\"p'\").x", 3.0);
  isEverywhere("gradient(\"p'\").z + gradient(U).1", -3.0);
  EXPECT_EQ(grid->GetPointData()->GetArray("vorticity(U)"), nullptr) << "only what was asked for";
  ASSERT_EQ(vtkMoteExpression::AddTo(grid, "n + gradient(n)", "slope"), "");
  EXPECT_NEAR(grid->GetCellData()->GetArray("slope")->GetComponent(5, 0), 7.0, 1e-9);
  const auto problem = [&](const char* expression)
  { return vtkMoteExpression::AddTo(grid, expression, "wrong"); };
  EXPECT_NE(problem("vorticity(n)").find("three components"), std::string::npos);
  EXPECT_NE(problem("vorticity(nothing)").find("'nothing'"), std::string::npos);
  EXPECT_NE(vtkMoteExpression::Check("vorticity(U"), "");
  EXPECT_NE(vtkMoteExpression::Check("vorticity('U"), "");
  EXPECT_NE(vtkMoteExpression::AddTo(somePoints(), "gradient(x)", "wrong"), "");
}

TEST(Expression, InCellsPointsCountByTheirMean)
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(4, 5, 6);
  grid->SetSpacing(0.5, 2.0, 1.0);
  vtkNew<vtkDoubleArray> ofPoints, ofCells;
  ofPoints->SetName("a");
  ofCells->SetName("b");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    ofPoints->InsertNextValue(std::sin(static_cast<double>(i)));
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    ofCells->InsertNextValue(static_cast<double>(i));
  grid->GetPointData()->AddArray(ofPoints);
  grid->GetCellData()->AddArray(ofCells);
  ASSERT_EQ(vtkMoteExpression::AddToCells(grid, "a * b + 10 * y", "both"), "");
  EXPECT_EQ(grid->GetPointData()->GetArray("both"), nullptr);
  vtkDataArray* both = grid->GetCellData()->GetArray("both");
  ASSERT_EQ(both->GetNumberOfTuples(), grid->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double a = 0.0, y = 0.0;
    grid->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      a += ofPoints->GetValue(corners->GetId(i)) / 8.0;
      y += grid->GetPoint(corners->GetId(i))[1] / 8.0;
    }
    EXPECT_NEAR(both->GetComponent(cell, 0), a * static_cast<double>(cell) + 10.0 * y, 1e-9);
  }
  EXPECT_NE(vtkMoteExpression::AddToCells(grid, "c + 1", "no"), "");
}

TEST(Expression, WrongOnesAreToldWithWhatIsThere)
{
  EXPECT_EQ(vtkMoteExpression::Check("type == 2 && anything"), "");
  const auto has = [](const std::string& text, const std::string& part)
  { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(problemOf("energy > 2"), "potential energy")) << problemOf("energy > 2");
  EXPECT_TRUE(has(problemOf("v.w"), "'v.w'")) << problemOf("v.w");
  EXPECT_TRUE(has(problemOf("type = 2"), "==")) << problemOf("type = 2");
  EXPECT_TRUE(has(problemOf("type & 2"), "&&")) << problemOf("type & 2");
  EXPECT_TRUE(has(problemOf("type == 1 | type == 2"), "||"));
  EXPECT_TRUE(has(problemOf("'potential energy > 2"), "quote"));
  EXPECT_TRUE(has(problemOf("2 * length(v)"), "there is no function length"));
  EXPECT_TRUE(has(problemOf("'v'1 + 'v'"), "after 'v' stands 1")) << problemOf("'v'1 + 'v'");
  EXPECT_TRUE(has(problemOf("'v'v.x"), "after 'v' stands v.x"));
  EXPECT_TRUE(has(problemOf("quoted_name_7"), "there is no array 'quoted_name_7'"));
  for (const char* wrong : {"", "  ", "type +", "(type", "type 2", "type, x", "f(type)", "#", "=="})
    EXPECT_NE(vtkMoteExpression::Check(wrong), "") << wrong;
  EXPECT_EQ(vtkMoteExpression::AddTo(nullptr, "1", "one"), "there is no data set");
  // Texts of files and sessions may be long, and their letters of several bytes.
  for (const std::string letter : {"q", "\u00e9"})
    for (int lead = 0; lead < 2; ++lead)
    {
      std::string text(static_cast<std::size_t>(lead), '1');
      while (text.size() < 100'000)
        text += letter;
      const std::string problem = problemOf("'" + text + "' > 2");
      EXPECT_LT(problem.size(), 2300u);
      EXPECT_TRUE(has(problem, text.substr(0, 100)));
      EXPECT_TRUE(has(problem, letter + "...': there is no array '")) << problem.substr(150, 100);
    }
}

TEST(Expression, AnArrayMayBeCalledMag)
{
  const auto data = somePoints();
  data->GetPointData()->GetArray("type")->SetName("mag");
  ASSERT_EQ(vtkMoteExpression::AddTo(data, "mag > 1 && (x > 0)", "result"), "");
  EXPECT_EQ(value(data, "result", 2), 1.0);
  ASSERT_EQ(vtkMoteExpression::AddTo(data, "mag(v) - v + 'mag'", "result"), "");
  EXPECT_EQ(value(data, "result", 3), 3.0);
}

TEST(Expression, TheFilterLeavesItsInputAsItIs)
{
  const auto data = somePoints();
  vtkNew<vtkMoteExpression> filter;
  filter->SetInputData(data);
  filter->SetExpression("type * 2");
  filter->SetResultArrayName("twice");
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  ASSERT_NE(output, nullptr);
  ASSERT_NE(output->GetPointData()->GetArray("twice"), nullptr);
  EXPECT_EQ(output->GetPointData()->GetArray("twice")->GetComponent(3, 0), 6.0);
  EXPECT_EQ(output->GetPoints(), data->GetPoints());
  EXPECT_EQ(data->GetPointData()->GetArray("twice"), nullptr);
  // Without points there is nothing to tell.
  vtkNew<vtkPolyData> none;
  EXPECT_EQ(vtkMoteExpression::AddTo(none, "x > 2", "right"), "");
}
