// SPDX-License-Identifier: MIT
#include "sinew_character/plane_motion.hpp"

#include <algorithm>
#include <utility>

#include "picture/plane_bones.hpp"
#include "sinew_character/map_skeleton.hpp"
#include "sinew_formats/box.hpp"

namespace sinew {
namespace {

// Sides that lie on each other in a picture seen from its side are so far from the middle, in shares of the longest side: it tells left from right.
constexpr float kHalfWidth = 0.08f;

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

// As the skeleton that was found says; of another one by what its joints are.
std::vector<uint8_t> classes_of(const PictureCharacter& picture, const Character& body) {
  const std::vector<Joint>&found = picture.rigged.skeleton.joints, &now = body.joints;
  const bool is_found =
      std::equal(found.begin(), found.end(), now.begin(), now.end(),
                 [](const Joint& a, const Joint& b) { return a.name == b.name && a.parent == b.parent; });
  return is_found ? picture.rigged.skeleton.classes : limb_classes(map_rig_of(body), 'y');
}

}  // namespace

void add_picture_motion(const PictureCharacter& picture, bool depth, const AnimateOptions& options,
                        const MotionInput& input, const StepsOf& steps, AnimatedCharacter* out) {
  AnimatedCharacter body;
  body.character = standing_body(picture, out->character);
  body.motion = motion_of(body.character.joints);
  AnimateOptions copied = options;
  copied.up = "y";
  if (copied.method == AnimateMethod::kAuto && !depth)
    copied.method = AnimateMethod::kCopy;  // feet are put on the floor here
  add_motion(copied, input, steps, &body);
  const std::vector<uint8_t> classes = classes_of(picture, body.character);
  for (const Clip& clip : body.motion.clips)
    out->motion.clips.push_back(depth ? clip_with_depth(body.motion, clip, picture.view, out->motion)
                                      : clip_in_plane(body.motion, clip, classes, picture.view, out->motion));
  out->made.insert(out->made.end(), body.made.begin(), body.made.end());
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
