// SPDX-License-Identifier: MIT
// The three kinds of steps. Bounds: edge vectors are clamped to 32 cells (2^19), vectors of volumes to 16 (2^18), so that
// products of two stay below 2^38 and of three, once shifted, below 2^42.
#include "deform/solver.hpp"

#include "core/vector_math.hpp"

namespace sinew {
namespace {

constexpr int32_t kLongEdge = 32 * kCellUnits, kLongSide = 16 * kCellUnits;
constexpr int64_t kSmallVolume = int64_t{1} << (2 * kCellBits);  // six volumes of a corner tetrahedron, >> 14
// Tetrahedra that are flat give way: 0.2 of the cell's edge to the fourth, in units of six times the gradients.
constexpr int64_t kLeastDenominator = 36 * (int64_t{1} << (2 * kCellBits)) / 5;
constexpr int64_t kLongestStep = kCellUnits / 4;
constexpr int kRatioBits = 18;
constexpr uint32_t kWorthThreads = 2048;
// A node keeps 0.8 of the way of its last round, at most a cell. 20 rounds reach what took more than 30.
constexpr int32_t kMomentum = 205;      // Q8
constexpr uint32_t kRoundsWithout = 2;  // at the end, in which the constraints settle

int32_t clamped(int32_t x, int32_t most) { return x > most ? most : x < -most ? -most : x; }
Vec3i clamped(Vec3i v, int32_t most) { return {clamped(v.x, most), clamped(v.y, most), clamped(v.z, most)}; }
int32_t rounded(int64_t v, int shift) { return static_cast<int32_t>((v + (int64_t{1} << (shift - 1))) >> shift); }

// A vector of products over the cell's edge.
Vec3i over_cell(Vec3l v) {
  return {static_cast<int32_t>(v.x >> kCellBits), static_cast<int32_t>(v.y >> kCellBits),
          static_cast<int32_t>(v.z >> kCellBits)};
}
void step(Vec3i* p, int64_t ratio, Vec3i v, int shift) {
  p->x += rounded(ratio * v.x, shift);
  p->y += rounded(ratio * v.y, shift);
  p->z += rounded(ratio * v.z, shift);
}

int64_t sum_of_sides(Vec3i v) { return abs64(v.x) + abs64(v.y) + abs64(v.z); }

struct EdgeRates {
  int64_t softness;
  int64_t inverse[2];  // Q24 of 1 / (moving ends + softness), one or two ends
};

void solve_edge(const EdgeRates& rates, const uint8_t* moves, Vec3i* nodes, SolverEdge* edge) {
  const Vec3i d = clamped(nodes[edge->a] - nodes[edge->b], kLongEdge);
  const int64_t now = isqrt64(static_cast<uint64_t>(dot(d, d)) << 8);  // Q4
  if (now < 16) return;
  const bool a = moves[edge->a] != 0, b = moves[edge->b] != 0;
  const int64_t error = (edge->rest - now) * 256 - rates.softness * edge->lambda;
  const int32_t change = rounded(error * rates.inverse[a && b ? 1 : 0], 24);
  edge->lambda += change;
  const int64_t ratio = (static_cast<int64_t>(change) * (1 << 20)) / now;  // Q20
  if (a) step(&nodes[edge->a], ratio, d, 20);
  if (b) step(&nodes[edge->b], -ratio, d, 20);
}

void solve_volume(const uint32_t* at, int64_t rest, const uint8_t* moves, Vec3i* nodes) {
  const Vec3i origin = nodes[at[0]];
  const Vec3i b = clamped(nodes[at[1]] - origin, kLongSide), c = clamped(nodes[at[2]] - origin, kLongSide),
              d = clamped(nodes[at[3]] - origin, kLongSide);
  Vec3i gradient[4];
  gradient[1] = over_cell(cross(c, d));
  gradient[2] = over_cell(cross(d, b));
  gradient[3] = over_cell(cross(b, c));
  gradient[0] = {-(gradient[1].x + gradient[2].x + gradient[3].x), -(gradient[1].y + gradient[2].y + gradient[3].y),
                 -(gradient[1].z + gradient[2].z + gradient[3].z)};
  const int64_t error = rest - dot(b, gradient[1]);
  int64_t denominator = 0, largest = 0;
  for (int k = 0; k < 4; ++k) {
    if (moves[at[k]] == 0) continue;
    denominator += dot(gradient[k], gradient[k]);
    const int64_t bound = sum_of_sides(gradient[k]);
    largest = bound > largest ? bound : largest;
  }
  if (denominator < kLeastDenominator) denominator = kLeastDenominator;
  int64_t ratio = (error * (1 << 12)) / (denominator >> 6);
  // No node moves by more than a quarter of a cell. The sum of a vector's sides bounds its length, and most steps are short.
  const int64_t size = ratio < 0 ? -ratio : ratio;
  if ((size * largest) >> kRatioBits > kLongestStep) {
    int64_t square = 0;
    for (int k = 0; k < 4; ++k) {
      const int64_t own = moves[at[k]] != 0 ? dot(gradient[k], gradient[k]) : 0;
      square = own > square ? own : square;
    }
    const int64_t moved = (size * isqrt64(static_cast<uint64_t>(square))) >> kRatioBits;
    if (moved > kLongestStep) ratio = ratio * kLongestStep / moved;
  }
  for (int k = 0; k < 4; ++k) {
    if (moves[at[k]] != 0) step(&nodes[at[k]], ratio, gradient[k], kRatioBits);
  }
}

void solve_point(const SolverPoint& point, const uint8_t* moves, Vec3i* nodes) {
  int64_t place = 0;
  for (int k = 0; k < 4; ++k) place += (dot(point.normal, nodes[point.nodes[k]]) >> 14) * point.shares[k];
  int64_t outside = point.offset - (place >> kShareBits);
  if (outside <= 0) return;
  if (outside > kLongSide) outside = kLongSide;
  for (int k = 0; k < 4; ++k) {
    if (moves[point.nodes[k]] == 0 || point.shares[k] == 0) continue;
    Vec3i& node = nodes[point.nodes[k]];
    step(&node, outside * point.shares[k] / point.stiffness, point.normal, 14);
    node = clamped(node, 2 * kFarthest);  // there may be any number of points
  }
}

// Every node goes on in the way that it came since the last round's end.
void add_momentum(bool on, uint32_t count, SolverState* state) {
  for (uint32_t n = 0; n < count; ++n) {
    if (state->moves[n] == 0) continue;
    const Vec3i way = clamped(state->nodes[n] - state->last[n], kCellUnits);
    state->last[n] = state->nodes[n];
    if (on) step(&state->nodes[n], kMomentum, way, 8);
  }
}

// Constraints of every piece, colour by colour. begins [pieces + 1].
template <class Solve>
void each_piece(const Lattice& lattice, const uint32_t* begins, bool backwards, const Threads& threads,
                const Solve& one) {
  for (uint32_t i = 0; i < kColours; ++i) {
    const uint32_t colour = backwards ? kColours - 1 - i : i;
    const uint32_t first = lattice.colour_pieces[colour], pieces = lattice.colour_pieces[colour + 1] - first;
    const auto piece = [&](uint32_t p, uint32_t) {
      const uint32_t begin = begins[first + p], end = begins[first + p + 1];
      if (backwards) {
        for (uint32_t k = end; k-- > begin;) one(k);
      } else {
        for (uint32_t k = begin; k < end; ++k) one(k);
      }
    };
    // Fewer are done before threads have begun.
    if (begins[first + pieces] - begins[first] < kWorthThreads) {
      for (uint32_t p = 0; p < pieces; ++p) piece(p, 0);
    } else {
      threads.each(pieces, piece);
    }
  }
}

// Six volumes at rest over the cell's edge: the fifth tetrahedron of a cell is twice as large.
int64_t rest_volume(uint32_t tetrahedron) { return tetrahedron % 5 == 4 ? 2 * kSmallVolume : kSmallVolume; }

}  // namespace

bool SolverState::allocate(Arena& arena, uint32_t node_count, uint32_t tetrahedra_most, uint32_t edges_most,
                           uint32_t points_most) {
  nodes = arena.alloc<Vec3i>(node_count);
  last = arena.alloc<Vec3i>(node_count);
  moves = arena.alloc<uint8_t>(node_count);
  tetrahedra = arena.alloc<uint32_t>(tetrahedra_most);
  edges = arena.alloc<SolverEdge>(edges_most);
  points = arena.alloc<SolverPoint>(points_most);
  const size_t pieces = tetrahedra_most / (5 * kPieceCopies) + kColours + 1;
  piece_tetrahedra = arena.alloc<uint32_t>(pieces);
  piece_edges = arena.alloc<uint32_t>(pieces);
  return arena.ok();
}

void list_constraints(const Lattice& lattice, SolverState* state) {
  const uint8_t* const moves = state->moves;
  constexpr int32_t kStraight = kCellUnits * 16;
  const int32_t diagonal = static_cast<int32_t>(isqrt64(uint64_t{2} * kStraight * kStraight));
  uint32_t tetrahedra = 0, edges = 0;
  for (uint32_t piece = 0; piece < lattice.piece_count(); ++piece) {
    state->piece_tetrahedra[piece] = tetrahedra;
    state->piece_edges[piece] = edges;
    // Those of one kind follow each other, as with edges.
    for (uint32_t kind = 0; kind < 5; ++kind) {
      for (uint32_t i = lattice.piece_copies[piece]; i < lattice.piece_copies[piece + 1]; ++i) {
        const uint32_t t = 5 * lattice.copy_order[i] + kind;
        const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(t);
        if ((moves[at[0]] | moves[at[1]] | moves[at[2]] | moves[at[3]]) != 0) state->tetrahedra[tetrahedra++] = t;
      }
    }
    for (uint32_t e = lattice.piece_edges[piece]; e < lattice.piece_edges[piece + 1]; ++e) {
      const LatticeEdge& edge = lattice.edges[e];
      if ((moves[edge.a] | moves[edge.b]) == 0) continue;
      const Vec3i d = lattice.nodes[edge.b] - lattice.nodes[edge.a];
      const int axes = (d.x != 0) + (d.y != 0) + (d.z != 0);
      state->edges[edges++] = {edge.a, edge.b, axes == 1 ? kStraight : diagonal, 0};
    }
  }
  state->piece_tetrahedra[lattice.piece_count()] = state->tetrahedron_count = tetrahedra;
  state->piece_edges[lattice.piece_count()] = state->edge_count = edges;
}

void add_point(const Lattice& lattice, const Embedding& place, Vec3i normal, int32_t offset, SolverState* state) {
  const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(place.tetrahedron);
  SolverPoint& point = state->points[state->point_count];
  int64_t squares = 0;
  for (int k = 0; k < 4; ++k) {
    point.nodes[k] = at[k];
    point.shares[k] = place.shares[k];
    if (state->moves[at[k]] != 0) squares += static_cast<int64_t>(place.shares[k]) * place.shares[k];
  }
  constexpr int64_t kLeastSquares = (int64_t{1} << (2 * kShareBits)) / 50;
  if (squares <= kLeastSquares) return;
  point.normal = normal;
  point.offset = offset;
  point.stiffness = squares >> kShareBits;
  ++state->point_count;
}

void solve(const Lattice& lattice, uint32_t rounds, uint32_t softness, const Threads& threads, SolverState* state) {
  EdgeRates rates;
  rates.softness = softness;
  for (int64_t ends = 1; ends <= 2; ++ends)
    rates.inverse[ends - 1] = (int64_t{1} << 24) / (256 * ends + rates.softness);
  Vec3i* const nodes = state->nodes;
  const uint8_t* const moves = state->moves;
  for (uint32_t n = 0; n < lattice.node_count; ++n) state->last[n] = nodes[n];
  for (uint32_t round = 0; round < rounds; ++round) {
    // Every other round goes backwards, so that no direction is ahead of the others.
    const bool backwards = round % 2 != 0;
    each_piece(lattice, state->piece_edges, backwards, threads,
               [&](uint32_t e) { solve_edge(rates, moves, nodes, state->edges + e); });
    each_piece(lattice, state->piece_tetrahedra, backwards, threads, [&](uint32_t i) {
      const uint32_t t = state->tetrahedra[i];
      solve_volume(lattice.tetrahedra + 4 * static_cast<size_t>(t), rest_volume(t), moves, nodes);
    });
    for (uint32_t i = 0; i < state->point_count; ++i) solve_point(state->points[i], moves, nodes);
    add_momentum(round > 0 && round + kRoundsWithout < rounds, lattice.node_count, state);
  }
}

uint32_t count_inverted(const Lattice& lattice, const SolverState& state) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < state.tetrahedron_count; ++i) {
    const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(state.tetrahedra[i]);
    const Vec3i origin = state.nodes[at[0]];
    const Vec3i b = clamped(state.nodes[at[1]] - origin, kLongSide),
                c = clamped(state.nodes[at[2]] - origin, kLongSide),
                d = clamped(state.nodes[at[3]] - origin, kLongSide);
    if (dot(b, over_cell(cross(c, d))) < 0) ++count;
  }
  return count;
}

}  // namespace sinew
