// By which faces rays leave their cells. To be included by CellWalkSimd.cpp, once for every
// instruction set.

#if defined(MOTE_WALK_EXITS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WALK_EXITS_INL
#undef MOTE_WALK_EXITS_INL
#else
#define MOTE_WALK_EXITS_INL
#endif

#include "WalkWide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

/// Coordinates of four corners.
struct Four
{
  V4 x, y, z;
};

HWY_INLINE Four fourOf(const WalkCells::Point* points, const std::uint32_t* ids)
{
  const D4 d;
  const hn::Repartition<double, D4> pairs;
  const V4 a = hn::Load(d, &points[ids[0]].x), b = hn::Load(d, &points[ids[1]].x);
  const V4 c = hn::Load(d, &points[ids[2]].x), e = hn::Load(d, &points[ids[3]].x);
  const auto abLow = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
  const auto ceLow = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
  const auto abHigh = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
  const auto ceHigh = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
  return {hn::BitCast(d, hn::InterleaveLower(pairs, abLow, ceLow)),
    hn::BitCast(d, hn::InterleaveUpper(pairs, abLow, ceLow)),
    hn::BitCast(d, hn::InterleaveLower(pairs, abHigh, ceHigh))};
}

/// Which of four edges turn counter-clockwise about the ray, and clockwise.
HWY_INLINE void turn(V4 ax, V4 ay, V4 bx, V4 by, unsigned first, unsigned& left, unsigned& right)
{
  const V4 p = hn::Mul(ax, by), q = hn::Mul(bx, ay);
  left |= bitsOf(hn::Gt(p, q)) << first;
  right |= bitsOf(hn::Lt(p, q)) << first;
}

/// A cell's corners about `count` rays.
template <std::size_t count>
struct alignas(64) CornersOf
{
  float x[8 * count], y[8 * count];
};

/// Finds the faces by which rays leave their cells, from winding numbers as CrossingLine has them.
/// An edge of which the two products are equal counts as not passed, for all of the cells that have
/// it: so nothing is lost between them. What more than one face says is left to seldomFaces().
template <int axis>
class WalkExits
{
public:
  WalkExits(WalkTask& task, Lanes& lanesOfTask)
    : task_(task)
    , l_(lanesOfTask)
    , mesh_{task.cells->points(), task.cells->mesh().cells(), task.cells->adjacency().data(),
        task.cells->bends(), task.cells->ofCells(), task.isBackwards,
        task.cells->mesh().cellCount() > std::size_t(INT32_MAX) / 6}
  {
  }

  /// Of all active lanes. Where there is none the face is noFace.
  HWY_INLINE void find()
  {
    task_.steps += static_cast<unsigned>(std::popcount(l_.active));
    const Mesh mesh = mesh_; // stores of SIMD vectors could change a member, for all compilers know
#if HWY_TARGET <= HWY_AVX3
    forCells([&](std::uint32_t cell, std::uint32_t same) { turnAll(mesh, cell, same); });
    std::uint32_t unsure = 0;
    for (std::size_t first = 0; first < lanes; first += 16)
      unsure |= decide(mesh, first) << first;
    std::uint32_t found = l_.active;
    forLanes(unsure, [&](std::size_t k) { found &= ~(isLost(mesh, k) ? 1U << k : 0U); });
    forLanes(found,
      [&](std::size_t k)
      {
        fetch(mesh, l_.behind[k]);
        const D d;
        const V xy = hn::Load(d, rows_[k][0]), zValue = hn::Load(d, rows_[k][1]);
        hn::Store(pick(xy, zValue, facePlaces.of[l_.outFace[k]]), d, l_.face[k]);
      });
#else
    forCells(
      [&](std::uint32_t cell, std::uint32_t same)
      {
        if (std::popcount(same) >= 2)
          together(mesh, cell, same);
        else
          alone(mesh, cell, static_cast<std::size_t>(std::countr_zero(same)));
      });
#endif
  }

private:
  struct Mesh
  {
    const WalkCells::Point* points;
    const HexMesh::Cell* cells;
    const std::array<std::uint32_t, 6>* next;
    const float* bends;
    const float* ofCells;
    bool isBackwards, isLarge; ///< more than indices of gathers reach
  };

  /// Calls visit(cell, lanes) for each cell that there are active lanes in.
  template <typename Visit>
  HWY_INLINE void forCells(const Visit& visit)
  {
    const DI di;
    for (std::uint32_t left = l_.active; left != 0;)
    {
      const std::uint32_t cell = l_.cell[std::countr_zero(left)];
      std::uint32_t same = 0;
      for (std::size_t first = 0; first < lanes; first += hn::Lanes(di))
      {
        const VI cells = hn::Load(di, reinterpret_cast<const std::int32_t*>(l_.cell + first));
        const auto is = hn::Eq(cells, hn::Set(di, static_cast<std::int32_t>(cell)));
        same |= maskOf(hn::RebindMask(D(), is)) << first;
      }
      same &= left;
      left &= ~same;
      visit(cell, same);
    }
  }

#if HWY_TARGET <= HWY_AVX3
  /// Of the rays in a cell, which edges turn about them: with all corners and edges in the lanes.
  HWY_INLINE void turnAll(const Mesh& mesh, std::uint32_t cell, std::uint32_t same)
  {
    const D d;
    const WideCell<axis> corners(mesh.points, mesh.cells[cell].data());
    forLanes(same,
      [&](std::size_t k)
      {
        const V xy = corners.about(l_, k);
        turnWide(xy, left_[k], right_[k]);
        hn::Store(xy, d, rows_[k][0]);
        hn::Store(corners.zValue, d, rows_[k][1]);
      });
  }

  /// Of 16 rays at a time. Where all edges of a face turn about the ray its winding number is 1. If
  /// the ray has come by the one face of which none does, it goes by the one of which all do. Gives
  /// the rays for which this does not tell.
  HWY_INLINE std::uint32_t decide(const Mesh& mesh, std::size_t first)
  {
    const DI d;
    const auto bits = static_cast<std::uint16_t>(l_.active >> first);
    const auto active = wide::lanesOf(bits);
    const VI every = hn::Set(d, 0xfff);
    const VI left = loadTurns(left_ + first), right = loadTurns(right_ + first);
    const VI set = hn::And(mesh.isBackwards ? right : left, every);
    const VI faces = wide::gather(active, turnFaces.of, set);
    const VI exit = hn::And(faces, hn::Set(d, 15)), in = hn::ShiftRight<4>(faces);
    auto sure = hn::And(active, hn::Eq(hn::And(hn::Xor(left, right), every), every));
    sure = hn::And(sure, hn::Ne(faces, hn::Set(d, TurnFaces::unsure)));
    if (mesh.isLarge)
      sure = wide::lanesOf(0);
    const VI cell = loadNumbers(l_.cell + first), slot = hn::Mul(cell, hn::Set(d, 6));
    const auto* next = mesh.next->data();
    const VI come = wide::gather(sure, next, hn::Add(slot, in));
    const VI behind = wide::gather(sure, next, hn::Add(slot, exit));
    const VI bend = wide::gather(sure, mesh.bends, cell);
    sure = hn::And(sure, hn::Eq(come, loadNumbers(l_.before + first)));
    const auto warped = hn::And(sure, hn::Lt(bend, hn::Zero(d)));
    if (!hn::AllFalse(d, warped))
    {
      const VI words = wide::gather(warped, task_.view->foldable(), hn::ShiftRight<5>(cell));
      const VI bit = hn::Shl(hn::Set(d, 1), hn::And(cell, hn::Set(d, 31)));
      sure = hn::AndNot(hn::And(warped, hn::TestBit(words, bit)), sure);
    }
    storeNumbers(in, l_.inFace + first);
    storeNumbers(exit, l_.outFace + first);
    storeNumbers(behind, l_.behind + first);
    hn::Store(hn::Abs(hn::BitCast(D(), bend)), D(), l_.bend + first);
    storeNumbers(cell, l_.before + first);
    if (mesh.ofCells != nullptr)
      wide::storeWhere(sure, wide::gather(sure, mesh.ofCells, cell), l_.cellValue + first);
    return bits & ~std::uint32_t(wide::bitsOf(sure));
  }
  static HWY_INLINE VI loadTurns(const std::uint16_t* turns)
  {
    return hn::PromoteTo(DI(), hn::Load(hn::Rebind<std::uint16_t, DI>(), turns));
  }
  static HWY_INLINE VI loadNumbers(const std::uint32_t* numbers)
  {
    return hn::BitCast(DI(), hn::Load(hn::RebindToUnsigned<DI>(), numbers));
  }
  static HWY_INLINE void storeNumbers(VI numbers, std::uint32_t* to)
  {
    const hn::RebindToUnsigned<DI> d;
    hn::Store(hn::BitCast(d, numbers), d, to);
  }

  /// Of a ray of which windings must tell: whether it goes by no face at all.
  HWY_INLINE bool isLost(const Mesh& mesh, std::size_t k)
  {
    const unsigned above = cornersAbove(hn::Load(D(), rows_[k][0]));
    const std::uint32_t windings = windingsOf(above, left_[k] & 0xfffU, right_[k] & 0xfffU);
    return note(mesh, l_.cell[k], k, noWindings + (mesh.isBackwards ? 0U - windings : windings)) ==
           noFace;
  }
#endif

  /// Of one ray, with corners and edges in the lanes.
  HWY_INLINE void alone(const Mesh& mesh, std::uint32_t cell, std::size_t k)
  {
    const D4 d;
    const std::uint32_t* ids = mesh.cells[cell].data();
    V4 x[2], y[2];
    CornersOf<1> corners;
    unsigned above = 0;
    for (std::size_t half = 0; half < 2; ++half)
    {
      const Four p = fourOf(mesh.points, ids + 4 * half);
      const V4 z = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      const V4 u = axis == 0 ? p.y : axis == 1 ? p.z : p.x;
      const V4 v = axis == 0 ? p.z : axis == 1 ? p.x : p.y;
      x[half] = hn::Sub(hn::Sub(u, hn::Set(d, l_.x[k])), hn::Mul(hn::Set(d, l_.dx[k]), z));
      y[half] = hn::Sub(hn::Sub(v, hn::Set(d, l_.y[k])), hn::Mul(hn::Set(d, l_.dy[k]), z));
      above |= bitsOf(hn::Gt(y[half], hn::Zero(d))) << 4 * half;
      hn::Store(x[half], d, corners.x + 4 * half);
      hn::Store(y[half], d, corners.y + 4 * half);
    }
    unsigned left = 0, right = 0;
    turn(x[0], y[0], hn::Shuffle0321(x[0]), hn::Shuffle0321(y[0]), 0, left, right);
    turn(x[1], y[1], hn::Shuffle0321(x[1]), hn::Shuffle0321(y[1]), 4, left, right);
    turn(x[0], y[0], x[1], y[1], 8, left, right);
    const std::uint32_t windings = windingsOf(above, left, right);
    take(mesh, cell, k, noWindings + (mesh.isBackwards ? 0U - windings : windings), corners, 0);
  }

  /// Of several rays in a cell, with the rays in the lanes.
  HWY_INLINE void together(const Mesh& mesh, std::uint32_t cell, std::uint32_t which)
  {
    const D d;
    const DI di;
    const std::uint32_t* ids = mesh.cells[cell].data();
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d))
    {
      const std::uint32_t here = which >> first & ((1U << hn::Lanes(d)) - 1);
      if (here == 0)
        continue;
      const V rayX = hn::Load(d, l_.x + first), rayY = hn::Load(d, l_.y + first);
      const V dx = hn::Load(d, l_.dx + first), dy = hn::Load(d, l_.dy + first);
      V x[8], y[8];
      CornersOf<lanes> corners;
      M above[8];
      for (std::size_t i = 0; i < 8; ++i)
      {
        const float* p = &mesh.points[ids[i]].x;
        const V z = set(p[axis]);
        x[i] = hn::Sub(hn::Sub(set(p[(axis + 1) % 3]), rayX), hn::Mul(dx, z));
        y[i] = hn::Sub(hn::Sub(set(p[(axis + 2) % 3]), rayY), hn::Mul(dy, z));
        above[i] = hn::Gt(y[i], hn::Zero(d));
        hn::Store(x[i], d, corners.x + i * lanes);
        hn::Store(y[i], d, corners.y + i * lanes);
      }
      VI windings = hn::Zero(di);
#pragma GCC unroll 12
      for (std::size_t e = 0; e < 12; ++e)
      {
        const std::size_t i = edgeCorners[e][0], j = edgeCorners[e][1];
        const V p = hn::Mul(x[i], y[j]), q = hn::Mul(x[j], y[i]);
        const M up = hn::And(hn::AndNot(above[i], above[j]), hn::Gt(p, q));
        const M down = hn::And(hn::AndNot(above[j], above[i]), hn::Lt(p, q));
        const VI add = hn::Set(di, static_cast<std::int32_t>(windingOf(e)));
        windings = hn::Add(windings, hn::IfThenElseZero(hn::RebindMask(di, up), add));
        windings = hn::Sub(windings, hn::IfThenElseZero(hn::RebindMask(di, down), add));
      }
      if (mesh.isBackwards)
        windings = hn::Neg(windings);
      windings = hn::Add(windings, hn::Set(di, noWindings));
      takeTogether(mesh, cell, first, here, windings, corners);
    }
  }

  /// Of rays in a cell, face by face.
  HWY_INLINE void takeTogether(const Mesh& mesh, std::uint32_t cell, std::size_t first,
    std::uint32_t here, VI windings, const CornersOf<lanes>& corners)
  {
    const D d;
    const DI di;
    const VI exits = hn::And(
      hn::And(windings, hn::ShiftRight<2>(windings)), hn::Set(di, 0x111111)); // where it is 5
    const std::uint32_t* ids = mesh.cells[cell].data();
    const float bend = mesh.bends[cell];
    std::uint32_t left = here;
    const bool isFoldable = std::signbit(bend) && task_.view->isFoldable(cell);
    for (std::uint32_t f = 0; f < 6 && left != 0 && !isFoldable; ++f)
    {
      const auto is = hn::Eq(exits, hn::Set(di, static_cast<std::int32_t>(1U << 4 * f)));
      const std::uint32_t which = maskOf(hn::RebindMask(D(), is)) & left;
      if (which == 0)
        continue;
      left &= ~which;
      const std::uint32_t behind = mesh.next[cell][f];
      fetch(mesh, behind);
      const M mask = lanesOf(which);
      const auto keep = [&](V value, float* to)
      { hn::Store(hn::IfThenElse(mask, value, hn::Load(d, to + first)), d, to + first); };
      const auto keepNumber = [&](std::uint32_t number, std::uint32_t* to)
      {
        const V value = hn::BitCast(d, hn::Set(di, static_cast<std::int32_t>(number)));
        keep(value, reinterpret_cast<float*>(to));
      };
      keep(set(std::abs(bend)), l_.bend);
      keepNumber(behind, l_.behind);
      keepNumber(f, l_.outFace);
      for (std::size_t i = 0; i < 4; ++i)
      {
        const std::size_t c = faceCorners[f][i];
        const float* p = &mesh.points[ids[c]].x;
        keep(hn::Load(d, corners.x + c * lanes), l_.cornerX[i]);
        keep(hn::Load(d, corners.y + c * lanes), l_.cornerY[i]);
        keep(set(p[axis]), l_.cornerZ[i]);
        keep(set(p[3]), l_.cornerValue[i]);
      }
    }
    if (mesh.ofCells != nullptr)
      forLanes(here, [&](std::size_t k) { l_.cellValue[first + k] = mesh.ofCells[cell]; });
    alignas(64) std::int32_t all[lanes];
    hn::Store(windings, di, all);
    for (std::uint32_t some = here & ~left; some != 0; some &= some - 1)
    {
      const auto k = static_cast<std::size_t>(std::countr_zero(some));
      l_.inFace[first + k] = entryOf(static_cast<std::uint32_t>(all[k]));
    }
    for (; left != 0; left &= left - 1)
    {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      take(mesh, cell, first + k, static_cast<std::uint32_t>(all[k]), corners, k);
    }
  }

  /// The face of which the winding number is -1, 3 as it is kept.
  static HWY_INLINE std::uint32_t entryOf(std::uint32_t windings)
  {
    const std::uint32_t entries = windings & windings >> 1 & ~(windings >> 2) & 0x111111U;
    return static_cast<std::uint32_t>(std::countr_zero(entries)) / 4;
  }
  static HWY_INLINE void fetch(const Mesh& mesh, std::uint32_t cell)
  {
    if (cell == HexMesh::noCell)
      return;
    __builtin_prefetch(&mesh.cells[cell]);
    __builtin_prefetch(&mesh.next[cell]);
    __builtin_prefetch(&mesh.bends[cell]);
  }

  /// Notes by which faces a ray comes and goes. Gives the latter; or noFace.
  HWY_INLINE unsigned note(
    const Mesh& mesh, std::uint32_t cell, std::size_t k, std::uint32_t windings)
  {
    const std::uint32_t exits = windings & windings >> 2 & 0x111111U; // 5
    const float bend = mesh.bends[cell];
    unsigned exit = static_cast<unsigned>(std::countr_zero(exits)) / 4;
    l_.inFace[k] = entryOf(windings);
    const bool isUnsure = exits == 0 || (exits & (exits - 1)) != 0;
    if (HWY_UNLIKELY(isUnsure || (std::signbit(bend) && task_.view->isFoldable(cell))))
    {
      const WalkFaces faces = seldomFaces(task_, l_.ray(k), cell, l_.z[k]);
      exit = faces.out;
      l_.inFace[k] = faces.in;
    }
    l_.outFace[k] = exit;
    l_.bend[k] = std::abs(bend);
    const std::uint32_t behind = exit == noFace ? HexMesh::noCell : mesh.next[cell][exit];
    fetch(mesh, behind);
    l_.behind[k] = behind;
    if (mesh.ofCells != nullptr)
      l_.cellValue[k] = mesh.ofCells[cell];
    return exit;
  }

  template <std::size_t count>
  HWY_INLINE void take(const Mesh& mesh, std::uint32_t cell, std::size_t k, std::uint32_t windings,
    const CornersOf<count>& corners, std::size_t at)
  {
    const unsigned exit = note(mesh, cell, k, windings);
    if (exit == noFace)
      return;
    const std::uint32_t* ids = mesh.cells[cell].data();
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::size_t c = faceCorners[exit][i];
      const float* p = &mesh.points[ids[c]].x;
      l_.cornerX[i][k] = corners.x[c * count + at];
      l_.cornerY[i][k] = corners.y[c * count + at];
      l_.cornerZ[i][k] = p[axis];
      l_.cornerValue[i][k] = p[3];
    }
  }

  WalkTask& task_;
  Lanes& l_;
  const Mesh mesh_;
#if HWY_TARGET <= HWY_AVX3
  alignas(64) float rows_[lanes][2][16]; ///< corners about the rays; depths and values
  alignas(64) std::uint16_t left_[lanes]{}, right_[lanes]{}; ///< see turnWide()
#endif
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
