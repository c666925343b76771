// SPDX-License-Identifier: MIT
// Retargets clips of one skeleton to another, by sinew/motion.h.
#ifndef SINEW_CHARACTER_RETARGET_HPP
#define SINEW_CHARACTER_RETARGET_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sinew/joint_limits.h"
#include "sinew/motion_clips.h"
#include "sinew/published.h"
#include "sinew/sinew.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// The mesh of a motion's own file, for take_bodies(); none in a .bvh or a file with only a skeleton.
std::optional<Character> body_of_motion(const std::string& path);

// Limbs after copying and after the method; the same number in the same order.
struct ClipReport {
  std::vector<sinew_limb_quality> before, after;
  // [frames x SINEW_MAX_MOTION_LIMBS] after the method; empty without a body
  std::vector<sinew_contact_spot> spots;
};

// sinew_up of the source's and target's worlds.
struct UpAxes {
  uint32_t source = SINEW_UP_AUTO, target = SINEW_UP_AUTO;
};

class Retargeter {
 public:
  //   target   joints of the character; the resulting clips are poses of motion_of(target)
  //   map      [target] joint of the source, or -1
  //   classes  [target] sinew_joint_class
  // Throws Error with `source.name` for input that the engine rejects.
  Retargeter(const Motion& source, const std::vector<Joint>& target, const std::vector<int>& map,
             const std::vector<uint8_t>& classes, const RetargetSettings& settings = {}, UpAxes up = {});

  // Sets the bodies for the calls below. `target` has the target's joints, `source` the motion's first joints and
  // weights; null: the motion has no body. Returns the number of triangles in which the two meshes correspond; 0:
  // only the target's body is used.
  size_t take_bodies(const Character& target, const Character* source);
  // Enables contacts in clips (sinew_retarget_contacts()); needs bodies.
  void keep_contacts();
  // Uses reference points instead of contacts (sinew_retarget_reference_points()): of corresponding meshes if both
  // have one; else of the target's mesh and corresponding points on the source's; else of capsules around both
  // skeletons. Call it after take_bodies(), with the same bodies.
  enum class PointsOf { kOneMesh, kTwoMeshes, kCapsules };
  PointsOf follow_reference_points(const sinew_reference_options& settings, const Character& target,
                                   const Character* source);

  // Uses a stream instead of contacts: each frame depends on past frames only, as for live capture or in a game
  // (sinew/motion_stream.h); the floor is that of the source at rest.
  void play_as_stream();

  // Keeps knees and elbows in their natural range (sinew_retarget_keep_range()); needs bodies.
  void keep_range() { range_ = true; }

  // Clamps joints to limits (sinew_keep_joint_limits()), which take precedence.
  void keep_limits(std::vector<sinew_joint_limit> limits) { limits_ = std::move(limits); }

  // Retargets a clip. `keep_going` is called before each frame; false stops with an Error. With a `report` the clip
  // is measured, which needs bodies.
  Clip run(const Clip& clip, const std::function<bool()>& keep_going = {}, ClipReport* report = nullptr);

 private:
  void check(sinew_status status) const;

  // Converts a body for the engine.
  struct Body {
    std::vector<float> positions;
    std::vector<uint16_t> joints, weights;
    uint32_t slots = 0;
  };
  static Body body_of(const Character& character, const std::vector<uint32_t>& vertices);
  sinew_motion_body view(const Body& body) const;
  bool take_corresponding(const Character& target, const Character& source);
  // Replaces the target's frames of `whole`.
  void stream_clip(const sinew_motion_clip& whole, float fps) const;

  std::string name_;
  size_t source_count_, target_count_;
  std::vector<Joint> source_joints_, target_joints_;
  RetargetSettings settings_;
  UpAxes up_;
  std::vector<uint8_t> classes_;
  std::vector<int> map_;  // [target]
  Workspace memory_;
  sinew_retarget* plan_ = nullptr;  // in memory_
  enum class Method { kCopy, kContacts, kStream, kReferencePoints } method_ = Method::kCopy;
  bool has_source_ = false, range_ = false;
  sinew_reference_options reference_ = {};  // for Method::kReferencePoints
  std::vector<sinew_joint_limit> limits_;
  Body target_body_, source_body_;
  std::vector<uint32_t> triangles_, vertices_;  // vertices of the target
  Workspace workspace_;
};

}  // namespace sinew
#endif
