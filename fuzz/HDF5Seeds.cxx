// fuzz-hdf5-seeds FOLDER: small files of particles in HDF5, for libFuzzer to begin with.

#include "HDF5Writer.h"

int main(int count, char** words)
{
  if (count != 2)
    return 1;
  const std::string folder = words[1];
  writeGadget(folder + "/seed-gadget");
  writeH5Part(folder + "/seed-h5part");
  writeOpenPMD(folder + "/seed-openpmd");
  return 0;
}
