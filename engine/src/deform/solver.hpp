// SPDX-License-Identifier: MIT
// Position-based solver of a lattice in integers: soft edges, hard volumes, half spaces of embedded points. The same steps on
// every target and for any number of threads: color by color, in index order.
#ifndef SINEW_DEFORM_SOLVER_HPP
#define SINEW_DEFORM_SOLVER_HPP

#include "core/threads.hpp"
#include "core/vec3d.hpp"
#include "deform/lattice.hpp"

namespace sinew::deform {

// Positions beyond are clamped to it, in lattice units: 16,384 cells.
constexpr int32_t kFarthest = 1 << 28;
constexpr uint32_t kSettlingRounds = 2;  // the last ones, without momentum, in which the constraints settle

// Rounded, half away from zero.
inline int32_t to_units(double x) {
  const double most = kFarthest;
  if (!(x > -most)) return -kFarthest;
  if (!(x < most)) return kFarthest;
  const int32_t whole = static_cast<int32_t>(x);  // toward zero
  const double rest = x - whole;
  return rest >= 0.5 ? whole + 1 : rest < -0.5 ? whole - 1 : whole;
}
inline Vec3i to_units(Vec3d v) { return {to_units(v.x), to_units(v.y), to_units(v.z)}; }

// An embedded point stays where normal . x >= offset.
struct SolverPoint {
  uint32_t nodes[4];
  int16_t shares[4];  // Q14
  Vec3i normal;       // Q14
  int32_t offset;     // lattice units
  int64_t stiffness;  // Q14: the sum of the moving nodes' squared shares; not 0
};

struct SolverState {
  SolverNode* nodes = nullptr;  // [n] in and out
  Vec3i* last = nullptr;        // [n] where the last round's constraints left them
  // Those with a node that moves. What is read together lies together.
  uint32_t* corners = nullptr;                                  // [t x 4] of tetrahedra
  uint32_t* ends = nullptr;                                     // [e x 2] of edges
  int32_t *rests = nullptr, *lambdas = nullptr;                 // [e]
  uint8_t *tetrahedron_flags = nullptr, *edge_flags = nullptr;  // [t], [e]
  uint32_t tetrahedron_count = 0, edge_count = 0;
  uint32_t *piece_tetrahedra = nullptr, *piece_edges = nullptr;  // [pieces + 1] begins in the two lists
  uint32_t* stamps = nullptr;                                    // [n] scratch of list_constraints()
  SolverPoint* points = nullptr;
  uint32_t point_count = 0;

  bool allocate(Arena& arena, uint32_t nodes, uint32_t tetrahedra, uint32_t edges, uint32_t points);
};

// Lists tetrahedra and edges when it is known which nodes move.
void list_constraints(const Lattice& lattice, SolverState* state);
// A point goes to the list if its moving nodes can carry it there.
void add_point(const Lattice& lattice, const Embedding& position, Vec3i normal, int32_t offset, SolverState* state);
// Method: M. Mueller et al., "Position Based Dynamics", 2007; M. Macklin, M. Mueller, N. Chentanez, "XPBD", 2016, for edges, with
// a time step of 1; rounds gain by momentum, as in H. Wang, "A Chebyshev Semi-Iterative Approach for Accelerating Projective and
// Position-Based Dynamics", ACM TOG 34(6), 2015, with one factor for all of them. softness: their compliance in 1/256.
void solve(const Lattice& lattice, uint32_t rounds, uint32_t softness, const ConstraintKernels& kernels,
           const Threads& threads, SolverState* state);
// Tetrahedra of the list that are inside out.
uint32_t count_inverted(const SolverState& state);

}  // namespace sinew::deform
#endif
