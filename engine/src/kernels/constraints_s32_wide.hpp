// SPDX-License-Identifier: MIT
// Several soft edges or hard volumes at once, for all registers. Sums and products are integers below 2^53 in doubles, so exact. A quotient of two that
// are below 2^52, cut to an integer, and a root of one, are too, whatever the processor's rounding mode. Where a
// number may be larger, the reference takes over. A file that is compiled with an instruction set's flags includes
// this and says what a register is, of kWidth entries:
//   kRunFlag                    of entries that begin a run of so many
//   Real, all(double), add, subtract, times, divide, root, floored, cut (toward zero), magnitude, larger (of two Reals)
//   Int                         int32; load(from), store(to, Int), sum, difference, within(Int, most) (-most to most), whole(Real) of an integer, real(Int)
//   Mask                        less(Real, Real), at_least(Real, Real), both(Mask, Mask), of_moves(Int), of_both_moves(Int, Int), bits(Mask)
//   where(Mask, Real or Int)    0 elsewhere; either(Mask, Real a, Real b): a where the mask is set
//   load_nodes<N>(nodes, at, &x, &y, &z, &moves), store_nodes<N>(x, y, z, moves, at, nodes)   nodes at[0], at[N], at[2 N], ...
#ifndef SINEW_KERNELS_CONSTRAINTS_S32_WIDE_HPP
#define SINEW_KERNELS_CONSTRAINTS_S32_WIDE_HPP

#include "kernels/constraints.hpp"
#include "kernels/isolated.hpp"

namespace sinew {
namespace {

template <class Isa>
struct Ints {
  typename Isa::Int x, y, z;
};
template <class Isa>
struct Reals {
  typename Isa::Real x, y, z;
};
template <class Isa>
struct Nodes {
  Ints<Isa> position;
  typename Isa::Int moves;
};

template <class Isa, int N>
SINEW_INLINE Nodes<Isa> load_nodes(const SolverNode* nodes, const uint32_t* at) {
  Nodes<Isa> out;
  Isa::template load_nodes<N>(nodes, at, &out.position.x, &out.position.y, &out.position.z, &out.moves);
  return out;
}
template <class Isa, int N>
SINEW_INLINE void store_nodes(const Nodes<Isa>& v, const uint32_t* at, SolverNode* nodes) {
  Isa::template store_nodes<N>(v.position.x, v.position.y, v.position.z, v.moves, at, nodes);
}

template <class Isa>
SINEW_INLINE typename Isa::Real dot(const Reals<Isa>& a, const Reals<Isa>& b) {
  return Isa::add(Isa::add(Isa::times(a.x, b.x), Isa::times(a.y, b.y)), Isa::times(a.z, b.z));
}
// a - b, clamped
template <class Isa>
SINEW_INLINE Reals<Isa> between(const Ints<Isa>& a, const Ints<Isa>& b, int32_t most) {
  return {Isa::real(Isa::within(Isa::difference(a.x, b.x), most)),
          Isa::real(Isa::within(Isa::difference(a.y, b.y), most)),
          Isa::real(Isa::within(Isa::difference(a.z, b.z), most))};
}
// Products over the cell's edge.
template <class Isa, class Real>
SINEW_INLINE Real over_cell(Real a, Real b, Real c, Real d) {
  return Isa::floored(Isa::times(Isa::subtract(Isa::times(a, b), Isa::times(c, d)), Isa::all(1.0 / kCellUnits)));
}
template <class Isa>
SINEW_INLINE Reals<Isa> cross_over_cell(const Reals<Isa>& a, const Reals<Isa>& b) {
  return {over_cell<Isa>(a.y, b.z, a.z, b.y), over_cell<Isa>(a.z, b.x, a.x, b.z), over_cell<Isa>(a.x, b.y, a.y, b.x)};
}

// x + (ratio * g + half) >> shift in the lanes of a mask; `scaled` is the ratio over 2^shift.
template <class Isa>
SINEW_INLINE void step(Ints<Isa>* p, typename Isa::Real scaled, const Reals<Isa>& g, typename Isa::Mask mask) {
  const auto half = Isa::all(0.5);
  const auto way = [&](typename Isa::Real x) {
    return Isa::where(mask, Isa::whole(Isa::floored(Isa::add(Isa::times(scaled, x), half))));
  };
  p->x = Isa::sum(p->x, way(g.x));
  p->y = Isa::sum(p->y, way(g.y));
  p->z = Isa::sum(p->z, way(g.z));
}

// The reference does the remaining lanes of a mask.
template <class Isa, class List, class One>
SINEW_INLINE void finish(typename Isa::Mask usual, const List& list, uint32_t first, const One& one) {
  for (uint32_t lane = 0, odd = Isa::kLanes ^ Isa::bits(usual); odd >> lane != 0; ++lane) {
    if ((odd >> lane & 1) != 0) one(list, first + lane);
  }
}

template <class Isa>
SINEW_INLINE void solve_volumes_at(const VolumeList& list, uint32_t first) {
  using Real = typename Isa::Real;
  constexpr double kSmall = static_cast<double>(kSmallVolume);
  const uint32_t* const at = list.corners + 4 * static_cast<size_t>(first);
  Nodes<Isa> nodes[4];
  SINEW_UNROLL for (int k = 0; k < 4; ++k) nodes[k] = load_nodes<Isa, 4>(list.nodes, at + k);
  const Reals<Isa> b = between<Isa>(nodes[1].position, nodes[0].position, kLongSide),
                   c = between<Isa>(nodes[2].position, nodes[0].position, kLongSide),
                   d = between<Isa>(nodes[3].position, nodes[0].position, kLongSide);
  Reals<Isa> gradient[4];
  gradient[1] = cross_over_cell<Isa>(c, d);
  gradient[2] = cross_over_cell<Isa>(d, b);
  gradient[3] = cross_over_cell<Isa>(b, c);
  const Real none = Isa::all(0);
  gradient[0] = {Isa::subtract(none, Isa::add(Isa::add(gradient[1].x, gradient[2].x), gradient[3].x)),
                 Isa::subtract(none, Isa::add(Isa::add(gradient[1].y, gradient[2].y), gradient[3].y)),
                 Isa::subtract(none, Isa::add(Isa::add(gradient[1].z, gradient[2].z), gradient[3].z))};
  const Real rest = Isa::all((list.flags[first] & kLargeVolume) != 0 ? 2 * kSmall : kSmall);
  const Real error = Isa::subtract(rest, dot<Isa>(b, gradient[1]));
  Real denominator = none, largest = none;
  SINEW_UNROLL for (int k = 0; k < 4; ++k) {
    const auto moves = Isa::of_moves(nodes[k].moves);
    const Reals<Isa>& g = gradient[k];
    denominator = Isa::add(denominator, Isa::where(moves, dot<Isa>(g, g)));
    const Real bound = Isa::add(Isa::add(Isa::magnitude(g.x), Isa::magnitude(g.y)), Isa::magnitude(g.z));
    largest = Isa::larger(largest, Isa::where(moves, bound));
  }
  denominator = Isa::larger(denominator, Isa::all(static_cast<double>(kLeastDenominator)));
  const Real ratio = Isa::cut(
      Isa::divide(Isa::times(error, Isa::all(4096)), Isa::floored(Isa::times(denominator, Isa::all(1.0 / 64)))));
  // The reference shortens long steps.
  constexpr double kLong = static_cast<double>((kLongestStep + 1) << kRatioBits), kLargeError = 1099511627776.0;
  const auto usual = Isa::both(Isa::less(Isa::times(Isa::magnitude(ratio), largest), Isa::all(kLong)),
                               Isa::less(Isa::magnitude(error), Isa::all(kLargeError)));
  const Real scaled = Isa::times(ratio, Isa::all(1.0 / (1 << kRatioBits)));
  SINEW_UNROLL for (int k = 0; k < 4; ++k) {
    step<Isa>(&nodes[k].position, scaled, gradient[k], Isa::both(usual, Isa::of_moves(nodes[k].moves)));
    store_nodes<Isa, 4>(nodes[k], at + k, list.nodes);
  }
  finish<Isa>(usual, list, first, solve_volume_ref);
}

template <class Isa>
SINEW_INLINE void solve_edges_at(const EdgeList& list, uint32_t first) {
  using Real = typename Isa::Real;
  const uint32_t* const at = list.ends + 2 * static_cast<size_t>(first);
  Nodes<Isa> from = load_nodes<Isa, 2>(list.nodes, at), to = load_nodes<Isa, 2>(list.nodes, at + 1);
  const Reals<Isa> d = between<Isa>(from.position, to.position, kLongEdge);
  const Real now = Isa::floored(Isa::root(Isa::times(dot<Isa>(d, d), Isa::all(256))));
  const Real rest = Isa::real(Isa::load(list.rests + first));
  const auto before = Isa::load(list.lambdas + first);
  const Real error = Isa::subtract(Isa::times(Isa::subtract(rest, now), Isa::all(256)),
                                   Isa::times(Isa::all(static_cast<double>(list.rates.softness)), Isa::real(before)));
  const Real inverse =
      Isa::either(Isa::of_both_moves(from.moves, to.moves), Isa::all(static_cast<double>(list.rates.inverse[1])),
                  Isa::all(static_cast<double>(list.rates.inverse[0])));
  const Real change =
      Isa::floored(Isa::times(Isa::add(Isa::times(error, inverse), Isa::all(8388608)), Isa::all(1.0 / 16777216)));
  const Real ratio = Isa::cut(Isa::divide(Isa::times(change, Isa::all(1048576)), now));
  constexpr double kLargeError = 68719476736.0, kLargeRatio = 2147483648.0, kShort = 16;
  const auto usual = Isa::both(Isa::both(Isa::less(Isa::magnitude(error), Isa::all(kLargeError)),
                                         Isa::less(Isa::magnitude(ratio), Isa::all(kLargeRatio))),
                               Isa::at_least(now, Isa::all(kShort)));
  Isa::store(list.lambdas + first, Isa::sum(before, Isa::where(usual, Isa::whole(change))));
  const Real scaled = Isa::times(ratio, Isa::all(1.0 / 1048576));
  step<Isa>(&from.position, scaled, d, Isa::both(usual, Isa::of_moves(from.moves)));
  step<Isa>(&to.position, Isa::subtract(Isa::all(0), scaled), d, Isa::both(usual, Isa::of_moves(to.moves)));
  store_nodes<Isa, 2>(from, at, list.nodes);
  store_nodes<Isa, 2>(to, at + 1, list.nodes);
  finish<Isa>(usual, list, first, solve_edge_ref);
}

// Runs of the widest registers that fit, what is in none by the reference. Halves: registers of half the width, or Isa again.
template <class Isa, class Halves, class List, class Wide, class Half, class One>
SINEW_INLINE void each_run(const List& list, uint32_t begin, uint32_t end, bool backwards, const Wide& wide,
                           const Half& half, const One& one) {
  constexpr uint32_t kWhole = Isa::kWidth, kPart = Halves::kWidth;
  if (backwards) {
    for (uint32_t k = end; k > begin;) {
      if (k >= begin + kWhole && (list.flags[k - kWhole] & Isa::kRunFlag) != 0) {
        k -= kWhole;
        wide(k);
      } else if (kPart != kWhole && k >= begin + kPart && (list.flags[k - kPart] & Halves::kRunFlag) != 0) {
        k -= kPart;
        half(k);
      } else {
        one(list, --k);
      }
    }
    return;
  }
  for (uint32_t k = begin; k < end;) {
    if ((list.flags[k] & Isa::kRunFlag) != 0) {
      wide(k);
      k += kWhole;
    } else if (kPart != kWhole && (list.flags[k] & Halves::kRunFlag) != 0) {
      half(k);
      k += kPart;
    } else {
      one(list, k++);
    }
  }
}

template <class Isa, class Halves>
void solve_edges(const EdgeList& list, uint32_t begin, uint32_t end, bool backwards) {
  each_run<Isa, Halves>(
      list, begin, end, backwards, [&list](uint32_t k) { solve_edges_at<Isa>(list, k); },
      [&list](uint32_t k) { solve_edges_at<Halves>(list, k); }, solve_edge_ref);
}
template <class Isa, class Halves>
void solve_volumes(const VolumeList& list, uint32_t begin, uint32_t end, bool backwards) {
  each_run<Isa, Halves>(
      list, begin, end, backwards, [&list](uint32_t k) { solve_volumes_at<Isa>(list, k); },
      [&list](uint32_t k) { solve_volumes_at<Halves>(list, k); }, solve_volume_ref);
}

}  // namespace
}  // namespace sinew
#endif
