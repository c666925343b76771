// SPDX-License-Identifier: MIT
// What clips are made with: a puppet of a bundled skeleton, the path of a foot, and the clips of each kind of body.
#ifndef SINEW_CHARACTER_CLIPS_PUPPET_HPP
#define SINEW_CHARACTER_CLIPS_PUPPET_HPP

#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew::clips {

// A bundled skeleton that code poses joint by joint, limbs by where they reach: what the clips that ship are made with.

constexpr double kFps = 30;

double radians(double degrees);
// About x, y and z, in degrees.
Quaternion about_x(double degrees);
Quaternion about_y(double degrees);
Quaternion about_z(double degrees);
// Of a turn of 2 pi; `turns` from 0 to 1.
double wave(double turns);

// A smooth curve through keys that repeats after 1 and never leaves the range of two neighbours (Fritsch, Carlson 1980): equal
// neighbours are a level.
struct Key {
  double phase, value;  // phase rises from 0, below 1
};
double curve(std::initializer_list<Key> keys, double phase);

// A bone of a limb, the next one and where they reach, by name.
struct Limb {
  std::string upper, lower, end;
  Point3 bend = {};  // where the middle joint points at rest: forward for knees
};

class Puppet {
 public:
  // `skeleton` of skeleton_template(), `prefix` of its names that calls leave out.
  explicit Puppet(const std::string& skeleton, std::string prefix = "");

  const Motion& motion() const { return motion_; }
  const MotionFrame& frame() const { return frame_; }

  void to_rest();
  // The root's position against that at rest, and its rotation.
  void place(const Point3& shift, const Quaternion& rotation = kNoRotation4);
  void turn(const std::string& joint, const Quaternion& against_parent);
  void turn_in_world(const std::string& joint, const Quaternion& rotation);
  Point3 position(const std::string& joint) const;
  Point3 rest_position(const std::string& joint) const;
  // Bends the limb so that its end is at `target`, the middle joint towards `bend`.
  void reach(const Limb& limb, const Point3& target, const Point3& bend);
  // The longest reach since the last call, over the limb's length: above 1 its end fell short.
  double take_stretch();

 private:
  size_t index(const std::string& joint) const;
  Quaternion world_rotation(int joint) const;
  Point3 world_position(size_t joint) const;

  std::string prefix_;
  Motion motion_;
  MotionFrame frame_;
  std::map<std::string, size_t> index_;
  std::vector<Joint> rest_;
  double stretch_ = 0;
};

// Frames of a cycle: `pose` poses the puppet at a phase from 0 up to 1, which is 0 again but for `travel` of the root. Where a limb
// falls short, the root is lowered by as much as it takes, which `pose` is told.
template <class Pose>
Clip cycle(Puppet* puppet, const std::string& name, size_t frames, const Point3& travel, const Pose& pose) {
  constexpr double kReach = 0.9985, kLower = 0.004, kLowest = 0.4;
  for (double drop = 0;; drop += kLower) {
    Clip clip = {name, 1 / kFps, {}};
    puppet->take_stretch();
    for (size_t f = 0; f <= frames; ++f) {
      puppet->to_rest();
      pose(static_cast<double>(f % frames) / static_cast<double>(frames), drop);
      MotionFrame frame = puppet->frame();
      frame.translations[0] = frame.translations[0] + (static_cast<double>(f) / static_cast<double>(frames)) * travel;
      clip.frames.push_back(std::move(frame));
    }
    if (puppet->take_stretch() <= kReach || drop > kLowest) return clip;
  }
}

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
  double stance = 0.6;  // share of the cycle
  double stride = 1;    // what the body travels in one
  double front = 0;     // where the foot stands, flat, against its position at rest, when the stance begins
  double lift = 0;      // height that the ankle is carried higher than it leaves and lands
  std::function<double(double phase)> pitch;
};

// In the frame that travels with the body. While it stands the foot moves back as fast as that travels, so its pivot stays in place.
FootPose foot_at(const FootPath& path, const FootShape& shape, double phase);

// All clips of one kind of body, made when they are asked for.
Motion person_clips();     // walk, run, idle, wave, jump, sit, squat, reach
Motion quadruped_clips();  // walk, trot, idle
Motion bird_clips();       // flap
Motion fish_clips();       // swim
Motion spider_clips();     // crawl

}  // namespace sinew::clips
#endif
