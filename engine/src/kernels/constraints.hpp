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
// Flat tetrahedra yield: 0.2 of the cell's edge to the fourth, in units of six times the gradients.
constexpr int64_t kLeastDenominator = 36 * (int64_t{1} << (2 * kCellBits)) / 5;
constexpr int64_t kLongestStep = kCellUnits / 4;
constexpr int kRatioBits = 18;

// A node while it is solved: as wide as a register.
struct alignas(16) SolverNode {
  Vec3i position;  // lattice units
  int32_t moves;   // -1, 0 for a node that is pinned
};

struct EdgeRates {
  int64_t softness;
  int64_t inverse[2];  // Q24 of 1 / (moving ends + softness), one or two ends
};

// Flags of entries. Entries that follow each other and have no node in common, so that their order says nothing, are a run.
constexpr uint8_t kRunOfFour = 1, kRunOfEight = 2;  // begins with this one; a run of eight is two of four as well
constexpr uint8_t kLargeVolume =
    4;  // the middle tetrahedron of a cell, twice as large as those of its corners. The same in all of a run

struct EdgeList {
  EdgeRates rates;
  const uint32_t* ends;  // [e x 2] nodes
  const int32_t* rests;  // [e] lengths at rest, Q4 lattice units
  int32_t* lambdas;      // [e] Q4
  const uint8_t* flags;  // [e]
  SolverNode* nodes;
};

struct VolumeList {
  const uint32_t* corners;  // [t x 4] nodes
  const uint8_t* flags;     // [t]
  SolverNode* nodes;
};

// Six volumes at rest over the cell's edge.
inline int64_t rest_volume(uint8_t flags) { return (flags & kLargeVolume) != 0 ? 2 * kSmallVolume : kSmallVolume; }

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
bool add_constraints_s32_avx512(ConstraintKernels* kernels);

}  // namespace sinew
#endif
