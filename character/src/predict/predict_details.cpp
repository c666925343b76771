// SPDX-License-Identifier: MIT
// Adds details to a skeleton by sinew_rig_details(): fingers first, since props are children of hands.
#include "sinew_character/predict/predict_details.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "sinew/sinew.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

// A predicted skeleton as the arrays that sinew_rig_details() takes and lets grow.
class SkeletonArrays {
 public:
  // Throws Error when the skeleton has more joints than there is room for.
  //   names  whether the engine sees the joints' names, as far as they fit; else it gives those behind a joint's own
  SkeletonArrays(const Character& character, const PredictedSkeleton& skeleton, const std::string& what, bool names);
  SkeletonArrays(const SkeletonArrays&) = delete;
  SkeletonArrays& operator=(const SkeletonArrays&) = delete;

  // Adds one sinew_rig_detail; hands_model is for hands alone. Throws Error and OutOfMemory with the character's name. The
  // skeleton's seconds and workspace grow; its joints are as they were.
  void grow(const Character& character, const SkeletonOptions& options, sinew_rig_detail detail,
            const sinew_model* hands_model, PredictedSkeleton* skeleton);

  size_t joint_count() const { return outputs_.joint_count; }
  int parent(size_t j) const { return parents_[j]; }
  uint8_t joint_class(size_t j) const { return classes_[j]; }
  const char* name(size_t j) const { return &names_[j * SINEW_JOINT_NAME_BYTES]; }
  // Makes the skeleton's arrays as long as these, with everything but joints and ends.
  void resize(PredictedSkeleton* skeleton) const;
  // Writes joint j, of this name.
  void take(size_t j, const std::string& name, PredictedSkeleton* skeleton) const;

 private:
  std::vector<float> positions_;
  std::vector<int32_t> parents_, partners_;
  std::vector<uint8_t> flags_, classes_;
  std::vector<uint16_t> confidence_, parent_confidence_;
  std::vector<char> names_;
  sinew_rig_outputs outputs_;
};

// Joints to arrays with room for more, one call of the engine, and back.

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
    throw Error(character.name + ": " + what + " need a skeleton of at most " + std::to_string(SINEW_MAX_RIG_JOINTS) +
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
                      " MB in one block");
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

namespace {

// Hands that have fingers, but no thumb among them: one line each.
void say_thumbs(const PredictedSkeleton& skeleton, std::vector<std::string>* notes) {
  const auto is_finger = [&](size_t j) { return is_finger_class(skeleton.classes[j]); };
  std::vector<uint8_t> fingers(skeleton.joints.size(), 0), thumbs(skeleton.joints.size(), 0);
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    if (parent < 0 || !is_finger(j) || is_finger(static_cast<size_t>(parent))) continue;
    (skeleton.classes[j] == SINEW_CLASS_THUMB ? thumbs : fingers)[static_cast<size_t>(parent)] = 1;
  }
  for (size_t j = 0; j < skeleton.joints.size(); ++j)
    if (fingers[j] != 0 && thumbs[j] == 0) notes->push_back(skeleton.joints[j].name + ": no thumb found");
}

}  // namespace

std::vector<std::string> predict_details(const Character& character, SkeletonDetail detail, const sinew_model& hands,
                                         const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  std::vector<std::string> notes;
  if (detail == SkeletonDetail::kBody) return notes;
  const bool fingers = std::any_of(skeleton->classes.begin(), skeleton->classes.end(), is_finger_class);
  if (!fingers && predict_hands(character, hands, options, skeleton) == 0)
    notes.push_back("no hand with separate fingers");
  say_thumbs(*skeleton, &notes);
  if (detail != SkeletonDetail::kFull) return notes;
  if (predict_face(character, options, skeleton) == 0) notes.push_back("no head with separate eyes, so no face joints");
  predict_props(character, options, skeleton);
  return notes;
}

size_t predict_hands(const Character& character, const sinew_model& hands, const SkeletonOptions& options,
                     PredictedSkeleton* skeleton) {
  // Names here are longer than there, so only what is put behind them is taken: the hand's own name is left empty.
  SkeletonArrays arrays(character, *skeleton, "fingers", false);
  arrays.grow(character, options, SINEW_DETAIL_HANDS, &hands, skeleton);

  std::set<int> fingered;
  arrays.resize(skeleton);
  for (size_t j = 0; j < arrays.joint_count(); ++j) {
    if (!is_finger_class(arrays.joint_class(j)) || *arrays.name(j) == 0) continue;
    int hand = arrays.parent(j);
    while (is_finger_class(arrays.joint_class(static_cast<size_t>(hand))))
      hand = arrays.parent(static_cast<size_t>(hand));
    fingered.insert(hand);
    arrays.take(j, skeleton->joints[static_cast<size_t>(hand)].name + arrays.name(j), skeleton);
  }
  return fingered.size();
}

namespace {

// Lets the skeleton grow by one detail and returns how many joints there are more that are no bone ends.
size_t add_joints(const Character& character, const SkeletonOptions& options, const char* what, sinew_rig_detail detail,
                  PredictedSkeleton* skeleton) {
  const size_t before = skeleton->joints.size();
  SkeletonArrays arrays(character, *skeleton, what, true);
  arrays.grow(character, options, detail, nullptr, skeleton);
  size_t more = 0;
  arrays.resize(skeleton);
  for (size_t j = before; j < arrays.joint_count(); ++j) {
    arrays.take(j, arrays.name(j), skeleton);
    more += skeleton->ends[j] == 0 ? 1 : 0;
  }
  return more;
}

}  // namespace

size_t predict_face(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  return add_joints(character, options, "faces", SINEW_DETAIL_FACE, skeleton);
}

size_t predict_props(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  return add_joints(character, options, "props", SINEW_DETAIL_PROPS, skeleton);
}

}  // namespace sinew
