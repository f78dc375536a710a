// A scalar on hexahedra keeps its values.

#include <kernels/core/Error.h>
#include <kernels/hexahedra/HangingPoints.h>
#include <kernels/hexahedra/HexField.h>

#include <support/HexMeshes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

using namespace mote;
using namespace mote::testing;

TEST(HexField, KeepsSmallDifferencesOfLargeValues)
{
  const auto mesh = hexBlock(4, 4, 4).mesh();
  std::vector<double> values;
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
    values.push_back(101325.0 + std::sin(double(p)));
  const HexField field(*mesh, {{values.data(), values.size(), 1}});
  for (std::size_t p = 0; p < values.size(); ++p)
    EXPECT_NEAR(field.offset() + field.ofPoint(p), values[p], 1e-7);
  EXPECT_EQ(field.lower(), *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(field.upper(), *std::max_element(values.begin(), values.end()));
}

TEST(HexField, TakesComponentsMagnitudesAndCells)
{
  HexCells cells = hexBlock(2, 1, 1);
  // A cell of another type in front shifts the numbers of those that are kept.
  HexCells mixed;
  mixed.points = cells.points;
  mixed.addCell(static_cast<HexCellType>(42), std::vector<std::int64_t>{0, 1, 2});
  for (int c = 0; c < 2; ++c)
    mixed.addCell(
      HexCellType::Hexahedron, std::vector<std::int64_t>(cells.connectivity.begin() + 8 * c,
                                 cells.connectivity.begin() + 8 * (c + 1)));
  const auto mesh = mixed.mesh();
  ASSERT_EQ(mesh->cellCount(), 2U);
  const float ofCells[] = {7.0F, 1.0F, 5.0F};
  const HexField byCell(*mesh, {{ofCells, 3, 1}, 0, true});
  EXPECT_TRUE(byCell.isOfCells());
  EXPECT_EQ(byCell.offset() + byCell.ofCell(0), 1.0);
  EXPECT_EQ(byCell.offset() + byCell.ofCell(1), 5.0);
  EXPECT_EQ(byCell.lower(), 1.0); // what is left out has no say

  std::vector<double> vectors;
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
    vectors.insert(vectors.end(), {3.0 * double(p), 4.0 * double(p), 0.0});
  const ArrayView view(vectors.data(), mesh->pointCount(), 3);
  const HexField second(*mesh, {view, 1}), length(*mesh, {view, ArrayView::magnitude});
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
  {
    EXPECT_NEAR(second.offset() + second.ofPoint(p), 4.0 * double(p), 1e-5);
    EXPECT_NEAR(length.offset() + length.ofPoint(p), 5.0 * double(p), 1e-5);
  }
}

TEST(HexField, RangesAreTheCornersAndNaNsHaveAll)
{
  const auto mesh = hexBlock(2, 1, 1).mesh();
  std::vector<float> values(mesh->pointCount(), 1.0F);
  values[0] = NAN;
  const HexField field(*mesh, {{values.data(), values.size(), 1}});
  const auto ranges = cellRanges(*mesh, field);
  EXPECT_EQ(ranges[0].upper, INFINITY);
  EXPECT_EQ(ranges[0].lower, -INFINITY);
  EXPECT_EQ(ranges[1].upper + field.offset(), 1.0);
  EXPECT_EQ(ranges[1].lower + field.offset(), 1.0);
  EXPECT_EQ(field.lower(), 1.0);
}

TEST(HexField, RefusesWhatDoesNotFit)
{
  const auto mesh = hexBlock(2, 1, 1).mesh();
  const std::vector<float> values(mesh->pointCount(), 1.0F);
  EXPECT_THROW(HexField(*mesh, {{values.data(), 5, 1}}), Error);
  EXPECT_THROW(HexField(*mesh, {{values.data(), values.size(), 1}, 1}), Error);
  EXPECT_THROW(HexField(*mesh, {{values.data(), values.size(), 1}, 0, true}), Error);
}

TEST(HexField, RefusesARangeThatFloatHasNot)
{
  const auto mesh = hexBlock(1, 1, 1).mesh();
  for (const double large : {1e39, 1.7e308})
  {
    std::vector<double> values(mesh->pointCount(), -large);
    values[0] = large;
    EXPECT_THROW(HexField(*mesh, {{values.data(), values.size(), 1}}), Error);
  }
  const std::vector<double> same(mesh->pointCount(), 1e300);
  EXPECT_EQ(HexField(*mesh, {{same.data(), same.size(), 1}}).ofPoint(0), 0.0F);
}

TEST(HexField, OfNothingButNaNHasNoRange)
{
  const auto mesh = hexBlock(1, 1, 1).mesh();
  const std::vector<float> values(mesh->pointCount(), NAN);
  const HexField field(*mesh, {{values.data(), values.size(), 1}});
  EXPECT_GT(field.lower(), field.upper());
  EXPECT_EQ(field.offset(), 0.0);
}

TEST(HexField, AtPointsHasTheMeansOfTheCellsAround)
{
  // Some cells as one polyhedron, which is drawn in parts and counts once.
  const HexCells plain = hexBlock(5, 4, 3);
  for (const HexCells& cells : {plain, merged(plain, {{0, 1, 2}, {30, 31}})})
  {
    const auto mesh = cells.mesh();
    std::vector<double> values(mesh->report().cells);
    for (std::size_t c = 0; c < values.size(); ++c)
      values[c] = c % 11 == 4 ? NAN : 1e5 + std::sin(double(c));
    const HexField ofCells(*mesh, {{values.data(), values.size(), 1}, 0, true});
    const HexField field = HexField::atPoints(*mesh, ofCells);
    EXPECT_FALSE(field.isOfCells());
    std::vector<std::map<std::size_t, double>> around(mesh->pointCount()); // cells and weights
    for (std::size_t c = 0; c < mesh->cellCount(); ++c)
    {
      Vec3d middle = cellCenter(mesh->corners(c));
      for (const std::uint32_t p : mesh->cell(c))
        if (p >= around.size())
          middle = mesh->point(p);
      for (const std::uint32_t p : mesh->cell(c))
        if (p < around.size() && !std::isnan(values[mesh->inputCell(c)]))
          around[p][mesh->inputCell(c)] = 1.0 / glm::length(mesh->point(p) - middle);
    }
    double lower = INFINITY;
    for (std::size_t p = 0; p < around.size(); ++p)
    {
      double sum = 0.0, weights = 0.0;
      for (const auto& [c, weight] : around[p])
      {
        sum += weight * values[c];
        weights += weight;
      }
      const double mean = sum / weights;
      if (around[p].empty())
        EXPECT_TRUE(std::isnan(field.ofPoint(p)));
      else
        EXPECT_NEAR(field.offset() + field.ofPoint(p), mean, 1e-7);
      lower = around[p].empty() ? lower : std::min(lower, mean);
    }
    EXPECT_NEAR(field.lower(), lower, 1e-7);
    for (std::size_t m = 0; m < mesh->middleCount(); ++m)
    {
      double sum = 0.0;
      for (const std::uint32_t p : mesh->aroundMiddle(m))
        sum += field.ofPoint(p);
      EXPECT_NEAR(
        field.ofPoint(mesh->pointCount() + m), sum / double(mesh->aroundMiddle(m).size()), 1e-6);
    }
  }
}

TEST(HexField, AtPointsIsContinuousWhereCellsOfTwoSizesMeet)
{
  const auto mesh = refinedBlock().mesh();
  const std::vector<HangingPoint> hanging = hangingPointsOf(*mesh);
  std::vector<double> values(mesh->cellCount());
  for (std::size_t c = 0; c < values.size(); ++c)
    values[c] = std::sin(7.0 * double(c));
  const HexField field = HexField::atPoints(
    *mesh, HexField(*mesh, {{values.data(), values.size(), 1}, 0, true}), hanging);
  // Those that lie on a cell, but not in a corner of it, and what the cell has there.
  std::set<std::size_t> expected;
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
    for (std::size_t c = 0; c < mesh->cellCount(); ++c)
    {
      const Box box = boundsOf(mesh->corners(c));
      const Vec3d at = (mesh->point(p) - box.lower) / box.size();
      if (at != glm::clamp(at, 0.0, 1.0) || at == glm::floor(at))
        continue;
      expected.insert(p);
      double sum = 0.0;
      for (const std::uint32_t corner : mesh->cell(c))
      {
        const Vec3d of = (mesh->point(corner) - box.lower) / box.size();
        const Vec3d share = 1.0 - glm::abs(at - of);
        sum += share.x * share.y * share.z * field.ofPoint(corner);
      }
      EXPECT_NEAR(field.ofPoint(p), sum, 1e-6) << p << " on cell " << c;
    }
  EXPECT_EQ(expected.size(), hanging.size());
  EXPECT_GT(hanging.size(), 60U);
  for (const HangingPoint& point : hanging)
  {
    EXPECT_EQ(expected.count(point.point), 1U);
    Vec3d place(0.0);
    for (std::size_t k = 0; k < 4; ++k)
      place += double(point.weights[k]) * mesh->point(point.corners[k]);
    EXPECT_NEAR(glm::length(place - mesh->point(point.point)), 0.0, 1e-6);
  }
}
