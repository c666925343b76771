// SPDX-License-Identifier: MIT
// Clips of one skeleton for another, by the engine (sinew/motion.h).
#ifndef SINEW_FORMATS_RETARGET_HPP
#define SINEW_FORMATS_RETARGET_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sinew/sinew.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// The mesh of a motion's own file, which keep_contacts() compares with; none in a .bvh or a file with a skeleton alone.
std::optional<Character> body_of_motion(const std::string& path);

class Retargeter {
 public:
  //   target   joints of the character; clips made are poses of motion_of(target)
  //   map      [target] joint of the source, or -1
  //   classes  [target] sinew_joint_class
  // Throws Error naming `source.name` for what the engine refuses.
  Retargeter(const Motion& source, const std::vector<Joint>& target, const std::vector<int>& map,
             const std::vector<uint8_t>& classes, const RetargetSettings& settings = {});

  // From now on clips keep their contacts (sinew_retarget_contacts()): feet stay where they stand, and where the two bodies
  // are one mesh in two shapes, hands that touch go on touching and stay outside. `target` has the target's joints, `source`
  // the motion's first ones and weights; null: the motion has no body. Returns how many triangles the two bodies share, 0:
  // feet alone.
  size_t keep_contacts(const Character& target, const Character* source);

  // Before each frame `keep_going` is asked; false ends with an Error that says so.
  Clip run(const Clip& clip, const std::function<bool()>& keep_going = {});

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

  std::string name_;
  size_t source_count_, target_count_;
  std::vector<uint8_t> classes_;
  RetargetPlan plan_;
  bool contacts_ = false, has_source_ = false;
  Body target_body_, source_body_;
  std::vector<uint32_t> triangles_;
  Workspace workspace_;
};

}  // namespace sinew
#endif
