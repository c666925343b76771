// SPDX-License-Identifier: MIT
// How the lattice gives way to what touches: smooth displacements of its nodes.
#include "deform/contacts.hpp"
#include "deform/pins.hpp"

namespace sinew::deform {
namespace {

constexpr int kRounds = 10;
constexpr uint32_t kRings = 3;          // around what touches, which they reach
constexpr double kSmoothing = 0.6;      // of a round: share of the neighbours' mean
constexpr double kBoneYields = 0.3;     // of what other nodes do
constexpr double kLeastSquares = 0.25;  // a vertex that hangs on few nodes does not carry them away
constexpr double kShare = 1.0 / (1 << kShareBits);

class DisplacementMaker {
 public:
  DisplacementMaker(const DeformRest& rest, ContactState* state)
      : rest_(rest), lattice_(rest.lattice), state_(*state) {}

  void run() {
    find_edges();
    for (int round = 0; round < kRounds; ++round) {
      if (round > 0) smooth();
      for (uint32_t u = 0; u < rest_.welded_count; ++u) {
        if (state_.pushes[u] > 0) follow(u);
      }
    }
  }

 private:
  double yield(uint32_t node) const { return (rest_.node_flags[node] & kNodeAtBone) != 0 ? kBoneYields : 1; }

  void find_edges() {
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      state_.displacements[n] = {0, 0, 0};
      state_.reached[n] = 0;
      state_.counts[n] = 0;
    }
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      if (state_.pushes[u] <= 0) continue;
      const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(lattice_.vertices[u].tetrahedron);
      for (int k = 0; k < 4; ++k) state_.reached[at[k]] = 1;
    }
    grow_nodes(lattice_, 1, kRings, state_.reached);
    state_.edge_count = 0;
    for (uint32_t i = 0; i < lattice_.edge_count; ++i) {
      const LatticeEdge& edge = lattice_.edges[i];
      state_.counts[edge.a] += state_.reached[edge.a];
      state_.counts[edge.b] += state_.reached[edge.b];
      if ((state_.reached[edge.a] & state_.reached[edge.b]) != 0) state_.edges[state_.edge_count++] = i;
    }
  }

  // All nodes at once go towards the mean of their neighbours. Displacements are 0 beyond.
  void smooth() {
    for (uint32_t n = 0; n < lattice_.node_count; ++n) state_.sums[n] = {0, 0, 0};
    for (uint32_t i = 0; i < state_.edge_count; ++i) {
      const LatticeEdge& edge = lattice_.edges[state_.edges[i]];
      state_.sums[edge.a] = state_.sums[edge.a] + state_.displacements[edge.b];
      state_.sums[edge.b] = state_.sums[edge.b] + state_.displacements[edge.a];
    }
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      if (state_.counts[n] == 0) continue;
      state_.displacements[n] =
          state_.displacements[n] + kSmoothing * ((1.0 / state_.counts[n]) * state_.sums[n] - state_.displacements[n]);
    }
  }

  // The nodes around a vertex take it to where it is to go, if they do not yet.
  void follow(uint32_t u) {
    const Embedding& position = lattice_.vertices[u];
    const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
    double gone = 0, squares = 0;
    for (int k = 0; k < 4; ++k) {
      const double share = kShare * position.shares[k];
      gone += share * dot(state_.directions[u], state_.displacements[at[k]]);
      squares += share * share * yield(at[k]);
    }
    const double left = state_.pushes[u] - gone;
    if (left <= 0) return;
    const double step = left / greater(squares, kLeastSquares);
    for (int k = 0; k < 4; ++k) {
      state_.displacements[at[k]] =
          state_.displacements[at[k]] + (step * kShare * position.shares[k] * yield(at[k])) * state_.directions[u];
    }
  }

  const DeformRest& rest_;
  const Lattice& lattice_;
  ContactState& state_;
};

}  // namespace

void press_contacts(const DeformRest& rest, ContactState* state) { DisplacementMaker(rest, state).run(); }

Vec3d contact_push(const DeformRest& rest, const ContactState& state, uint32_t vertex) {
  const Embedding& position = rest.lattice.vertices[rest.welded[vertex]];
  if (position.tetrahedron == kNoTetrahedron) return {0, 0, 0};
  const uint32_t* const at = rest.lattice.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
  Vec3d sum = {0, 0, 0};
  for (int k = 0; k < 4; ++k) sum = sum + (kShare * position.shares[k]) * state.displacements[at[k]];
  return rest.unit * sum;
}

}  // namespace sinew::deform
