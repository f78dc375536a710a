#pragma once

#include "CellValues.h"
#include "Part.h"
#include "settings/IdRanges.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace mote::app
{

/// A particle, or a cell of a volume or of a mesh, by its number in a part's data set.
struct Picked
{
  enum class Kind : unsigned char
  {
    Particle,
    Cell
  };
  int part = 0; ///< of the stage's parts
  Kind kind = Kind::Particle;
  vtkIdType id = 0;
  bool operator==(const Picked&) const = default;
};

/// What can be picked of a part.
Picked::Kind kindOfPicks(const Part& part);

/// What the user picked, in the order of picking; each once. There may be millions.
class PickedSet
{
public:
  using Parts = std::vector<std::unique_ptr<Part>>;

  const std::vector<Picked>& items() const { return items_; }
  bool empty() const { return items_.empty(); }
  bool contains(const Picked& picked) const { return keys_.contains(keyOf(picked)); }
  /// Changes with the set.
  unsigned long version() const { return version_; }

  void clear();
  /// Adds those that are not in it yet.
  void add(const std::vector<Picked>& picked);
  /// Adds it, or takes it away.
  void toggle(const Picked& picked);

  /// Where a cell was picked; placeOf() is the middle of the cell else.
  void setPlace(const Picked& picked, const std::array<double, 3>& place);
  std::array<double, 3> placeOf(const Parts& parts, const Picked& picked) const;
  /// How the points of a cell count there.
  CellWeights weightsOf(const Parts& parts, const Picked& picked) const;

  /// The ids of the particles and the numbers of the cells among them, as --hide-ids takes them;
  /// and of the particles alone.
  IdRanges ids(const Parts& parts) const;
  IdRanges particleIds(const Parts& parts) const;
  /// "12 particles", "3 cells", "12 particles and 3 cells".
  std::string counts() const;

  //@{
  /// Them as MarkSettings::picked: in the order of picking where they are so
  /// few that something is measured, else in ranges. And what such words name, taken in.
  std::vector<std::string> words(const Parts& parts) const;
  void addNamed(const Parts& parts, const std::vector<std::string>& words);
  //@}

  /// What is known of the picked from one time step to the next.
  struct Names
  {
    std::vector<std::int64_t> ids;    ///< of particles, numbers of cells: one of each of items()
    std::vector<vtkIdType> cellsThen; ///< how many cells the parts have
  };
  //@{
  /// Before and after other data take the place of the present ones: the particles of the same ids
  /// stay picked, and the cells of the same numbers where there are as many of them. Particles that
  /// the new data lack are picked again by data that have them.
  Names names(const Parts& parts) const;
  void findAgain(const Parts& parts, const Names& names);
  //@}
  /// How many of the picked particles the present data lack.
  std::size_t numberAway() const { return away_.size(); }
  /// Whether particles are picked, those included that the present data lack.
  bool hasParticles() const;
  /// What was picked last; null where that is nothing, or the present data lack it.
  const Picked* last() const;
  /// Forgets what the parts do not have.
  void keepWhatIs(const Parts& parts);

private:
  /// A picked particle that the present data lack.
  struct Away
  {
    std::size_t place; ///< among the items, in the order of picking
    int part;
    std::int64_t id;
    bool operator==(const Away&) const = default;
  };
  static std::uint64_t keyOf(const Picked& picked);
  IdRanges idsOf(const Parts& parts, bool particlesAlone) const;
  void replace(std::vector<Picked> items, std::vector<Away> away = {});

  std::vector<Picked> items_;
  std::vector<Away> away_; ///< by ascending place
  std::unordered_set<std::uint64_t> keys_;
  std::unordered_map<std::uint64_t, std::array<double, 3>> places_;
  unsigned long version_ = 0;
};

} // namespace mote::app
