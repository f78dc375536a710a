// Prints what a frame change of a volume takes before the first ray, seconds of the wall clock and
// of the processors, in a time series over one geometry:
//   MoteVolumeFrames [SCALE]        the rotor of the pump; 1 is 2.15 million cells
#include "vtkMotePumpSource.h"
#include "vtkMoteVolumeMapper.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace
{

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

std::vector<Grid> makeFrames(double scale, int count)
{
  vtkNew<vtkMotePumpSource> pump;
  pump->SetScale(scale);
  pump->SetPartToRotor();
  std::vector<Grid> frames;
  for (int i = 0; i < count; ++i)
  {
    pump->UpdateTimeStep(0.001 * i);
    frames.push_back(Grid::New());
    frames.back()->ShallowCopy(pump->GetOutputDataObject(0));
  }
  return frames;
}

/// The same frame with points and cells of its own, as readers make them that know no better.
Grid withOwnGeometry(vtkUnstructuredGrid* frame)
{
  Grid own = Grid::New();
  own->DeepCopy(frame);
  return own;
}

void show(vtkMoteVolumeMapper* mapper, vtkUnstructuredGrid* frame, const char* what)
{
  mapper->SetInputData(frame);
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t busy = std::clock();
  mapper->Update();
  const double cpu = double(std::clock() - busy) / CLOCKS_PER_SEC;
  const double wall =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%-42s %8.4f s wall, %8.4f s CPU\n", what, wall, cpu);
}

} // namespace

int main(int argc, char** argv)
{
  const double scale = argc > 1 ? std::atof(argv[1]) : 0.05;
  const std::vector<Grid> frames = makeFrames(scale, 5);
  for (const char* structure : {"cylbvh", "cylgrid"})
    for (const char* array : {"pressure", "velocity"})
    {
      vtkNew<vtkMoteVolumeMapper> mapper;
      mapper->SetStructureName(structure);
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectScalarArray(array);
      mapper->SetVectorModeToMagnitude();
      std::printf("%s, %s\n", structure, array);
      show(mapper, frames[0], "first frame");
      for (std::size_t i = 1; i < frames.size(); ++i)
        show(mapper, frames[i], "next frame, the same points and cells");
      for (std::size_t i = 0; i < 3; ++i)
        show(mapper, withOwnGeometry(frames[i]), "next frame, equal points and cells anew");
      std::printf("%lld cells, %d build, %d times scalars were taken\n",
        static_cast<long long>(mapper->GetNumberOfCells()), mapper->GetNumberOfBuilds(),
        mapper->GetNumberOfFieldUpdates());
    }
  return 0;
}
