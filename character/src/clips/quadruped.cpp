// SPDX-License-Identifier: MIT
// Clips of a quadruped: every leg has its own phase of one cycle; hind legs carry a metatarsus between hock and toes.
#include "clips/puppet.hpp"

namespace sinew::clips {
namespace {

std::string left_or_right(const char* joint, int side) { return std::string(joint) + (side == 0 ? ".L" : ".R"); }

class Quadruped {
 public:
  Quadruped() : puppet_("quadruped") {
    for (const int side : {0, 1}) {
      front_[side] = shape_of(left_or_right("FrontFoot", side));
      back_[side] = shape_of(left_or_right("BackToe", side));
    }
  }
  Puppet* puppet() { return &puppet_; }
  const FootShape& front(int side) const { return front_[side]; }
  const FootShape& back(int side) const { return back_[side]; }

  void front_leg(int side, const FootPose& pose, double shoulder) {
    puppet_.turn(left_or_right("FrontShoulder", side), about_x(-shoulder));
    const Limb limb = {left_or_right("FrontUpperLeg", side),
                       left_or_right("FrontLowerLeg", side),
                       left_or_right("FrontFoot", side),
                       {0, 0, -1}};
    puppet_.reach(limb, pose.ankle, {0, 0, -1});
    puppet_.turn_in_world(limb.end, about_x(pose.pitch));
  }
  // `metatarsus`: degrees that the bone from hock to toes leans forward.
  void hind_leg(int side, const FootPose& pose, double metatarsus) {
    const std::string hock = left_or_right("BackFoot", side), toe = left_or_right("BackToe", side);
    const Limb limb = {left_or_right("BackUpperLeg", side), left_or_right("BackLowerLeg", side), hock, {0, 0, 1}};
    const Point3 bone = puppet_.rest_position(hock) - puppet_.rest_position(toe);
    puppet_.reach(limb, pose.ankle + rotate(about_x(metatarsus), bone), {0, 0, 1});
    puppet_.turn_in_world(hock, about_x(metatarsus));
    puppet_.turn_in_world(toe, about_x(pose.pitch));
  }
  // Degrees of the trunk: sideways from hips to chest, bow of the back; of neck, head and tail.
  void trunk(double yaw, double bow, double neck, double head, double look, double tail) {
    for (const char* joint : {"Spine1", "Spine2", "Spine3"})
      puppet_.turn(joint, multiply(about_y(yaw / 3), about_x(bow / 3)));
    for (const char* joint : {"Neck1", "Neck2"}) puppet_.turn(joint, multiply(about_y(look / 3), about_x(neck / 2)));
    puppet_.turn("Head", multiply(about_y(look / 3 - yaw / 2), about_x(head)));
    for (const char* joint : {"Tail1", "Tail2", "Tail3", "Tail4"}) puppet_.turn(joint, about_y(tail / 4));
  }
  void ears(double left, double right) {
    puppet_.turn("Ear.L", about_x(left));
    puppet_.turn("Ear.R", about_x(right));
  }

 private:
  FootShape shape_of(const std::string& joint) const {
    const Point3 ankle = puppet_.rest_position(joint);
    return {ankle, {ankle[0], 0.01, ankle[2] - 0.03}, puppet_.rest_position(joint + "_end")};
  }

  Puppet puppet_;
  FootShape front_[2], back_[2];
};

struct Gait {
  FootPath front, back;
  double hind_phase[2], front_phase[2];  // left, right
  double forth, rear;                    // degrees that shoulder and metatarsus move about their mean
};

double wrapped(double phase) { return phase < 0 ? phase + 1 : phase >= 1 ? phase - 1 : phase; }

void legs(Quadruped* q, const Gait& gait, double t) {
  for (const int side : {0, 1}) {
    const double f = wrapped(t - gait.front_phase[side]), b = wrapped(t - gait.hind_phase[side]);
    const double stance = gait.front.stance;
    q->front_leg(side, foot_at(gait.front, q->front(side), f),
                 gait.forth * curve({{0, 1}, {stance, -1}, {stance + (1 - stance) * 0.3, -0.6}}, f));
    const double lift = gait.back.stance;
    q->hind_leg(side, foot_at(gait.back, q->back(side), b),
                gait.rear * curve({{0, -0.35}, {0.5 * lift, 0}, {lift, 0.9}, {lift + (1 - lift) * 0.35, 1.3}}, b));
  }
}

Clip walk(Quadruped* q) {
  Gait gait;
  gait.front.stance = gait.back.stance = 0.64;
  gait.front.stride = gait.back.stride = 0.84;
  gait.front.front = 0.25;
  gait.back.front = 0.3;
  gait.front.lift = 0.09;
  gait.back.lift = 0.06;
  gait.front.pitch = [](double t) {
    return curve({{0, -4}, {0.06, 0}, {0.46, 0}, {0.64, 38}, {0.78, 66}, {0.94, -6}}, t);
  };
  gait.back.pitch = [](double t) {
    return curve({{0, -4}, {0.06, 0}, {0.46, 0}, {0.64, 40}, {0.76, 56}, {0.94, -6}}, t);
  };
  gait.hind_phase[0] = 0;  // left hind, left fore, right hind, right fore
  gait.front_phase[0] = 0.25;
  gait.hind_phase[1] = 0.5;
  gait.front_phase[1] = 0.75;
  gait.forth = 7;
  gait.rear = 26;
  return cycle(q->puppet(), "walk", 34, {0, 0, 0.84}, [&](double t, double drop) {
    const double yaw = 4 * wave(t + 0.2);
    q->puppet()->place(
        {0.012 * wave(t - 0.1), -0.02 - drop - 0.01 * wave(2 * t + 0.1), 0},
        multiply(about_y(-0.5 * yaw), multiply(about_z(1.6 * wave(t - 0.1)), about_x(0.8 * wave(2 * t)))));
    q->trunk(yaw, 1.5 * wave(2 * t + 0.3), 5 + 3.5 * wave(2 * t + 0.35), 2 - 2.5 * wave(2 * t + 0.35), 0,
             14 * wave(t + 0.35));
    legs(q, gait, t);
  });
}

Clip trot(Quadruped* q) {
  Gait gait;
  gait.front.stance = gait.back.stance = 0.42;
  gait.front.stride = gait.back.stride = 1.3;
  gait.front.front = 0.26;
  gait.back.front = 0.29;
  gait.front.lift = 0.14;
  gait.back.lift = 0.1;
  gait.front.pitch = [](double t) {
    return curve({{0, -4}, {0.05, 0}, {0.26, 0}, {0.42, 44}, {0.62, 80}, {0.9, -6}}, t);
  };
  gait.back.pitch = [](double t) {
    return curve({{0, -4}, {0.05, 0}, {0.26, 0}, {0.42, 46}, {0.6, 66}, {0.9, -6}}, t);
  };
  gait.hind_phase[0] = gait.front_phase[1] = 0;  // diagonal pairs
  gait.hind_phase[1] = gait.front_phase[0] = 0.5;
  gait.forth = 9;
  gait.rear = 30;
  return cycle(q->puppet(), "trot", 19, {0, 0, 1.3}, [&](double t, double drop) {
    const double yaw = 3 * wave(t + 0.2);
    q->puppet()->place({0, -0.03 - drop - 0.024 * wave(2 * t + 0.06), 0}, about_y(-0.5 * yaw));
    q->trunk(yaw, 1.5 * wave(2 * t + 0.3), -3 + 2 * wave(2 * t + 0.2), 3 - 2 * wave(2 * t + 0.3), 0,
             9 * wave(t + 0.35));
    q->ears(-8, -8);
    legs(q, gait, t);
  });
}

Clip idle(Quadruped* q) {
  return cycle(q->puppet(), "idle", 120, {}, [&](double t, double drop) {
    const double breath = wave(3 * t);
    q->puppet()->place({0.012 * wave(t), -0.012 - drop + 0.003 * breath, 0.006 * wave(t + 0.2)},
                       about_z(0.8 * wave(t)));
    const double low = curve({{0, 0}, {0.1, 0}, {0.45, 1}, {0.6, 1}, {0.9, 0}}, t);
    q->trunk(1.5 * wave(t + 0.1), 0.8 * breath, 1 + 0.8 * breath + 14 * low, 6 * low, 22 * wave(t + 0.02),
             16 * wave(2 * t));
    q->ears(curve({{0, 0}, {0.3, 0}, {0.33, 22}, {0.36, 0}}, t), curve({{0, 0}, {0.7, 0}, {0.73, 22}, {0.77, 0}}, t));
    for (const int side : {0, 1}) {
      q->front_leg(side, {q->front(side).ankle, 0, 0}, 0);
      q->hind_leg(side, {q->back(side).ankle, 0, 0}, 0);
    }
  });
}

}  // namespace

Motion quadruped_clips() {
  Quadruped quadruped;
  Motion motion = quadruped.puppet()->motion();
  motion.clips = {walk(&quadruped), trot(&quadruped), idle(&quadruped)};
  return motion;
}

}  // namespace sinew::clips
