// SPDX-License-Identifier: MIT
// Stage 4 of a bind: heat-equilibrium weights (Baran and Popovic 2007, "Automatic Rigging and Animation of 3D
// Characters", section 4), in integers: (L + A H) w = A H p for every joint, three variants. README.md beside
// this file is the exact definition.
#ifndef SINEW_HEAT_HEAT_HPP
#define SINEW_HEAT_HEAT_HPP

#include "kernels/table.hpp"
#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"

namespace sinew {

constexpr uint32_t kHeatSlots = 16;  // largest joints kept per vertex and field
enum HeatFieldKind : uint32_t { kFieldRule = 0, kFieldParts = 1, kFieldSoft = 2, kFieldCount = 3 };

// One solved field. Of every vertex the kHeatSlots joints with the largest weights are kept, by descending weight, the
// lower joint first where weights are equal. Weights under 2^-12 are not kept: the slots left over are at the end, with
// kNoJoint and 0. Weights are those of the solution, neither cut nor normalized.
struct HeatField {
  uint16_t* joints = nullptr;     // [U x kHeatSlots]
  uint16_t* weights = nullptr;    // [U x kHeatSlots] Q15, 0 .. 32768
  uint16_t* nearest = nullptr;    // [U] joint of the bone that is nearest by the field's distance, visible or not
  uint8_t* has_source = nullptr;  // [U] 1 when the vertex is a source: that bone is visible from it
};

struct HeatFields {
  HeatField field[kFieldCount];
  uint8_t* part_rule = nullptr;            // [parts <= U] which visibility the rule chose: 0 merged, 1 parts, 2 open
  const uint8_t* source_joints = nullptr;  // [J] those that solve_heat() was given

  bool allocate(Arena& arena, const Counts& counts);
};

// Solves the three fields. Sources and visibility by exact integer geometry (BVH over the triangles).
//   source_joints  [J] from choose_source_joints()
//   fields         in/out allocated by the caller with the same counts; its content is undefined unless SINEW_OK
//   progress       reported from 0 to 1000 of this stage
//   arena          scratch, all of it released
//   beside         is run once, unless the stage is cancelled before
//   kernels        inner loops of the factorisation and of visibility. The fields are the same bytes with all of them
// Every row has at least one joint. It sums to 1 but for weights that were too small to keep. has_source follows the
// visibility that the field used in the end, so it is 1 in every vertex of an open part. kFieldParts and kFieldSoft are
// open in parts that see no bone at all. Agrees with a float64 solution to 2e-5
// (tests/integration/heat_agreement_test.cpp). The same bytes on every platform.
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status solve_heat(const Mesh& mesh, const Skeleton& skeleton, const uint8_t* source_joints, const Counts& counts,
                        const Kernels& kernels, const Progress& progress, Arena& arena, HeatFields* fields,
                        const WorkBeside& beside = {});

// Weights by distance alone, the published method instead of stage 4; the room `published` defines it.
// Fills fields->field[kFieldRule] with weights by the inverse square of the distance to bones. The vertices that are
// nearest to a bone are a sub-mesh: of the bones, its own, the one above it and those below it have weight there.
// Neither the surface nor what lies between is used.
//   source_joints  [J] from choose_source_joints(): bones that may have weight
//   fields         allocated by the caller with the same counts; the other fields stay undefined
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE. The same bytes on every platform.
sinew_status weigh_by_distance(const Mesh& mesh, const Skeleton& skeleton, const uint8_t* source_joints,
                               const Counts& counts, Arena& arena, HeatFields* fields);

// Finishes a row as the method heat does. Weights under 0.025 become 0. Weights from there to 0.05 are ramped: they
// rise linearly from 0 to 0.05. Then the row is normalized to Q15; its sum is 32768 but for rounding. A row without
// weights becomes its nearest joint with 32768.
//   joints, weights  out [kHeatSlots], kNoJoint and 0 where unused
// Returns the number of slots used, at least 1.
uint32_t finish_heat_row(const HeatField& field, uint32_t vertex, uint16_t* joints, uint16_t* weights);

// Fills source_joints [J]: 1 where the joint's bone may be a source. Every usable joint's may, but for a root on the
// floor: a joint without a parent and with 1 to 4 children, in the lowest 3 % of the mesh's height, unless the caller
// said which joints deform or the skeleton has two joints at most. If that would leave no source, every usable joint's bone may be one.
// The mesh is the caller's, not a reduced one, whose height is another.
void choose_source_joints(const Mesh& mesh, const Skeleton& skeleton, uint8_t* source_joints);

}  // namespace sinew
#endif
