#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace mote
{

/// A view of somebody else's numbers: `count` tuples of `components` values of one type, tuple
/// after tuple. It copies nothing and owns nothing; the viewed memory must outlive it.
class ArrayView
{
public:
  enum class Type : std::uint8_t
  {
    None,
    Float32,
    Float64,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64
  };
  /// Asks value() for the Euclidean length of the tuple.
  static constexpr int magnitude = -1;

  ArrayView() = default;
  ArrayView(const void* data, Type type, std::size_t count, int components)
    : data_(data)
    , count_(count)
    , components_(components)
    , type_(type)
  {
  }
  ArrayView(const float* data, std::size_t count, int components)
    : ArrayView(data, Type::Float32, count, components)
  {
  }
  ArrayView(const double* data, std::size_t count, int components)
    : ArrayView(data, Type::Float64, count, components)
  {
  }

  bool empty() const { return type_ == Type::None || count_ == 0; }
  std::size_t count() const { return count_; }
  int components() const { return components_; }
  Type type() const { return type_; }
  const void* data() const { return data_; }

  /// Whether it is the same view of the same memory.
  bool operator==(const ArrayView&) const = default;

  /// Component `c` of tuple `i` as a double; `c` in [0, components()) or `magnitude`.
  double value(std::size_t i, int c = 0) const
  {
    if (c >= 0)
      return raw(i * static_cast<std::size_t>(components_) + static_cast<std::size_t>(c));
    double sum = 0.0;
    for (int k = 0; k < components_; ++k)
    {
      const double v = value(i, k);
      sum += v * v;
    }
    return std::sqrt(sum);
  }

private:
  template <typename T>
  double as(std::size_t k) const
  {
    return static_cast<double>(static_cast<const T*>(data_)[k]);
  }

  double raw(std::size_t k) const
  {
    switch (type_)
    {
    case Type::Float32:
      return as<float>(k);
    case Type::Float64:
      return as<double>(k);
    case Type::Int8:
      return as<std::int8_t>(k);
    case Type::UInt8:
      return as<std::uint8_t>(k);
    case Type::Int16:
      return as<std::int16_t>(k);
    case Type::UInt16:
      return as<std::uint16_t>(k);
    case Type::Int32:
      return as<std::int32_t>(k);
    case Type::UInt32:
      return as<std::uint32_t>(k);
    case Type::Int64:
      return as<std::int64_t>(k);
    case Type::UInt64:
      return as<std::uint64_t>(k);
    case Type::None:
      break;
    }
    return 0.0;
  }

  const void* data_ = nullptr;
  std::size_t count_ = 0;
  int components_ = 1;
  Type type_ = Type::None;
};

} // namespace mote
