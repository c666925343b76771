// SPDX-License-Identifier: MIT
// A Character's mesh goes through sinew_rig(); joints come back.
#include "sinew_formats/predict_skeleton.hpp"

#include <chrono>
#include <string>

#include "sinew/sinew.hpp"
#include "sinew_formats/bind.hpp"
#include "sinew_formats/engine_views.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

PredictedSkeleton predict_skeleton(const Character& character, const SkeletonOptions& options) {
  if (character.vertices.empty()) throw Error(character.name + ": no vertices; expected a mesh");
  const EngineViews views(character, {});
  sinew_rig_options engine_options = sinew_rig_options_init();
  engine_options.up_axis = options.up_axis;
  engine_options.mirror = options.mirror;
  engine_options.spine_count = options.spine_count;
  engine_options.no_toes = options.toes ? 0 : 1;
  engine_options.no_ends = options.ends ? 0 : 1;
  engine_options.kernel = options.kernel != SINEW_KERNEL_AUTO ? options.kernel : kernel_from_environment();

  PredictedSkeleton result;
  throw_status(character, sinew_rig_workspace_size(options.model, views.mesh.vertex_count, views.mesh.face_count,
                                                   views.mesh.corner_count, &engine_options, &result.workspace_bytes));
  const Workspace workspace(result.workspace_bytes);
  if (workspace.size() < result.workspace_bytes) {
    throw OutOfMemory(character.name + ": no memory for a workspace of " +
                      std::to_string(result.workspace_bytes / 1000000) + " MB in one piece");
  }
  std::vector<float> positions(size_t{3} * SINEW_MAX_RIG_JOINTS);
  std::vector<int32_t> parents(SINEW_MAX_RIG_JOINTS);
  std::vector<uint8_t> flags(SINEW_MAX_RIG_JOINTS);
  std::vector<uint16_t> confidence(SINEW_MAX_RIG_JOINTS), parent_confidence(SINEW_MAX_RIG_JOINTS);
  std::vector<char> names(size_t{SINEW_MAX_RIG_JOINTS} * SINEW_JOINT_NAME_BYTES);
  result.classes.resize(SINEW_MAX_RIG_JOINTS);
  result.partners.resize(SINEW_MAX_RIG_JOINTS);
  sinew_rig_outputs outputs = sinew_rig_outputs_init(positions.data(), parents.data());
  outputs.flags = flags.data();
  outputs.joint_classes = result.classes.data();
  outputs.partners = result.partners.data();
  outputs.confidence = confidence.data();
  outputs.parent_confidence = parent_confidence.data();
  outputs.names = reinterpret_cast<char(*)[SINEW_JOINT_NAME_BYTES]>(names.data());
  const auto begin = std::chrono::steady_clock::now();
  throw_status(character,
               sinew_rig(options.model, &views.mesh, &engine_options, workspace.data(), workspace.size(), &outputs));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  const uint32_t count = outputs.joint_count;
  result.classes.resize(count);
  result.partners.resize(count);
  for (uint32_t j = 0; j < count; ++j) {
    const bool end = (flags[j] & SINEW_JOINT_NEVER) != 0;
    result.joints.push_back({&names[size_t{j} * SINEW_JOINT_NAME_BYTES],
                             {positions[3 * j], positions[3 * j + 1], positions[3 * j + 2]},
                             parents[j],
                             !end});
    result.ends.push_back(end ? 1 : 0);
    result.confidence.push_back(static_cast<float>(confidence[j]) / 32768.0f);
    result.parent_confidence.push_back(static_cast<float>(parent_confidence[j]) / 32768.0f);
  }
  result.mirrored = outputs.mirrored != 0;
  result.quarter_turns = outputs.quarter_turns;
  result.plane = outputs.plane;
  result.spread = outputs.spread;
  return result;
}

}  // namespace sinew
