// write-mesh-samples FOLDER: the small meshes of MeshSamples.h, for tests of the program.
#include "MeshSamples.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLStructuredGridWriter.h"

int main(int argc, char** argv)
{
  if (argc != 2)
    return 2;
  const std::string folder = argv[1];
  samples::writeFoam(folder + "/foam");
  samples::writeDecomposedFoam(folder + "/decomposed", true);
  samples::writeEnSight(folder + "/ensight", true);
  samples::writeCGNS(folder + "/a.cgns");
  vtkNew<vtkXMLStructuredGridWriter> grid;
  grid->SetInputData(samples::structuredBox());
  grid->SetFileName((folder + "/a.vts").c_str());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, samples::box());
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "fluid");
  blocks->SetBlock(1, samples::structuredBox());
  vtkNew<vtkXMLMultiBlockDataWriter> both;
  both->SetInputData(blocks);
  both->SetFileName((folder + "/a.vtm").c_str());
  return grid->Write() && both->Write() ? 0 : 1;
}
