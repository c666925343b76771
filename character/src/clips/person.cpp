// SPDX-License-Identifier: MIT
// Clips of a person: cycles of legs that stand where they stand, arms against them, a trunk that carries the head level.
#include "clips/puppet.hpp"

namespace sinew::clips {
namespace {

const Point3 kForward = {0, 0, 1};

struct Arm {
  double swing = 0;  // degrees forward
  double out = 9;    // from the body
  double roll = 0;   // of the upper arm about itself, hand upwards
  double elbow = 18;
};

class Person {
 public:
  Person() : puppet_("mixamo", "mixamorig:") {
    for (const int side : {0, 1}) {
      FootShape& foot = feet_[side];
      foot.ankle = puppet_.rest_position(name(side, "Foot"));
      foot.ball = puppet_.rest_position(name(side, "ToeBase"));
      foot.heel = {foot.ankle[0], 0.01, foot.ankle[2] - 0.05};
    }
  }
  Puppet* puppet() { return &puppet_; }
  const FootShape& foot(int side) const { return feet_[side]; }

  static std::string name(int side, const char* joint) { return (side == 0 ? "Left" : "Right") + std::string(joint); }

  void hips(const Point3& shift, double yaw, double list, double pitch = 0) {
    puppet_.place(shift, multiply(about_y(yaw), multiply(about_z(list), about_x(pitch))));
  }
  // Degrees forward, to the left, and sideways, shared by three joints; the head looks along `look` whatever the chest does.
  void trunk(double pitch, double yaw, double list, double look_yaw = 0, double look_pitch = 0) {
    const Quaternion third = multiply(about_y(yaw / 3), multiply(about_z(list / 3), about_x(pitch / 3)));
    for (const char* joint : {"Spine", "Spine1", "Spine2"}) puppet_.turn(joint, third);
    const Quaternion gaze = multiply(about_y(look_yaw), about_x(look_pitch));
    puppet_.turn_in_world("Neck", slerp(multiply(about_y(yaw / 2), about_x(pitch / 2)), gaze, 0.5));
    puppet_.turn_in_world("Head", gaze);
  }
  void arm(int side, const Arm& a) {
    const double s = side == 0 ? 1 : -1;
    puppet_.turn(name(side, "Arm"),
                 multiply(about_x(-a.swing), multiply(about_z(-s * (90 - a.out)), about_x(-a.roll))));
    puppet_.turn(name(side, "ForeArm"), about_y(-s * a.elbow));
    for (const char* finger : {"Index", "Middle", "Ring", "Pinky"})
      for (const char* part : {"1", "2", "3"})
        puppet_.turn(name(side, ("Hand" + std::string(finger) + part).c_str()), about_z(-s * 14));
  }
  // Ankle and rolls, in the frame of the frame at hand.
  void leg(int side, const FootPose& pose, double knee_out = 0.08) {
    const double s = side == 0 ? 1 : -1;
    const Limb limb = {name(side, "UpLeg"), name(side, "Leg"), name(side, "Foot"), kForward};
    puppet_.reach(limb, pose.ankle, Point3{s * knee_out, 0, 1});
    puppet_.turn_in_world(name(side, "Foot"), about_x(pose.pitch));
    puppet_.turn_in_world(name(side, "ToeBase"), about_x(pose.toes));
  }
  // Flat where it stands at rest, so far apart and ahead, rolled onto the ball by `pitch` degrees.
  void stand(int side, double ahead = 0, double pitch = 0) {
    FootPose pose;
    const FootShape& shape = feet_[side];
    pose.pitch = pitch;
    pose.ankle = shape.ball + rotate(about_x(pitch), shape.ankle - shape.ball) + Point3{0, 0, ahead};
    leg(side, pose);
  }

 private:
  Puppet puppet_;
  FootShape feet_[2];
};

double phase_of(double phase, int side) { return side == 0 ? phase : phase < 0.5 ? phase + 0.5 : phase - 0.5; }

Clip walk(Person* p) {
  FootPath path;
  path.stance = 0.62;
  path.stride = 1.24;
  path.front = 0.33;
  path.lift = 0.055;
  path.pitch = [](double t) {
    return curve({{0, -20}, {0.09, 0}, {0.36, 0}, {0.62, 46}, {0.72, 40}, {0.88, -8}, {0.96, -20}}, t);
  };
  return cycle(p->puppet(), "walk", 32, {0, 0, path.stride}, [&](double t, double drop) {
    const double swing = -wave(t + 0.25 - 0.03);  // the left leg is ahead at 0, so its arm is behind
    p->hips({0.022 * wave(t - 0.06), -0.012 - drop - 0.018 * wave(2 * t + 0.25 - 0.1), 0}, 6 * swing,
            2.5 * wave(t - 0.05));
    p->trunk(3, -13 * swing, -3 * wave(t - 0.05), 0, 2);
    for (const int side : {0, 1}) {
      const double s = side == 0 ? 1 : -1;
      p->arm(side, {4 + 22 * s * swing, 8, 0, 24 + 12 * s * swing});
      p->leg(side, foot_at(path, p->foot(side), phase_of(t, side)));
    }
  });
}

Clip run(Person* p) {
  FootPath path;
  path.stance = 0.34;
  path.stride = 2.1;
  path.front = 0.27;
  path.lift = 0.22;
  path.pitch = [](double t) {
    return curve({{0, -6}, {0.05, 0}, {0.15, 0}, {0.34, 52}, {0.5, 84}, {0.66, 62}, {0.86, -4}, {0.94, -8}}, t);
  };
  return cycle(p->puppet(), "run", 21, {0, 0, path.stride}, [&](double t, double drop) {
    const double swing = -wave(t + 0.25 - 0.04);
    p->hips({0.01 * wave(t - 0.06), -0.04 - drop - 0.038 * wave(2 * t - 0.09), 0}, 9 * swing, 3 * wave(t - 0.05), 6);
    p->trunk(9, -22 * swing, -3 * wave(t - 0.05), 0, 4);
    for (const int side : {0, 1}) {
      const double s = side == 0 ? 1 : -1;
      p->arm(side, {-6 + 42 * s * swing, 12, 0, 88 + 16 * s * swing});
      p->leg(side, foot_at(path, p->foot(side), phase_of(t, side)));
    }
  });
}

// Weight from one leg to the other, breath; arms as `right` wants them where it is given.
void idle_pose(Person* p, double t, double drop, const Arm* right) {
  const double sway = wave(t), breath = wave(2 * t);
  p->hips({0.022 * sway, -0.008 - drop - 0.004 * wave(2 * t + 0.25), 0.004 * wave(t + 0.3)}, 2 * wave(t + 0.1),
          1.4 * sway);
  p->trunk(1.5 + 1.2 * breath, -2 * wave(t + 0.1), -1.6 * sway, 7 * wave(t + 0.4), 2 + wave(2 * t + 0.2));
  for (const int side : {0, 1}) {
    const Arm hanging = {3 + 1.5 * wave(t + 0.2 + 0.1 * side), 9 + 1.2 * breath, 0, 16 + 2 * breath};
    p->arm(side, side == 1 && right != nullptr ? *right : hanging);
    p->stand(side);
  }
}

Clip idle(Person* p) {
  return cycle(p->puppet(), "idle", 120, {}, [&](double t, double drop) { idle_pose(p, t, drop, nullptr); });
}

Clip wave_hand(Person* p) {
  return cycle(p->puppet(), "wave", 75, {}, [&](double t, double drop) {
    const double up = curve({{0, 0}, {0.04, 0}, {0.26, 1}, {0.74, 1}, {0.96, 0}}, t);
    const double side_to_side = t > 0.26 && t < 0.74 ? wave(3 * (t - 0.26) / 0.48) : 0;
    const Arm right = {3 + 12 * up, 9 + 72 * up, 80 * up, 16 + 68 * up + 22 * side_to_side};
    idle_pose(p, t, drop, &right);
  });
}

Clip jump(Person* p) {
  constexpr double kFrames = 48, kLeave = 17 / kFrames, kLand = 33 / kFrames, kGravity = 9.81;
  return cycle(p->puppet(), "jump", static_cast<size_t>(kFrames), {}, [&](double t, double drop) {
    const bool flies = t > kLeave && t < kLand;
    const double since = (t - kLeave) * kFrames / kFps, left = (kLand - t) * kFrames / kFps;
    const double height = flies ? kGravity / 2 * since * left : 0;
    const double crouch =
        curve({{0, 0}, {0.05, 0}, {0.24, 0.3}, {kLeave, -0.05}, {kLand, -0.03}, {0.8, 0.22}, {0.97, 0}}, t);
    const double tiptoe = curve({{0, 0}, {0.24, 0}, {kLeave, 50}, {0.5, 38}, {kLand, 26}, {kLand + 0.05, 0}}, t);
    const double lean =
        curve({{0, 1}, {0.05, 1}, {0.24, 38}, {kLeave, 2}, {0.5, 4}, {kLand, 8}, {0.8, 30}, {0.97, 1}}, t);
    p->hips({0, height - crouch - drop, -0.28 * (crouch > 0 ? crouch : 0)}, 0, 0, 0.4 * lean);
    p->trunk(0.6 * lean, 0, 0, 0, 0.25 * lean);
    const double swing =
        curve({{0, 3}, {0.05, 3}, {0.22, -48}, {kLeave, 140}, {0.5, 118}, {kLand, 70}, {0.82, 8}, {0.97, 3}}, t);
    const double tuck = flies ? 0.1 * wave((t - kLeave) / (kLand - kLeave) / 2) : 0;
    for (const int side : {0, 1}) {
      p->arm(side, {swing, 12, 0, 18 + 0.12 * (swing > 0 ? swing : 0)});
      FootPose pose;
      const FootShape& shape = p->foot(side);
      pose.pitch = tiptoe;
      pose.ankle =
          shape.ball + rotate(about_x(tiptoe), shape.ankle - shape.ball) + Point3{0, height + tuck, -0.4 * tuck};
      pose.toes = flies ? 0.5 * tiptoe : 0;
      p->leg(side, pose);
    }
  });
}

Clip sit(Person* p) {
  return cycle(p->puppet(), "sit", 135, {}, [&](double t, double drop) {
    const double down = curve({{0, 0}, {0.06, 0}, {0.3, 1}, {0.7, 1}, {0.94, 0}}, t);
    const double lean = curve({{0, 0}, {0.06, 0}, {0.2, 42}, {0.33, 4}, {0.67, 4}, {0.8, 44}, {0.94, 0}}, t);
    const double breath = wave(3 * t), bow = wave(down / 4);  // back first, then down
    p->hips({0, -drop - 0.43 * down + 0.003 * breath, -0.4 * bow}, 0, 0, 0.35 * lean);
    p->trunk(1.5 + 0.65 * lean + breath, 0, 0, 0, 2 + 0.25 * lean);
    for (const int side : {0, 1}) {
      p->arm(side, {3 + 32 * down + 0.35 * lean, 9 - 2 * down, 0, 16 + 36 * down});
      p->stand(side);
    }
  });
}

// The two ends of what weights must bear: deep knees and hips with the arms ahead, arms above the head.
Clip squat(Person* p) {
  return cycle(p->puppet(), "squat", 90, {}, [&](double t, double drop) {
    const double down = curve({{0, 0}, {0.04, 0}, {0.4, 1}, {0.6, 1}, {0.96, 0}}, t);
    p->hips({0, -drop - 0.5 * down, -0.24 * down}, 0, 0);
    p->trunk(30 * down, 0, 0, 0, 15 * down);
    for (const int side : {0, 1}) {
      p->arm(side, {3 + 87 * down, 9 - 3 * down, 0, 16});
      p->stand(side);
    }
  });
}

Clip reach(Person* p) {
  return cycle(p->puppet(), "reach", 90, {}, [&](double t, double drop) {
    const double up = curve({{0, 0}, {0.04, 0}, {0.4, 1}, {0.6, 1}, {0.96, 0}}, t);
    p->hips({0, -0.008 - drop, 0}, 0, 0);
    p->trunk(-6 * up, 0, 0, 0, -10 * up);
    for (const int side : {0, 1}) {
      p->arm(side, {3 - 3 * up, 9 + 151 * up, 0, 16 - 12 * up});
      p->stand(side);
    }
  });
}

}  // namespace

Motion person_clips() {
  Person person;
  Motion motion = person.puppet()->motion();
  motion.clips = {walk(&person), run(&person), idle(&person),  wave_hand(&person),
                  jump(&person), sit(&person), squat(&person), reach(&person)};
  return motion;
}

}  // namespace sinew::clips
