#include <kernels/core/ArrayView.h>

#include <gtest/gtest.h>

#include <vector>

using mote::ArrayView;

namespace
{

template <typename T>
void expectValues(ArrayView::Type type)
{
  const std::vector<T> values = {T(3), T(4), T(12), T(100), T(0), T(1)};
  const ArrayView view(values.data(), type, 2, 3);
  EXPECT_EQ(view.count(), 2u);
  EXPECT_EQ(view.components(), 3);
  EXPECT_FALSE(view.empty());
  for (std::size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(view.value(i, c), double(values[3 * i + static_cast<std::size_t>(c)]));
  EXPECT_DOUBLE_EQ(view.value(0, ArrayView::magnitude), 13.0);
}

} // namespace

TEST(ArrayView, ReadsEveryType)
{
  expectValues<float>(ArrayView::Type::Float32);
  expectValues<double>(ArrayView::Type::Float64);
  expectValues<std::int8_t>(ArrayView::Type::Int8);
  expectValues<std::uint8_t>(ArrayView::Type::UInt8);
  expectValues<std::int16_t>(ArrayView::Type::Int16);
  expectValues<std::uint16_t>(ArrayView::Type::UInt16);
  expectValues<std::int32_t>(ArrayView::Type::Int32);
  expectValues<std::uint32_t>(ArrayView::Type::UInt32);
  expectValues<std::int64_t>(ArrayView::Type::Int64);
  expectValues<std::uint64_t>(ArrayView::Type::UInt64);
}

TEST(ArrayView, KeepsSignsAndRanges)
{
  const std::int8_t small[] = {-128, 127};
  EXPECT_EQ(ArrayView(small, ArrayView::Type::Int8, 2, 1).value(0), -128.0);
  const std::uint8_t bytes[] = {255};
  EXPECT_EQ(ArrayView(bytes, ArrayView::Type::UInt8, 1, 1).value(0), 255.0);
  const std::int64_t large[] = {-(std::int64_t{1} << 53)};
  EXPECT_EQ(ArrayView(large, ArrayView::Type::Int64, 1, 1).value(0), -0x1p53);
  const std::uint64_t larger[] = {std::uint64_t{1} << 63};
  EXPECT_EQ(ArrayView(larger, ArrayView::Type::UInt64, 1, 1).value(0), 0x1p63);
}

TEST(ArrayView, IsEmptyUnlessGivenSomething)
{
  EXPECT_TRUE(ArrayView().empty());
  EXPECT_EQ(ArrayView().count(), 0u);
  const float none[] = {0.0f};
  EXPECT_TRUE(ArrayView(none, 0, 3).empty());
}
