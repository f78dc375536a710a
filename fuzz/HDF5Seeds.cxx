// fuzz-hdf5-seeds FORMAT FOLDER: small files in HDF5, of particles (hdf5) or of VTK (vtkhdf), for
// libFuzzer to begin with.

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
  writeGadget(folder + "/seed-gadget");
  writeH5Part(folder + "/seed-h5part");
  writeOpenPMD(folder + "/seed-openpmd");
  return 0;
}
