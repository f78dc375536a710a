// Hiding particles by value.
#include "VTKTestSupport.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace mote::testing;

namespace
{

struct Visibility : ::testing::Test
{
  std::vector<Ball> balls = someBalls(300);
  std::vector<double> values;
  vtkSmartPointer<vtkPolyData> data = makeParticles(balls);
  Stage stage{data};

  Visibility()
  {
    for (int i = 0; i < 300; ++i)
      values.push_back(i % 10);
    values[5] = std::numeric_limits<double>::quiet_NaN();
    addValues(data, "value", values);
    addValues(data, "other", std::vector<double>(300, 1.0), false);
  }

  /// The picture must be that of a mapper which was never given the hidden particles.
  void expectOnly(const std::function<bool(int)>& shown)
  {
    std::vector<Ball> some;
    std::vector<long long> ids;
    for (int i = 0; i < 300; ++i)
      if (shown(i))
      {
        some.push_back(balls[i]);
        ids.push_back(i);
      }
    Stage subset(makeParticles(some));
    std::vector<long long> expected = subset.trace(96, 96).particles();
    for (long long& id : expected)
      id = id < 0 ? id : ids[id];
    const std::vector<long long> got = stage.trace(96, 96).particles();
    int wrong = 0;
    for (std::size_t i = 0; i < got.size(); ++i)
      wrong += got[i] != expected[i] ? 1 : 0;
    EXPECT_LE(wrong, 1) << "pixels"; // float coordinates about another origin
  }
};

} // namespace

TEST_F(Visibility, ShowsAllAtFirst)
{
  expectOnly([](int) { return true; });
}

TEST_F(Visibility, RangeOfTheColouringArrayWithBothEnds)
{
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityRange(3, 6);
  expectOnly([this](int i) { return values[i] >= 3 && values[i] <= 6; });
  stage.mapper->SetVisibilityRange(0, 0);
  expectOnly([this](int i) { return values[i] == 0; });
  stage.mapper->UseVisibilityRangeOff();
  expectOnly([](int) { return true; });
  EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 300);
}

TEST_F(Visibility, HidesNaN)
{
  const double infinity = std::numeric_limits<double>::infinity();
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityRange(-infinity, infinity);
  expectOnly([](int i) { return i != 5; });
}

TEST_F(Visibility, OfAnotherArray)
{
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityArrayName("radius");
  stage.mapper->SetVisibilityRange(0.1, 0.15);
  expectOnly([this](int i) { return balls[i].r >= 0.1 && balls[i].r <= 0.15; });
  stage.mapper->SetVisibilityArrayName("other");
  stage.mapper->SetVisibilityRange(2, 3);
  expectOnly([](int) { return false; });
}

TEST_F(Visibility, FollowsValuesChangedInPlace)
{
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityRange(3, 6);
  stage.trace();
  values[0] = 4;
  values[3] = 9;
  vtkDataArray* array = data->GetPointData()->GetArray("value");
  array->SetTuple1(0, 4);
  array->SetTuple1(3, 9);
  array->Modified();
  expectOnly([this](int i) { return values[i] >= 3 && values[i] <= 6; });
}

TEST_F(Visibility, SurvivesARebuild)
{
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityRange(3, 6);
  stage.trace();
  data->GetPoints()->Modified();
  expectOnly([this](int i) { return values[i] >= 3 && values[i] <= 6; });
}

TEST_F(Visibility, ComponentOrMagnitudeOfAVector)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < 300; ++i)
    vectors->InsertNextTuple3(i % 3, i % 5, 0);
  data->GetPointData()->AddArray(vectors);
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityArrayName("velocity");
  stage.mapper->SetVisibilityRange(2, 2.5);
  expectOnly([](int i) { return i % 3 == 2; });
  stage.mapper->SetVisibilityComponent(1);
  expectOnly([](int i) { return i % 5 == 2; });
  stage.mapper->SetVisibilityComponent(-1);
  expectOnly(
    [](int i)
    {
      const double v = std::hypot(i % 3, i % 5);
      return v >= 2 && v <= 2.5;
    });
}

TEST_F(Visibility, FollowsTheLookupTablesComponent)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(2);
  for (int i = 0; i < 300; ++i)
    vectors->InsertNextTuple2(i % 3, i % 5);
  data->GetPointData()->SetScalars(vectors);
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityRange(2, 2.5);
  vtkScalarsToColors* table = stage.mapper->GetLookupTable();
  table->SetVectorModeToComponent();
  expectOnly([](int i) { return i % 3 == 2; });
  table->SetVectorComponent(1);
  expectOnly([](int i) { return i % 5 == 2; });
}

TEST_F(Visibility, MissingArrayIsAnErrorOnce)
{
  Complaints complaints(stage.mapper);
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityArrayName("nothing");
  stage.trace();
  stage.trace();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("\"nothing\""), std::string::npos) << complaints.text;
  stage.mapper->SetVisibilityArrayName(nullptr);
  stage.mapper->ScalarVisibilityOff();
  stage.trace();
  EXPECT_EQ(complaints.errors, 2) << "nothing colours, so nothing can hide";
}

TEST_F(Visibility, UnfitArrayIsAnErrorOnce)
{
  addValues(data, "short", {1, 2, 3}, false);
  Complaints complaints(stage.mapper);
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityArrayName("short");
  stage.trace();
  stage.trace();
  EXPECT_EQ(complaints.errors, 1) << complaints.text;
  stage.mapper->SetVisibilityArrayName("radius");
  stage.mapper->SetVisibilityComponent(1);
  stage.trace();
  stage.trace();
  EXPECT_EQ(complaints.errors, 2) << "no component 1";
}

TEST_F(Visibility, HiddenParticlesKeepTheirPlaceInTheBounds)
{
  const std::array<double, 6> all = [this]
  {
    std::array<double, 6> b;
    stage.mapper->GetBounds(b.data());
    return b;
  }();
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityRange(100, 200);
  std::array<double, 6> hidden;
  stage.mapper->GetBounds(hidden.data());
  EXPECT_EQ(hidden, all) << "so that the camera does not jump";
}
