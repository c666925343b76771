// SPDX-License-Identifier: MIT
// A Character's mesh goes through sinew_rig(); joints come back.
#include "sinew_character/predict/predict_skeleton.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "sinew/sinew.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

PredictedSkeleton predict_skeleton(const Character& character, const SkeletonOptions& options) {
  if (character.vertices.empty()) throw Error(character.name + ": no vertices; expected a mesh");
  const EngineViews views(character, {});
  RigSettings engine_options;
  engine_options.method = options.method;
  engine_options.category = options.category;
  engine_options.up = options.find_up ? uint32_t{SINEW_UP_AUTO} : engine_up(options.up_axis);
  engine_options.front_model = options.front_model;
  engine_options.front = options.front;
  engine_options.axes_known = options.axes_known ? 1 : 0;
  engine_options.mirror = options.mirror;
  engine_options.spine_count = options.spine_count;
  if (!options.toes) engine_options.without |= SINEW_WITHOUT_TOES;
  if (!options.ends) engine_options.without |= SINEW_WITHOUT_ENDS;
  engine_options.kernel = options.kernel != SINEW_KERNEL_AUTO ? options.kernel : kernel_from_environment();

  PredictedSkeleton result;
  throw_status(character, sinew_rig_workspace_size(options.model, views.mesh.vertex_count, views.mesh.face_count,
                                                   views.mesh.corner_count, &engine_options, &result.workspace_bytes));
  Workspace workspace(result.workspace_bytes);
  if (workspace.size() < result.workspace_bytes) {
    throw OutOfMemory(character.name + ": no memory for a workspace of " +
                      std::to_string(result.workspace_bytes / 1000000) + " MB in one piece");
  }
  RiggedSkeleton rigged;
  const auto begin = std::chrono::steady_clock::now();
  throw_status(character, rig(options.model, views.mesh, engine_options, &workspace, &rigged));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  for (uint32_t j = 0; j < rigged.joint_count(); ++j) {
    const bool end = (rigged.flags[j] & SINEW_JOINT_NEVER) != 0;
    const float* const position = &rigged.positions[size_t{3} * j];
    result.joints.push_back({rigged.names[j].text, {position[0], position[1], position[2]}, rigged.parents[j], !end});
    result.ends.push_back(end ? 1 : 0);
    result.confidence.push_back(static_cast<float>(rigged.confidence[j]) / 32768.0f);
    result.parent_confidence.push_back(static_cast<float>(rigged.parent_confidence[j]) / 32768.0f);
  }
  result.classes = std::move(rigged.joint_classes);
  result.partners = std::move(rigged.partners);
  result.mirrored = rigged.mirrored;
  result.facing = rigged.facing;
  result.plane = rigged.plane;
  result.spread = rigged.spread;
  std::copy(std::begin(rigged.front), std::end(rigged.front), result.front.begin());
  result.up_axis = rigged.up == SINEW_UP_Z ? Axis::kZ : Axis::kY;
  result.front_confidence = rigged.front_confidence;
  result.up_confidence = rigged.up_confidence;
  if (options.method == SINEW_RIG_VOTES) result.usable = usable_probability(result.spread, result.mirrored);
  return result;
}

float usable_probability(float spread, bool mirrored) {
  constexpr double kSure = 1.68, kPerDoubling = -3.54, kNotMirrored = -0.74;
  const double score =
      kSure + kPerDoubling * std::log2(std::max(double{spread}, 1e-4) / 0.05) + (mirrored ? 0 : kNotMirrored);
  return static_cast<float>(1 / (1 + std::exp(-score)));
}

}  // namespace sinew
