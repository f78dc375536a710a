#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace mote
{

/// An allocator that leaves numbers uninitialised on resize(): large arrays are then first touched
/// by the threads that fill them, not once before by one thread that writes zeros.
template <typename T>
class RawAllocator : public std::allocator<T>
{
public:
  template <typename U>
  struct rebind
  {
    using other = RawAllocator<U>;
  };
  template <typename U>
  void construct(U* p)
  {
    ::new (static_cast<void*>(p)) U;
  }
  template <typename U, typename... Args>
  void construct(U* p, Args&&... args)
  {
    ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
  }
};

template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;

} // namespace mote
