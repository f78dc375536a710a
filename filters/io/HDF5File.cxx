#include "HDF5File.h"

#include "FileError.h"
#include "HDF5Handle.h"
#include "HDF5Walk.h"
#include "TextFile.h"

#include "vtk_hdf5.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mote
{
namespace
{

/// A group or an array, wherever every group on the way to it is there.
hid_t openObject(hid_t file, const std::string& name)
{
  for (std::size_t at = name.find('/', 1); name != "/"; at = name.find('/', at + 1))
  {
    const std::string part = name.substr(0, at);
    if (H5Lexists(file, part.c_str(), H5P_DEFAULT) <= 0)
      return -1;
    if (at == std::string::npos)
      break;
  }
  return H5Oopen(file, name.c_str(), H5P_DEFAULT);
}

} // namespace

HDF5File::HDF5File(const std::string& path)
  : m_path(path)
  , m_bytes(TextFile(path).bytes())
{
  if (m_bytes == 0)
    throw FileError(FileError::Kind::Truncated, path, "the file is empty");
  requireWalkable(path);
  const HDF5Silence silence;
  m_file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (m_file < 0)
    throw FileError(FileError::Kind::Malformed, path,
      "HDF5 cannot open it: it is damaged, truncated or being written");
}

HDF5File::~HDF5File()
{
  if (m_file >= 0)
    H5Fclose(m_file);
}

std::vector<std::string> HDF5File::namesIn(const std::string& group) const
{
  const HDF5Silence silence;
  std::vector<std::string> names;
  const HDF5Handle object(openObject(m_file, group), H5Oclose);
  H5G_info_t info{};
  if (!object.isGood() || H5Iget_type(object) != H5I_GROUP || H5Gget_info(object, &info) < 0)
    return names;
  for (hsize_t i = 0; i < std::min<hsize_t>(info.nlinks, m_bytes); ++i)
  {
    std::array<char, 1024> name{};
    if (H5Lget_name_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size() - 1,
          H5P_DEFAULT) >= 0)
      names.emplace_back(name.data());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool HDF5File::isGroup(const std::string& name) const
{
  const HDF5Silence silence;
  const HDF5Handle object(openObject(m_file, name), H5Oclose);
  return object.isGood() && H5Iget_type(object) == H5I_GROUP;
}

std::optional<HDF5Array> HDF5File::array(const std::string& name) const
{
  const HDF5Silence silence;
  const HDF5Handle object(openObject(m_file, name), H5Oclose);
  if (!object.isGood() || H5Iget_type(object) != H5I_DATASET)
    return {};
  const HDF5Handle space(H5Dget_space(object), H5Sclose);
  const HDF5Handle type(H5Dget_type(object), H5Tclose);
  const int rank = space.isGood() ? H5Sget_simple_extent_ndims(space) : -1;
  if (!type.isGood() || rank < 0 || rank > 8)
    return {};
  HDF5Array array;
  std::array<hsize_t, 8> sizes{};
  H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  array.dimensions.assign(sizes.begin(), sizes.begin() + rank);
  // The best packer leaves a byte of some thousand equal ones.
  double values = 1.0;
  for (const std::uint64_t size : array.dimensions)
    values *= static_cast<double>(size);
  if (values > std::max(1e6, 4096.0 * static_cast<double>(m_bytes)))
    throw FileError(FileError::Kind::Malformed, m_path,
      "the file has no room for the values that '" + name + "' announces");
  const H5T_class_t kind = H5Tget_class(type);
  array.isWhole = kind == H5T_INTEGER && H5Tget_size(type) <= 8;
  array.isNumber = array.isWhole || kind == H5T_FLOAT;
  array.isSigned = !array.isWhole || H5Tget_sign(type) != H5T_SGN_NONE;
  array.bytes = H5Tget_size(type);
  return array;
}

std::string HDF5File::text(const std::string& of, const std::string& attribute) const
{
  const HDF5Silence silence;
  const HDF5Handle object(openObject(m_file, of), H5Oclose);
  if (!object.isGood() || H5Aexists(object, attribute.c_str()) <= 0)
    return {};
  const HDF5Handle found(H5Aopen(object, attribute.c_str(), H5P_DEFAULT), H5Aclose);
  const HDF5Handle type(found.isGood() ? H5Aget_type(found) : -1, H5Tclose);
  const HDF5Handle space(found.isGood() ? H5Aget_space(found) : -1, H5Sclose);
  if (!type.isGood() || H5Tget_class(type) != H5T_STRING || !space.isGood() ||
      H5Sget_simple_extent_npoints(space) != 1)
    return {};
  std::string text;
  if (H5Tis_variable_str(type) > 0)
  {
    char* words = nullptr;
    if (H5Aread(found, type, &words) >= 0 && words)
    {
      text = words;
      H5free_memory(words);
    }
    return text;
  }
  const std::size_t length = H5Tget_size(type);
  if (length == 0 || length > 4096)
    return {};
  text.resize(length);
  if (H5Aread(found, type, text.data()) < 0)
    return {};
  return text.substr(0, text.find('\0'));
}

bool HDF5File::hasAttribute(const std::string& of, const std::string& attribute) const
{
  const HDF5Silence silence;
  const HDF5Handle object(openObject(m_file, of), H5Oclose);
  return object.isGood() && H5Aexists(object, attribute.c_str()) > 0;
}

std::vector<double> HDF5File::numbers(const std::string& of, const std::string& attribute) const
{
  const HDF5Silence silence;
  const HDF5Handle object(openObject(m_file, of), H5Oclose);
  if (!object.isGood() || H5Aexists(object, attribute.c_str()) <= 0)
    return {};
  const HDF5Handle found(H5Aopen(object, attribute.c_str(), H5P_DEFAULT), H5Aclose);
  const HDF5Handle space(found.isGood() ? H5Aget_space(found) : -1, H5Sclose);
  const HDF5Handle type(found.isGood() ? H5Aget_type(found) : -1, H5Tclose);
  const hssize_t count = space.isGood() ? H5Sget_simple_extent_npoints(space) : 0;
  const H5T_class_t kind = type.isGood() ? H5Tget_class(type) : H5T_NO_CLASS;
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || count < 1 || count > 10'000)
    return {};
  std::vector<double> values(static_cast<std::size_t>(count));
  if (H5Aread(found, H5T_NATIVE_DOUBLE, values.data()) < 0)
    return {};
  return values;
}

void HDF5File::readAs(std::int64_t memoryType, const std::string& name, std::uint64_t first,
  std::uint64_t count, void* values) const
{
  const std::optional<HDF5Array> known = array(name);
  if (!known || known->columns() == 0)
    failToRead(name);
  readSlab(memoryType, name, *known, first, count, values);
}

void HDF5File::failToRead(const std::string& name) const
{
  throw FileError(FileError::Kind::Malformed, m_path,
    "'" + name + "' cannot be read: it is damaged, or packed in a way that HDF5 lacks here");
}

void HDF5File::readSlab(std::int64_t memoryType, const std::string& name, const HDF5Array& known,
  std::uint64_t first, std::uint64_t count, void* values) const
{
  if (first > known.rows() || count > known.rows() - first)
    failToRead(name);
  if (count == 0)
    return;
  const HDF5Silence silence;
  const HDF5Handle object(openObject(m_file, name), H5Oclose);
  const HDF5Handle space(object.isGood() ? H5Dget_space(object) : -1, H5Sclose);
  std::array<hsize_t, 8> begin{}, size{};
  std::copy(known.dimensions.begin(), known.dimensions.end(), size.begin());
  begin[0] = first;
  size[0] = count;
  const HDF5Handle memory(
    H5Screate_simple(static_cast<int>(known.dimensions.size()), size.data(), nullptr), H5Sclose);
  if (!space.isGood() || !memory.isGood() ||
      H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr) < 0 ||
      H5Dread(object, memoryType, memory, space, H5P_DEFAULT, values) < 0)
    failToRead(name);
}

void HDF5File::readAsStored(
  const std::string& name, std::uint64_t first, std::uint64_t count, void* values) const
{
  const std::optional<HDF5Array> known = array(name);
  if (!known || !known->isNumber || known->dimensions.empty())
    failToRead(name);
  const std::array<hid_t, 4> wholes = {
    H5T_NATIVE_INT8, H5T_NATIVE_INT16, H5T_NATIVE_INT32, H5T_NATIVE_INT64};
  const std::array<hid_t, 4> naturals = {
    H5T_NATIVE_UINT8, H5T_NATIVE_UINT16, H5T_NATIVE_UINT32, H5T_NATIVE_UINT64};
  const std::size_t size = known->bytes <= 1   ? 0
                           : known->bytes <= 2 ? 1
                           : known->bytes <= 4 ? 2
                                               : 3;
  const hid_t type = !known->isWhole   ? size <= 2 ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE
                     : known->isSigned ? wholes[size]
                                       : naturals[size];
  readSlab(type, name, *known, first, count, values);
}

void HDF5File::read(
  const std::string& name, std::uint64_t first, std::uint64_t count, double* values) const
{
  readAs(H5T_NATIVE_DOUBLE, name, first, count, values);
}

void HDF5File::read(
  const std::string& name, std::uint64_t first, std::uint64_t count, std::int64_t* values) const
{
  readAs(H5T_NATIVE_INT64, name, first, count, values);
}

} // namespace mote
