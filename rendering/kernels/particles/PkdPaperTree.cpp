#include "PkdPaperTree.h"

#include "detail/ParticleAttributes.h"
#include "detail/StoredRanges.h"

namespace mote
{

std::uint64_t PkdPaperTree::inputIndex(std::size_t slot) const
{
  const std::uint32_t* end = &words_[slot * wordsAParticle_] + wordsAParticle_;
  if (indexWords_ == 0)
    return slot;
  return indexWords_ == 1 ? end[-1] : std::uint64_t{end[-2]} << 32 | end[-1];
}

std::size_t PkdPaperTree::bytes() const
{
  const auto bytesOf = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytesOf(words_) + bytesOf(axes_) + bytesOf(subtreeRadius_) + bytesOf(values_) +
         bytesOf(visible_) + bytesOf(shown_);
}

void PkdPaperTree::clear()
{
  StoredParticles::clear();
  words_.clear();
  axes_.clear();
  subtreeRadius_.clear();
  visible_.clear();
  shown_.clear();
}

void PkdPaperTree::setVisibility(const std::function<bool(std::size_t)>& shown)
{
  keepVisibility(shown, count_, visible_);
  findShown();
}

void PkdPaperTree::setAttributes(const std::vector<ParticleAttribute>& attributes)
{
  checkAttributes(attributes, indexWords_ > 0);
  keepAttributes(
    attributes, count_, values_, [this](std::size_t slot) { return inputIndex(slot); });
  findShown();
}

void PkdPaperTree::setRanges(const ParticleRanges& ranges)
{
  keepRanges(ranges);
  findShown();
}

std::size_t PkdPaperTree::shownCount() const
{
  return countBits(shown_, count_);
}

void PkdPaperTree::findShown()
{
  const StoredRanges stored(ranges_, origin_, unit_, !values_.empty());
  shown_ = visible_;
  if (stored.limits == 0)
    return;
  findBits(count_, shown_,
    [&](std::size_t slot)
    {
      if (!visible_.empty() && (visible_[slot / 64] >> (slot % 64) & 1) == 0)
        return false;
      const float record[4] = {
        number(slot, 0), number(slot, 1), number(slot, 2), storedRadius(slot)};
      return stored.contain(record, values_.empty() ? nullptr : values_[slot].data());
    });
}

} // namespace mote
