#include "VisibleCells.h"

#include "kernels/core/Error.h"

#include <cstdint>
#include <string>

namespace mote
{

bool VisibleCells::set(vtkUnsignedCharArray* isVisible)
{
  const bool isOther = isVisible_ != isVisible;
  isVisible_ = isVisible;
  seen_ = 0;
  return isOther;
}

const InputKey& VisibleCells::key(vtkIdType cells)
{
  if (isVisible_ && isVisible_->GetNumberOfValues() != cells)
    throw Error("There are " + std::to_string(isVisible_->GetNumberOfValues()) +
                " values that say which of " + std::to_string(cells) + " cells are visible.");
  if (!isVisible_)
    key_.clear();
  else if (seen_ != isVisible_->GetMTime())
  {
    const auto bytes = static_cast<std::size_t>(isVisible_->GetNumberOfValues());
    const ContentHash hash = hashOf(isVisible_->GetPointer(0), bytes);
    key_.clear();
    for (const std::uint64_t word : {hash.low, hash.high})
      for (const std::uint64_t half : {word >> 32, word & 0xffffffffU}) // exact as doubles
        key_.push_back(static_cast<double>(half));
    seen_ = isVisible_->GetMTime();
  }
  return key_;
}

} // namespace mote
