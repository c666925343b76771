// SPDX-License-Identifier: MIT
// Clips of one skeleton for another, by the engine (sinew/motion.h).
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

// The mesh of a motion's own file, which take_bodies() compares with; none in a .bvh or a file with a skeleton alone.
std::optional<Character> body_of_motion(const std::string& path);

// Limbs as they were copied, and as the method left them; as many of both, in one order.
struct ClipReport {
  std::vector<sinew_limb_quality> before, after;
  // [frames x SINEW_MAX_MOTION_LIMBS] of what the method left; empty without a body
  std::vector<sinew_contact_spot> spots;
};

// sinew_up of the source's and the target's world.
struct UpAxes {
  uint32_t source = SINEW_UP_AUTO, target = SINEW_UP_AUTO;
};

class Retargeter {
 public:
  //   target   joints of the character; clips made are poses of motion_of(target)
  //   map      [target] joint of the source, or -1
  //   classes  [target] sinew_joint_class
  // Throws Error naming `source.name` for what the engine refuses.
  Retargeter(const Motion& source, const std::vector<Joint>& target, const std::vector<int>& map,
             const std::vector<uint8_t>& classes, const RetargetSettings& settings = {}, UpAxes up = {});

  // Bodies for what follows. `target` has the target's joints, `source` the motion's first ones and weights; null: the motion has
  // no body. Returns how many triangles of skin the two share as one mesh in two shapes; 0: the target's own body is looked at
  // alone.
  size_t take_bodies(const Character& target, const Character* source);
  // From now on clips keep their contacts (sinew_retarget_contacts()), for which bodies are there.
  void keep_contacts();
  // In place of contacts, arms go where reference points want them (sinew_retarget_reference_points()): those of the body of one
  // mesh that both have; else of the target's mesh and what corresponds to it on the source's, which is then the motion's body; else of
  // capsules round both skeletons. After take_bodies(), with the same two.
  enum class PointsOf { kOneMesh, kTwoMeshes, kCapsules };
  PointsOf follow_reference_points(const sinew_reference_options& settings, const Character& target,
                                   const Character* source);

  // In place of contacts, every frame is made of those before it alone, as it would be of a capture or in a game
  // (sinew/motion_stream.h): the floor is where the source's is at rest.
  void play_as_stream();

  // From now on knees and elbows stay in their natural range (sinew_retarget_keep_range()), for which bodies are there.
  void keep_range() { range_ = true; }

  // From now on joints stay within limits (sinew_keep_joint_limits()), which have the last word.
  void keep_limits(std::vector<sinew_joint_limit> limits) { limits_ = std::move(limits); }

  // Before each frame `keep_going` is asked; false ends with an Error that says so. With a `report` the clip is measured, for
  // which bodies are there.
  Clip run(const Clip& clip, const std::function<bool()>& keep_going = {}, ClipReport* report = nullptr);

 private:
  void check(sinew_status status) const;

  // A body for the engine.
  struct Body {
    std::vector<float> positions;
    std::vector<uint16_t> joints, weights;
    uint32_t slots = 0;
  };
  static Body body_of(const Character& character, const std::vector<uint32_t>& vertices);
  sinew_motion_body view(const Body& body) const;
  bool take_corresponding(const Character& target, const Character& source);
  // In place of `whole`'s frames of the target.
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
  sinew_reference_options reference_ = {};  // of Method::kReferencePoints
  std::vector<sinew_joint_limit> limits_;
  Body target_body_, source_body_;
  std::vector<uint32_t> triangles_, vertices_;  // vertices of the target
  Workspace workspace_;
};

}  // namespace sinew
#endif
