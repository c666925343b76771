// SPDX-License-Identifier: MIT
// A skeleton's arrays go through sinew_rig_hands(); longer ones come back.
#include "sinew_formats/predict_hands.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include "sinew/sinew.hpp"
#include "sinew_formats/bind.hpp"
#include "sinew_formats/engine_views.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

uint16_t q15(float value) { return static_cast<uint16_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 32767.0f)); }

}  // namespace

size_t predict_hands(const Character& character, const sinew_model& hands, const SkeletonOptions& options,
                     PredictedSkeleton* skeleton) {
  const size_t before = skeleton->joints.size();
  if (before > SINEW_MAX_RIG_JOINTS)
    throw Error(character.name + ": fingers are for skeletons of at most " + std::to_string(SINEW_MAX_RIG_JOINTS) +
                " joints, found " + std::to_string(before));
  const EngineViews views(character, {});
  sinew_rig_options engine_options = sinew_rig_options_init();
  engine_options.up_axis = options.up_axis;
  engine_options.kernel = options.kernel != SINEW_KERNEL_AUTO ? options.kernel : kernel_from_environment();
  size_t bytes = 0;
  throw_status(character, sinew_rig_hands_workspace_size(&hands, views.mesh.vertex_count, views.mesh.face_count,
                                                         views.mesh.corner_count, &engine_options, &bytes));
  const Workspace workspace(bytes);
  if (workspace.size() < bytes)
    throw OutOfMemory(character.name + ": no memory for a workspace of " + std::to_string(bytes / 1000000) +
                      " MB in one piece");

  std::vector<float> positions(size_t{3} * SINEW_MAX_RIG_JOINTS);
  std::vector<int32_t> parents(SINEW_MAX_RIG_JOINTS), partners(SINEW_MAX_RIG_JOINTS, -1);
  std::vector<uint8_t> flags(SINEW_MAX_RIG_JOINTS), classes(SINEW_MAX_RIG_JOINTS);
  std::vector<uint16_t> confidence(SINEW_MAX_RIG_JOINTS), parent_confidence(SINEW_MAX_RIG_JOINTS);
  std::vector<char> names(size_t{SINEW_MAX_RIG_JOINTS} * SINEW_JOINT_NAME_BYTES);
  for (size_t j = 0; j < before; ++j) {
    const Joint& joint = skeleton->joints[j];
    positions[3 * j] = joint.position.x;
    positions[3 * j + 1] = joint.position.y;
    positions[3 * j + 2] = joint.position.z;
    parents[j] = joint.parent;
    partners[j] = skeleton->partners[j];
    flags[j] = skeleton->ends[j] != 0 ? SINEW_JOINT_NEVER : 0;
    classes[j] = skeleton->classes[j];
    confidence[j] = q15(skeleton->confidence[j]);
    parent_confidence[j] = q15(skeleton->parent_confidence[j]);
  }
  sinew_rig_outputs outputs = sinew_rig_outputs_init(positions.data(), parents.data());
  outputs.joint_count = static_cast<uint32_t>(before);
  outputs.flags = flags.data();
  outputs.joint_classes = classes.data();
  outputs.partners = partners.data();
  outputs.confidence = confidence.data();
  outputs.parent_confidence = parent_confidence.data();
  // Names here are longer than there, so only what is put behind them is taken: the hand's own name is left empty.
  outputs.names = reinterpret_cast<char(*)[SINEW_JOINT_NAME_BYTES]>(names.data());
  outputs.mirrored = skeleton->mirrored ? 1 : 0;
  outputs.quarter_turns = skeleton->quarter_turns;
  outputs.plane = skeleton->plane;
  const auto begin = std::chrono::steady_clock::now();
  throw_status(character,
               sinew_rig_hands(&hands, &views.mesh, &engine_options, workspace.data(), workspace.size(), &outputs));
  skeleton->seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  skeleton->workspace_bytes = std::max(skeleton->workspace_bytes, bytes);

  const size_t count = outputs.joint_count;
  std::set<int> fingered;
  skeleton->joints.resize(count);
  skeleton->classes.assign(classes.begin(), classes.begin() + static_cast<long>(count));
  skeleton->partners.assign(partners.begin(), partners.begin() + static_cast<long>(count));
  skeleton->ends.resize(count);
  skeleton->confidence.resize(count);
  skeleton->parent_confidence.resize(count);
  for (size_t j = 0; j < count; ++j) {
    if (!is_finger_class(classes[j]) || names[j * SINEW_JOINT_NAME_BYTES] == 0) continue;
    int hand = parents[j];
    while (is_finger_class(classes[static_cast<size_t>(hand)])) hand = parents[static_cast<size_t>(hand)];
    fingered.insert(hand);
    const bool end = flags[j] == SINEW_JOINT_NEVER;
    skeleton->joints[j] = {skeleton->joints[static_cast<size_t>(hand)].name + &names[j * SINEW_JOINT_NAME_BYTES],
                           {positions[3 * j], positions[3 * j + 1], positions[3 * j + 2]},
                           parents[j],
                           !end};
    skeleton->ends[j] = end ? 1 : 0;
    skeleton->confidence[j] = static_cast<float>(confidence[j]) / 32767.0f;
    skeleton->parent_confidence[j] = static_cast<float>(parent_confidence[j]) / 32767.0f;
  }
  return fingered.size();
}

}  // namespace sinew
