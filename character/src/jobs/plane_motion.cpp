// SPDX-License-Identifier: MIT
// Pairs of joints by what they are, and a clip played in the picture's plane.
#include "sinew_character/jobs/plane_motion.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

bool is_pinned(uint8_t joint_class) {
  switch (joint_class) {
    case SINEW_CLASS_PELVIS:
    case SINEW_CLASS_HEAD:
    case SINEW_CLASS_UPPER_ARM:
    case SINEW_CLASS_FOREARM:
    case SINEW_CLASS_HAND:
    case SINEW_CLASS_THIGH:
    case SINEW_CLASS_CALF:
    case SINEW_CLASS_FOOT:
    case SINEW_CLASS_WING:
      return true;
    default:
      return false;
  }
}

using Group = std::pair<uint8_t, int>;  // class and side

std::map<Group, std::vector<size_t>> groups_of(const LabeledSkeleton& skeleton) {
  std::map<Group, std::vector<size_t>> groups;
  for (size_t j = 0; j < skeleton.joints.size(); ++j)
    if (skeleton.ends[j] == 0 && is_pinned(skeleton.classes[j]))
      groups[{skeleton.classes[j], static_cast<int>(side_of_name(skeleton.joints[j].name))}].push_back(j);
  return groups;
}

}  // namespace

std::vector<sinew_map_pin> pins_by_class(const LabeledSkeleton& target, const LabeledSkeleton& source) {
  std::vector<sinew_map_pin> pins;
  const auto sources = groups_of(source);
  for (const auto& [group, joints] : groups_of(target)) {
    const auto found = sources.find(group);
    if (found == sources.end()) continue;
    for (size_t k = 0; k < std::min(joints.size(), found->second.size()); ++k)
      pins.push_back({static_cast<uint32_t>(joints[k]), static_cast<int32_t>(found->second[k])});
  }
  return pins;
}

namespace {

// Sides that lie on each other in a picture seen from its side are so far from the middle, in shares of the longest side: it tells left from right.
constexpr float kHalfWidth = 0.08f;
// A map that covers as much of the least of legs, arms and trunk needs no help.
constexpr float kMostCover = 0.75f;

// The character with its joints and mesh facing +z, sides apart.
Character standing_body(const PictureCharacter& picture, const Character& character) {
  Character out = character;
  const float apart = kHalfWidth * box_of(character.vertices).longest_side();
  for (Vec3& v : out.vertices) v = from_picture(picture.view, v);
  for (Joint& joint : out.joints) {
    joint.position = from_picture(picture.view, joint.position);
    if (picture.view == PictureView::kFront) {
      joint.position.z = 0;
      continue;
    }
    joint.position.x = joint.name.rfind("Left", 0) == 0 ? apart : joint.name.rfind("Right", 0) == 0 ? -apart : 0;
  }
  return out;
}

bool has_found_skeleton(const PictureCharacter& picture, const Character& body) {
  const std::vector<Joint>&found = picture.rigged.skeleton.joints, &now = body.joints;
  return std::equal(found.begin(), found.end(), now.begin(), now.end(),
                    [](const Joint& a, const Joint& b) { return a.name == b.name && a.parent == b.parent; });
}

// As the skeleton that was found says; of another one by what its joints are.
std::vector<uint8_t> classes_of(const PictureCharacter& picture, const Character& body) {
  return has_found_skeleton(picture, body) ? picture.rigged.skeleton.classes : limb_classes(map_rig_of(body), Axis::kY);
}

// By anatomy; where a quarter more joints move if those that votes know are taken at their word, by them.
AnimatedCharacter moved(const PictureCharacter& picture, const Character& character, const AnimateOptions& options,
                        const MotionInput& input, const StepsOf& steps) {
  const auto with = [&](const AnimateOptions& how) {
    AnimatedCharacter body;
    body.character = standing_body(picture, character);
    body.motion = motion_of(body.character.joints);
    add_motion(how, input, steps, &body);
    return body;
  };
  const bool free = options.map.empty() && options.sources.empty() && options.pins.empty();
  if (!free || options.map_as_drawn || !picture.rigged.skeleton.usable || !has_found_skeleton(picture, character))
    return with(options);
  AnimateOptions tried = options;
  tried.force = true;
  AnimatedCharacter best = with(tried);
  tried.pins = pins_by_class(label_skeleton(picture.rigged.skeleton), label_skeleton(rest_joints(*input.motion)));
  bool by_class = false;
  if (best.map.cover.share < kMostCover && !tried.pins.empty()) {
    AnimatedCharacter other = with(tried);
    by_class = 4 * moved_joints(other.map) >= 5 * moved_joints(best.map);
    if (by_class) best = std::move(other);
  }
  if (options.force || by_class || best.map.cover.share >= kLeastCover) return best;
  return with(options);  // says why not
}

}  // namespace

void add_picture_motion(const PictureCharacter& picture, bool depth, const AnimateOptions& options,
                        const MotionInput& input, const StepsOf& steps, AnimatedCharacter* out) {
  AnimateOptions copied = options;
  copied.up = Axis::kY;
  if (copied.method == AnimateMethod::kAuto && !depth)
    copied.method = AnimateMethod::kCopy;  // feet are put on the floor here
  AnimatedCharacter body = moved(picture, out->character, copied, input, steps);
  const std::vector<uint8_t> classes = classes_of(picture, body.character);
  for (const Clip& clip : body.motion.clips)
    out->motion.clips.push_back(depth ? clip_with_depth(body.motion, clip, picture.view, out->motion)
                                      : clip_in_plane(body.motion, clip, classes, picture.view, out->motion));
  out->animated_clips.insert(out->animated_clips.end(), body.animated_clips.begin(), body.animated_clips.end());
  for (std::string& note : body.motion.notes) out->motion.notes.push_back(std::move(note));
  out->map = body.map;
  out->certainty = body.certainty;
}

const char* default_clip(BodyClass body) {
  switch (body) {
    case BodyClass::kBiped:
      return "builtin:person/wave";
    case BodyClass::kQuadruped:
      return "builtin:quadruped/trot";
    case BodyClass::kBird:
      return "builtin:bird/flap";
    case BodyClass::kManyLegged:
      return "builtin:spider/crawl";
    default:
      return "builtin:fish/swim";
  }
}

}  // namespace sinew
