#pragma once

#include "RawVector.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace mote
{

/// Values in one piece of memory, either the array's own, or somebody else's, such as a mapped
/// file's, or shared with its copies. Reading costs the same.
template <typename T>
class StoredArray
{
public:
  StoredArray() = default;
  StoredArray(const StoredArray& other) { *this = other; }
  StoredArray(StoredArray&& other) noexcept { *this = std::move(other); }
  ~StoredArray() = default;

  StoredArray& operator=(const StoredArray& other)
  {
    if (this == &other)
      return *this;
    own_ = other.own_;
    keeper_ = other.keeper_;
    given_ = nullptr; // who else keeps the memory does not write to it
    data_ = keeper_ ? other.data_ : own_.data();
    size_ = other.size_;
    return *this;
  }
  StoredArray& operator=(StoredArray&& other) noexcept
  {
    if (this == &other)
      return *this;
    own_ = std::move(other.own_); // the values stay where they are
    keeper_ = std::move(other.keeper_);
    given_ = std::exchange(other.given_, nullptr);
    data_ = std::exchange(other.data_, nullptr);
    size_ = std::exchange(other.size_, 0);
    other.clear();
    return *this;
  }

  /// Makes the values its own, uninitialised where there were less.
  void resize(std::size_t size)
  {
    keeper_.reset();
    given_ = nullptr;
    own_.resize(size);
    data_ = own_.data();
    size_ = size;
  }
  /// The same in memory that it is given; null stands for its own.
  void resize(std::size_t size, std::shared_ptr<void> memory)
  {
    if (!memory)
    {
      this->resize(size);
      return;
    }
    given_ = static_cast<T*>(memory.get());
    this->view(given_, size, std::move(memory));
  }
  /// Takes values as its own.
  void take(RawVector<T>&& values)
  {
    keeper_.reset();
    given_ = nullptr;
    own_ = std::move(values);
    data_ = own_.data();
    size_ = own_.size();
  }
  /// Forgets the values; memory of its own is kept for the next ones.
  void clear() { resize(0); }
  /// Takes `size` values at `data`, which are there as long as `keeper`, not null, lives.
  void view(const T* data, std::size_t size, std::shared_ptr<const void> keeper)
  {
    own_ = {};
    given_ = data == given_ ? given_ : nullptr;
    keeper_ = std::move(keeper);
    data_ = data;
    size_ = size;
  }

  /// Takes values that the array's copies share with it.
  void share(RawVector<T>&& values)
  {
    const auto keeper = std::make_shared<const RawVector<T>>(std::move(values));
    this->view(keeper->data(), keeper->size(), keeper);
  }

  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  /// For writing, after resize(); null where the values are somebody else's.
  T* own() { return keeper_ ? given_ : own_.data(); }
  std::size_t bytes() const { return (keeper_ ? size_ : own_.capacity()) * sizeof(T); }

private:
  RawVector<T> own_;
  std::shared_ptr<const void> keeper_;
  T* given_ = nullptr; ///< the values, where they may be written to and are not in own_
  const T* data_ = nullptr;
  std::size_t size_ = 0;
};

} // namespace mote
