#pragma once

#include "Arrays.h"
#include "Opacity.h"
#include "Part.h"
#include "TypeNames.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

class vtkLookupTable;

namespace mote::app
{

/// Which array colours the parts, and how: the array, its range, the table of colours.
class Coloring
{
public:
  /// The settings are those of the scene: apply() follows them when they have changed.
  explicit Coloring(const Settings& settings);

  /// Gives the parts their colours. The first call with arrays chooses one, unless the settings
  /// name it; throws Failure if no part has the array that they name. The range grows from step to
  /// step, so that colours keep their meaning.
  void apply(const std::vector<std::unique_ptr<Part>>& parts);
  /// Takes opacities of the parts that were found before.
  void offer(const std::vector<std::unique_ptr<Part>>& parts, const UsualOpacity::Found& opacity);
  /// What there is to offer of these parts another time.
  UsualOpacity::Found usualOpacity(const std::vector<std::unique_ptr<Part>>& parts) const;

  /// Only takes the parts' values into the range and the types.
  void include(const std::vector<std::unique_ptr<Part>>& parts);

  /// Forgets array, range and types: other files may follow.
  void startAnew();

  /// As --color-by takes it: the next of the arrays that the parts have, then no array, then the
  /// first again.
  std::string nextArray(const std::vector<std::unique_ptr<Part>>& parts) const;

  /// The same of the next component of the array, if it has several.
  std::string nextComponent(const std::vector<std::unique_ptr<Part>>& parts) const;

  /// Whether an array, as --color-by takes it, has values above zero, for logarithmic colours.
  bool isAboveZero(const std::vector<std::unique_ptr<Part>>& parts, const std::string& array) const;

  /// The colour map after this one.
  std::string nextMap() const;

  /// The settings that say outright what is chosen of itself: the array, and the range that it has
  /// had so far.
  ColorSettings inForce(const std::vector<std::unique_ptr<Part>>& parts) const;

  /// How many components the array has that colours; 0 where there is none.
  int componentCount(const std::vector<std::unique_ptr<Part>>& parts) const;

  /// The opacities of volumes, those that were chosen by themselves too; none without volumes.
  const std::vector<OpacityPoint>& opacity() const { return opacity_; }

  /// The colours to explain in a legend; null where there is no array, or it holds colours.
  vtkLookupTable* table() const;

  /// The same for legends: a table of types has a name for each.
  vtkLookupTable* legendTable() const;

  /// Of the values in all data that were shown so far, which colours have where nobody chooses; and
  /// back to what it was.
  struct SeenRange
  {
    double whole[2] = {1.0, 0.0};   // from the least to the greatest
    double trimmed[2] = {1.0, 0.0}; // between the percentiles that the settings name, if any
    double leastPositive = 0.0;
  };
  SeenRange seenRange() const { return seen_; }
  void goBackTo(const SeenRange& seen) { seen_ = seen; }

  /// Most of the values in these parts, without a hundredth at both ends, where these take most of
  /// the range; false else. Parts are looked at anew only where they have changed.
  bool rangeOfMost(const std::vector<std::unique_ptr<Part>>& parts, double range[2]) const;
  /// The percentiles that leave outliers out.
  static std::vector<double> percentilesOfMost() { return {1.0, 99.0}; }

  const ArrayChoice& choice() const { return choice_; }

  /// What the colours mean: "v magnitude".
  const std::string& title() const { return title_; }
  /// Whether colours stand for types, one by one.
  bool isTyped() const { return typed_; }
  const std::string& mapName() const { return settings_.color.map; }

private:
  void followSettings();
  void choose(const std::vector<std::unique_ptr<Part>>& parts);
  bool updateRange(const std::vector<std::unique_ptr<Part>>& parts);
  bool updateTypes(const std::vector<std::unique_ptr<Part>>& parts);
  bool findTypes(const std::vector<std::unique_ptr<Part>>& parts, std::size_t limit);
  void updateNames(const std::vector<std::unique_ptr<Part>>& parts);
  const double* range() const { return percentiles_.empty() ? seen_.whole : seen_.trimmed; }
  void makeTable(bool types);
  void forget();

  const Settings& settings_;
  ArrayChoice choice_;
  bool chosen_ = false;
  std::string wanted_; // what the settings named when it was chosen
  SeenRange seen_;
  std::vector<double> percentiles_; // of seen_.trimmed

  /// What percentiles of arrays were last.
  struct Percentiles
  {
    std::vector<double> of;
    vtkDataArray* array = nullptr;
    vtkMTimeType time = 0;
    int component = 0;
    bool isAny = false;
    double range[2] = {1.0, 0.0};
  };
  bool percentilesOf(
    vtkDataArray* array, const std::vector<double>& percentiles, double range[2]) const;
  mutable std::vector<Percentiles> known_;
  std::vector<int> types_;        // in the order of their colours; new ones come last
  bool countable_ = true;         // whether types_ could be found
  std::vector<Color> typeColors_; // of types_
  TypeNames dataNames_, names_;   // of types: as data have named them so far; in force
  std::vector<std::pair<vtkDataSet*, unsigned long>>
    named_; // what dataNames_ has, with times of change
  std::string title_;
  bool typed_ = false;     // colours stand for types_
  bool explained_ = false; // there is something for a legend to explain
  vtkSmartPointer<vtkLookupTable> table_;
  bool isTypeTable_ = false;
  TypeNames legendNames_;
  vtkSmartPointer<vtkLookupTable> legendTable_;
  UsualOpacity usual_; ///< of volumes
  std::vector<OpacityPoint> opacity_;
};

} // namespace mote::app
