#include "PickedSet.h"

#include "Ids.h"
#include "PlacedCell.h"
#include "base/Text.h"
#include "settings/Values.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>

#include <algorithm>

namespace mote::app
{

namespace
{

bool has(const PickedSet::Parts& parts, const Picked& picked)
{
  if (picked.part < 0 || picked.part >= static_cast<int>(parts.size()) || picked.id < 0)
    return false;
  const Part& part = *parts[static_cast<std::size_t>(picked.part)];
  return kindOfPicks(part) == picked.kind &&
         picked.id < (picked.kind == Picked::Kind::Cell ? part.data()->GetNumberOfCells()
                                                        : part.data()->GetNumberOfPoints());
}

/// Puts the particles of part k in the place of their ids; -1 where there is none.
void findIn(const Part& part, int k, std::vector<Picked>& picked)
{
  vtkDataArray* ids = part.kind() == Part::Kind::Particles ? idArrayOf(part.data()) : nullptr;
  if (!ids)
    return; // numbers are ids
  std::unordered_map<std::int64_t, std::vector<std::size_t>> wanted;
  for (std::size_t i = 0; i < picked.size(); ++i)
    if (picked[i].part == k && picked[i].kind == Picked::Kind::Particle)
    {
      wanted[picked[i].id].push_back(i);
      picked[i].id = -1; // until it is found
    }
  for (vtkIdType p = 0; !wanted.empty() && p < ids->GetNumberOfTuples(); ++p)
    if (const auto those = wanted.find(idOf(ids, p)); those != wanted.end())
    {
      // Ids that stand twice name as many as were picked.
      picked[those->second.back()].id = p;
      those->second.pop_back();
      if (those->second.empty())
        wanted.erase(those);
    }
}

} // namespace

Picked::Kind kindOfPicks(const Part& part)
{
  return part.kind() == Part::Kind::Particles ? Picked::Kind::Particle : Picked::Kind::Cell;
}

std::uint64_t PickedSet::keyOf(const Picked& picked)
{
  return static_cast<std::uint64_t>(picked.part) << 50 |
         static_cast<std::uint64_t>(picked.kind) << 48 | static_cast<std::uint64_t>(picked.id);
}

void PickedSet::clear()
{
  this->replace({});
}

void PickedSet::replace(std::vector<Picked> items, std::vector<Away> away)
{
  if (items.empty() && items_.empty() && away == away_)
    return;
  items_ = std::move(items);
  away_ = std::move(away);
  keys_.clear();
  keys_.reserve(items_.size());
  for (const Picked& picked : items_)
    keys_.insert(keyOf(picked));
  std::erase_if(places_, [this](const auto& place) { return !keys_.contains(place.first); });
  ++version_;
}

void PickedSet::add(const std::vector<Picked>& picked)
{
  items_.reserve(items_.size() + picked.size());
  keys_.reserve(keys_.size() + picked.size());
  for (const Picked& one : picked)
    if (keys_.insert(keyOf(one)).second)
      items_.push_back(one);
  ++version_;
}

void PickedSet::toggle(const Picked& picked)
{
  if (!this->contains(picked))
    return this->add({picked});
  keys_.erase(keyOf(picked));
  places_.erase(keyOf(picked));
  std::erase(items_, picked);
  ++version_;
}

bool PickedSet::hasParticles() const
{
  return !away_.empty() ||
         std::any_of(items_.begin(), items_.end(),
           [](const Picked& picked) { return picked.kind == Picked::Kind::Particle; });
}

const Picked* PickedSet::last() const
{
  const bool isAway = !away_.empty() && away_.back().place + 1 >= items_.size() + away_.size();
  return items_.empty() || isAway ? nullptr : &items_.back();
}

void PickedSet::setPlace(const Picked& picked, const std::array<double, 3>& place)
{
  places_[keyOf(picked)] = place;
}

CellWeights PickedSet::weightsOf(const Parts& parts, const Picked& picked) const
{
  const Part& part = *parts[static_cast<std::size_t>(picked.part)];
  if (const auto known = places_.find(keyOf(picked)); known != places_.end())
    if (auto weights = placedCell(part, picked.id, known->second).weights)
      return *std::move(weights);
  return evenWeights(part.data(), picked.id);
}

std::array<double, 3> PickedSet::placeOf(const Parts& parts, const Picked& picked) const
{
  std::array<double, 3> place{};
  if (const auto known = places_.find(keyOf(picked)); known != places_.end())
    return known->second;
  vtkDataSet* data = parts[static_cast<std::size_t>(picked.part)]->data();
  if (picked.kind != Picked::Kind::Cell)
  {
    data->GetPoint(picked.id, place.data());
    return place;
  }
  double bounds[6];
  data->GetCellBounds(picked.id, bounds);
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  const auto placed = parts[static_cast<std::size_t>(picked.part)]->placements().front();
  placed->TransformPoint(place.data(), place.data());
  return place;
}

IdRanges PickedSet::ids(const Parts& parts) const
{
  return this->idsOf(parts, false);
}

IdRanges PickedSet::particleIds(const Parts& parts) const
{
  return this->idsOf(parts, true);
}

std::string PickedSet::counts() const
{
  const auto all = static_cast<std::int64_t>(items_.size());
  const auto cells = static_cast<std::int64_t>(std::count_if(items_.begin(), items_.end(),
    [](const Picked& one) { return one.kind == Picked::Kind::Cell; }));
  const std::string ofCells = counted(cells, "cell"), rest = counted(all - cells, "particle");
  return cells == 0 ? rest : cells == all ? ofCells : rest + " and " + ofCells;
}

IdRanges PickedSet::idsOf(const Parts& parts, bool particlesAlone) const
{
  const auto counts = [&](const auto& part)
  { return !particlesAlone || part->kind() == Part::Kind::Particles; };
  const bool isAlone = std::count_if(parts.begin(), parts.end(), counts) == 1;
  std::vector<vtkDataArray*> arrays;
  for (const auto& part : parts)
    arrays.push_back(idArrayOf(part->data()));
  std::vector<IdRange> ranges;
  for (const Picked& picked : items_)
  {
    const bool isParticle = picked.kind == Picked::Kind::Particle;
    if (!isParticle && particlesAlone)
      continue;
    const std::int64_t id =
      isParticle ? idOf(arrays[static_cast<std::size_t>(picked.part)], picked.id) : picked.id;
    ranges.push_back({isAlone ? 0 : picked.part + 1, id, id});
  }
  for (const Away& away : away_)
    ranges.push_back({isAlone ? 0 : away.part + 1, away.id, away.id});
  return IdRanges(std::move(ranges));
}

std::vector<std::string> PickedSet::words(const Parts& parts) const
{
  constexpr std::size_t mostMeasured = 3;
  if (items_.size() > mostMeasured || !away_.empty())
    return ValuesOf<IdRanges>::words(this->ids(parts));
  std::vector<std::string> words;
  for (const Picked& picked : items_)
  {
    PickedSet alone;
    alone.toggle(picked);
    for (const std::string& word : ValuesOf<IdRanges>::words(alone.ids(parts)))
      words.push_back(word);
  }
  return words;
}

void PickedSet::addNamed(const Parts& parts, const std::vector<std::string>& words)
{
  constexpr std::size_t mostMeasured = 3;
  // A look through the data for each of a few keeps their order.
  std::vector<IdRanges> looks;
  if (words.size() > mostMeasured)
    looks.push_back(ValuesOf<IdRanges>::parse(words, {}));
  else
    for (const std::string& word : words)
      looks.push_back(ValuesOf<IdRanges>::parse({word}, {}));
  std::vector<Picked> found;
  for (const IdRanges& look : looks)
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      const Picked::Kind kind = kindOfPicks(*parts[k]);
      const bool isCell = kind == Picked::Kind::Cell;
      vtkDataSet* data = parts[k]->data();
      vtkDataArray* ids = isCell ? nullptr : idArrayOf(data);
      const vtkIdType count = isCell ? data->GetNumberOfCells() : data->GetNumberOfPoints();
      const auto wanted = look.of(static_cast<int>(k) + 1);
      for (vtkIdType i = 0; !wanted.empty() && i < count; ++i)
        if (holds(wanted, idOf(ids, i)))
          found.push_back({static_cast<int>(k), kind, i});
    }
  this->add(found);
}

PickedSet::Names PickedSet::names(const Parts& parts) const
{
  Names names;
  names.ids.reserve(items_.size());
  std::vector<vtkDataArray*> arrays;
  for (const auto& part : parts)
  {
    arrays.push_back(items_.empty() ? nullptr : idArrayOf(part->data()));
    names.cellsThen.push_back(part->data()->GetNumberOfCells());
  }
  for (const Picked& picked : items_)
    names.ids.push_back(picked.kind == Picked::Kind::Particle && has(parts, picked)
                          ? idOf(arrays[static_cast<std::size_t>(picked.part)], picked.id)
                          : picked.id);
  return names;
}

void PickedSet::findAgain(const Parts& parts, const Names& names)
{
  if (items_.empty() && away_.empty())
    return;
  // All that were picked, in the order of picking, by what names them.
  std::vector<Picked> found = items_;
  for (std::size_t i = 0; i < found.size(); ++i)
    found[i].id = names.ids[i];
  for (const Away& away : away_)
    found.insert(found.begin() + static_cast<std::ptrdiff_t>(std::min(away.place, found.size())),
      {away.part, Picked::Kind::Particle, away.id});
  const std::vector<Picked> wanted = found;
  for (std::size_t k = 0; k < parts.size(); ++k)
    findIn(*parts[k], static_cast<int>(k), found);
  std::vector<Away> away;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const auto part = static_cast<std::size_t>(found[i].part);
    const bool isCell = found[i].kind == Picked::Kind::Cell;
    // A number says nothing of the cells of another mesh.
    if (isCell && (part >= parts.size() || part >= names.cellsThen.size() ||
                    parts[part]->data()->GetNumberOfCells() != names.cellsThen[part]))
      found[i].id = -1;
    if (!isCell && !has(parts, found[i]))
      away.push_back({i, wanted[i].part, wanted[i].id});
  }
  std::erase_if(found, [&](const Picked& picked) { return !has(parts, picked); });
  // Meshes may have moved.
  std::unordered_map<std::uint64_t, std::array<double, 3>> places;
  for (const Picked& picked : found)
    if (const auto known = places_.find(keyOf(picked));
        known != places_.end() &&
        placedCell(*parts[static_cast<std::size_t>(picked.part)], picked.id, known->second).weights)
      places.insert(*known);
  places_ = std::move(places);
  this->replace(std::move(found), std::move(away));
}

void PickedSet::keepWhatIs(const Parts& parts)
{
  std::vector<Picked> kept;
  std::copy_if(items_.begin(), items_.end(), std::back_inserter(kept),
    [&](const Picked& picked) { return has(parts, picked); });
  if (kept.size() != items_.size())
    this->replace(std::move(kept), away_);
}

} // namespace mote::app
