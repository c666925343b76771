// SPDX-License-Identifier: MIT
// Joints to arrays with room for more, one call of the engine, and back.
#include "skeleton_arrays.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "sinew/sinew.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr float kSure = 32768.0f;

uint16_t q15(float value) { return static_cast<uint16_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * kSure)); }

}  // namespace

SkeletonArrays::SkeletonArrays(const Character& character, const PredictedSkeleton& skeleton, const std::string& what,
                               bool names)
    : positions_(size_t{3} * SINEW_MAX_RIG_JOINTS),
      parents_(SINEW_MAX_RIG_JOINTS),
      partners_(SINEW_MAX_RIG_JOINTS, -1),
      flags_(SINEW_MAX_RIG_JOINTS),
      classes_(SINEW_MAX_RIG_JOINTS),
      confidence_(SINEW_MAX_RIG_JOINTS),
      parent_confidence_(SINEW_MAX_RIG_JOINTS),
      names_(size_t{SINEW_MAX_RIG_JOINTS} * SINEW_JOINT_NAME_BYTES) {
  const size_t count = skeleton.joints.size();
  if (count > SINEW_MAX_RIG_JOINTS)
    throw Error(character.name + ": " + what + " are for skeletons of at most " + std::to_string(SINEW_MAX_RIG_JOINTS) +
                " joints, found " + std::to_string(count));
  for (size_t j = 0; j < count; ++j) {
    const Joint& joint = skeleton.joints[j];
    positions_[3 * j] = joint.position.x;
    positions_[3 * j + 1] = joint.position.y;
    positions_[3 * j + 2] = joint.position.z;
    parents_[j] = joint.parent;
    partners_[j] = skeleton.partners[j];
    flags_[j] = skeleton.ends[j] != 0 ? SINEW_JOINT_NEVER : 0;
    classes_[j] = skeleton.classes[j];
    confidence_[j] = q15(skeleton.confidence[j]);
    parent_confidence_[j] = q15(skeleton.parent_confidence[j]);
    if (names) std::strncpy(&names_[j * SINEW_JOINT_NAME_BYTES], joint.name.c_str(), SINEW_JOINT_NAME_BYTES - 1);
  }
  outputs_ = SINEW_INIT(sinew_rig_outputs);
  outputs_.positions = positions_.data();
  outputs_.parents = parents_.data();
  outputs_.joint_count = static_cast<uint32_t>(count);
  outputs_.flags = flags_.data();
  outputs_.joint_classes = classes_.data();
  outputs_.partners = partners_.data();
  outputs_.confidence = confidence_.data();
  outputs_.parent_confidence = parent_confidence_.data();
  outputs_.names = reinterpret_cast<char(*)[SINEW_JOINT_NAME_BYTES]>(names_.data());
  outputs_.mirrored = skeleton.mirrored ? 1 : 0;
  outputs_.facing = skeleton.facing;
  outputs_.plane = skeleton.plane;
  std::copy(skeleton.front.begin(), skeleton.front.end(), outputs_.front);
  outputs_.up = engine_up(skeleton.up_axis);
}

void SkeletonArrays::grow(const Character& character, const SkeletonOptions& options, sinew_rig_detail detail,
                          const sinew_model* hands_model, PredictedSkeleton* skeleton) {
  const EngineViews views(character, {});
  sinew_rig_options engine_options = SINEW_INIT(sinew_rig_options);
  engine_options.up = engine_up(options.up_axis);
  engine_options.kernel = options.kernel != SINEW_KERNEL_AUTO ? options.kernel : kernel_from_environment();
  size_t bytes = 0;
  const sinew_mesh& mesh = views.mesh;
  throw_status(character, sinew_rig_details_workspace_size(hands_model, mesh.vertex_count, mesh.face_count,
                                                           mesh.corner_count, detail, &engine_options, &bytes));
  const Workspace workspace(bytes);
  if (workspace.size() < bytes)
    throw OutOfMemory(character.name + ": no memory for a workspace of " + std::to_string(bytes / 1000000) +
                      " MB in one piece");
  const auto begin = std::chrono::steady_clock::now();
  throw_status(character, sinew_rig_details(hands_model, &mesh, detail, &engine_options, workspace.data(),
                                            workspace.size(), &outputs_));
  skeleton->seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  skeleton->workspace_bytes = std::max(skeleton->workspace_bytes, bytes);
}

void SkeletonArrays::resize(PredictedSkeleton* skeleton) const {
  const auto count = static_cast<std::ptrdiff_t>(joint_count());
  skeleton->joints.resize(joint_count());
  skeleton->classes.assign(classes_.begin(), classes_.begin() + count);
  skeleton->partners.assign(partners_.begin(), partners_.begin() + count);
  skeleton->ends.resize(joint_count());
  skeleton->confidence.resize(joint_count());
  skeleton->parent_confidence.resize(joint_count());
}

void SkeletonArrays::take(size_t j, const std::string& name, PredictedSkeleton* skeleton) const {
  const bool end = flags_[j] == SINEW_JOINT_NEVER;
  skeleton->joints[j] = {name, {positions_[3 * j], positions_[3 * j + 1], positions_[3 * j + 2]}, parents_[j], !end};
  skeleton->ends[j] = end ? 1 : 0;
  skeleton->confidence[j] = static_cast<float>(confidence_[j]) / kSure;
  skeleton->parent_confidence[j] = static_cast<float>(parent_confidence_[j]) / kSure;
}

}  // namespace sinew
