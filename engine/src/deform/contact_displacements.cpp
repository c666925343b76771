// SPDX-License-Identifier: MIT
// Smooth displacements of the lattice's nodes away from contacts.
#include "deform/contact_displacements.hpp"

#include "deform/pins.hpp"

namespace sinew::deform {
namespace {

constexpr int kRounds = 10;
constexpr uint32_t kRings = 3;          // around what touches, which they reach
constexpr double kSmoothing = 0.6;      // of a round: share of the neighbors' mean
constexpr double kBoneYields = 0.3;     // of what other nodes do
constexpr double kLeastSquares = 0.25;  // a vertex that depends on few nodes does not drag them along
constexpr double kShare = 1.0 / (1 << kShareBits);

class DisplacementMaker {
 public:
  DisplacementMaker(const DeformRest& rest, const ContactState& state, ContactDisplacements* out)
      : rest_(rest), lattice_(rest.lattice), state_(state), out_(*out) {}

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
      out_.displacements[n] = {0, 0, 0};
      out_.reached[n] = 0;
      out_.counts[n] = 0;
    }
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      if (state_.pushes[u] <= 0) continue;
      const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(lattice_.vertices[u].tetrahedron);
      for (int k = 0; k < 4; ++k) out_.reached[at[k]] = 1;
    }
    grow_nodes(lattice_, 1, kRings, out_.reached);
    out_.edge_count = 0;
    for (uint32_t i = 0; i < lattice_.edge_count; ++i) {
      const LatticeEdge& edge = lattice_.edges[i];
      out_.counts[edge.a] += out_.reached[edge.a];
      out_.counts[edge.b] += out_.reached[edge.b];
      if ((out_.reached[edge.a] & out_.reached[edge.b]) != 0) out_.edges[out_.edge_count++] = i;
    }
  }

  // All nodes at once go towards the mean of their neighbors. Displacements are 0 beyond.
  void smooth() {
    for (uint32_t n = 0; n < lattice_.node_count; ++n) out_.sums[n] = {0, 0, 0};
    for (uint32_t i = 0; i < out_.edge_count; ++i) {
      const LatticeEdge& edge = lattice_.edges[out_.edges[i]];
      out_.sums[edge.a] = out_.sums[edge.a] + out_.displacements[edge.b];
      out_.sums[edge.b] = out_.sums[edge.b] + out_.displacements[edge.a];
    }
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      if (out_.counts[n] == 0) continue;
      out_.displacements[n] =
          out_.displacements[n] + kSmoothing * ((1.0 / out_.counts[n]) * out_.sums[n] - out_.displacements[n]);
    }
  }

  // The nodes around a vertex take it to where it is to go, if they do not yet.
  void follow(uint32_t u) {
    const Embedding& position = lattice_.vertices[u];
    const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
    double gone = 0, squares = 0;
    for (int k = 0; k < 4; ++k) {
      const double share = kShare * position.shares[k];
      gone += share * dot(state_.directions[u], out_.displacements[at[k]]);
      squares += share * share * yield(at[k]);
    }
    const double left = state_.pushes[u] - gone;
    if (left <= 0) return;
    const double step = left / greater(squares, kLeastSquares);
    for (int k = 0; k < 4; ++k) {
      out_.displacements[at[k]] =
          out_.displacements[at[k]] + (step * kShare * position.shares[k] * yield(at[k])) * state_.directions[u];
    }
  }

  const DeformRest& rest_;
  const Lattice& lattice_;
  const ContactState& state_;
  ContactDisplacements& out_;
};

}  // namespace

bool ContactDisplacements::allocate(Arena& arena, const Lattice& lattice) {
  displacements = arena.alloc<Vec3d>(lattice.node_count);
  sums = arena.alloc<Vec3d>(lattice.node_count);
  reached = arena.alloc<uint8_t>(lattice.node_count);
  edges = arena.alloc<uint32_t>(lattice.edge_count);
  counts = arena.alloc<uint32_t>(lattice.node_count);
  return arena.ok();
}

void press_contacts(const DeformRest& rest, const ContactState& state, ContactDisplacements* out) {
  DisplacementMaker(rest, state, out).run();
}

Vec3d contact_push(const DeformRest& rest, const ContactDisplacements& moved, uint32_t vertex) {
  const Embedding& position = rest.lattice.vertices[rest.welded[vertex]];
  if (position.tetrahedron == kNoTetrahedron) return {0, 0, 0};
  const uint32_t* const at = rest.lattice.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
  Vec3d sum = {0, 0, 0};
  for (int k = 0; k < 4; ++k) sum = sum + (kShare * position.shares[k]) * moved.displacements[at[k]];
  return rest.unit * sum;
}

}  // namespace sinew::deform
