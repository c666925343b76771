// SPDX-License-Identifier: MIT
// Checks a caller's skeleton and converts it back from the grid.
#include "details/given_skeleton.hpp"

#include <string.h>

#include "core/read_skeleton.hpp"
#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kNameRoom = SINEW_JOINT_NAME_BYTES - 1, kLongestTail = 12;  // of a new name and its number

bool is_new_name(const sinew_rig_outputs& skeleton, uint32_t j) {
  for (uint32_t i = 0; i < j; ++i) {
    if (same_text(skeleton.names[i], skeleton.names[j])) return false;
  }
  return true;
}

// LeftEye, or LeftEye1, LeftEye2 ... where others have that name.
SINEW_RARE void name_joint(const NewJoint& joint, uint32_t j, sinew_rig_outputs* skeleton) {
  char* const to = skeleton->names[j];
  for (uint32_t number = 0; number <= kMostGivenJoints; ++number) {
    uint32_t at = 0;
    if (joint.named_after >= 0) {
      for (const char* from = skeleton->names[joint.named_after]; at < kNameRoom - kLongestTail && from[at] != 0; ++at)
        to[at] = from[at];
    }
    for (const char* from = joint.name; *from != 0; ++from) to[at++] = *from;
    if (number >= 100) to[at++] = static_cast<char>('0' + number / 100);
    if (number >= 10) to[at++] = static_cast<char>('0' + number / 10 % 10);
    if (number > 0) to[at++] = static_cast<char>('0' + number % 10);
    to[at] = 0;
    if (is_new_name(*skeleton, j)) return;
  }
}

}  // namespace

SINEW_RARE sinew_status GivenSkeleton::read(const GridQuantizer& quantizer) {
  const uint32_t count = joints.joint_count;
  if (count == 0 || count > kMostGivenJoints) return SINEW_ERROR_COUNT;
  memset(ends_below, 0, sizeof ends_below);
  memset(joints_below, 0, sizeof joints_below);
  for (uint32_t j = 0; j < count; ++j) {
    const float* const p = joints.positions + size_t{3} * j;
    if (!is_finite_point(p)) return SINEW_ERROR_NOT_FINITE;
    const int32_t parent = joints.parents[j];
    if (parent < -1 || parent >= static_cast<int32_t>(j)) return SINEW_ERROR_INDEX;
    if (partner(j) < -1 || partner(j) >= static_cast<int32_t>(count)) return SINEW_ERROR_INDEX;
    at[j] = quantize_point(quantizer, p);
    end[j] = joints.flags != nullptr && joints.flags[j] == SINEW_JOINT_NEVER;
    if (parent >= 0) ++(end[j] ? ends_below : joints_below)[parent];
  }
  return SINEW_OK;
}

int32_t GivenSkeleton::end_of(uint32_t j) const {
  if (ends_below[j] != 1) return -1;
  for (uint32_t e = j + 1; e < joints.joint_count; ++e) {
    if (end[e] && joints.parents[e] == static_cast<int32_t>(j)) return static_cast<int32_t>(e);
  }
  return -1;
}

sinew_status read_given(const sinew_mesh& input, uint32_t up_axis, const Counts& counts, Arena& arena, Mesh* mesh,
                        GivenSkeleton* skeleton) {
  GridQuantizer quantizer;
  sinew_status status = make_grid_quantizer(input.positions, input.vertex_count, up_axis, &quantizer);
  if (status == SINEW_OK) status = skeleton->read(quantizer);
  return status == SINEW_OK ? build_mesh(input, quantizer, counts, arena, mesh) : status;
}

void place_point(const Units& units, uint32_t up_axis, const sinew_rig_outputs& skeleton, Vec3i p, PointSide side,
                 float* to) {
  double at[3] = {units.zero(0) + units.length(p.x), units.zero(1) + units.length(p.y),
                  units.zero(2) + units.length(p.z)};
  double& across = at[(skeleton.facing & 1) != 0 ? 2 : 0];
  const double plane = static_cast<double>(skeleton.plane);
  if (side == PointSide::kMirrored) across = 2 * plane - across;
  if (side == PointSide::kPlane) across = plane;
  to[0] = to_float(at[0]);
  to[1] = to_float(up_axis == 0 ? at[1] : -at[2]);
  to[2] = to_float(up_axis == 0 ? at[2] : at[1]);
}

Vec3i nearest_on_segment(Vec3i a, Vec3i b, Vec3i p) {
  const Vec3i along = b - a;
  const int64_t whole = dot(along, along), part = dot(p - a, along);
  if (part <= 0 || whole == 0) return a;
  if (part >= whole) return b;
  return a + round_div(Vec3l{along.x * part, along.y * part, along.z * part}, whole);
}

SINEW_RARE void append_joint(const Units& units, uint32_t up_axis, const NewJoint& joint, sinew_rig_outputs* skeleton) {
  const uint32_t j = skeleton->joint_count++;
  place_point(units, up_axis, *skeleton, joint.at, joint.side, skeleton->positions + size_t{3} * j);
  skeleton->parents[j] = joint.parent;
  skeleton->joint_classes[j] = joint.joint_class;
  if (skeleton->flags != nullptr) skeleton->flags[j] = joint.end ? SINEW_JOINT_NEVER : 0;
  if (skeleton->partners != nullptr) skeleton->partners[j] = joint.partner;
  if (skeleton->confidence != nullptr) skeleton->confidence[j] = joint.confidence;
  if (skeleton->parent_confidence != nullptr) skeleton->parent_confidence[j] = joint.confidence;
  if (skeleton->names != nullptr) name_joint(joint, j, skeleton);
}

}  // namespace sinew::rigging
