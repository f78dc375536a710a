#pragma once

#include "Arrays.h"
#include "Part.h"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace mote::app
{

/// How many values lie where, between the least and the greatest.
struct Histogram
{
  double least = 1.0, most = 0.0; ///< least > most: there are no values
  std::vector<double> counts;     ///< of equal parts of the range
  double highest = 0.0;           ///< of the counts

  bool isEmpty() const { return least > most; }
};

/// Of what all parts that have it hold of an array. Of more than a million values of a part, evenly
/// spread ones are counted, and count for those between them; least and greatest are of all.
Histogram histogramOf(
  const std::vector<std::unique_ptr<Part>>& parts, const ArrayChoice& choice, int bins);

/// Types and how many there are of each, in ascending order.
using Kinds = std::vector<std::pair<int, vtkIdType>>;

/// Of an array of types of particles, as isTypes() knows it; none of other arrays and of more than
/// a hundred types.
Kinds kindsOf(const std::vector<std::unique_ptr<Part>>& parts, const ArrayChoice& choice);

/// The mean radius that particles of each of these types are drawn with. Particles are looked at
/// only where their radii differ.
std::map<int, double> meanRadii(
  const std::vector<std::unique_ptr<Part>>& parts, const ArrayChoice& types, const Kinds& kinds);

/// Of the positions of all particles, and of all points of meshes, along x, y or z: 0, 1 or 2.
Histogram histogramOfPlaces(const std::vector<std::unique_ptr<Part>>& parts, int axis, int bins);

} // namespace mote::app
