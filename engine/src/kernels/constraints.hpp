// SPDX-License-Identifier: MIT
// The inner loops of deform's solver: soft edges and hard volumes of tetrahedra, in the order of their lists.
#ifndef SINEW_KERNELS_CONSTRAINTS_HPP
#define SINEW_KERNELS_CONSTRAINTS_HPP

#include <cstddef>

#include "core/fixed.hpp"

namespace sinew {

constexpr int kCellBits = 14;
constexpr int32_t kCellUnits = 1 << kCellBits;  // edge of a cell in lattice units

// Bounds: edge vectors are clamped to 32 cells (2^19), vectors of volumes to 16 (2^18), so that products of two stay below
// 2^38 and of three, once shifted, below 2^42. Nodes lie within 2^29.
constexpr int32_t kLongEdge = 32 * kCellUnits, kLongSide = 16 * kCellUnits;
constexpr int64_t kSmallVolume = int64_t{1} << (2 * kCellBits);  // six volumes of a corner tetrahedron, >> 14
// Tetrahedra that are flat give way: 0.2 of the cell's edge to the fourth, in units of six times the gradients.
constexpr int64_t kLeastDenominator = 36 * (int64_t{1} << (2 * kCellBits)) / 5;
constexpr int64_t kLongestStep = kCellUnits / 4;
constexpr int kRatioBits = 18;

struct SolverEdge {
  uint32_t a, b;
  int32_t rest;    // Q4 lattice units
  int32_t lambda;  // Q4
};

struct EdgeRates {
  int64_t softness;
  int64_t inverse[2];  // Q24 of 1 / (moving ends + softness), one or two ends
};

// Entries of a list that follow each other and have no node in common, so that their order says nothing.
constexpr uint32_t kWide = 4;
enum WideKind : uint8_t { kNarrow = 0, kWideSmall = 1, kWideLarge = 2 };

struct EdgeList {
  EdgeRates rates;
  SolverEdge* edges;
  const uint8_t* wide;   // [e] kWideSmall: this one and the three after it are independent
  const uint8_t* moves;  // [n] 1: the node may be moved
  Vec3i* nodes;          // [n] lattice units
};

struct VolumeList {
  const uint32_t* tetrahedra;  // [t] numbers in `corners`
  const uint8_t* wide;  // [t] the same: kWideSmall where all four are of corners of a cell, kWideLarge if of its middle
  const uint32_t* corners;  // [4 x tetrahedra] nodes
  const uint8_t* moves;
  Vec3i* nodes;
};

// Six volumes at rest over the cell's edge: the fifth tetrahedron of a cell is twice as large.
inline int64_t rest_volume(uint32_t tetrahedron) { return tetrahedron % 5 == 4 ? 2 * kSmallVolume : kSmallVolume; }

// One constraint by its definition.
void solve_edge_ref(const EdgeList& list, uint32_t edge);
void solve_volume_ref(const VolumeList& list, uint32_t entry);
// Entries begin to end, or from the last one back to the first.
void solve_edges_ref(const EdgeList& list, uint32_t begin, uint32_t end, bool backwards);
void solve_volumes_ref(const VolumeList& list, uint32_t begin, uint32_t end, bool backwards);

struct ConstraintKernels {
  decltype(&solve_edges_ref) edges = solve_edges_ref;
  decltype(&solve_volumes_ref) volumes = solve_volumes_ref;
};

// False when the file was compiled without its instruction set. The same nodes as the reference, bit for bit.
bool add_constraints_s32_avx2(ConstraintKernels* kernels);

}  // namespace sinew
#endif
