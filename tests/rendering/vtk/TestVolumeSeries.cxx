// vtkMoteVolumeMapper on the time steps of a series of files.
#include "VolumeTestSupport.h"

#include "vtkMoteReaderTable.h"

using namespace mote::testing;

namespace
{

std::string swirl(int step)
{
  return std::string(MOTE_SOURCE_DIR "/data/swirl.") + std::to_string(step) + ".vtu";
}

} // namespace

TEST(VolumeSeries, StepsOfTheSameGeometryBuildOnce)
{
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader({swirl(0), swirl(1)}, error);
  ASSERT_TRUE(reader) << error;
  vtkNew<vtkMoteVolumeMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("p");
  double least[2];
  for (const int step : {0, 1})
  {
    EXPECT_EQ(mapper->UpdateTimeStep(7.5 + 0.5 * step), 1);
    least[step] = mapper->GetScalarRange()[0];
    EXPECT_EQ(mapper->GetNumberOfFieldUpdates(), step + 1);
  }
  EXPECT_EQ(mapper->GetNumberOfCells(), 8547);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
  EXPECT_NE(least[0], least[1]);
  EXPECT_EQ(mapper->UpdateTimeStep(7.5), 1);
  EXPECT_EQ(mapper->GetScalarRange()[0], least[0]);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
}
