#pragma once

#include "FaceAdjacency.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mote
{

/// Faces of cells with a volume, cut into triangles; those of a face follow one another, and turn
/// about its normal, which goes outwards of all cells or inwards of all.
struct FacesInTriangles
{
  ArrayView triangles; ///< three numbers of points each
  ArrayView points;    ///< three coordinates each
  /// Which sides of each triangle are sides of its face: bit k from corner k on. Empty: all.
  std::span<const std::uint8_t> edges;
  /// For each point the one that stands for it. Empty: each for itself.
  std::span<const long long> welds;
};

/// The triangles of a face.
struct FaceRange
{
  std::size_t first = 0, end = 0;
};

/// The faces of so many triangles, of which those of a face follow one another; see
/// FacesInTriangles.
std::vector<FaceRange> facesOf(std::size_t triangles, std::span<const std::uint8_t> edges);

/// A face that smaller ones cover, on the other side of its place.
struct CoveredFace
{
  FaceRange larger;
  double area = 0.0;
  std::vector<FaceRange> smaller;
};

/// The faces of the surface of a mesh that smaller ones cover, by their area, the largest first.
/// Meshes that are refined here and there have them, such as octrees: the face of a coarse cell
/// meets four of finer cells, with points that the coarse cell has not ("hanging nodes").
///
/// All corners of the larger face are corners of smaller ones, which look at it, lie within it, and
/// come to its area, up to a tenth: points that hang may follow a curved boundary. Thus the two
/// sides of a thin wall, whose points are not the same but at its rim, stay. In parallel.
std::vector<CoveredFace> coveredFaces(const FacesInTriangles& faces);

/// Which triangles are no walls: 1 for those of such faces, and of the smaller ones; empty for
/// none.
std::vector<std::uint8_t> hangingFaces(const FacesInTriangles& faces);

/// Faces of cells in triangles, which look outwards.
struct FaceTriangles
{
  std::vector<std::uint32_t> corners; ///< three points of the mesh each
  std::vector<std::uint8_t> edges;    ///< see FacesInTriangles
  std::vector<std::size_t> first;     ///< of each face's triangles, and their number at the end

  FaceTriangles(const HexMesh& mesh, const RawVector<CellFace>& faces);
};

/// The faces of a mesh's boundary but for those that hang.
RawVector<CellFace> wallsOf(const HexMesh& mesh, const FaceAdjacency& adjacency);

} // namespace mote
