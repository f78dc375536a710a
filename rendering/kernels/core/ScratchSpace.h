#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace mote
{

/// Memory for arrays that together may be larger than the machine's: what goes beyond a budget lies
/// in files, whose pages the system takes away and brings back as it needs room.
///
/// The files have no names: nothing is left of them, however the process ends. Thread-safe.
class ScratchSpace
{
public:
  /// `beside`: a file, which need not be there, in whose folder scratch files are made. `budget`:
  /// bytes that may be held in memory proper.
  ScratchSpace(const std::string& beside, std::uint64_t budget);

  /// Memory for so many bytes, more than none, at a page's begin; what it holds at first is not
  /// defined. It is given back with the last pointer. Throws WriteError, which names the file that
  /// the space is beside, where its disk has no room, and std::bad_alloc. `inFile` spares the
  /// budget for others.
  std::shared_ptr<void> allocate(std::uint64_t bytes, bool inFile = false);

  /// Whether so many more bytes would lie in memory proper.
  bool hasRoomFor(std::uint64_t bytes) const
  {
    return bytes <= budget_ && *used_ <= budget_ - bytes;
  }

  std::uint64_t budget() const { return budget_; }
  /// Whether any memory has been given that lies in files.
  bool usesFiles() const { return usesFiles_; }

private:
  std::string beside_;
  std::uint64_t budget_;
  std::shared_ptr<std::atomic<std::uint64_t>> used_; ///< of the budget; memory may outlive this
  std::atomic<bool> usesFiles_{false};
};

} // namespace mote
