// SPDX-License-Identifier: MIT
// A bundled skeleton that is posed joint by joint, its limbs by where they reach, and the path of a foot over one cycle.
#ifndef SINEW_CHARACTER_CLIPS_PUPPET_HPP
#define SINEW_CHARACTER_CLIPS_PUPPET_HPP

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew::clips {

Quaternion about_x(double degrees);
Quaternion about_y(double degrees);
Quaternion about_z(double degrees);

class Puppet {
 public:
  // `skeleton` of skeleton_template(), `prefix` of its names that calls leave out, `without` these joints and all below them,
  // `spliced` joints only: their children become children of their parents.
  Puppet(const std::string& skeleton, std::string prefix, const std::vector<std::string>& without,
         const std::vector<std::string>& spliced);

  const Motion& motion() const { return motion_; }
  const MotionFrame& frame() const { return frame_; }
  size_t index(const std::string& joint) const;  // throws Error where there is none
  bool is_left_out(const std::string& joint) const { return left_out_.count(prefix_ + joint) != 0; }
  bool is_end(size_t joint) const { return motion_.joints[joint].end; }
  // The joint on the other side, or the joint itself.
  size_t twin(size_t joint) const { return twins_[joint]; }
  bool is_right(size_t joint) const { return rights_[joint]; }

  void to_rest();
  void move_root(const Point3& shift) { frame_.translations[0] = motion_.joints[0].offset + shift; }
  void turn(size_t joint, const Quaternion& against_parent) { frame_.rotations[joint] = normalized(against_parent); }
  void turn_in_world(size_t joint, const Quaternion& rotation);
  // Relative to the rotation by the joint's parents.
  Quaternion carried(size_t joint) const { return world_rotation(motion_.joints[joint].parent); }
  Point3 rest_position(size_t joint) const { return rest_[joint]; }
  // Bends the limb so that its end is at `target`, the middle joint towards `bend`, where it also points at rest.
  void reach(size_t upper, size_t lower, size_t end, const Point3& target, const Point3& bend);
  // The longest reach since the last call, over the limb's length: above 1 its end fell short.
  double take_stretch();

 private:
  Quaternion world_rotation(int joint) const;
  Point3 world_position(size_t joint) const;

  std::string prefix_;
  Motion motion_;
  MotionFrame frame_;
  std::map<std::string, size_t> index_;
  std::set<std::string> left_out_;
  std::vector<size_t> twins_;
  std::vector<bool> rights_;
  std::vector<Point3> rest_;
  double stretch_ = 0;
};

// Points of a foot at rest, flat on the floor.
struct FootShape {
  Point3 ankle, heel, ball;
};

struct FootPose {
  Point3 ankle;
  double pitch = 0;  // degrees, toes down
  double toes = 0;   // degrees of the toes in the world
};

struct FootPath {
  double stance = 1;  // share of the cycle
  double stride = 0;  // what the body travels in one
  double front = 0;   // where the foot stands, flat, against its position at rest, when the stance begins
  double lift = 0;    // height that the ankle is carried higher than it leaves and lands
  std::function<double(double phase)> pitch;
};

// In the frame that travels with the body. While it stands the foot moves back as fast as that travels, so its pivot stays in place.
FootPose foot_at(const FootPath& path, const FootShape& shape, double phase);

}  // namespace sinew::clips
#endif
