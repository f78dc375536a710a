// Values over time at places in cells.

#include <base/ProgressRelay.h>
#include <stage/CellValues.h>
#include <stage/Input.h>
#include <stage/ValuesOverTime.h>

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

using namespace mote::app;

namespace
{

constexpr int steps = 4;

class ValuesOverTimeTest : public testing::Test
{
protected:
  ValuesOverTimeTest()
    : folder(
        std::filesystem::path(testing::TempDir()) /
        (std::string("over-time-") + testing::UnitTest::GetInstance()->current_test_info()->name()))
  {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~ValuesOverTimeTest() override { std::filesystem::remove_all(folder); }

  /// So many cubes in a row, which has moved along z by the step; p grows along x and with time.
  static vtkSmartPointer<vtkUnstructuredGrid> row(int cubes, int step)
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> p, v, volume;
    p->SetName("p");
    v->SetName("v");
    v->SetNumberOfComponents(3);
    volume->SetName("number");
    for (int i = 0; i <= cubes; ++i)
      for (const auto& [y, z] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
      {
        points->InsertNextPoint(i, y, z + step);
        p->InsertNextValue(i + 100.0 * step);
        v->InsertNextTuple3(3.0 * step, 4.0 * i, 0.0);
      }
    grid->SetPoints(points);
    for (vtkIdType i = 0; i < cubes; ++i)
    {
      const vtkIdType a = 4 * i, b = 4 * (i + 1);
      const vtkIdType corners[8] = {a, b, b + 1, a + 1, a + 3, b + 3, b + 2, a + 2};
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
      volume->InsertNextValue(static_cast<double>(10 * step + i));
    }
    grid->GetPointData()->AddArray(p);
    grid->GetPointData()->AddArray(v);
    grid->GetCellData()->AddArray(volume);
    return grid;
  }

  std::vector<std::string> files(bool lastIsOther = false) const
  {
    std::vector<std::string> names;
    for (int step = 0; step < steps; ++step)
    {
      names.push_back((folder / ("row." + std::to_string(step) + ".vtu")).string());
      vtkNew<vtkXMLUnstructuredGridWriter> writer;
      writer->SetFileName(names.back().c_str());
      writer->SetInputData(row(lastIsOther && step + 1 == steps ? 1 : 5, step));
      writer->Write();
    }
    return names;
  }

  /// All that the place (2.25, 0.5, 0.5) of the first step has over time.
  std::unique_ptr<ValuesOverTime> followed(const std::vector<std::string>& files)
  {
    auto input = std::make_unique<Input>(files);
    input->open(progress);
    const auto first = input->read(0, progress);
    const auto weights = weightsAt(first.front().data, 2, {2.25, 0.5, 0.5});
    EXPECT_TRUE(weights);
    auto values = std::make_unique<ValuesOverTime>(
      std::move(input), Followed{{}, {{0, 2, weights.value_or(CellWeights())}}}, Settings());
    while (values->stepsRead() < steps)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return values;
  }

  std::filesystem::path folder;
  ProgressRelay progress;
};

} // namespace

TEST_F(ValuesOverTimeTest, AreThoseOfThePlaceInTheCell)
{
  const auto values = this->followed(this->files());
  const auto curve = [&](const std::string& name)
  {
    const auto all = values->curves(name);
    EXPECT_EQ(all.size(), 1u) << name;
    EXPECT_EQ(all.front().id, 2);
    return all.front().values;
  };
  for (std::size_t step = 0; step < steps; ++step)
  {
    const auto time = static_cast<double>(step);
    EXPECT_NEAR(curve("x")[step], 2.25, 1e-9);
    EXPECT_NEAR(curve("z")[step], 0.5 + time, 1e-9) << "it goes with the cell";
    EXPECT_NEAR(curve("p")[step], 2.25 + 100.0 * time, 1e-9);
    EXPECT_NEAR(curve("v:0")[step], 3.0 * time, 1e-9);
    EXPECT_NEAR(curve("v:magnitude")[step], std::hypot(3.0 * time, 9.0), 1e-9);
    EXPECT_EQ(curve("number")[step], 10.0 * time + 2.0);
  }
  const std::string file = (folder / "values.csv").string();
  values->write(file, {});
  std::ifstream lines(file);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 18), "step,time,id,x,y,z");
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 8), "1,,2,2.2") << line;
}

TEST_F(ValuesOverTimeTest, EndWhereTheMeshIsAnother)
{
  const auto values = this->followed(this->files(true));
  const auto curve = values->curves("p").front().values;
  EXPECT_NEAR(curve[2], 202.25, 1e-9);
  EXPECT_TRUE(std::isnan(curve[3]));
}
