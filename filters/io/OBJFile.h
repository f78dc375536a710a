#ifndef MoteOBJFile_h
#define MoteOBJFile_h

#include "TextCursor.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace mote
{

/// What a Wavefront OBJ file holds, but for texture coordinates, smoothing groups, curves and what
/// its library of materials says.
struct OBJFile
{
  struct Corner
  {
    std::int64_t vertex = 0;
    std::int64_t normal = -1; ///< -1: none
  };
  /// The names of one kind of group that cells are in, in the order in which they appear. The first
  /// one is empty: that of cells before any.
  struct Groups
  {
    std::vector<std::string> names = {""};
    std::unordered_map<std::string, std::int32_t> numbers = {{"", 0}};
    std::int32_t current = 0;
    void begin(std::string_view name);
  };
  /// Cells of one dimension, one after the other.
  struct Cells
  {
    std::vector<Corner> corners;
    std::vector<std::int64_t> ends; ///< in `corners`
    std::vector<std::int32_t> materials, groups, objects;
  };

  std::vector<double> places; ///< x, y, z of each vertex
  /// Red, green and blue of each vertex, as written, behind its place; white where there are none;
  /// empty where no vertex has any.
  std::vector<float> colors;
  std::vector<float> normals; ///< x, y, z of each
  Cells points, lines, faces;
  Groups materials, groups, objects;
};

/// Reads a file, plain or gzip. Throws FileError, with the line, for vertices that are no numbers,
/// corners that are not written as 1, 1/2, 1/2/3 or 1//3 or name something that is not there, and
/// zero bytes; and for `progress` that stops it. Source: Wavefront, Advanced Visualizer manual,
/// appendix B1; colours behind places as MeshLab writes them.
OBJFile readOBJ(const std::string& path, const Progress& progress);

} // namespace mote

#endif
