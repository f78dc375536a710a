#include "SilhouetteInput.h"

#include "ImageError.h"

#include <vtkBoundingBox.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace mote::imaging
{
namespace
{

std::string arraysOf(vtkImageData* image)
{
  std::string names;
  vtkPointData* points = image->GetPointData();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    const char* name = points->GetArrayName(i);
    names += std::string(names.empty() ? "" : ", ") + (name && *name ? name : "(no name)");
  }
  return names.empty() ? "no arrays" : names;
}

vtkDataArray* checked(vtkDataArray* array)
{
  if (array->GetNumberOfComponents() != 1)
  {
    throw ImageError(vtkErrorCode::FileFormatError,
      std::string("The array \"") + (array->GetName() ? array->GetName() : "") + "\" has " +
        std::to_string(array->GetNumberOfComponents()) + " numbers a pixel, and must have one.");
  }
  return array;
}

template <typename T>
void convert(const T* values, std::vector<float>& out)
{
  std::transform(
    values, values + out.size(), out.begin(), [](T value) { return static_cast<float>(value); });
}

/// Any numbers that differ where these do, and are ordered as these where those are whole.
template <typename T>
void convert(const T* values, std::vector<std::uint64_t>& out)
{
  const auto number = [](T value)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      const double wide = value == T(0) ? 0.0 : static_cast<double>(value);
      std::uint64_t bits;
      std::memcpy(&bits, &wide, sizeof(bits));
      return bits;
    }
    else
    {
      return static_cast<std::uint64_t>(value);
    }
  };
  std::transform(values, values + out.size(), out.begin(), number);
}

template <typename Out>
void convertArray(vtkDataArray* array, std::vector<Out>& out)
{
  out.resize(array->GetNumberOfTuples());
  switch (array->GetDataType())
  {
    vtkTemplateMacro(convert(static_cast<const VTK_TT*>(array->GetVoidPointer(0)), out));
  default: // bits
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = static_cast<Out>(array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
}

} // namespace

vtkDataArray* findNumbers(vtkImageData* image, const std::string& name)
{
  if (vtkDataArray* array = image->GetPointData()->GetArray(name.c_str()))
    return checked(array);
  throw ImageError(vtkErrorCode::FileFormatError,
    "The image has no array \"" + name + "\" of numbers; it has " + arraysOf(image) + ".");
}

vtkDataArray* findDepths(vtkImageData* image, const std::string& name)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const bool haveScalars = scalars && scalars->GetNumberOfComponents() == 1;
  if (!name.empty() || !haveScalars || image->GetPointData()->GetArray("depth"))
    return findNumbers(image, name.empty() ? "depth" : name);
  return scalars;
}

void SilhouetteInput::setExtents(const int* whole, const int* present, int reduction)
{
  std::copy(whole, whole + 6, m_whole);
  std::copy(present, present + 6, m_present);
  m_reduction = reduction;
  for (int axis = 0; axis < 3; ++axis)
    if (present[2 * axis] > present[2 * axis + 1])
      throw ImageError(vtkErrorCode::FileFormatError, "The image is empty.");
}

void SilhouetteInput::takeDepths(vtkDataArray* depths)
{
  if (depths->GetDataType() == VTK_FLOAT)
  {
    m_depth = static_cast<const float*>(depths->GetVoidPointer(0));
    return;
  }
  convertArray(depths, m_depths);
  m_depth = m_depths.data();
}

void SilhouetteInput::takeGroups(vtkDataArray* groups)
{
  convertArray(groups, m_groups);
}

void SilhouetteInput::setView(bool perspective, double angle, double height, bool alongRays)
{
  const double pixels = m_whole[3] - m_whole[2] + 1;
  m_tangent = perspective ? 2.0 * std::tan(0.5 * vtkMath::RadiansFromDegrees(angle)) / pixels : 0.0;
  m_pixelSize = perspective ? 0.0 : height / pixels;
  m_alongRays = alongRays;
}

std::int64_t SilhouetteInput::indexOf(int x, int y, int z) const
{
  const std::int64_t width = m_present[1] - m_present[0] + 1;
  const std::int64_t height = m_present[3] - m_present[2] + 1;
  return ((z - m_present[4]) * height + (y - m_present[2])) * width + (x - m_present[0]);
}

/// All that there is of a slice.
DepthImage SilhouetteInput::present(int z) const
{
  DepthImage image;
  image.width = m_present[1] - m_present[0] + 1;
  image.height = m_present[3] - m_present[2] + 1;
  const std::int64_t first = indexOf(m_present[0], m_present[2], z);
  image.depth = m_depth + first;
  image.group = m_groups.empty() ? nullptr : m_groups.data() + first;
  image.depthStride = image.groupStride = image.width;
  image.background = background;
  image.dx = image.dy = m_tangent;
  image.x0 = (m_present[0] - 0.5 * (m_whole[0] + m_whole[1] + 1)) * m_tangent;
  image.y0 = (m_present[2] - 0.5 * (m_whole[2] + m_whole[3] + 1)) * m_tangent;
  image.alongRays = m_alongRays;
  image.pixelSize = m_pixelSize;
  return image;
}

double SilhouetteInput::sceneSize() const
{
  vtkBoundingBox box;
  for (int z = m_present[4]; z <= m_present[5]; ++z)
  {
    const DepthImage image = present(z);
    for (int y = 0; y < image.height; ++y)
    {
      for (int x = 0; x < image.width; ++x)
      {
        const double depth = image.depth[y * image.depthStride + x];
        if (!std::isfinite(depth) || !(depth < background))
          continue;
        const double across = image.x0 + (x + 0.5) * image.dx;
        const double above = image.y0 + (y + 0.5) * image.dy;
        const double axial =
          m_alongRays ? depth / std::sqrt(1.0 + across * across + above * above) : depth;
        box.AddPoint(across * axial + x * m_pixelSize, above * axial + y * m_pixelSize, axial);
      }
    }
  }
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

DepthImage SilhouetteInput::slice(int z, const int* extent, PixelBox& box) const
{
  DepthImage image = present(z);
  int first[2]; // pixel of the output with which the depth image begins
  for (int axis = 0; axis < 2; ++axis)
  {
    const int offset = m_present[2 * axis] - m_whole[2 * axis];
    first[axis] = reducedSize(offset, m_reduction);
    // There may be more than was asked for, which begins within a square.
    const int skipped = first[axis] * m_reduction - offset;
    (axis == 0 ? image.width : image.height) -= skipped;
    const std::ptrdiff_t values = skipped * (axis == 0 ? 1 : image.depthStride);
    image.depth += values;
    image.group = image.group ? image.group + values : nullptr;
    (axis == 0 ? image.x0 : image.y0) += skipped * m_tangent;
  }
  const int x = m_whole[0] + first[0], y = m_whole[2] + first[1];
  box = {extent[0] - x, extent[2] - y, extent[1] - x + 1, extent[3] - y + 1};
  return image;
}

PixelSquare SilhouetteInput::square(int x, int y, int z) const
{
  const int left = m_whole[0] + (x - m_whole[0]) * m_reduction;
  const int low = m_whole[2] + (y - m_whole[2]) * m_reduction;
  return {indexOf(left, low, z), m_present[1] - m_present[0] + 1,
    std::min(m_reduction, m_whole[1] - left + 1), std::min(m_reduction, m_whole[3] - low + 1)};
}

LineColors::LineColors(vtkImageData* image, const std::string& name, const double* lines)
  : m_colors(image->GetPointData()->GetArray(name.c_str()))
{
  std::copy(lines, lines + 3, m_lines);
  if (m_colors && m_colors->GetNumberOfComponents() > 4)
  {
    throw ImageError(vtkErrorCode::FileFormatError,
      "The array \"" + name + "\" has " + std::to_string(m_colors->GetNumberOfComponents()) +
        " numbers a pixel, and colours have 1 to 4.");
  }
}

void LineColors::mix(const PixelSquare& square, float share, float* out) const
{
  float sum[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  const int components = m_colors ? m_colors->GetNumberOfComponents() : 0;
  const bool bytes = m_colors && m_colors->GetDataType() == VTK_UNSIGNED_CHAR;
  const float unit = bytes ? 1.0f / 255.0f : 1.0f;
  const bool grey = components < 3, transparent = components % 2 == 0;
  for (int j = 0; components > 0 && j < square.height; ++j)
  {
    for (int i = 0; i < square.width; ++i)
    {
      const vtkIdType point = square.first + j * square.rowStride + i;
      const auto value = [&](int c)
      { return unit * static_cast<float>(m_colors->GetComponent(point, c)); };
      const float alpha = transparent ? value(components - 1) : 1.0f;
      for (int c = 0; c < 3; ++c)
      {
        // Floats are premultiplied, bytes are not.
        sum[c] += value(grey ? 0 : c) * (bytes ? alpha : 1.0f);
      }
      sum[3] += alpha;
    }
  }
  const float left = (1.0f - share) / static_cast<float>(square.width * square.height);
  for (int c = 0; c < 4; ++c)
    out[c] = sum[c] * left + share * (c < 3 ? m_lines[c] : 1.0f);
}

} // namespace mote::imaging
