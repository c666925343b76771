// SPDX-License-Identifier: MIT
// Stretch, energy, volume and contact, one constraint after the other. Lengths are in cells.
#include "published/xpbd_solver.hpp"

#include "core/vector_math.hpp"
#include "deform/solver.hpp"

namespace sinew::deform {
namespace {

constexpr double kShortest = 1e-9;     // of an edge or a spring that has a direction
constexpr double kFlat = 0.02;         // squared gradients of a volume, below which a flat tetrahedron yields
constexpr double kLongestMove = 0.25;  // of a node, by one volume
constexpr double kLeastSquaredShares =
    0.02;  // squared shares of moving nodes, below which nothing carries an embedded vertex

constexpr double kMomentumShare = 0.8;

class XpbdSolver {
 public:
  XpbdSolver(const Lattice& lattice, const XpbdSettings& settings, XpbdState* state)
      : lattice_(lattice), settings_(settings), state_(*state), nodes_(state->nodes), moves_(state->moves) {}

  void run() {
    for (uint32_t i = 0; i < 4 * state_.tetrahedron_count; ++i) state_.spring_lambdas[i] = 0;
    for (uint32_t i = 0; i < state_.edge_count; ++i) state_.edge_lambdas[i] = 0;
    for (uint32_t n = 0; n < lattice_.node_count; ++n) state_.last[n] = nodes_[n];
    for (uint32_t round = 0; round < settings_.rounds; ++round) {
      const bool backwards = round % 2 != 0;
      each(state_.edge_count, backwards, [this](uint32_t i) { stretch(i); });
      each(state_.tetrahedron_count, backwards, [this](uint32_t i) {
        energy(i);
        volume(i);
      });
      each(state_.point_count, backwards, [this](uint32_t i) { contact(i); });
      add_momentum(round > 0 && round + kSettlingRounds < settings_.rounds);
    }
  }

 private:
  template <class Solve>
  static void each(uint32_t count, bool backwards, const Solve& solve_one) {
    for (uint32_t i = 0; i < count; ++i) solve_one(backwards ? count - 1 - i : i);
  }
  // Every node repeats its step since the last round's end, at most a cell.
  void add_momentum(bool on) {
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      if (moves_[n] == 0) continue;
      const Vec3d move = nodes_[n] - state_.last[n];
      const double far = length(move);
      state_.last[n] = nodes_[n];
      if (on) nodes_[n] = nodes_[n] + (kMomentumShare / greater(far, 1)) * move;
    }
  }
  double weight(uint32_t node) const { return moves_[node] != 0 ? 1 : 0; }
  const uint32_t* corners(uint32_t i) const {
    return lattice_.tetrahedra + 4 * static_cast<size_t>(state_.tetrahedra[i]);
  }

  void stretch(uint32_t i) {
    const LatticeEdge& edge = lattice_.edges[state_.edges[i]];
    const Vec3i at_rest = lattice_.nodes[edge.a] - lattice_.nodes[edge.b];
    const int axes = (at_rest.x != 0) + (at_rest.y != 0) + (at_rest.z != 0);
    const Vec3d d = nodes_[edge.a] - nodes_[edge.b];
    const double now = length(d), a = weight(edge.a), b = weight(edge.b);
    if (now < kShortest) return;
    const double off = now - (axes == 1 ? 1 : diagonal_), compliance = settings_.edge_compliance;
    double& lambda = state_.edge_lambdas[i];
    const double step = -(off + compliance * lambda) / (a + b + compliance);
    lambda += step;
    const Vec3d move = (step / now) * d;
    nodes_[edge.a] = nodes_[edge.a] + a * move;
    nodes_[edge.b] = nodes_[edge.b] - b * move;
  }

  // The energy 1/2 sum k (|p_i - p_0| - d_i)^2 is that of four constraints of compliance 1/k, taken at once.
  void energy(uint32_t i) {
    const uint32_t* const at = corners(i);
    Vec3d middle = {0, 0, 0}, moves[4];
    Vec3i sum = {0, 0, 0};
    double weights[4], all = 0;
    for (int k = 0; k < 4; ++k) {
      middle = middle + 0.25 * nodes_[at[k]];
      sum = sum + lattice_.nodes[at[k]];
      weights[k] = weight(at[k]);
      all += weights[k];
    }
    Vec3d common = {0, 0, 0};
    const double compliance = settings_.spring_compliance;
    for (int k = 0; k < 4; ++k) {
      const Vec3d d = nodes_[at[k]] - middle;
      const double now = length(d);
      moves[k] = {0, 0, 0};
      if (now < kShortest) continue;
      const Vec3i own = lattice_.nodes[at[k]];
      const Vec3d at_rest =
          (0.25 / kCellUnits) * to_double(Vec3i{4 * own.x - sum.x, 4 * own.y - sum.y, 4 * own.z - sum.z});
      double& lambda = state_.spring_lambdas[4 * static_cast<size_t>(i) + static_cast<size_t>(k)];
      const double square = 0.5 * weights[k] + 0.0625 * all;  // (3/4)^2 for its own corner, (1/4)^2 for the others
      if (!(square > 0)) continue;
      const double step = -(now - length(at_rest) + compliance * lambda) / (square + compliance);
      lambda += step;
      moves[k] = (step / now) * d;
      common = common + 0.25 * moves[k];
    }
    for (int k = 0; k < 4; ++k) nodes_[at[k]] = nodes_[at[k]] + weights[k] * (moves[k] - common);
  }

  void volume(uint32_t i) {
    const uint32_t* const at = corners(i);
    const Vec3d a = nodes_[at[0]], b = nodes_[at[1]] - a, c = nodes_[at[2]] - a, d = nodes_[at[3]] - a;
    Vec3d gradient[4];  // six times
    gradient[1] = cross(c, d);
    gradient[2] = cross(d, b);
    gradient[3] = cross(b, c);
    gradient[0] = -1.0 * (gradient[1] + gradient[2] + gradient[3]);
    const double off = dot(b, gradient[1]) - (state_.tetrahedra[i] % 5 == 4 ? 2 : 1);
    double square = 0, largest = 0;
    for (int k = 0; k < 4; ++k) {
      const double own = weight(at[k]) * dot(gradient[k], gradient[k]);
      square += own;
      largest = greater(largest, own);
    }
    double step = -off / greater(square, kFlat);
    const double moved = absolute(step) * root(largest);
    if (moved > kLongestMove) step = step * kLongestMove / moved;
    for (int k = 0; k < 4; ++k) nodes_[at[k]] = nodes_[at[k]] + (weight(at[k]) * step) * gradient[k];
  }

  void contact(uint32_t i) {
    const Embedding& position = lattice_.vertices[state_.points[i]];
    const double outside = outside_by(state_.spaces[i], embedded(lattice_, position, nodes_));
    if (!(outside < 0)) return;
    const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
    double square = 0;
    for (int k = 0; k < 4; ++k) square += weight(at[k]) * share_of(position, k) * share_of(position, k);
    for (int k = 0; k < 4; ++k) {
      nodes_[at[k]] =
          nodes_[at[k]] - (weight(at[k]) * outside * share_of(position, k) / square) * state_.spaces[i].normal;
    }
  }

  const Lattice& lattice_;
  const XpbdSettings& settings_;
  XpbdState& state_;
  Vec3d* const nodes_;
  const uint8_t* const moves_;
  const double diagonal_ = root(2.0);
};

}  // namespace

bool XpbdState::allocate(Arena& arena, const Lattice& lattice, uint32_t vertices) {
  nodes = arena.alloc<Vec3d>(lattice.node_count);
  last = arena.alloc<Vec3d>(lattice.node_count);
  moves = arena.alloc<uint8_t>(lattice.node_count);
  tetrahedra = arena.alloc<uint32_t>(lattice.tetrahedron_count);
  edges = arena.alloc<uint32_t>(lattice.edge_count);
  spring_lambdas = arena.alloc<double>(4 * static_cast<size_t>(lattice.tetrahedron_count));
  edge_lambdas = arena.alloc<double>(lattice.edge_count);
  points = arena.alloc<uint32_t>(vertices);
  spaces = arena.alloc<HalfSpace>(vertices);
  return arena.ok();
}

void list_xpbd_constraints(const Lattice& lattice, XpbdState* state) {
  const uint8_t* const moves = state->moves;
  state->tetrahedron_count = state->edge_count = state->point_count = 0;
  for (uint32_t i = 0; 5 * i < lattice.tetrahedron_count; ++i) {
    for (uint32_t kind = 0; kind < 5; ++kind) {
      const uint32_t t = 5 * lattice.copy_order[i] + kind;
      const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(t);
      if ((moves[at[0]] | moves[at[1]] | moves[at[2]] | moves[at[3]]) != 0)
        state->tetrahedra[state->tetrahedron_count++] = t;
    }
  }
  for (uint32_t e = 0; e < lattice.edge_count; ++e) {
    if ((moves[lattice.edges[e].a] | moves[lattice.edges[e].b]) != 0) state->edges[state->edge_count++] = e;
  }
}

void add_xpbd_point(const Lattice& lattice, uint32_t vertex, const HalfSpace& space, XpbdState* state) {
  const Embedding& position = lattice.vertices[vertex];
  const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
  double square = 0;
  for (int k = 0; k < 4; ++k) {
    if (state->moves[at[k]] != 0) square += share_of(position, k) * share_of(position, k);
  }
  if (square < kLeastSquaredShares) return;
  state->points[state->point_count] = vertex;
  state->spaces[state->point_count++] = space;
}

void solve_xpbd(const Lattice& lattice, const XpbdSettings& settings, XpbdState* state) {
  XpbdSolver(lattice, settings, state).run();
}

uint32_t count_inverted_xpbd(const Lattice& lattice, const XpbdState& state) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < state.tetrahedron_count; ++i) {
    const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(state.tetrahedra[i]);
    const Vec3d a = state.nodes[at[0]];
    if (dot(state.nodes[at[1]] - a, cross(state.nodes[at[2]] - a, state.nodes[at[3]] - a)) < 0) ++count;
  }
  return count;
}

}  // namespace sinew::deform
