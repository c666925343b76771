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

// Ways from an end of an edge to the other: each coordinate falls, stays or rises.
constexpr uint32_t kDirections = 27;
uint32_t direction_of(Vec3i d) {
  const auto sign = [](int32_t x) { return x < 0 ? 0u : x == 0 ? 1u : 2u; };
  return 9 * sign(d.x) + 3 * sign(d.y) + sign(d.z);
}

// Six volumes at rest over the cell's edge: the fifth tetrahedron of a cell is twice as large.
int64_t rest_volume(uint32_t tetrahedron) { return tetrahedron % 5 == 4 ? 2 * kSmallVolume : kSmallVolume; }

}  // namespace

bool SolverState::allocate(Arena& arena, uint32_t node_count, uint32_t tetrahedra_most, uint32_t edges_most,
                           uint32_t points_most) {
  nodes = arena.alloc<Vec3i>(node_count);
  moves = arena.alloc<uint8_t>(node_count);
  tetrahedra = arena.alloc<uint32_t>(tetrahedra_most);
  edges = arena.alloc<SolverEdge>(edges_most);
  points = arena.alloc<SolverPoint>(points_most);
  return arena.ok();
}

void list_constraints(const Lattice& lattice, SolverState* state) {
  // Constraints of one kind and parity follow each other: they share few nodes, so that a processor need not wait for one to
  // begin the next. 15 % less time than in the order of cells.
  state->tetrahedron_count = 0;
  for (uint32_t kind = 0; kind < 10; ++kind) {
    for (uint32_t t = kind % 5 + 5 * (kind / 5); t < lattice.tetrahedron_count; t += 10) {
      const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(t);
      if ((state->moves[at[0]] | state->moves[at[1]] | state->moves[at[2]] | state->moves[at[3]]) != 0) {
        state->tetrahedra[state->tetrahedron_count++] = t;
      }
    }
  }
  constexpr int32_t kStraight = kCellUnits * 16;
  const int32_t diagonal = static_cast<int32_t>(isqrt64(uint64_t{2} * kStraight * kStraight));
  uint32_t begins[kDirections + 1] = {};
  const auto each_edge = [&](const auto& visit) {
    for (uint32_t a = 0; a < lattice.node_count; ++a) {
      for (uint32_t e = lattice.edge_offsets[a]; e < lattice.edge_offsets[a + 1]; ++e) {
        const uint32_t b = lattice.edge_ends[e];
        if ((state->moves[a] | state->moves[b]) != 0) visit(a, b, direction_of(lattice.nodes[b] - lattice.nodes[a]));
      }
    }
  };
  each_edge([&](uint32_t, uint32_t, uint32_t direction) { ++begins[direction + 1]; });
  for (uint32_t d = 0; d < kDirections; ++d) begins[d + 1] += begins[d];
  state->edge_count = begins[kDirections];
  each_edge([&](uint32_t a, uint32_t b, uint32_t direction) {
    const Vec3i d = lattice.nodes[b] - lattice.nodes[a];
    const int axes = (d.x != 0) + (d.y != 0) + (d.z != 0);
    state->edges[begins[direction]++] = {a, b, axes == 1 ? kStraight : diagonal, 0};
  });
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

void solve(const Lattice& lattice, uint32_t rounds, uint32_t softness, SolverState* state) {
  EdgeRates rates;
  rates.softness = softness;
  for (int64_t ends = 1; ends <= 2; ++ends)
    rates.inverse[ends - 1] = (int64_t{1} << 24) / (256 * ends + rates.softness);
  Vec3i* const nodes = state->nodes;
  for (uint32_t round = 0; round < rounds; ++round) {
    for (uint32_t e = 0; e < state->edge_count; ++e) solve_edge(rates, state->moves, nodes, state->edges + e);
    for (uint32_t i = 0; i < state->tetrahedron_count; ++i) {
      const uint32_t t = state->tetrahedra[i];
      solve_volume(lattice.tetrahedra + 4 * static_cast<size_t>(t), rest_volume(t), state->moves, nodes);
    }
    for (uint32_t i = 0; i < state->point_count; ++i) solve_point(state->points[i], state->moves, nodes);
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
