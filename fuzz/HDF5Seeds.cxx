// fuzz-hdf5-seeds FORMAT FOLDER: small files in HDF5, of particles (hdf5), of VTK (vtkhdf) or of
// meshes (cgns), for libFuzzer to begin with.

#include "CGNSCubes.h"
#include "VTKHDFSamples.h"

int main(int count, char** words)
{
  if (count != 3)
    return 1;
  const std::string format = words[1], folder = words[2];
  if (format == "vtkhdf")
  {
    writeGridHDF(folder + "/seed-grid");
    writePolygonsHDF(folder + "/seed-polygons");
    writeStepsHDF(folder + "/seed-steps");
    writeImageHDF(folder + "/seed-image");
    return 0;
  }
  if (format == "cgns")
  {
    samples::writeCubes(folder + "/seed-mixed", {samples::mixed()});
    samples::writeCubes(folder + "/seed-polyhedra", {samples::polygons(), samples::polyhedra()});
    samples::writeCubes(folder + "/seed-hexahedra",
      {{CGNS_ENUMV(HEXA_8), 1, 1, samples::firstCube, {}},
        {CGNS_ENUMV(HEXA_8), 2, 2, samples::secondCube, {}}},
      2, {1, 4});
    return 0;
  }
  writeGadget(folder + "/seed-gadget");
  writeH5Part(folder + "/seed-h5part");
  writeOpenPMD(folder + "/seed-openpmd");
  return 0;
}
