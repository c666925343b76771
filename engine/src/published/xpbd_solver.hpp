// SPDX-License-Identifier: MIT
// The constraints of the published correction on the nodes of a lattice, in doubles of one order of operations.
#ifndef SINEW_PUBLISHED_XPBD_SOLVER_HPP
#define SINEW_PUBLISHED_XPBD_SOLVER_HPP

#include "core/vec3d.hpp"
#include "deform/half_spaces.hpp"
#include "deform/lattice.hpp"

namespace sinew::deform {

// Method: M. Macklin, M. Mueller, N. Chentanez, "XPBD: Position-Based Simulation of Compliant Constrained Dynamics", 2016, with masses and a time step of 1;
// rounds gain by momentum as in solver.hpp. Multipliers add up over the rounds, so that more rounds come nearer to one solution.
struct XpbdSettings {
  uint32_t rounds = 0;
  double edge_compliance = 0;    // of the stretch
  double spring_compliance = 0;  // 1 / k, of the springs from a tetrahedron's centroid to its corners
};

// n nodes, t tetrahedra and e edges of the lattice, U welded vertices.
struct XpbdState {
  Vec3d* nodes = nullptr;            // [n] in and out, in cells
  Vec3d* last = nullptr;             // [n] scratch: where the last round's constraints left them
  uint8_t* moves = nullptr;          // [n] 0 for a node that is pinned
  uint32_t* tetrahedra = nullptr;    // [t] those with a node that moves, by the order of copies
  uint32_t* edges = nullptr;         // [e] likewise
  double* spring_lambdas = nullptr;  // [t x 4]
  double* edge_lambdas = nullptr;    // [e]
  uint32_t* points = nullptr;        // [U] welded vertices that have a half space and can be moved
  HalfSpace* spaces = nullptr;       // [U] of these, in cells
  uint32_t tetrahedron_count = 0, edge_count = 0, point_count = 0;

  bool allocate(Arena& arena, const Lattice& lattice, uint32_t vertices);
};

// Lists tetrahedra and edges when it is known which nodes move.
void list_xpbd_constraints(const Lattice& lattice, XpbdState* state);
// Adds a half space, in cells, of an embedded vertex, if its moving nodes can carry it there.
void add_xpbd_point(const Lattice& lattice, uint32_t vertex, const HalfSpace& space, XpbdState* state);
// Gauss-Seidel in one order: edges, tetrahedra with their springs and their volume, half spaces; every other round backwards.
void solve_xpbd(const Lattice& lattice, const XpbdSettings& settings, XpbdState* state);
// Tetrahedra of the list that are inside out.
uint32_t count_inverted_xpbd(const Lattice& lattice, const XpbdState& state);

inline double share_of(const Embedding& position, int k) { return position.shares[k] * (1.0 / (1 << kShareBits)); }
// Where nodes take an embedded vertex.
inline Vec3d embedded(const Lattice& lattice, const Embedding& position, const Vec3d* nodes) {
  const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
  Vec3d sum = {0, 0, 0};
  for (int k = 0; k < 4; ++k) sum = sum + share_of(position, k) * nodes[at[k]];
  return sum;
}

}  // namespace sinew::deform
#endif
