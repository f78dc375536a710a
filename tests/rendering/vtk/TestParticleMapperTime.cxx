// vtkMoteParticleMapper on the time steps of a pipeline.
#include "VTKTestSupport.h"

#include "filters/io/IOTestSupport.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkPolyData.h"

#include <cmath>

using namespace mote::testing;

namespace
{

/// A dump of five steps with 30, 60, 0, 45 and 60 atoms; the third and fourth lack "c_pe".
struct Film : FileTest
{
  static constexpr int atoms[5] = {30, 60, 0, 45, 60};
  vtkNew<vtkMoteLAMMPSDumpReader> reader;
  Stage stage;
  vtkMoteParticleMapper* mapper = stage.mapper;

  static bool hasEnergy(int step) { return step != 2 && step != 3; }
  static double energy(int step, int atom) { return (atom * 7 + step) % 10; }

  Film()
  {
    std::string text;
    for (int step = 0; step < 5; ++step)
    {
      std::string rows;
      for (int i = 0; i < atoms[step]; ++i)
      {
        rows += std::to_string(i + 1) + " " + std::to_string(i % 3 + 1);
        for (const double v : {-1.2 + 0.04 * i, -1.0 + 0.3 * (i % 7), 0.1 * step})
          rows += " " + std::to_string(v);
        rows += (hasEnergy(step) ? " " + std::to_string(energy(step, i)) : "") + "\n";
      }
      text += dumpFrame(100 * step, atoms[step],
        std::string("id type x y z") + (hasEnergy(step) ? " c_pe" : ""), rows);
    }
    reader->SetFileName(write("film.dump", text).c_str());
    mapper->SetInputConnection(reader->GetOutputPort());
    mapper->SetRadiusModeToConstant();
    mapper->SetRadius(0.05);
  }

  int shownAt(int step)
  {
    EXPECT_EQ(mapper->UpdateTimeStep(100.0 * step), 1);
    EXPECT_EQ(mapper->GetNumberOfParticles(), atoms[step]) << step;
    stage.trace();
    EXPECT_EQ(mapper->GetNumberOfParticles(), atoms[step]) << "and drawing keeps the step";
    return static_cast<int>(mapper->GetNumberOfVisibleParticles());
  }

  static int between(int step, double low, double high)
  {
    int count = 0;
    for (int i = 0; i < atoms[step]; ++i)
      count += energy(step, i) >= low && energy(step, i) <= high ? 1 : 0;
    return count;
  }
};

} // namespace

TEST_F(Film, StepsHaveTheirOwnParticles)
{
  for (const int step : {0, 1, 2, 3, 4, 0, 2, 4})
    EXPECT_EQ(shownAt(step), atoms[step]);
}

TEST_F(Film, RangeStaysWhatTheUserChose)
{
  Complaints complaints(mapper);
  mapper->AddRange("c_pe", 3, 6);
  for (const int step : {0, 1, 4, 1})
    EXPECT_EQ(shownAt(step), between(step, 3, 6));
  EXPECT_EQ(complaints.errors, 0);
}

TEST_F(Film, VanishedArrayIsToldOnceAndHoldsAgainLater)
{
  Complaints complaints(mapper);
  mapper->AddRange("c_pe", 3, 6);
  mapper->AddRange("type", 1, 2);
  shownAt(1);
  EXPECT_EQ(complaints.errors, 0);
  EXPECT_EQ(shownAt(2), 0) << "no atoms, no complaint";
  EXPECT_EQ(complaints.errors, 0);
  EXPECT_EQ(shownAt(3), 30) << "the other range goes on";
  shownAt(3);
  EXPECT_EQ(complaints.errors, 1) << complaints.text;
  int wanted = 0;
  for (int i = 0; i < atoms[4]; ++i)
    wanted += energy(4, i) >= 3 && energy(4, i) <= 6 && i % 3 < 2 ? 1 : 0;
  EXPECT_EQ(shownAt(4), wanted);
  EXPECT_EQ(complaints.errors, 1);
}

TEST_F(Film, KeepsColoursCameraAndMemory)
{
  vtkNew<vtkLookupTable> table;
  table->SetRange(2, 5);
  mapper->SetLookupTable(table);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("c_pe");
  mapper->UseLookupTableScalarRangeOn();
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  shownAt(1);
  const auto bytes = mapper->GetStructureBytes();
  for (const int step : {0, 4, 1})
    shownAt(step);
  EXPECT_EQ(table->GetRange()[0], 2.0);
  EXPECT_EQ(table->GetRange()[1], 5.0);
  EXPECT_EQ(camera->GetPosition()[2], 10.0);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 4);
  EXPECT_EQ(mapper->GetStructureBytes(), bytes) << "the largest step's memory serves them all";
}

TEST_F(Film, SameStepIsNotBuiltAgain)
{
  shownAt(1);
  shownAt(1);
  stage.trace();
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
}

TEST_F(Film, PictureIsThatOfAMapperOfItsOwn)
{
  for (const int step : {0, 1, 3, 4, 0})
  {
    shownAt(step);
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(reader->GetOutput());
    Stage own(copy);
    own.mapper->SetRadiusModeToConstant();
    own.mapper->SetRadius(0.05);
    EXPECT_EQ(stage.trace().particles(), own.trace().particles()) << step;
  }
}

TEST_F(Film, ReadersOwnTimeStepsWorkToo)
{
  reader->UpdateTimeStep(100);
  stage.trace();
  EXPECT_EQ(mapper->GetNumberOfParticles(), 60);
  reader->UpdateTimeStep(300);
  stage.trace();
  EXPECT_EQ(mapper->GetNumberOfParticles(), 45);
}

TEST(MapperTime, WithoutInputThereIsNoStep)
{
  Stage stage;
  EXPECT_EQ(stage.mapper->UpdateTimeStep(1.0), 0);
}
