// SPDX-License-Identifier: MIT
// Leaves out roots that stand on the floor below a character (stage 4, before the sources are found).
#include "heat/heat.hpp"

namespace sinew {
namespace {

constexpr int64_t kFloorPercent = 3;  // a root this low stands on the floor
constexpr uint16_t kFloorRootChildren = 4;
constexpr uint32_t kFewJoints = 2;  // a lamp or a door, each of whose joints moves something

}  // namespace

void choose_source_joints(const Mesh& mesh, const Skeleton& skeleton, uint8_t* source_joints) {
  int64_t height = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    if (mesh.positions[v].y > height) height = mesh.positions[v].y;
  }
  bool any = false;
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
    const bool floor_root = !skeleton.deform_known && skeleton.joint_count > kFewJoints && skeleton.parents[j] < 0 &&
                            skeleton.child_count[j] >= 1 && skeleton.child_count[j] <= kFloorRootChildren &&
                            100 * static_cast<int64_t>(skeleton.positions[j].y) <= kFloorPercent * height;
    source_joints[j] = skeleton.usable[j] != 0 && !floor_root ? 1 : 0;
    any = any || source_joints[j] != 0;
  }
  // Heat must come from somewhere: when only such a root may be used, it is a source after all.
  for (uint32_t j = 0; j < skeleton.joint_count && !any; ++j) source_joints[j] = skeleton.usable[j];
}

}  // namespace sinew
