// Many look-ups in occlusion maps at a time, compiled once for every SIMD instruction set.

#include "OcclusionLookUp.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/OcclusionLookUp.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<std::int32_t, DF>;
using VF = hn::Vec<DF>;

constexpr float pi = 3.14159265358979f;

HWY_INLINE VF set(float x)
{
  return hn::Set(DF(), x);
}

/// The polynomial of x with these coefficients, the highest power's first.
template <std::size_t N>
HWY_INLINE VF polynomial(VF x, const float (&coefficients)[N])
{
  VF sum = set(coefficients[0]);
  for (std::size_t k = 1; k < N; ++k)
    sum = hn::MulAdd(sum, x, set(coefficients[k]));
  return sum;
}

/// The arc cosine of x in [-1, 1], within 1e-7: Abramowitz and Stegun, 4.4.46.
HWY_INLINE VF arcCosine(VF x)
{
  static constexpr float coefficients[] = {-0.0012624911f, 0.0066700901f, -0.0170881256f,
    0.0308918810f, -0.0501743046f, 0.0889789874f, -0.2145988016f, 1.5707963050f};
  const VF size = hn::Min(hn::Abs(x), set(1.0f));
  const VF angle = hn::Mul(hn::Sqrt(hn::Sub(set(1.0f), size)), polynomial(size, coefficients));
  return hn::IfThenElse(hn::Lt(x, set(0.0f)), hn::Sub(set(pi), angle), angle);
}

/// The angle of (x, y), in [0, 2 pi], within 1e-6: Abramowitz and Stegun, 4.4.49. 0 for (0, 0).
HWY_INLINE VF angleOf(VF x, VF y)
{
  static constexpr float coefficients[] = {0.0028662257f, -0.0161657367f, 0.0429096138f,
    -0.0752896400f, 0.1065626393f, -0.1420889944f, 0.1999355085f, -0.3333314528f, 1.0f};
  const VF ax = hn::Abs(x), ay = hn::Abs(y);
  const VF most = hn::Max(hn::Max(ax, ay), set(1e-30f));
  const VF ratio = hn::Div(hn::Min(ax, ay), most);
  VF angle = hn::Mul(ratio, polynomial(hn::Mul(ratio, ratio), coefficients));
  angle = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(set(0.5f * pi), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, set(0.0f)), hn::Sub(set(pi), angle), angle);
  return hn::IfThenElse(hn::Lt(y, set(0.0f)), hn::Sub(set(2.0f * pi), angle), angle);
}

void placeAll(OcclusionLookUp& b, int count)
{
  const DF d;
  const DI di;
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d)))
  {
    const VF side = hn::Load(d, b.side + i);
    const VF polar = arcCosine(hn::Load(d, b.nz + i));
    const VF around = angleOf(hn::Load(d, b.nx + i), hn::Load(d, b.ny + i));
    const VF v = hn::MulSub(hn::Mul(polar, set(1.0f / pi)), side, set(0.5f));
    const VF u = hn::MulSub(hn::Mul(around, set(0.5f / pi)), side, set(0.5f));
    const VF row = hn::Floor(v), column = hn::Floor(u);
    hn::Store(hn::ConvertTo(di, row), di, b.upper + i);
    hn::Store(hn::ConvertTo(di, column), di, b.column + i);
    hn::Store(hn::Sub(v, row), d, b.down + i);
    hn::Store(hn::Sub(u, column), d, b.along + i);
  }
}

void blendAll(OcclusionLookUp& b, int count, float maximum)
{
  const DF d;
  const DI di;
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d)))
  {
    const auto square = [&](int k)
    {
      const VF q = hn::ConvertTo(d, hn::Load(di, b.texel[k] + i));
      return hn::Mul(q, q);
    };
    const VF along = hn::Load(d, b.along + i), down = hn::Load(d, b.down + i);
    const VF a = square(0), c = square(2);
    const VF upper = hn::MulAdd(along, hn::Sub(square(1), a), a);
    const VF lower = hn::MulAdd(along, hn::Sub(square(3), c), c);
    const VF value = hn::MulAdd(down, hn::Sub(lower, upper), upper);
    hn::Store(hn::Mul(hn::Div(value, set(255.0f * 255.0f)), set(maximum)), d, b.value + i);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(placeAll);
HWY_EXPORT(blendAll);

void OcclusionLookUp::place(int count)
{
  HWY_DYNAMIC_DISPATCH(placeAll)(*this, count);
}

void OcclusionLookUp::blend(int count, float maximum)
{
  HWY_DYNAMIC_DISPATCH(blendAll)(*this, count, maximum);
}

} // namespace mote

#endif
