#pragma once

#include "HugePages.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace mote
{

/// An allocator that leaves numbers uninitialised on resize(): large arrays are then first touched
/// by the threads that fill them, not once before by one thread that writes zeros. Large arrays
/// lie in huge pages where the system has some: what is read here and there then misses fewer
/// translations of addresses, and the system clears fewer pages.
template <typename T>
class RawAllocator : public std::allocator<T>
{
public:
  template <typename U>
  struct rebind
  {
    using other = RawAllocator<U>;
  };
  T* allocate(std::size_t count)
  {
    if (count <= leastHuge / sizeof(T))
      return std::allocator<T>::allocate(count);
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T) - hugePage)
      throw std::bad_array_new_length();
    constexpr std::size_t alignment = std::max(hugePage, alignof(T));
    void* memory = ::operator new(count * sizeof(T), std::align_val_t(alignment));
    preferHugePages(memory, count * sizeof(T));
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count)
  {
    if (count <= leastHuge / sizeof(T))
      std::allocator<T>::deallocate(memory, count);
    else
      ::operator delete(memory, std::align_val_t(std::max(hugePage, alignof(T))));
  }

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

private:
  static constexpr std::size_t hugePage = std::size_t{1} << 21;
  static constexpr std::size_t leastHuge = 2 * hugePage; ///< bytes
};

template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;

} // namespace mote
