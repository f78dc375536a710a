// Opacities that mote chooses: rare values opaque, common ones faint.

#include <stage/Opacity.h>

#include <gtest/gtest.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>
#include <functional>

using namespace mote::app;

namespace
{

/// 10,000 voxels in a row with a field along it, from 0 to 1.
vtkSmartPointer<vtkImageData> row(const std::function<double(double)>& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(10001, 2, 2);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    values->InsertNextValue(field(image->GetPoint(i)[0] / 10000.0));
  image->GetPointData()->AddArray(values);
  return image;
}

double opacityAt(const std::vector<OpacityPoint>& points, double value)
{
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (value >= points[i].value && value <= points[i + 1].value)
      return points[i].opacity + (points[i + 1].opacity - points[i].opacity) *
                                   (value - points[i].value) /
                                   (points[i + 1].value - points[i].value);
  return 0.0;
}

const ArrayChoice f{"f", 0, false};

} // namespace

TEST(UsualOpacity, HidesWhatIsCommonWhateverTheUnits)
{
  for (const double unit : {1e-9, 1.0, 1e12})
  {
    // Nearly all of the volume is about 0.5; a hundredth reaches far away, on both sides.
    const auto data = row(
      [unit](double t) {
        return unit * (t < 0.005 ? -100.0 : t > 0.995 ? 200.0 : 0.5 + 0.01 * std::sin(9 * t));
      });
    const auto points = opacitiesFor({data}, f);
    EXPECT_GT(opacityAt(points, -99.0 * unit), 0.5);
    EXPECT_GT(opacityAt(points, 199.0 * unit), 0.5);
    EXPECT_LT(opacityAt(points, 0.5 * unit), 0.05);
    for (std::size_t i = 1; i < points.size(); ++i)
      EXPECT_GT(points[i].value, points[i - 1].value);
  }
}

TEST(UsualOpacity, TheLeastValueIsFaintWhereMuchHasIt)
{
  const auto points = opacitiesFor({row([](double t) { return std::max(0.0, t - 0.6); })}, f);
  EXPECT_EQ(points.front().value, 0.0);
  EXPECT_LT(points.front().opacity, 0.05) << "six tenths of the volume";
  EXPECT_GT(points.back().opacity, 0.5);
}

TEST(UsualOpacity, OneValueIsSeenAndNoneGivesNone)
{
  const auto same = opacitiesFor({row([](double) { return 7.0; })}, f);
  ASSERT_EQ(same.size(), 1u);
  EXPECT_EQ(same.front().value, 7.0);
  EXPECT_GT(same.front().opacity, 0.0);
  EXPECT_TRUE(opacitiesFor({row([](double) { return std::nan(""); })}, f).empty());
  EXPECT_TRUE(opacitiesFor({}, f).empty());
}

TEST(UsualOpacity, IsKeptUntilDataChange)
{
  UsualOpacity usual;
  const auto data = row([](double t) { return t; });
  const OpacityPoint* first = usual.of({data}, f).data();
  EXPECT_EQ(usual.of({data}, f).data(), first);
  vtkDataArray* values = data->GetPointData()->GetArray("f");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    values->SetTuple1(i, 2.0 * values->GetTuple1(i));
  values->Modified();
  EXPECT_EQ(usual.of({data}, f).back().value, 2.0);
}

TEST(UsualOpacity, IsOfferedWithTheDataThatItWasFoundOf)
{
  const auto one = row([](double t) { return t; });
  const auto other = row([](double t) { return 10.0 * t; });
  UsualOpacity opacity;
  opacity.of({one}, f);
  const UsualOpacity::Found found = opacity.foundOf({one});
  EXPECT_TRUE(found.choice == f);
  EXPECT_FALSE(found.points.empty());
  EXPECT_TRUE(opacity.foundOf({other}).points.empty()) << "another step's";

  UsualOpacity later;
  later.offer({other}, UsualOpacity::Found());
  EXPECT_TRUE(later.foundOf({other}).points.empty());
  later.offer({one}, found);
  EXPECT_EQ(later.foundOf({one}).points.size(), found.points.size());
  one->Modified();
  EXPECT_TRUE(later.foundOf({one}).points.empty()) << "data that changed";
}
