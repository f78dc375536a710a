// A queue that gives what is nearest first, included once per SIMD instruction set.

#if defined(MOTE_NEAREST_FIRST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_NEAREST_FIRST_INL_H
#undef MOTE_NEAREST_FIRST_INL_H
#else
#define MOTE_NEAREST_FIRST_INL_H
#endif

#include "../../core/RawVector.h"
#include "BundlePencil-inl.h"

#include <cstdint>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// A heap of entries that have 16 children each, so that the least of them is found at once and
/// what a ray bundle has waiting is one or two levels deep. Of equally near entries any may come
/// first, the same one on every machine.
class NearestFirst
{
public:
  /// A node, or, where the level is -1, a bucket.
  struct Entry
  {
    float near; ///< kappa before which it holds nothing
    std::int32_t level;
    std::size_t index;
  };

  void clear()
  {
    std::fill_n(keys_.begin(), std::min(keys_.size(), offset + size_), infinity);
    size_ = 0;
  }
  bool empty() const { return size_ == 0; }

  HWY_INLINE void push(const Entry& entry)
  {
    if (HWY_UNLIKELY(size_ == entries_.size()))
      grow();
    std::size_t i = size_++;
    while (i > 0)
    {
      const std::size_t parent = (i - 1) / arity;
      if (!(entry.near < keys_[offset + parent]))
        break;
      put(i, entries_[parent]);
      i = parent;
    }
    put(i, entry);
  }

  HWY_INLINE Entry pop()
  {
    const Entry nearest = entries_[0], last = entries_[--size_];
    keys_[offset + size_] = infinity;
    std::size_t i = 0;
    for (std::size_t first = 1; first < size_; first = arity * i + 1)
    {
      const std::size_t child = first + leastOf(&keys_[offset + first]);
      if (!(keys_[offset + child] < last.near))
        break;
      put(i, entries_[child]);
      i = child;
    }
    if (size_ > 0)
      put(i, last);
    return nearest;
  }

private:
  static constexpr std::size_t arity = 16;
  /// Children of an entry begin where a cache line does.
  static constexpr std::size_t offset = arity - 1;

  void put(std::size_t i, const Entry& entry)
  {
    entries_[i] = entry;
    keys_[offset + i] = entry.near;
  }

  void grow()
  {
    entries_.resize(2 * size_ + arity);
    keys_.resize(offset + entries_.size() + arity, infinity);
  }

  /// Which of 16 numbers is least; of equal ones the first.
  static HWY_INLINE std::size_t leastOf(const float* keys)
  {
    const DF d;
    VF least = hn::LoadU(d, keys);
    for (std::size_t k = hn::Lanes(d); k < arity; k += hn::Lanes(d))
      least = hn::Min(least, hn::LoadU(d, keys + k));
    least = hn::MinOfLanes(d, least);
    unsigned bits = 0;
    for (std::size_t k = 0; k < arity; k += hn::Lanes(d))
      bits |= bitsOf(hn::Eq(hn::LoadU(d, keys + k), least)) << k;
    return static_cast<std::size_t>(__builtin_ctz(bits));
  }

  std::vector<Entry> entries_;
  std::vector<float> keys_; ///< entries' `near`, then infinity
  std::size_t size_ = 0;
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
