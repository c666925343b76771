// SPDX-License-Identifier: MIT
// Clips relative to a T pose: with T the rotation of a joint from rest to the T pose and W its rotation from the rest
// pose in the world, it is W T^-1 against the T pose.
#include "sinew_character/profile/vrm_clips.hpp"

#include <utility>

#include "predict/turn.hpp"
#include "sinew_character/pose/rest_pose.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

class HumanoidClips {
 public:
  HumanoidClips(const Character& character, const Motion& motion)
      : joints_(character.joints), motion_(motion), bones_(vrm_bones(joints_, character.name)) {
    const Rotation body = body_axes(joints_);
    turn_ = {body[0], body[3], body[6], body[1], body[4], body[7], body[2], body[5], body[8]};
    turn4_ = quaternion_of(turn_);
    RestPose stretched;
    stretched.name = "t";
    const std::vector<Affine> palette = rest_pose_palette(label_skeleton(joints_), stretched, character.up);
    number_.assign(joints_.size(), -1);
    for (const size_t j : JointTree(joints_).parents_first) {
      to_t_.push_back(kNoRotation4);
      if (bones_[j].empty()) continue;
      number_[j] = static_cast<int>(kept_.size());
      kept_.push_back(j);
    }
    for (size_t j = 0; j < joints_.size(); ++j) {
      to_t_[j] = quaternion_of(rotation_part(palette[j]));
      const Point3 p = point(joints_[j].position);
      positions_.push_back(turned(turn_, transform_point(palette[j], p[0], p[1], p[2])));
    }
  }

  Motion run() const {
    Motion out;
    out.name = motion_.name;
    for (const size_t j : kept_) {
      const int above = bone_above(j);
      const Point3 from = above < 0 ? Point3{} : positions_[kept_[static_cast<size_t>(above)]];
      out.joints.push_back({bones_[j], above, positions_[j] - from});
    }
    for (const Clip& clip : motion_.clips) {
      Clip made = {clip.name, clip.frame_time, {}};
      for (const MotionFrame& frame : clip.frames) made.frames.push_back(frame_of(frame, out));
      out.clips.push_back(std::move(made));
    }
    return out;
  }

 private:
  // The next bone above, by its number.
  int bone_above(size_t joint) const {
    for (int up = joints_[joint].parent; up >= 0; up = joints_[joint_index(up)].parent)
      if (number_[joint_index(up)] >= 0) return number_[joint_index(up)];
    return -1;
  }

  MotionFrame frame_of(const MotionFrame& frame, const Motion& humanoid) const {
    const WorldPose pose = world_pose(motion_, frame);
    std::vector<Quaternion> worlds;
    MotionFrame out;
    for (size_t k = 0; k < kept_.size(); ++k) {
      const size_t j = kept_[k];
      const Quaternion against_t = multiply(pose.rotations[j], conjugate(to_t_[j]));
      worlds.push_back(normalized(multiply(multiply(turn4_, against_t), conjugate(turn4_))));
      const int above = humanoid.joints[k].parent;
      out.rotations.push_back(
          above < 0 ? worlds[k] : normalized(multiply(conjugate(worlds[static_cast<size_t>(above)]), worlds[k])));
      out.translations.push_back(above < 0 ? turned(turn_, pose.positions[j]) : humanoid.joints[k].offset);
    }
    return out;
  }

  const std::vector<Joint>& joints_;
  const Motion& motion_;
  const std::vector<std::string> bones_;  // [J] "" for none
  Rotation turn_ = kNoRotation;           // of the whole body: upright and to the front
  Quaternion turn4_ = kNoRotation4;
  std::vector<Quaternion> to_t_;   // [J]
  std::vector<Point3> positions_;  // [J] in the T pose, rotated
  std::vector<int> number_;        // [J] of the bone, or -1
  std::vector<size_t> kept_;       // [bones] parents first
};

}  // namespace

Motion humanoid_motion(const Character& character, const Motion& motion) {
  return HumanoidClips(character, motion).run();
}

void write_clips(const std::string& path, const Character& character, const Motion& motion) {
  if (has_extension(path, ".vrma")) return write_vrm_animation(path, humanoid_motion(character, motion));
  if (motion.clips.size() != 1)
    throw Error(path + ": a BVH holds one clip, found " + std::to_string(motion.clips.size()) + "; write a .glb");
  write_bvh(path, motion, motion.clips[0]);
}

}  // namespace sinew
