#ifndef MoteHDF5Writer_h
#define MoteHDF5Writer_h

// Small files of particles in HDF5.

#include "vtk_hdf5.h"

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

/// Writes HDF5.
class HDF5Writer
{
public:
  /// A new file, or one that is there and is changed.
  explicit HDF5Writer(const std::string& file, bool isNew = true)
    : m_file(isNew ? H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)
                   : H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT))
  {
  }
  ~HDF5Writer() { H5Fclose(m_file); }
  HDF5Writer(const HDF5Writer&) = delete;
  HDF5Writer& operator=(const HDF5Writer&) = delete;

  void remove(const std::string& name) { H5Ldelete(m_file, name.c_str(), H5P_DEFAULT); }

  void group(const std::string& name)
  {
    H5Gclose(H5Gcreate2(m_file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }

  template <class Number>
  void array(const std::string& name, const std::vector<Number>& values, hsize_t columns = 1)
  {
    if (columns > 1)
      this->block(name, values, {values.size() / columns, columns});
    else
      this->block(name, values, {values.size()});
  }

  /// An array of any dimensions.
  template <class Number>
  void block(
    const std::string& name, const std::vector<Number>& values, const std::vector<hsize_t>& sizes)
  {
    const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    const hid_t type = std::is_same_v<Number, double>          ? H5T_NATIVE_DOUBLE
                       : std::is_same_v<Number, float>         ? H5T_NATIVE_FLOAT
                       : std::is_same_v<Number, int>           ? H5T_NATIVE_INT32
                       : std::is_same_v<Number, unsigned char> ? H5T_NATIVE_UINT8
                                                               : H5T_NATIVE_INT64;
    const hid_t set =
      H5Dcreate2(m_file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    H5Sclose(space);
  }

  void attribute(const std::string& of, const std::string& name, const std::vector<double>& values)
  {
    const hid_t object = H5Oopen(m_file, of.c_str(), H5P_DEFAULT);
    const hsize_t size = values.size();
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t set =
      H5Acreate2(object, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(set, H5T_NATIVE_DOUBLE, values.data());
    H5Aclose(set);
    H5Sclose(space);
    H5Oclose(object);
  }

  void text(const std::string& of, const std::string& name, const std::string& text)
  {
    const hid_t object = H5Oopen(m_file, of.c_str(), H5P_DEFAULT);
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, text.size());
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t set = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(set, type, text.data());
    H5Aclose(set);
    H5Sclose(space);
    H5Tclose(type);
    H5Oclose(object);
  }

private:
  hid_t m_file;
};

/// A snapshot of two particles of gas and one of halo.
inline void writeGadget(const std::string& file)
{
  HDF5Writer out(file);
  for (const char* name : {"/Header", "/PartType0", "/PartType1"})
    out.group(name);
  out.attribute("/Header", "Time", {0.75});
  out.attribute("/Header", "BoxSize", {50});
  out.attribute("/Header", "MassTable", {0, 2.5});
  out.array<double>("/PartType0/Coordinates", {1, 2, 3, 4, 5, 6}, 3);
  out.array<float>("/PartType0/Masses", {0.5F, 1.5F});
  out.array<std::int64_t>("/PartType0/ParticleIDs", {5, (1LL << 60) + 1});
  out.array<double>("/PartType0/Metallicity", {0.1, 0.2, 0.3, 0.4}, 2);
  out.array<double>("/PartType1/Coordinates", {7, 8, 9}, 3);
  out.array<std::int64_t>("/PartType1/ParticleIDs", {7});
}

/// A file of a snapshot that is spread over several: two particles of gas, which begin at `place`.
inline void writeGadgetShare(const std::string& file, double place, double files)
{
  HDF5Writer out(file);
  for (const char* name : {"/Header", "/PartType0"})
    out.group(name);
  out.attribute("/Header", "Time", {0.5});
  out.attribute("/Header", "NumFilesPerSnapshot", {files});
  out.array<double>("/PartType0/Coordinates", {place, 0, 0, place + 1, 0, 0}, 3);
  out.array<std::int64_t>("/PartType0/ParticleIDs", {std::int64_t(place), std::int64_t(place) + 1});
  if (place == 0)
    return;
  out.group("/PartType4");
  out.array<double>("/PartType4/Coordinates", {place, 5, 5}, 3);
}

/// Steps 0, 2 and 10 of two particles.
inline void writeH5Part(const std::string& file)
{
  HDF5Writer out(file);
  for (const int step : {0, 2, 10})
  {
    const std::string group = "/Step#" + std::to_string(step);
    out.group(group);
    for (const char* axis : {"x", "y", "z", "px", "py", "pz"})
      out.array<double>(group + "/" + axis, {0.5 + step, *axis - 100.0});
    out.array<std::int64_t>(group + "/id", {3, 4});
    out.array<std::int64_t>(group + "/other", {3, 4, 5}); // not of these particles
  }
}

/// An iteration with one kind of particles, whose offsets are one value.
inline void writeOpenPMD(const std::string& file)
{
  HDF5Writer out(file);
  out.attribute("/", "openPMD", {1});
  for (const char* name : {"/data", "/data/100", "/data/100/particles", "/data/100/particles/e",
         "/data/100/particles/e/position", "/data/100/particles/e/positionOffset",
         "/data/100/particles/e/positionOffset/x", "/data/100/particles/e/positionOffset/y",
         "/data/100/particles/e/mass"})
    out.group(name);
  out.attribute("/data/100", "time", {2.5});
  const std::string e = "/data/100/particles/e";
  out.array<double>(e + "/position/x", {1, 2});
  out.array<double>(e + "/position/y", {3, 4});
  for (const char* axis : {"x", "y"})
  {
    out.attribute(e + "/positionOffset/" + axis, "value", {10});
    out.attribute(e + "/positionOffset/" + axis, "shape", {2});
    out.attribute(e + "/positionOffset/" + axis, "unitSI", {1e-6});
    out.attribute(e + "/position/" + axis, "unitSI", {1e-6});
  }
  out.attribute(e + "/mass", "value", {9.1e-31});
  out.attribute(e + "/mass", "shape", {2});
  out.array<float>(e + "/weighting", {0.5F, 0.25F});
}

#endif
