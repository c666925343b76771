// SPDX-License-Identifier: MIT
// A Character's mesh goes through sinew_rig(); joints come back.
#include "sinew_character/predict/predict_skeleton.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include "predict/limbs.hpp"
#include "predict/mirror_plane.hpp"
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
                      std::to_string(result.workspace_bytes / 1000000) + " MB in one block");
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

void take_the_place_of(const PredictedSkeleton& other, PredictedSkeleton* skeleton) {
  skeleton->up_axis = other.up_axis;
  skeleton->up_confidence = other.up_confidence;
  skeleton->seconds += other.seconds;
  skeleton->workspace_bytes = std::max(skeleton->workspace_bytes, other.workspace_bytes);
}

float usable_probability(float spread, bool mirrored) {
  constexpr double kSure = 1.68, kPerDoubling = -3.54, kNotMirrored = -0.74;
  const double score =
      kSure + kPerDoubling * std::log2(std::max(double{spread}, 1e-4) / 0.05) + (mirrored ? 0 : kNotMirrored);
  return static_cast<float>(1 / (1 + std::exp(-score)));
}

// Confidences of limbs' joints to a probability.

namespace {

// Fitted to 511 limbs of 105 characters of makers whom the model did not know, of which 128 lay more than 6 % of the size from the
// artist's joints in the mean (trainer/configs/RESULTS.md).
constexpr double kConstant = -15.0, kUnsure = 16.5, kPerBit = 0.148, kMostBits = 14;

bool is_class(const PredictedSkeleton& skeleton, int joint, uint8_t wanted) {
  return skeleton.classes[static_cast<size_t>(joint)] == wanted && skeleton.ends[static_cast<size_t>(joint)] == 0;
}

float doubt_of(const PredictedSkeleton& skeleton, const Limb& limb) {
  double joints = 0, unsure = 0, weakest = 1;
  for (const int j : limb.joints) {
    const auto i = static_cast<size_t>(j);
    if (skeleton.ends[i] != 0) continue;
    ++joints;
    unsure += 1 - static_cast<double>(skeleton.confidence[i]);
    weakest = std::min(weakest, static_cast<double>(skeleton.parent_confidence[i]));
  }
  const double bits = std::min(-std::log2(std::max(weakest, 1e-5)), kMostBits);
  const double score = kConstant + kUnsure * unsure / std::max(joints, 1.0) + kPerBit * bits;
  return static_cast<float>(1 / (1 + std::exp(-score)));
}

// Arms and legs are called by the bone that begins them, not by the clavicle or hip before it.
int called_by(const PredictedSkeleton& skeleton, const Limb& limb) {
  for (const int j : limb.joints)
    if (is_class(skeleton, j, SINEW_CLASS_UPPER_ARM) || is_class(skeleton, j, SINEW_CLASS_THIGH)) return j;
  return limb.joints.front();
}

}  // namespace

std::vector<LimbDoubt> limb_doubts(const PredictedSkeleton& skeleton) {
  // Sides come from the positions of joints across the mirror plane.
  const MirrorPlane plane(skeleton);
  LabeledSkeleton labeled = {skeleton.joints, skeleton.classes, skeleton.ends};
  for (Joint& joint : labeled.joints) joint.position.x = plane.distance(joint.position);
  const Limbs limbs = find_limbs(labeled, 0, 0);
  std::vector<LimbDoubt> doubts;
  for (const Limb& limb : limbs.limbs) {
    if (limb.kind == LimbKind::kTrunk || limb.joints.empty()) continue;
    LimbDoubt one;
    one.joints = limb.joints;
    one.joint = called_by(skeleton, limb);
    one.name = skeleton.joints[static_cast<size_t>(one.joint)].name;
    one.doubt = doubt_of(skeleton, limb);
    doubts.push_back(std::move(one));
  }
  return doubts;
}

std::vector<LimbDoubt> doubtful_limbs(const PredictedSkeleton& skeleton) {
  std::vector<LimbDoubt> doubts = limb_doubts(skeleton);
  std::erase_if(doubts, [](const LimbDoubt& one) { return one.doubt < kDoubtfulLimb; });
  std::stable_sort(doubts.begin(), doubts.end(),
                   [](const LimbDoubt& a, const LimbDoubt& b) { return a.doubt > b.doubt; });
  return doubts;
}

std::string doubts_text(const std::vector<LimbDoubt>& limbs) {
  std::string text;
  for (const LimbDoubt& one : limbs) text += (text.empty() ? "warning: these limbs may be wrong: " : ", ") + one.name;
  return text.empty() ? text : text + "; check them";
}

}  // namespace sinew
