// Particles of a periodic box: wrapped they lie in it, unwrapped they lie where their image numbers
// say, and both differ from what was read by whole edges.

#include <vtkMotePeriodicPositions.h>

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

constexpr int many = 10000; // several blocks
constexpr double origin[3] = {-3.0, 10.0, 1e4};
constexpr double edges[3][3] = {{4.0, 0.0, 0.0}, {1.5, 3.0, 0.0}, {-0.5, 1.0, 5.0}}; // triclinic

/// Points at known shares of the edges, some boxes away.
struct Sample
{
  vtkNew<vtkPolyData> data;
  std::vector<std::array<double, 3>> shares; ///< in the box
  std::vector<std::array<int, 3>> images;    ///< how many boxes away
};

std::array<double, 3> placeOf(const std::array<double, 3>& share)
{
  std::array<double, 3> place{};
  for (int axis = 0; axis < 3; ++axis)
  {
    place[axis] = origin[axis];
    for (int v = 0; v < 3; ++v)
      place[axis] += share[v] * edges[v][axis];
  }
  return place;
}

void makeSample(Sample& sample, int type, bool isAway)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  vtkNew<vtkIntArray> images[3];
  for (int i = 0; i < many; ++i)
  {
    std::array<double, 3> share{};
    std::array<int, 3> image{};
    for (int v = 0; v < 3; ++v)
    {
      share[v] = 0.02 + 0.96 * std::abs(std::sin(1.0 + i * (v + 1.3)));
      image[v] = (i / (v + 2)) % 5 - 2;
      images[v]->InsertNextValue(image[v]);
    }
    std::array<double, 3> at = share;
    for (int v = 0; isAway && v < 3; ++v)
      at[v] += image[v];
    points->InsertNextPoint(placeOf(at).data());
    sample.shares.push_back(share);
    sample.images.push_back(image);
  }
  sample.data->SetPoints(points);
  const char* const names[] = {"ix", "iy", "iz"};
  for (int v = 0; v < 3; ++v)
  {
    images[v]->SetName(names[v]);
    sample.data->GetPointData()->AddArray(images[v]);
  }
  vtkNew<vtkDoubleArray> box, from;
  box->SetName("box");
  from->SetName("box_origin");
  for (int i = 0; i < 9; ++i)
    box->InsertNextValue(edges[i / 3][i % 3]);
  for (double value : origin)
    from->InsertNextValue(value);
  sample.data->GetFieldData()->AddArray(box);
  sample.data->GetFieldData()->AddArray(from);
}

void setBoundary(vtkPolyData* data, const char* boundary)
{
  vtkNew<vtkStringArray> text;
  text->SetName("boundary");
  text->InsertNextValue(boundary);
  data->GetFieldData()->AddArray(text);
}

/// The largest distance of the points from where share(i) says that they lie.
template <typename Share>
double largestError(vtkPolyData* data, const Share& share)
{
  double largest = 0.0;
  for (int i = 0; i < many; ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    const std::array<double, 3> right = placeOf(share(i));
    for (int axis = 0; axis < 3; ++axis)
      largest = std::max(largest, std::abs(point[axis] - right[axis]));
  }
  return largest;
}

} // namespace

TEST(PeriodicPositions, WrappedPointsLieInTheBox)
{
  for (const int type : {VTK_DOUBLE, VTK_FLOAT})
  {
    Sample sample;
    makeSample(sample, type, true);
    const vtkSmartPointer<vtkPoints> before = sample.data->GetPoints();
    ASSERT_EQ(vtkMotePeriodicPositions::Move(sample.data, vtkMotePeriodicPositions::WRAPPED), "");
    EXPECT_EQ(sample.data->GetPoints()->GetDataType(), type);
    EXPECT_NE(sample.data->GetPoints(), before.Get()) << "others still look at those";
    EXPECT_LT(largestError(sample.data, [&](int i) { return sample.shares[i]; }),
      type == VTK_DOUBLE ? 1e-10 : 3e-3);
  }
}

TEST(PeriodicPositions, WallsAreNotCrossed)
{
  Sample sample;
  makeSample(sample, VTK_DOUBLE, true);
  setBoundary(sample.data, "pp fm pp");
  ASSERT_EQ(vtkMotePeriodicPositions::Move(sample.data, vtkMotePeriodicPositions::WRAPPED), "");
  const auto share = [&](int i)
  {
    std::array<double, 3> at = sample.shares[i];
    at[1] += sample.images[i][1];
    return at;
  };
  EXPECT_LT(largestError(sample.data, share), 1e-10);
}

TEST(PeriodicPositions, UnwrappingUndoesWrapping)
{
  Sample sample;
  makeSample(sample, VTK_DOUBLE, true);
  vtkNew<vtkMotePeriodicPositions> wrap, unwrap;
  wrap->SetInputData(sample.data);
  unwrap->SetInputConnection(wrap->GetOutputPort());
  unwrap->SetModeToUnwrapped();
  unwrap->Update();
  const auto away = [&](int i)
  {
    std::array<double, 3> at = sample.shares[i];
    for (int v = 0; v < 3; ++v)
      at[v] += sample.images[i][v];
    return at;
  };
  auto* output = vtkPolyData::SafeDownCast(unwrap->GetOutput());
  EXPECT_LT(largestError(output, away), 1e-10);
  EXPECT_NE(output->GetPointData()->GetArray("ix"), nullptr);
}

TEST(PeriodicPositions, WhatIsMissingIsTold)
{
  Sample sample;
  makeSample(sample, VTK_DOUBLE, false);
  sample.data->GetPointData()->RemoveArray("iy");
  EXPECT_NE(
    vtkMotePeriodicPositions::Move(sample.data, vtkMotePeriodicPositions::UNWRAPPED).find("'iy'"),
    std::string::npos);
  sample.data->GetFieldData()->RemoveArray("box");
  EXPECT_NE(
    vtkMotePeriodicPositions::Move(sample.data, vtkMotePeriodicPositions::WRAPPED).find("box"),
    std::string::npos);
}

TEST(PeriodicPositions, PositionsThatAreNoNumbersStaySo)
{
  Sample sample;
  makeSample(sample, VTK_DOUBLE, false);
  sample.data->GetPoints()->SetPoint(7, std::numeric_limits<double>::quiet_NaN(), 11.0, 1e4);
  ASSERT_EQ(vtkMotePeriodicPositions::Move(sample.data, vtkMotePeriodicPositions::WRAPPED), "");
  EXPECT_TRUE(std::isnan(sample.data->GetPoint(7)[0]));
}
