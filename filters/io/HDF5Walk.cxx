#include "HDF5Walk.h"

#include "ChildProcess.h"
#include "FileError.h"
#include "HDF5Handle.h"
#include "TextFile.h"

#include "vtk_hdf5.h"

#include <array>
#include <ctime>
#include <mutex>
#include <unistd.h>
#include <utility>
#include <vector>

namespace mote
{
namespace
{

constexpr double secondsAtMost = 5.0;
/// What takes longer than this within one call does not come back.
constexpr unsigned secondsOfCall = 60;
/// Attributes of particle formats are a few numbers or words.
constexpr hsize_t largestAttribute = 1 << 16;
constexpr int deepest = 32;

double now()
{
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Not 0: no more.
herr_t isLate(const void* end)
{
  return now() > *static_cast<const double*>(end) ? 1 : 0;
}

herr_t readAttribute(hid_t of, const char* name, const H5A_info_t*, void* end)
{
  const HDF5Handle attribute(H5Aopen(of, name, H5P_DEFAULT), H5Aclose);
  const HDF5Handle type(H5Aget_type(attribute), H5Tclose);
  const HDF5Handle space(H5Aget_space(attribute), H5Sclose);
  const hssize_t count = space.isGood() ? H5Sget_simple_extent_npoints(space) : -1;
  const std::size_t size = type.isGood() ? H5Tget_size(type) : 0;
  if (count > 0 && size > 0 && static_cast<hsize_t>(count) <= largestAttribute / size &&
      H5Tis_variable_str(type) <= 0)
  {
    std::vector<char> values(static_cast<std::size_t>(count) * size);
    H5Aread(attribute, type, values.data());
  }
  return isLate(end);
}

/// Reads the first value of an array, and the list of its chunks with that.
void readFirst(hid_t array)
{
  const HDF5Handle type(H5Dget_type(array), H5Tclose);
  const HDF5Handle space(H5Dget_space(array), H5Sclose);
  const HDF5Handle creation(H5Dget_create_plist(array), H5Pclose);
  H5Dget_storage_size(array);
  const int rank = space.isGood() ? H5Sget_simple_extent_ndims(space) : -1;
  const std::size_t size = type.isGood() ? H5Tget_size(type) : 0;
  if (rank < 1 || rank > 8 || size == 0 || size > largestAttribute || H5Tis_variable_str(type) > 0)
    return;
  const hsize_t first[8] = {}, one[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  const HDF5Handle place(H5Screate_simple(rank, one, nullptr), H5Sclose);
  std::vector<char> value(size);
  if (H5Sselect_hyperslab(space, H5S_SELECT_SET, first, nullptr, one, nullptr) >= 0)
    H5Dread(array, type, place, space, H5P_DEFAULT, value.data());
}

/// Looks at an object as HDF5File does, and at all below it. A group may be in itself: that ends
/// with the time, or the depth.
void look(hid_t object, double end, int depth)
{
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, readAttribute, &end);
  const H5I_type_t type = H5Iget_type(object);
  if (type == H5I_DATASET)
    readFirst(object);
  H5G_info_t info{};
  if (type != H5I_GROUP || H5Gget_info(object, &info) < 0 || depth > deepest)
    return;
  for (hsize_t i = 0; i < info.nlinks && !isLate(&end); ++i)
  {
    std::array<char, 1024> name{};
    if (H5Lget_name_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size() - 1,
          H5P_DEFAULT) < 0)
      continue;
    const HDF5Handle below(H5Oopen(object, name.data(), H5P_DEFAULT), H5Oclose);
    if (below.isGood())
      look(below, end, depth + 1);
  }
}

/// In the child: does not return where the library does not.
void walk(const char* path)
{
  const HDF5Silence silence;
  const HDF5Handle file(H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const HDF5Handle root(file.isGood() ? H5Oopen(file, "/", H5P_DEFAULT) : -1, H5Oclose);
  if (root.isGood())
    look(root, now() + secondsAtMost, 0);
}

} // namespace

void requireWalkable(const std::string& path)
{
  // A reader opens a file several times over.
  static std::mutex mutex;
  static std::pair<std::string, FileStamp> last;
  const FileStamp stamp = stampOf(path);
  {
    const std::lock_guard lock(mutex);
    if (last == std::pair(path, stamp))
      return;
  }
  // Where no process can be made, the file is taken as it is.
  if (inChildProcess(secondsOfCall, [&] { walk(path.c_str()); }) != ChildEnd::Well)
    throw FileError(
      FileError::Kind::Malformed, path, "it is damaged: HDF5 fails when it looks at it");
  const std::lock_guard lock(mutex);
  last = {path, stamp};
}

} // namespace mote
