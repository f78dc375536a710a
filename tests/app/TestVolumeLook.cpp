// What volumes look like where the user leaves it open: walls, and a slice.

#include "stage/VolumeLook.h"

#include <gtest/gtest.h>

#include <vtkDoubleArray.h>
#include <vtkHexahedron.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

using namespace mote::app;

namespace
{

/// Adds a block of cells to a grid.
void addBlock(vtkUnstructuredGrid* grid, const double low[3], const double high[3])
{
  constexpr int side = 8;
  for (int cell = 0; cell < side * side * side; ++cell)
  {
    vtkIdType points[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      const int at[3] = {
        (corner == 1 || corner == 2 || corner == 5 || corner == 6), corner % 4 >= 2, corner >= 4};
      const int cells[3] = {cell % side, cell / side % side, cell / side / side};
      double point[3];
      for (int k = 0; k < 3; ++k)
        point[k] = low[k] + (high[k] - low[k]) * (cells[k] + at[k]) / side;
      points[corner] = grid->GetPoints()->InsertNextPoint(point);
    }
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, points);
  }
}

vtkSmartPointer<vtkUnstructuredGrid> blocks(
  std::initializer_list<std::array<std::array<double, 3>, 2>> all)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  for (const auto& block : all)
    addBlock(grid, block[0].data(), block[1].data());
  return grid;
}

ShowRange at(const std::string& name, double place)
{
  return {name, {{place, place}}};
}

} // namespace

TEST(VolumeLook, TheSliceLiesAcrossTheShortestSideInTheMiddle)
{
  EXPECT_EQ(fullestSlice({blocks({{{{0, 0, 0}, {4, 4, 1}}}})}), at("z", 0.5));
  EXPECT_EQ(fullestSlice({blocks({{{{-3, 0, 0}, {-2, 4, 4}}}})}), at("x", -2.5));
  EXPECT_EQ(fullestSlice({blocks({{{{0, 0, 0}, {1, 1, 1}}}})}), at("y", 0.5));
  EXPECT_EQ(fullestSlice({blocks({})}), std::nullopt);
}

TEST(VolumeLook, TheSliceLiesWhereThereIsMuch)
{
  // A flat housing on a long pipe.
  const auto pump = blocks({{{{0, 0, 9}, {10, 10, 11}}}, {{{4, 4, 0}, {6, 6, 9}}}});
  const std::optional<ShowRange> slice = fullestSlice({pump});
  ASSERT_TRUE(slice);
  EXPECT_EQ(slice->name, "z");
  EXPECT_GT(slice->intervals.front().low, 9.0);
  EXPECT_LT(slice->intervals.front().low, 11.0);
}

TEST(VolumeLook, AcrossTheAxisTheSliceHasTheAxisInIt)
{
  // A shaft through the middle of a long housing: beside it there is more to be seen.
  const auto housing = blocks({{{{-2, -2, 0}, {2, -1, 9}}}, {{{-2, 1, 0}, {2, 2, 9}}},
    {{{-2, -1, 0}, {-1, 1, 9}}}, {{{1, -1, 0}, {2, 1, 9}}}});
  EXPECT_EQ(fullestSlice({housing}), at("y", 0.0));
}

TEST(VolumeLook, WhatIsAskedForComesInPlaceOfWhatIsChosen)
{
  const ShowRange slice = at("z", 0.5);
  Settings settings;
  const auto look = [&] { return lookInForce(settings, slice); };
  EXPECT_EQ(look().cloud, "off");
  EXPECT_EQ(look().slices, std::vector{slice});
  EXPECT_EQ(look().walls, 1.0);
  EXPECT_EQ(look().nearWalls, 0.0);
  Settings chosen;
  chosen.volume = look();
  EXPECT_EQ(lookInForce(chosen, at("x", 0.1)), look()); // what is chosen is said

  settings.volume.slices = std::vector<ShowRange>(); // nothing within: seen from outside
  EXPECT_EQ(look().nearWalls, 1.0);
  settings = {};
  settings.volume.walls = 0.3;
  EXPECT_EQ(look().nearWalls, 0.3);
  EXPECT_EQ(look().slices->size(), 1u);

  settings = {};
  settings.volume.isoValues = {3.0};
  EXPECT_TRUE(look().slices->empty());
  EXPECT_EQ(look().nearWalls, 0.0);
  EXPECT_EQ(look().cloud, "off");

  settings = {};
  settings.volume.cloud = "on";
  EXPECT_TRUE(look().slices->empty());
  EXPECT_EQ(look().walls, 0.0);
  settings = {};
  settings.volume.opacity = {{0.0, true, 0.5}};
  EXPECT_EQ(look().cloud, "on");
}

TEST(VolumeLook, CellsThatASelectionLeavesAreSeenFromOutside)
{
  const ShowRange slice = at("z", 0.5);
  Settings settings;
  const auto look = [&] { return lookInForce(settings, slice, true); };
  EXPECT_TRUE(look().slices->empty());
  EXPECT_EQ(look().nearWalls, 1.0);
  EXPECT_EQ(look().wallColor, "data");
  settings.volume.wallColor = "#102030";
  EXPECT_EQ(look().wallColor, "#102030");
  settings = {};
  settings.volume.walls = 1.0;
  EXPECT_EQ(look().wallColor, VolumeSettings().wallColor);
  EXPECT_EQ(look().slices, std::vector{slice});
  settings = {};
  settings.volume.slices = {slice};
  EXPECT_EQ(look().nearWalls, 0.0);
  settings = {};
  settings.volume.isoValues = {3.0};
  EXPECT_EQ(look().wallColor, VolumeSettings().wallColor);
  settings = {};
  settings.cuts.ranges = {{"x", {{-HUGE_VAL, 0.25}}}};
  EXPECT_EQ(look().slices, std::vector{at("x", 0.25)});
  EXPECT_EQ(look().nearWalls, 1.0);
}

TEST(VolumeLook, FacesOfCutsAreTheSlices)
{
  Settings settings;
  settings.cuts.ranges = {
    {"x", {{-HUGE_VAL, 0.25}}}, {"r", {{0.0, 2.0}}}, {"angle", {{30.0, 60.0}}}};
  const std::vector<ShowRange> wanted = {
    at("x", 0.25), at("r", 2.0), {"angle", {{30.0, 30.0}, {60.0, 60.0}}}};
  EXPECT_EQ(lookInForce(settings, at("z", 0.5)).slices, wanted);
}
