#pragma once

#include "../core/RawVector.h"
#include "StoredParticles.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace mote
{

/// Large groups of particles that are one and the same sphere: those that a simulation took out
/// and left at one place, say. Of such a group rays can meet but the first of the input that is
/// shown, and would else test all.
class RepeatedSpheres
{
public:
  /// Groups smaller than this are not worth it.
  static constexpr std::size_t smallest = 512;

  bool empty() const { return starts_.empty(); }
  void clear()
  {
    runs_.clear();
    starts_.clear();
  }
  std::size_t bytes() const
  {
    return runs_.capacity() * sizeof(SlotRun) + starts_.capacity() * sizeof(std::size_t);
  }

  /// Begins a group; addRun() adds to the last one.
  void addGroup() { starts_.push_back(runs_.size()); }
  void addRun(std::size_t first, std::size_t last)
  {
    if (runs_.size() > starts_.back() && runs_.back().last == first)
      runs_.back().last = last;
    else
      runs_.push_back({first, last});
  }
  /// The groups of another one behind those here.
  void add(const RepeatedSpheres& other)
  {
    for (const std::size_t start : other.starts_)
      starts_.push_back(runs_.size() + start);
    runs_.insert(runs_.end(), other.runs_.begin(), other.runs_.end());
  }

  /// Of bits that say what is shown, the first slot's lowest, leaves in every group one: that of
  /// the smallest inputIndex(slot).
  template <typename Word, typename InputIndex>
  void leaveFirst(RawVector<Word>& words, const InputIndex& inputIndex) const
  {
    constexpr std::size_t bits = 8 * sizeof(Word);
    for (std::size_t group = 0; group < starts_.size(); ++group)
    {
      const std::size_t end = group + 1 < starts_.size() ? starts_[group + 1] : runs_.size();
      std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
      std::size_t kept = 0;
      for (std::size_t run = starts_[group]; run < end; ++run)
        for (std::size_t slot = runs_[run].first; slot < runs_[run].last; ++slot)
        {
          Word& word = words[slot / bits];
          const auto bit = static_cast<Word>(Word{1} << (slot % bits));
          if ((word & bit) == 0)
            continue;
          word = static_cast<Word>(word & ~bit);
          if (const std::uint64_t index = inputIndex(slot); index < first)
          {
            first = index;
            kept = slot;
          }
        }
      if (first != std::numeric_limits<std::uint64_t>::max())
        words[kept / bits] = static_cast<Word>(words[kept / bits] | Word{1} << (kept % bits));
    }
  }

private:
  std::vector<SlotRun> runs_;
  std::vector<std::size_t> starts_; ///< of each group in runs_
};

} // namespace mote
