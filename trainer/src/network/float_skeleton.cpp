// SPDX-License-Identifier: MIT
// The engine's stages with float rows in between.
#include <algorithm>
#include <cmath>

#include "data/rig_sample.hpp"
#include "kernels/select.hpp"
#include "rig/rig.hpp"
#include "sinew/sinew.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/rig_difference.hpp"

namespace sinew {
namespace {

struct FloatRows {
  const FloatNetwork& network;
  NetworkRunner runner;

  static sinew_status run(void* user, const rigging::PointSet& set, int16_t* rows) {
    FloatRows& self = *static_cast<FloatRows*>(user);
    const std::vector<float>& exact = self.runner.forward(self.network, point_sample(set));
    for (size_t i = 0; i < exact.size(); ++i) {
      const double steps = std::floor(static_cast<double>(exact[i]) * kOutputScale + 0.5);
      rows[i] = static_cast<int16_t>(std::clamp(steps, -32767.0, 32767.0));
    }
    return SINEW_OK;
  }
};

// Left, right or on the plane, by which of a joint and its image is further along.
int side_of(const PredictedSkeleton& s, size_t j) {
  const int partner = s.partners[j];
  if (partner < 0 || partner == static_cast<int>(j)) return 0;
  const auto across = [&](size_t i) {
    const auto& p = s.joints[i].position;
    return s.facing % 2 == 0 ? p.x : p.z;
  };
  return across(j) > across(static_cast<size_t>(partner)) ? 1 : -1;
}

}  // namespace

PredictedSkeleton predict_float_skeleton(const Character& character, const FloatNetwork& network,
                                         const SkeletonOptions& options) {
  const EngineViews views(character, {});
  sinew_rig_options engine_options = SINEW_INIT(sinew_rig_options);
  engine_options.up = options.find_up ? SINEW_UP_AUTO : options.up_axis == Axis::kZ ? SINEW_UP_Z : SINEW_UP_Y;
  engine_options.front_model = options.front_model;
  engine_options.front = options.front;
  engine_options.mirror = options.mirror;
  rigging::RigPlan plan;
  throw_status(character, rigging::plan_rig(options.model, views.mesh.vertex_count, views.mesh.face_count,
                                            views.mesh.corner_count, &engine_options, &plan));
  FloatRows rows{network, {}};
  plan.other = {FloatRows::run, &rows};
  Kernels kernels;
  if (!select_kernels(kernel_from_environment(), &kernels)) throw_status(character, SINEW_ERROR_KERNEL);
  Arena measuring;
  throw_status(character, run_rig(plan, {}, kernels, measuring, nullptr));
  const Workspace block(measuring.high_water());
  if (block.size() < measuring.high_water()) throw OutOfMemory(character.name + ": no memory for a workspace");
  Arena arena(block.data(), block.size());

  constexpr size_t kMost = SINEW_MAX_RIG_JOINTS;
  std::vector<float> positions(3 * kMost);
  std::vector<int32_t> parents(kMost), partners(kMost);
  std::vector<uint8_t> flags(kMost), classes(kMost);
  sinew_rig_outputs outputs = SINEW_INIT(sinew_rig_outputs);
  outputs.positions = positions.data();
  outputs.parents = parents.data();
  outputs.flags = flags.data();
  outputs.joint_classes = classes.data();
  outputs.partners = partners.data();
  std::vector<char> names(kMost * SINEW_JOINT_NAME_BYTES);
  outputs.names = reinterpret_cast<char(*)[SINEW_JOINT_NAME_BYTES]>(names.data());
  throw_status(character, run_rig(plan, views.mesh, kernels, arena, &outputs));

  PredictedSkeleton result;
  const size_t count = outputs.joint_count;
  for (size_t j = 0; j < count; ++j) {
    const bool end = flags[j] == SINEW_JOINT_NEVER;
    result.joints.push_back(
        {outputs.names[j], {positions[3 * j], positions[3 * j + 1], positions[3 * j + 2]}, parents[j], !end});
    result.ends.push_back(end ? 1 : 0);
  }
  classes.resize(count);
  partners.resize(count);
  result.classes = std::move(classes);
  result.partners = std::move(partners);
  result.confidence.assign(count, 0);
  result.parent_confidence.assign(count, 0);
  result.mirrored = outputs.mirrored != 0;
  result.facing = outputs.facing;
  result.plane = outputs.plane;
  result.spread = outputs.spread;
  return result;
}

bool same_tree(const PredictedSkeleton& a, const PredictedSkeleton& b) {
  if (a.joints.size() != b.joints.size()) return false;
  // Every joint as its path to the root; names are numbers of a class and may go to another joint.
  const auto paths = [](const PredictedSkeleton& s) {
    std::vector<std::vector<int>> all;
    for (size_t j = 0; j < s.joints.size(); ++j) {
      std::vector<int> path;
      for (int at = static_cast<int>(j); at >= 0; at = s.joints[static_cast<size_t>(at)].parent) {
        const auto i = static_cast<size_t>(at);
        path.push_back(8 * s.classes[i] + 2 * (side_of(s, i) + 1) + s.ends[i]);
      }
      all.push_back(path);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  return paths(a) == paths(b);
}

}  // namespace sinew
