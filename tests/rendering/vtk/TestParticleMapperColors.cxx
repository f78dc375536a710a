// Colours of particles against those that VTK's own mapper gives to the same points. Unlit, so that
// a pixel shows its particle's colour.
#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace mote::testing;

namespace
{

const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

/// 40 by 30 particles, every one of which covers pixels of its own.
class Colors : public ::testing::Test
{
protected:
  static constexpr int columns = 40, rows = 30, number = columns * rows;

  Colors()
    : data(makeParticles(balls()))
    , stage(data, true)
  {
    stage.renderer->GetActiveCamera()->SetPosition(0.5 * (columns - 1), 0.5 * (rows - 1), 10);
    stage.renderer->GetActiveCamera()->SetFocalPoint(0.5 * (columns - 1), 0.5 * (rows - 1), 0);
    stage.renderer->GetActiveCamera()->SetParallelScale(0.5 * rows);
    stage.actor->GetProperty()->SetAmbient(1);
    stage.actor->GetProperty()->SetDiffuse(0);
    reference->SetInputData(data);
  }

  static std::vector<Ball> balls()
  {
    std::vector<Ball> all;
    for (int i = 0; i < number; ++i)
      all.push_back({double(i % columns), double(i / columns), 0, 0.5});
    return all;
  }

  /// Values evenly over a range, its ends included, then some of any kind.
  static std::vector<double> ramp(double from, double to, const std::vector<double>& others = {})
  {
    std::vector<double> values;
    const int even = number - static_cast<int>(others.size());
    for (int i = 0; i < even; ++i)
      values.push_back(i == even - 1 ? to : from + (to - from) * i / (even - 1));
    values.insert(values.end(), others.begin(), others.end());
    return values;
  }

  void setUp(const std::function<void(vtkMapper*)>& set)
  {
    set(stage.mapper);
    set(reference);
  }
  void use(vtkScalarsToColors* table)
  {
    setUp([&](vtkMapper* m) { m->SetLookupTable(table); });
  }

  /// Compares all particles; `tolerance` in parts of 255.
  void compare(double tolerance = 1.01)
  {
    vtkUnsignedCharArray* expected = reference->MapScalars(1.0);
    ASSERT_NE(expected, nullptr);
    ASSERT_EQ(expected->GetNumberOfTuples(), number);
    const Picture picture = stage.trace(columns * 4, rows * 4);
    std::vector<bool> seen(number, false);
    int wrong = 0;
    for (int pixel = 0; pixel < picture.count(); ++pixel)
    {
      const long long id = picture.particle(pixel);
      if (id < 0)
        continue;
      seen[id] = true;
      unsigned char c[4];
      expected->GetTypedTuple(id, c);
      const float* got = picture.color(pixel);
      double worst = std::abs(255.0 * got[3] - c[3]);
      for (int k = 0; k < 3; ++k) // the picture's are premultiplied
        worst = std::max(worst, std::abs(255.0 * got[k] - c[k] * c[3] / 255.0));
      if (worst > tolerance && wrong++ < 3)
        ADD_FAILURE() << "particle " << id << " of value " << stage.mapper->GetParticleValue(id)
                      << ": " << 255 * got[0] << " " << 255 * got[1] << " " << 255 * got[2] << " "
                      << 255 * got[3] << " instead of " << +c[0] << " " << +c[1] << " " << +c[2]
                      << " " << +c[3];
    }
    EXPECT_EQ(wrong, 0) << "pixels";
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), number);
  }

  vtkSmartPointer<vtkPolyData> data;
  Stage stage;
  vtkNew<vtkPolyDataMapper> reference;
};

vtkSmartPointer<vtkColorTransferFunction> rainbow(vtkColorTransferFunction* function)
{
  function->AddRGBPoint(0, 0.1, 0.0, 0.5);
  function->AddRGBPoint(0.3, 0.0, 0.8, 0.7);
  function->AddRGBPoint(0.35, 0.9, 0.9, 0.2);
  function->AddRGBPoint(1, 0.6, 0.0, 0.0);
  return function;
}

} // namespace

TEST_F(Colors, DefaultTable)
{
  addValues(data, "v", ramp(-0.5, 1.5, {notANumber, infinity, -infinity}));
  compare();
}

TEST_F(Colors, TablesOfSeveralSizes)
{
  addValues(data, "v", ramp(-1, 3, {notANumber, 0, 2, 1}));
  for (const int size : {1, 2, 3, 7, 16, 255, 256, 257, 1000, 70000})
  {
    SCOPED_TRACE(size);
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(size);
    table->SetHueRange(0.7, 0);
    table->SetAlphaRange(0.5, 1);
    table->Build();
    setUp([](vtkMapper* m) { m->SetScalarRange(0, 2); });
    use(table);
    compare();
  }
}

TEST_F(Colors, BelowAboveAndNanColours)
{
  addValues(data, "v", ramp(-1, 3, {notANumber, 0, 2, infinity, -infinity}));
  for (int flags = 0; flags < 4; ++flags)
  {
    SCOPED_TRACE(flags);
    vtkNew<vtkLookupTable> table;
    table->SetUseBelowRangeColor(flags & 1);
    table->SetUseAboveRangeColor(flags & 2);
    table->SetBelowRangeColor(1, 0, 1, 0.5);
    table->SetAboveRangeColor(0, 1, 1, 1);
    table->SetNanColor(0.2, 0.4, 0.6, 0.8);
    setUp([](vtkMapper* m) { m->SetScalarRange(0, 2); });
    use(table);
    compare();
  }
}

TEST_F(Colors, LogarithmicTable)
{
  vtkNew<vtkLookupTable> table;
  table->SetScaleToLog10();
  for (const bool outside : {false, true})
  {
    // What has no logarithm is below the range for Mote; VTK gives it the first entry even where
    // there is a colour for values below.
    addValues(data, "v", ramp(outside ? 0.02 : -0.1, 120, {notANumber, 0.01, 0.1, 1, 100}));
    table->SetUseBelowRangeColor(outside);
    table->SetUseAboveRangeColor(outside);
    setUp([](vtkMapper* m) { m->SetScalarRange(0.1, 100); });
    use(table);
    compare();
  }
}

TEST_F(Colors, LogarithmicTableOverNegativeRange)
{
  addValues(data, "v", ramp(-120, -0.05));
  vtkNew<vtkLookupTable> table;
  table->SetScaleToLog10();
  setUp([](vtkMapper* m) { m->SetScalarRange(-100, -0.1); });
  use(table);
  compare();
}

TEST_F(Colors, RangeWithoutWidth)
{
  for (const auto& values : {std::vector<double>(number, 5.0), ramp(4, 6, {5, 5, 5})})
  {
    addValues(data, "v", values);
    vtkNew<vtkLookupTable> table;
    setUp([](vtkMapper* m) { m->SetScalarRange(5, 5); });
    use(table);
    compare();
  }
}

TEST_F(Colors, TheTablesOwnRange)
{
  addValues(data, "v", ramp(-1, 3));
  vtkNew<vtkLookupTable> table;
  table->SetTableRange(0.25, 1.75);
  setUp([](vtkMapper* m) { m->UseLookupTableScalarRangeOn(); });
  use(table);
  compare();
}

TEST_F(Colors, TransferFunctions)
{
  addValues(data, "v", ramp(-0.2, 1.2, {notANumber, 0, 1}));
  for (int space = VTK_CTF_RGB; space <= VTK_CTF_DIVERGING; ++space)
    for (int flags = 0; flags < 4; ++flags)
    {
      SCOPED_TRACE(10 * space + flags);
      vtkNew<vtkColorTransferFunction> function;
      rainbow(function);
      function->SetColorSpace(space);
      function->SetUseBelowRangeColor(flags & 1);
      function->SetUseAboveRangeColor(flags & 2);
      function->SetBelowRangeColor(1, 0, 1);
      function->SetAboveRangeColor(0, 1, 1);
      function->SetNanColor(0.2, 0.4, 0.6);
      use(function);
      compare();
    }
}

TEST_F(Colors, TransferFunctionWithoutClamping)
{
  addValues(data, "v", ramp(-0.2, 1.2, {notANumber, 0, 1}));
  vtkNew<vtkColorTransferFunction> function;
  rainbow(function);
  function->ClampingOff();
  use(function);
  compare();
}

TEST_F(Colors, LogarithmicTransferFunction)
{
  addValues(data, "v", ramp(0.05, 120, {notANumber, 0.1, 1, 100}));
  vtkNew<vtkColorTransferFunction> function;
  function->AddRGBPoint(0.1, 0, 0, 1);
  function->AddRGBPoint(2, 0, 1, 0);
  function->AddRGBPoint(100, 1, 0, 0);
  function->SetScaleToLog10();
  use(function);
  compare();
}

TEST_F(Colors, TransferFunctionWithSharpSteps)
{
  addValues(data, "v", ramp(0, 1, {0.4995, 0.4997, 0.5003, 0.5005}));
  vtkNew<vtkColorTransferFunction> function;
  function->AddRGBPoint(0, 0, 0, 1, 0.4711, 1.0); // a step
  function->AddRGBPoint(0.49995, 0, 1, 0);
  function->AddRGBPoint(0.50005, 1, 0, 0);
  function->AddRGBPoint(1, 1, 1, 1);
  use(function);
  compare();
}

TEST_F(Colors, DiscretizableFunctions)
{
  std::vector<double> nearSteps = {notANumber, 0, 1};
  for (const int steps : {3, 7, 10, 256})
    for (int i = 1; i < steps; ++i)
      for (const double beside : {-1e-5, 1e-5})
        nearSteps.push_back(double(i) / steps + beside);
  addValues(data, "v", ramp(-0.2, 1.2, nearSteps));
  for (const int steps : {0, 1, 3, 7, 10, 256})
  {
    SCOPED_TRACE(steps);
    vtkNew<vtkDiscretizableColorTransferFunction> function;
    rainbow(function);
    function->SetDiscretize(steps > 0);
    function->SetNumberOfValues(std::max(1, steps));
    function->Build();
    use(function);
    compare();
    function->SetUseBelowRangeColor(1);
    function->SetUseAboveRangeColor(1);
    function->SetBelowRangeColor(1, 0, 1);
    function->SetAboveRangeColor(0, 1, 1);
    function->Build();
    compare();
  }
}

TEST_F(Colors, DiscretizableLogarithmicFunction)
{
  addValues(data, "v", ramp(0.05, 120, {notANumber, 0.1, 1, 100}));
  vtkNew<vtkDiscretizableColorTransferFunction> function;
  function->AddRGBPoint(0.1, 0, 0, 1);
  function->AddRGBPoint(100, 1, 0, 0);
  function->DiscretizeOn();
  function->SetNumberOfValues(6);
  function->SetUseLogScale(1);
  function->Build();
  use(function);
  compare();
}

TEST_F(Colors, IndexedLookup)
{
  std::vector<double> values;
  for (int i = 0; i < number; ++i)
    values.push_back(i % 7);
  addValues(data, "v", values);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(4);
  table->Build();
  table->IndexedLookupOn();
  for (int i = 0; i < 5; ++i)
    table->SetAnnotation(vtkVariant(i), "kind");
  table->SetNanColor(1, 1, 0, 1);
  use(table);
  compare();
  table->SetTableValue(1, 1, 1, 1, 1);
  compare();
}

TEST_F(Colors, DirectBytes)
{
  for (const int components : {1, 2, 3, 4})
  {
    SCOPED_TRACE(components);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("colours");
    colors->SetNumberOfComponents(components);
    for (int i = 0; i < number * components; ++i)
      colors->InsertNextValue(static_cast<unsigned char>((i * 37) % 256));
    data->GetPointData()->SetScalars(colors);
    compare();
    setUp([](vtkMapper* m) { m->SetColorModeToMapScalars(); });
    setUp([](vtkMapper* m) { m->SetScalarRange(0, 255); });
    compare();
    setUp([](vtkMapper* m) { m->SetColorModeToDefault(); });
  }
}

TEST_F(Colors, DirectFloats)
{
  vtkNew<vtkFloatArray> colors;
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < number * 3; ++i)
    colors->InsertNextValue(static_cast<float>((i * 37) % 256) / 255.0f);
  data->GetPointData()->SetScalars(colors);
  setUp([](vtkMapper* m) { m->SetColorModeToDirectScalars(); });
  compare();
}

TEST_F(Colors, ComponentAndMagnitudeOfVectors)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < number; ++i)
    vectors->InsertNextTuple3(std::sin(i), std::cos(0.3 * i), i / 600.0 - 1);
  data->GetPointData()->AddArray(vectors);
  vtkNew<vtkLookupTable> table;
  setUp(
    [](vtkMapper* m)
    {
      m->SetScalarRange(-1, 1);
      m->SetScalarModeToUsePointFieldData();
      m->SelectColorArray("velocity");
    });
  use(table);
  for (int component = 0; component < 3; ++component)
  {
    SCOPED_TRACE(component);
    table->SetVectorModeToComponent();
    table->SetVectorComponent(component);
    compare();
    EXPECT_EQ(stage.mapper->GetParticleValue(7), vectors->GetComponent(7, component));
  }
  table->SetVectorModeToMagnitude();
  compare();
  EXPECT_NEAR(stage.mapper->GetParticleValue(0), std::sqrt(2.0), 1e-12);
  table->SetVectorModeToRGBColors();
  compare();
}

TEST_F(Colors, ArrayComponentOfTheMapper)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < number; ++i)
    vectors->InsertNextTuple3(std::sin(i), std::cos(0.3 * i), i / 600.0 - 1);
  data->GetPointData()->AddArray(vectors);
  for (int component = 0; component < 3; ++component)
  {
    SCOPED_TRACE(component);
    setUp(
      [&](vtkMapper* m)
      {
        m->SetScalarModeToUsePointFieldData();
        m->ColorByArrayComponent("velocity", component);
      });
    compare();
  }
}

TEST_F(Colors, FieldDataOfOneTupleAPoint)
{
  auto* array = addValues(data, "v", ramp(0, 1));
  data->GetFieldData()->AddArray(array);
  data->GetPointData()->RemoveArray("v");
  setUp(
    [](vtkMapper* m)
    {
      m->SetScalarModeToUseFieldData();
      m->SelectColorArray("v");
    });
  compare();
}

TEST_F(Colors, OfTheActorWithoutScalars)
{
  addValues(data, "v", ramp(0, 1));
  stage.actor->GetProperty()->SetColor(0.2, 0.4, 0.8);
  const auto expectPlain = [this]
  {
    const Picture picture = stage.trace();
    const int middle = picture.at(33, 33);
    ASSERT_GE(picture.particle(middle), 0);
    EXPECT_NEAR(picture.color(middle)[0], 0.2, 1e-6);
    EXPECT_NEAR(picture.color(middle)[1], 0.4, 1e-6);
    EXPECT_NEAR(picture.color(middle)[2], 0.8, 1e-6);
    EXPECT_EQ(picture.color(middle)[3], 1);
    EXPECT_TRUE(std::isnan(stage.mapper->GetParticleValue(0)));
    double range[2];
    stage.mapper->GetColorArrayRange(range);
    EXPECT_GT(range[0], range[1]);
  };
  stage.mapper->ScalarVisibilityOff();
  expectPlain();
  stage.mapper->ScalarVisibilityOn();
  stage.mapper->SetScalarModeToUsePointFieldData();
  stage.mapper->SelectColorArray("nothing of this name");
  expectPlain();
  stage.mapper->SetScalarModeToUseCellData();
  expectPlain();
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  names->SetNumberOfValues(number);
  data->GetPointData()->AddArray(names);
  stage.mapper->SetScalarModeToUsePointFieldData();
  stage.mapper->SelectColorArray("names");
  expectPlain();
}

TEST_F(Colors, RangeOfTheArrayLeavesOutWhatIsNotFinite)
{
  addValues(data, "v", ramp(-3, 8, {notANumber, infinity, -infinity}));
  double range[2];
  stage.mapper->GetColorArrayRange(range);
  EXPECT_EQ(range[0], -3);
  EXPECT_EQ(range[1], 8);
  EXPECT_EQ(stage.mapper->GetParticleValue(0), -3);
  EXPECT_TRUE(std::isnan(stage.mapper->GetParticleValue(-1)));
  EXPECT_TRUE(std::isnan(stage.mapper->GetParticleValue(number)));
}
