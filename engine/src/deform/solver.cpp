// SPDX-License-Identifier: MIT
// Lists, rounds and contact points; edges and volumes are in kernels/constraints.hpp.
#include "deform/solver.hpp"

#include "kernels/constraint_steps.hpp"

namespace sinew::deform {
namespace {

constexpr uint32_t kWorthThreads = 2048;
// A node keeps 0.8 of the step of its last round, at most a cell (momentum): 20 rounds converge as far as 30 without
// it.
constexpr int32_t kMomentum = 205;  // Q8

void solve_point(const SolverPoint& point, SolverNode* nodes) {
  int64_t position = 0;
  for (int k = 0; k < 4; ++k) position += (dot(point.normal, nodes[point.nodes[k]].position) >> 14) * point.shares[k];
  int64_t outside = point.offset - (position >> kShareBits);
  if (outside <= 0) return;
  if (outside > kLongSide) outside = kLongSide;
  for (int k = 0; k < 4; ++k) {
    SolverNode& node = nodes[point.nodes[k]];
    if (node.moves == 0 || point.shares[k] == 0) continue;
    step(&node.position, outside * point.shares[k] / point.stiffness, point.normal, 14);
    node.position = clamped(node.position, 2 * kFarthest);  // there may be any number of points
  }
}

// Every node repeats its step since the last round's end.
void add_momentum(bool on, uint32_t count, SolverState* state) {
  for (uint32_t n = 0; n < count; ++n) {
    SolverNode& node = state->nodes[n];
    if (node.moves == 0) continue;
    const Vec3i move = clamped(node.position - state->last[n], kCellUnits);
    state->last[n] = node.position;
    if (on) step(&node.position, kMomentum, move, 8);
  }
}

// Constraints of every piece, color by color. begins [pieces + 1].
template <class Solve>
void each_piece(const Lattice& lattice, const uint32_t* begins, bool backwards, const Threads& threads,
                const Solve& solve_range) {
  for (uint32_t i = 0; i < kColors; ++i) {
    const uint32_t color = backwards ? kColors - 1 - i : i;
    const uint32_t first = lattice.color_pieces[color], pieces = lattice.color_pieces[color + 1] - first;
    const auto piece = [&](uint32_t p, uint32_t) { solve_range(begins[first + p], begins[first + p + 1]); };
    // Fewer are done before threads have begun.
    if (begins[first + pieces] - begins[first] < kWorthThreads) {
      for (uint32_t p = 0; p < pieces; ++p) piece(p, 0);
    } else {
      threads.each(pieces, piece);
    }
  }
}

// Marks runs of entries of a piece.
class WideRuns {
 public:
  // stamps [n] is scratch
  WideRuns(uint32_t* stamps, uint32_t node_count) : stamps_(stamps) {
    for (uint32_t n = 0; n < node_count; ++n) stamps_[n] = 0;
  }
  // Entries begin to end by each_node(entry, visit), which calls visit(node) until it says false.
  template <class Nodes>
  void mark(uint32_t begin, uint32_t end, uint8_t own, const Nodes& each_node, uint8_t* flags) {
    for (uint32_t k = begin; k < end; ++k) flags[k] = own;
    for (uint32_t k = begin; k < end;) {
      ++stamp_;
      uint32_t free = 0;
      while (free < 8 && k + free < end && each_node(k + free, [this](uint32_t n) { return take(n); })) ++free;
      if (free == 8) {
        flags[k] |= kRunOfEight | kRunOfFour;
        flags[k + 4] |= kRunOfFour;
        k += 8;
      } else if (free >= 4) {
        flags[k] |= kRunOfFour;
        k += 4;
      } else {
        k += free > 0 ? free : 1;
      }
    }
  }

 private:
  bool take(uint32_t node) {
    if (stamps_[node] == stamp_) return false;
    stamps_[node] = stamp_;
    return true;
  }
  uint32_t* stamps_;
  uint32_t stamp_ = 0;
};

}  // namespace

bool SolverState::allocate(Arena& arena, uint32_t node_count, uint32_t tetrahedra_most, uint32_t edges_most,
                           uint32_t points_most) {
  nodes = arena.alloc<SolverNode>(node_count);
  last = arena.alloc<Vec3i>(node_count);
  corners = arena.alloc<uint32_t>(4 * static_cast<size_t>(tetrahedra_most));
  ends = arena.alloc<uint32_t>(2 * static_cast<size_t>(edges_most));
  rests = arena.alloc<int32_t>(edges_most);
  lambdas = arena.alloc<int32_t>(edges_most);
  points = arena.alloc<SolverPoint>(points_most);
  tetrahedron_flags = arena.alloc<uint8_t>(tetrahedra_most);
  edge_flags = arena.alloc<uint8_t>(edges_most);
  stamps = arena.alloc<uint32_t>(node_count);
  const size_t pieces = tetrahedra_most / (5 * kPieceCopies) + kColors + 1;
  piece_tetrahedra = arena.alloc<uint32_t>(pieces);
  piece_edges = arena.alloc<uint32_t>(pieces);
  return arena.ok();
}

void list_constraints(const Lattice& lattice, SolverState* state) {
  const SolverNode* const nodes = state->nodes;
  constexpr int32_t kStraight = kCellUnits * 16;
  const int32_t diagonal = static_cast<int32_t>(isqrt64(uint64_t{2} * kStraight * kStraight));
  const auto corners_of = [state](uint32_t entry, auto visit) {
    const uint32_t* const at = state->corners + 4 * static_cast<size_t>(entry);
    return visit(at[0]) && visit(at[1]) && visit(at[2]) && visit(at[3]);
  };
  const auto ends_of = [state](uint32_t entry, auto visit) {
    return visit(state->ends[2 * static_cast<size_t>(entry)]) && visit(state->ends[2 * static_cast<size_t>(entry) + 1]);
  };
  WideRuns runs(state->stamps, lattice.node_count);
  uint32_t tetrahedra = 0, edges = 0;
  for (uint32_t piece = 0; piece < lattice.piece_count(); ++piece) {
    state->piece_tetrahedra[piece] = tetrahedra;
    state->piece_edges[piece] = edges;
    // Those of one kind follow each other, as with edges.
    for (uint32_t kind = 0; kind < 5; ++kind) {
      const uint32_t begin = tetrahedra;
      for (uint32_t i = lattice.piece_copies[piece]; i < lattice.piece_copies[piece + 1]; ++i) {
        const uint32_t t = 5 * lattice.copy_order[i] + kind;
        const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(t);
        if ((nodes[at[0]].moves | nodes[at[1]].moves | nodes[at[2]].moves | nodes[at[3]].moves) == 0) continue;
        for (size_t k = 0; k < 4; ++k) state->corners[4 * static_cast<size_t>(tetrahedra) + k] = at[k];
        ++tetrahedra;
      }
      runs.mark(begin, tetrahedra, kind == 4 ? kLargeVolume : 0, corners_of, state->tetrahedron_flags);
    }
    for (uint32_t e = lattice.piece_edges[piece]; e < lattice.piece_edges[piece + 1]; ++e) {
      const LatticeEdge& edge = lattice.edges[e];
      if ((nodes[edge.a].moves | nodes[edge.b].moves) == 0) continue;
      const Vec3i d = lattice.nodes[edge.b] - lattice.nodes[edge.a];
      const int axes = (d.x != 0) + (d.y != 0) + (d.z != 0);
      state->ends[2 * static_cast<size_t>(edges)] = edge.a;
      state->ends[2 * static_cast<size_t>(edges) + 1] = edge.b;
      state->rests[edges] = axes == 1 ? kStraight : diagonal;
      state->lambdas[edges++] = 0;
    }
    runs.mark(state->piece_edges[piece], edges, 0, ends_of, state->edge_flags);
  }
  state->piece_tetrahedra[lattice.piece_count()] = state->tetrahedron_count = tetrahedra;
  state->piece_edges[lattice.piece_count()] = state->edge_count = edges;
}

void add_point(const Lattice& lattice, const Embedding& position, Vec3i normal, int32_t offset, SolverState* state) {
  const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
  SolverPoint& point = state->points[state->point_count];
  int64_t squares = 0;
  for (int k = 0; k < 4; ++k) {
    point.nodes[k] = at[k];
    point.shares[k] = position.shares[k];
    if (state->nodes[at[k]].moves != 0) squares += static_cast<int64_t>(position.shares[k]) * position.shares[k];
  }
  constexpr int64_t kLeastSquares = (int64_t{1} << (2 * kShareBits)) / 50;
  if (squares <= kLeastSquares) return;
  point.normal = normal;
  point.offset = offset;
  point.stiffness = squares >> kShareBits;
  ++state->point_count;
}

void solve(const Lattice& lattice, uint32_t rounds, uint32_t softness, const ConstraintKernels& kernels,
           const Threads& threads, SolverState* state) {
  SolverNode* const nodes = state->nodes;
  EdgeList edges = {{softness, {0, 0}}, state->ends, state->rests, state->lambdas, state->edge_flags, nodes};
  for (int64_t ends = 1; ends <= 2; ++ends)
    edges.rates.inverse[ends - 1] = (int64_t{1} << 24) / (256 * ends + edges.rates.softness);
  const VolumeList volumes = {state->corners, state->tetrahedron_flags, nodes};
  for (uint32_t n = 0; n < lattice.node_count; ++n) state->last[n] = nodes[n].position;
  for (uint32_t round = 0; round < rounds; ++round) {
    // Every other round goes backwards, so that no direction is ahead of the others.
    const bool backwards = round % 2 != 0;
    each_piece(lattice, state->piece_edges, backwards, threads,
               [&](uint32_t begin, uint32_t end) { kernels.edges(edges, begin, end, backwards); });
    each_piece(lattice, state->piece_tetrahedra, backwards, threads,
               [&](uint32_t begin, uint32_t end) { kernels.volumes(volumes, begin, end, backwards); });
    for (uint32_t i = 0; i < state->point_count; ++i) solve_point(state->points[i], nodes);
    add_momentum(round > 0 && round + kSettlingRounds < rounds, lattice.node_count, state);
  }
}

uint32_t count_inverted(const SolverState& state) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < state.tetrahedron_count; ++i) {
    const uint32_t* const at = state.corners + 4 * static_cast<size_t>(i);
    const Vec3i origin = state.nodes[at[0]].position;
    const Vec3i b = clamped(state.nodes[at[1]].position - origin, kLongSide),
                c = clamped(state.nodes[at[2]].position - origin, kLongSide),
                d = clamped(state.nodes[at[3]].position - origin, kLongSide);
    if (dot(b, over_cell(cross(c, d))) < 0) ++count;
  }
  return count;
}

}  // namespace sinew::deform
