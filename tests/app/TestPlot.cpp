// Histograms and scatter plots against counting one by one.

#include <commands/PlotFile.h>
#include <stage/Plot.h>
#include <stage/Stage.h>

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <filesystem>
#include <numeric>

using namespace mote::app;

namespace
{

struct PlotTest : testing::Test
{
  static constexpr int count = 5000;
  Settings settings;
  ProgressRelay progress;
  std::unique_ptr<Stage> stage;
  PickedSet picked;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkFloatArray> a;
  vtkNew<vtkDoubleArray> v;

  PlotTest()
  {
    vtkMath::RandomSeed(5);
    vtkNew<vtkPoints> points;
    a->SetName("a");
    v->SetName("v");
    v->SetNumberOfComponents(3);
    for (int i = 0; i < count; ++i)
    {
      points->InsertNextPoint(vtkMath::Random(), vtkMath::Random(0.0, 2.0), vtkMath::Random());
      a->InsertNextValue(i == 17 ? std::nanf("") : static_cast<float>(vtkMath::Gaussian()));
      v->InsertNextTuple3(vtkMath::Random(), vtkMath::Random(), vtkMath::Random());
    }
    data->SetPoints(points);
    data->GetPointData()->AddArray(a);
    data->GetPointData()->AddArray(v);
  }
  void show()
  {
    stage = std::make_unique<Stage>(settings);
    stage->setData({{"a", data, "a"}});
    stage->build(progress);
    stage->applyColors();
  }
};

} // namespace

TEST_F(PlotTest, CountsEveryValueOnce)
{
  this->show();
  const Plot plot = plotOf(stage->parts(), picked, {{"a", ""}, Plotted::All}, 50, 40);
  EXPECT_EQ(plot.height, 1);
  EXPECT_EQ(plot.total, count - 1); // one is no number
  EXPECT_EQ(plot.what, "particles");
  std::vector<std::uint32_t> truth(50);
  for (int i = 0; i < count; ++i)
    if (const double value = a->GetValue(i); std::isfinite(value))
      ++truth[static_cast<std::size_t>(std::min(
        49.0, std::floor(50.0 * (value - plot.least[0]) / (plot.most[0] - plot.least[0]))))];
  EXPECT_EQ(plot.counts, truth);
}

TEST_F(PlotTest, CountsAndPicturesAreSaved)
{
  const Plot bars{4, 1, {0.0, 0.0}, {2.0, 0.0}, {3, 0, 1, 4}, 4, 8, ""};
  EXPECT_EQ(
    plotText(bars, {{"a", ""}, Plotted::All}), "a from,a to,count\n0,0.5,3\n1,1.5,1\n1.5,2,4\n");
  const Plot pairs{2, 2, {0.0, 10.0}, {1.0, 30.0}, {1, 0, 0, 7}, 7, 8, ""};
  EXPECT_EQ(plotText(pairs, {{"v:1", "a,b"}, Plotted::All}),
    "v:1 from,v:1 to,\"a,b from\",\"a,b to\",count\n0,0.5,10,20,1\n0.5,1,20,30,7\n");
  const std::string file = testing::TempDir() + "plot.png";
  const Plot one{2, 1, {5.0, 0.0}, {5.0, 0.0}, {9, 0}, 9, 9, ""}; // all values are one
  for (const Plot& plot : {bars, pairs, one})
    for (const bool isLogarithmic : {false, true})
    {
      std::filesystem::remove(file);
      writePlotPicture(plot, {{"a", plot.height > 1 ? "b" : ""}}, isLogarithmic, "data", file);
      EXPECT_GT(std::filesystem::file_size(file), 5000u);
    }
}

TEST_F(PlotTest, PairsAreThoseOfThePlaces)
{
  this->show();
  const Plot plot = plotOf(stage->parts(), picked, {{"v:1", "y"}, Plotted::All}, 20, 10);
  ASSERT_EQ(plot.counts.size(), 200u);
  EXPECT_EQ(plot.total, count);
  double place[3];
  std::vector<std::uint32_t> truth(200);
  for (int i = 0; i < count; ++i)
  {
    data->GetPoint(i, place);
    const double x = v->GetComponent(i, 1), y = place[1];
    const auto bin = [&](double value, std::size_t axis, int bins)
    {
      return std::min(bins - 1, static_cast<int>((value - plot.least[axis]) *
                                                 (bins / (plot.most[axis] - plot.least[axis]))));
    };
    ++truth[static_cast<std::size_t>(20 * bin(y, 1, 10) + bin(x, 0, 20))];
  }
  EXPECT_EQ(plot.counts, truth);
}

TEST_F(PlotTest, IsOfTheVisibleOrThePicked)
{
  settings.selection.ranges = {{"x", {{0.0, 0.25}}}};
  settings.selection.hidden = IdRanges({{0, 0, 99}});
  this->show();
  const PlotChoice choice = {{"x", "v:magnitude"}, Plotted::Visible};
  const Plot visible = plotOf(stage->parts(), picked, choice, 20, 10);
  EXPECT_EQ(visible.total, stage->numberShown());
  EXPECT_GT(visible.total, 500);
  for (std::size_t i = 0; i < visible.counts.size(); ++i)
    EXPECT_TRUE(i % 20 <= 5 || visible.counts[i] == 0) << i;
  picked.add({{0, Picked::Kind::Particle, 3}, {0, Picked::Kind::Particle, 4999}});
  EXPECT_EQ(plotOf(stage->parts(), picked, {choice.names, Plotted::Picked}, 20, 10).total, 2);
  // Ranges of axes stay those of all.
  EXPECT_EQ(
    plotOf(stage->parts(), picked, {choice.names, Plotted::All}, 20, 10).least, visible.least);
  stage->parts().front()->setHidden(true); // as --hide-data does
  EXPECT_EQ(plotOf(stage->parts(), picked, choice, 20, 10).total, 0);
  EXPECT_EQ(stage->numberShown(), 0);
}

TEST_F(PlotTest, RangesOfWhatIsShownAreThoseOfCountingOneByOne)
{
  settings.selection.ranges = {{"x", {{0.0, 0.25}}}, {"v:1", {{0.1, 0.4}, {0.6, 0.7}}}};
  settings.selection.where = "y < 1.5";
  settings.selection.hidden = IdRanges({{0, 0, 999}});
  this->show();
  double least = HUGE_VAL, most = -HUGE_VAL, place[3];
  for (int i = 1000; i < count; ++i)
  {
    data->GetPoint(i, place);
    const double v1 = v->GetComponent(i, 1);
    if (place[0] > 0.25 || place[1] >= 1.5 || v1 < 0.1 || v1 > 0.7 || (v1 > 0.4 && v1 < 0.6))
      continue;
    least = std::min(least, static_cast<double>(a->GetValue(i)));
    most = std::max(most, static_cast<double>(a->GetValue(i)));
  }
  double range[2];
  ASSERT_TRUE(rangeOfShown(stage->parts(), {"a", 0, false}, settings.selection, range));
  EXPECT_EQ(range[0], least);
  EXPECT_EQ(range[1], most);
  stage->parts().front()->setHidden(true);
  EXPECT_FALSE(rangeOfShown(stage->parts(), {"a", 0, false}, settings.selection, range));
}

TEST_F(PlotTest, IsEmptyWhereThereIsNoSuchArray)
{
  this->show();
  EXPECT_TRUE(plotOf(stage->parts(), picked, {{"b", ""}, Plotted::All}, 20, 10).isEmpty());
  EXPECT_TRUE(plotOf(stage->parts(), picked, {{"a", "b"}, Plotted::All}, 20, 10).isEmpty());
  const auto names = plottable(stage->parts());
  for (const char* name : {"a", "v:magnitude", "v:2", "x", "z"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}
