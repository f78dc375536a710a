// Distributions over the volume whose quantiles are known.

#include "MeshTools.h"

#include <vtkCellData.h>
#include <vtkMoteVolumeQuantiles.h>
#include <vtkMultiBlockDataSet.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

class VolumeQuantiles : public testing::Test
{
protected:
  void look(vtkDataObject* data, const char* array)
  {
    filter->SetInputDataObject(data);
    filter->SetArrayName(array);
    filter->Update();
  }
  vtkNew<vtkMoteVolumeQuantiles> filter;
};

/// Cells of other sizes: the cube's places drawn towards one corner.
Vec squeezed(Vec p)
{
  return {p[0] * p[0], p[1] * (0.3 + 0.7 * p[1]), p[2]};
}

void addCellField(vtkUnstructuredGrid* grid, const char* name, const std::function<double(Vec)>& f)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    double b[6];
    grid->GetCellBounds(i, b);
    array->InsertNextValue(f({0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5])}));
  }
  grid->GetCellData()->AddArray(array);
}

} // namespace

TEST_F(VolumeQuantiles, OfALinearFieldAreLinearWhateverTheCells)
{
  const Grid grid = block(24, squeezed);
  addField(grid, "x", 1, [](Vec p) { return Vec{10.0 + 2.0 * p[0]}; });
  this->look(grid, "x");
  for (const double share : {0.05, 0.25, 0.5, 0.9})
    EXPECT_NEAR(filter->GetQuantile(share), 10.0 + 2.0 * share, 2.0 / 12) << share;
  EXPECT_EQ(filter->GetQuantile(0.0), 10.0);
  EXPECT_EQ(filter->GetQuantile(1.0), 12.0);
  vtkTable* table = filter->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 101);
  EXPECT_EQ(valueAt(table, 50, "share"), 0.5);
  EXPECT_EQ(valueAt(table, 50, "value"), filter->GetQuantile(0.5));
}

TEST_F(VolumeQuantiles, OfCellsCountTheirVolume)
{
  const Grid grid = block(20, squeezed);
  addCellField(grid, "side", [](Vec p) { return p[0] < 0.25 ? 1.0 : 2.0; });
  filter->OfCellsOn();
  this->look(grid, "side");
  EXPECT_EQ(filter->GetQuantile(0.24), 1.0);
  EXPECT_EQ(filter->GetQuantile(0.26), 2.0);
}

TEST_F(VolumeQuantiles, OfVectorsAndOfSeveralParts)
{
  const Grid first = block(4, [](Vec p) { return p; });
  const Grid second = block(8, [](Vec p) { return Vec{p[0] + 5.0, p[1], 3.0 * p[2]}; });
  for (const Grid& grid : {first, second})
    addField(grid, "v", 3,
      [](Vec p) {
        return p[0] < 3.0 ? Vec{3.0, 0.0, -4.0} : Vec{0.0, 7.0, 0.0};
      });
  vtkNew<vtkMultiBlockDataSet> both;
  both->SetBlock(0, first);
  both->SetBlock(1, second);
  filter->SetComponent(-1);
  this->look(both, "v");
  EXPECT_EQ(filter->GetQuantile(0.24), 5.0) << "a quarter of the volume";
  EXPECT_EQ(filter->GetQuantile(0.26), 7.0);
  filter->SetComponent(2);
  filter->Update();
  EXPECT_EQ(filter->GetQuantile(0.0), -4.0);
  EXPECT_EQ(filter->GetQuantile(1.0), 0.0);
}

TEST_F(VolumeQuantiles, LeaveOutWhatIsNoNumberAndTakeAPartOfLargeMeshes)
{
  const Grid grid = block(20, [](Vec p) { return p; });
  addField(grid, "x", 1, [](Vec p) { return Vec{p[0] > 0.5 ? std::nan("") : p[0]}; });
  this->look(grid, "x");
  EXPECT_EQ(filter->GetQuantile(1.0), 0.5);
  EXPECT_NEAR(filter->GetQuantile(0.5), 0.25, 0.05);
  addField(grid, "y", 1, [](Vec p) { return Vec{p[1]}; });
  filter->SetMaximumNumberOfCells(777);
  this->look(grid, "y");
  for (const double share : {0.1, 0.5, 0.9})
    EXPECT_NEAR(filter->GetQuantile(share), share, 0.06) << share;
}

TEST_F(VolumeQuantiles, OfNothingAreNone)
{
  const Grid grid = block(2, [](Vec p) { return p; });
  this->look(grid, "nothing");
  EXPECT_TRUE(std::isnan(filter->GetQuantile(0.5)));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
  addField(grid, "nan", 1, [](Vec) { return Vec{std::nan("")}; });
  this->look(grid, "nan");
  EXPECT_TRUE(std::isnan(filter->GetQuantile(0.5)));
}
