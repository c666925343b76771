// SPDX-License-Identifier: MIT
// Stage 4 of a bind: heat-equilibrium weights (Baran and Popovic 2007, "Automatic Rigging and Animation of 3D
// Characters", section 4), in integers: (L + A H) w = A H p for every joint, three variants. README.md beside
// this file is the exact definition.
#ifndef SINEW_HEAT_HEAT_HPP
#define SINEW_HEAT_HEAT_HPP

#include "kernels/table.hpp"
#include "mesh/mesh.hpp"

namespace sinew {

constexpr uint32_t kHeatSlots = 16;  // largest joints kept per vertex and field
enum HeatFieldKind : uint32_t { kFieldRule = 0, kFieldParts = 1, kFieldSoft = 2, kFieldCount = 3 };

// One solved field, sparse: the kHeatSlots largest joints of a vertex by raw weight (ties: lower joint), falling.
// Weights are the raw solution (neither cut nor normalised), Q15 (32768 = 1), clamped to [0, 32768]; slots under 2^-12
// are left out (joint = kNoJoint, weight = 0, at the end).
struct HeatField {
  uint16_t* joints = nullptr;     // [U x kHeatSlots]
  uint16_t* weights = nullptr;    // [U x kHeatSlots]
  uint16_t* nearest = nullptr;    // [U] joint of the bone that is nearest by the field's distance, visible or not
  uint8_t* has_source = nullptr;  // [U] 1 when that bone is visible, so the vertex is a source
};

struct HeatFields {
  HeatField field[kFieldCount];
  uint8_t* component_rule = nullptr;  // [components <= U] which visibility the rule chose: 0 merged, 1 parts, 2 open

  bool allocate(Arena& arena, const Counts& counts);
};

// Solves the three fields. Sources and visibility by exact integer geometry (BVH over the triangles).
//   fields    in/out allocated by the caller with the same counts; its content is undefined unless SINEW_OK
//   progress  reported from 0 to 1000 of this stage
//   arena     scratch, all of it released
//   kernels   inner loops of the factorisation and of visibility. The fields are the same bytes with all of them
// Every row has at least one joint and sums to 1 up to slots that were too small to keep. has_source follows the
// visibility that the field used in the end: all 1 where it is open. kFieldParts and kFieldSoft are open in components
// that see no bone at all. Agrees with a float64 solution to 2e-5 (tests/integration/heat_agreement_test.cpp); the same
// bytes on every platform. Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status solve_heat(const Mesh& mesh, const Skeleton& skeleton, const Counts& counts, const Kernels& kernels,
                        const Progress& progress, Arena& arena, HeatFields* fields);

// Finishes a row as the method heat does: weights under 0.025 are cut, up to 0.05 ramped linearly from 0 to themselves,
// then normalised to Q15 (sum 32768 +- rounding). A row left empty becomes its nearest joint with 32768.
//   joints, weights  out [kHeatSlots], unused = kNoJoint / 0. Returns the number used (>= 1).
uint32_t finish_heat_row(const HeatField& field, uint32_t vertex, uint16_t* joints, uint16_t* weights);

}  // namespace sinew
#endif
