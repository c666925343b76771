// SPDX-License-Identifier: MIT
// Views of motions for the engine, frame by frame.
#include "sinew_formats/retarget.hpp"

#include "motion/turns.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// A skeleton as arrays.
struct RigArrays {
  std::vector<float> positions;
  std::vector<int32_t> parents;

  explicit RigArrays(const std::vector<Joint>& joints) {
    for (const Joint& joint : joints) {
      positions.insert(positions.end(), {joint.position.x, joint.position.y, joint.position.z});
      parents.push_back(joint.parent);
    }
  }
  sinew_motion_rig view() const {
    return {positions.data(), parents.data(), nullptr, static_cast<uint32_t>(parents.size())};
  }
};

struct FrameArrays {
  std::vector<float> rotations, translations;

  explicit FrameArrays(size_t joints) : rotations(4 * joints), translations(3 * joints) {}
  void take(const MotionFrame& frame) {
    for (size_t j = 0; j < frame.rotations.size(); ++j) {
      for (size_t i = 0; i < 4; ++i) rotations[4 * j + i] = static_cast<float>(frame.rotations[j][i]);
      for (size_t i = 0; i < 3; ++i) translations[3 * j + i] = static_cast<float>(frame.translations[j][i]);
    }
  }
  MotionFrame frame() const {
    MotionFrame out;
    for (size_t j = 0; j < translations.size() / 3; ++j) {
      Quaternion q{};
      Point3 p{};
      for (size_t i = 0; i < 4; ++i) q[i] = static_cast<double>(rotations[4 * j + i]);
      for (size_t i = 0; i < 3; ++i) p[i] = static_cast<double>(translations[3 * j + i]);
      out.rotations.push_back(normalised(q));
      out.translations.push_back(p);
    }
    return out;
  }
};

}  // namespace

void Retargeter::check(sinew_status status) const {
  if (status != SINEW_OK) throw Error(name_ + ": cannot retarget the motion: " + sinew_status_text(status));
}

Retargeter::Retargeter(const Motion& source, const std::vector<Joint>& target, const std::vector<int>& map,
                       const std::vector<uint8_t>& classes, const RetargetSettings& settings)
    : name_(source.name), source_count_(source.joints.size()), target_count_(target.size()) {
  const RigArrays from(rest_joints(source)), to(target);
  check(plan_.make(from.view(), to.view(), map.data(), classes.data(), settings));
}

Clip Retargeter::run(const Clip& clip, const std::function<bool()>& keep_going) {
  FrameArrays from(source_count_), to(target_count_);
  std::vector<float> heights;
  for (const MotionFrame& frame : clip.frames) {
    from.take(frame);
    heights.push_back(0);
    check(plan_.height(from.rotations.data(), from.translations.data(), &heights.back()));
  }
  float ground = 0;
  check(plan_.ground(heights.data(), heights.size(), &ground));
  Clip out = {clip.name, clip.frame_time, {}};
  for (const MotionFrame& frame : clip.frames) {
    if (keep_going && !keep_going()) throw Error(name_ + ": cannot go on, the work was interrupted");
    from.take(frame);
    check(plan_.frame(from.rotations.data(), from.translations.data(), ground, to.rotations.data(),
                      to.translations.data()));
    out.frames.push_back(to.frame());
  }
  return out;
}

}  // namespace sinew
