// SPDX-License-Identifier: MIT
// A skeleton that sinew_rig() gave or the caller made, in the mesh's grid, and new joints of it in the caller's units.
#ifndef SINEW_DETAILS_GIVEN_SKELETON_HPP
#define SINEW_DETAILS_GIVEN_SKELETON_HPP

#include "grid/caller_units.hpp"
#include "mesh/mesh.hpp"
#include "rig/rig.hpp"

namespace sinew::rigging {

constexpr uint32_t kMostGivenJoints = SINEW_MAX_RIG_JOINTS;

struct GivenSkeleton {
  const sinew_rig_outputs& joints;
  Vec3i at[kMostGivenJoints];
  bool end[kMostGivenJoints];  // a bone end, no joint
  uint8_t ends_below[kMostGivenJoints], joints_below[kMostGivenJoints];

  explicit GivenSkeleton(const sinew_rig_outputs& outputs) : joints(outputs) {}
  // Checks and reads all of it. Returns SINEW_OK, SINEW_ERROR_COUNT, SINEW_ERROR_NOT_FINITE or SINEW_ERROR_INDEX.
  sinew_status read(const GridQuantizer& quantizer);
  int32_t partner(uint32_t j) const { return joints.partners == nullptr ? -1 : joints.partners[j]; }
  // Its only bone end, or -1.
  int32_t end_of(uint32_t j) const;
};

// The mesh, allocated beforehand, and the skeleton in its grid. Returns what read() and build_mesh() do.
sinew_status read_given(const sinew_mesh& input, uint32_t up_axis, const Counts& counts, Arena& arena, Mesh* mesh,
                        GivenSkeleton* skeleton);

// A point of the grid in the caller's units and axes: itself, its mirror image, which is as far from the skeleton's plane, or
// moved into the plane.
enum class PointSide : uint8_t { kHere, kMirrored, kPlane };
void place_point(const Units& units, uint32_t up_axis, const sinew_rig_outputs& skeleton, Vec3i p, PointSide side,
                 float* to);

// The nearest point to p of the segment from a to b, rounded.
Vec3i nearest_on_segment(Vec3i a, Vec3i b, Vec3i p);

struct NewJoint {
  const char* name;     // behind `named_after`'s; numbered where another has it
  int32_t named_after;  // a joint whose name comes first, or -1
  Vec3i at;
  PointSide side;
  int32_t parent, partner;
  uint8_t joint_class;
  bool end;
  uint16_t confidence;
};
// Writes a joint behind the others. The caller sees to it that there is room.
void append_joint(const Units& units, uint32_t up_axis, const NewJoint& joint, sinew_rig_outputs* skeleton);

// Grows the skeleton in `outputs`. `stage` has room() for what it finds, find() looks, add() appends. With a measuring arena
// neither mesh nor skeleton is read. Errors are those of sinew_rig_details().
template <class Stage>
sinew_status grow_given(const RigPlan& plan, const sinew_mesh& input, Arena& arena, Stage stage,
                        sinew_rig_outputs* outputs) {
  Mesh mesh;
  (void)mesh.allocate(arena, plan.counts);
  stage.room(arena);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return build_mesh(input, GridQuantizer(), plan.counts, arena, &mesh);
  GivenSkeleton skeleton(*outputs);
  const sinew_status status = read_given(input, plan.up_axis, plan.counts, arena, &mesh, &skeleton);
  if (status != SINEW_OK) return status;
  if (!plan.progress.report(Progress::kWhole / 2)) return SINEW_ERROR_CANCELLED;
  stage.find(mesh, skeleton);
  stage.add(Units(input, plan.up_axis), plan.up_axis, outputs);
  outputs->used_bytes = arena.high_water();
  return SINEW_OK;
}

}  // namespace sinew::rigging
#endif
