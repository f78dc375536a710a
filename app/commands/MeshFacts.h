#pragma once

#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkDataSet;

namespace mote::app
{

/// What vtkMoteMeshStatistics says about one data set.
class MeshFacts
{
public:
  explicit MeshFacts(vtkDataSet* data);

  /// Whether the data have cells that fill space; all else means nothing where not.
  bool any() const;

  /// A column of the cells' table, such as "volume".
  double of(const char* column) const;

  /// The mean by volume of an array on "point" or "cell"; none where there is no finite value.
  std::optional<double> meanOf(const std::string& array, const std::string& place) const;

  /// "12 hexahedra, 3 wedges"; what is not there is left out.
  std::string cells() const;
  /// "2 inverted"; empty where there is nothing to complain of.
  std::string complaints() const;

  /// All of the cells' table, by the names of its columns.
  std::vector<std::pair<std::string, double>> all() const;

private:
  std::string counts(
    const std::initializer_list<std::pair<const char*, const char*>>& columns) const;

  vtkSmartPointer<vtkTable> cells_, arrays_;
};

} // namespace mote::app
