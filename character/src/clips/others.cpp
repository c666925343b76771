// SPDX-License-Identifier: MIT
// A bird that flaps, a fish that swims, a spider that crawls.
#include "clips/puppet.hpp"

namespace sinew::clips {
namespace {

// Wings follow their shoulders, each part later, and fold on the way up; the body goes against them.
Clip flap(Puppet* p) {
  return cycle(p, "flap", 24, {}, [&](double t, double) {
    const double up = wave(t + 0.25);
    p->place({0, -0.03 * wave(t + 0.25 - 0.06), 0}, about_x(-6 + 2 * wave(t)));
    p->turn("Neck1", about_x(4 - 2 * wave(t)));
    p->turn("Head", about_x(4 - 2 * wave(t + 0.1)));
    for (const char* joint : {"Tail1", "Tail2"}) p->turn(joint, about_x(5 * wave(t + 0.1)));
    for (const int side : {0, 1}) {
      const double s = side == 0 ? 1 : -1;
      const std::string end = side == 0 ? ".L" : ".R";
      const double fold = 0.5 + 0.5 * wave(t - 0.02);  // greatest half way up
      const auto wing = [&](const char* name, double lift, double sweep, double twist) {
        p->turn(name + end, multiply(about_z(s * lift), multiply(about_y(s * sweep), about_x(twist))));
      };
      wing("Wing1", 6 + 38 * up, 6 * fold, 8 * wave(t + 0.5));
      wing("Wing2", 20 * wave(t + 0.25 - 0.1) - 22 * fold, -8 * fold, 10 * wave(t + 0.45));
      wing("Wing3", 16 * wave(t + 0.25 - 0.17) - 10 * fold, 22 * fold, 8 * wave(t + 0.4));
      wing("Wing4", 12 * wave(t + 0.25 - 0.22), 8 * fold, 0);
      p->turn("UpperLeg" + end, about_x(58 + 4 * wave(t + 0.2)));
      p->turn("LowerLeg" + end, about_x(34));
      p->turn("Foot" + end, about_x(-20));
      p->turn("Toe" + end, about_x(40));
    }
  });
}

// A wave that runs from the head to the tail and grows.
Clip swim(Puppet* p) {
  return cycle(p, "swim", 36, {}, [&](double t, double) {
    p->place({0.015 * wave(t + 0.3), 0.004 * wave(2 * t), 0},
             multiply(about_y(5 * wave(t)), about_z(1.5 * wave(t + 0.2))));
    const double grows[] = {5, 9, 13, 18, 24};
    const char* const spine[] = {"Spine2", "Spine3", "Spine4", "Spine5", "Spine6"};
    for (size_t i = 0; i < 5; ++i) p->turn(spine[i], about_y(-grows[i] * wave(t - 0.12 * static_cast<double>(i + 1))));
    p->turn("Jaw", about_x(4 + 4 * wave(t)));
    p->turn("DorsalFin", about_z(5 * wave(t - 0.2)));
    for (const int side : {0, 1}) {
      const double s = side == 0 ? 1 : -1;
      p->turn(side == 0 ? "Fin.L" : "Fin.R",
              multiply(about_z(s * (6 + 14 * wave(2 * t))), about_y(s * 8 * wave(2 * t + 0.25))));
    }
  });
}

// Legs in two groups of four, each neighbour in the other; a foot stays where it stands.
Clip crawl(Puppet* p) {
  constexpr double kStance = 0.56, kStride = 0.36, kLift = 0.11;
  return cycle(p, "crawl", 22, {0, 0, kStride}, [&](double t, double drop) {
    p->place({0.008 * wave(t), -drop + 0.006 * wave(2 * t), 0},
             multiply(about_y(1.5 * wave(t + 0.1)), about_z(wave(t))));
    p->turn("Tail1", multiply(about_x(2 * wave(2 * t)), about_y(3 * wave(t))));
    for (int leg = 1; leg <= 4; ++leg) {
      for (const int side : {0, 1}) {
        const std::string end = std::to_string(leg) + (side == 0 ? ".L" : ".R");
        const double late = (leg + side) % 2 == 0 ? 0.0 : 0.5, own = t < late ? t - late + 1 : t - late;
        const double s = own < kStance ? 0 : (own - kStance) / (1 - kStance);
        // While it is carried the foot makes up for what the body travels: smooth at both ends against the floor.
        const double on_floor = -kStride * own + (own < kStance ? 0 : kStride * s * s * (3 - 2 * s));
        const Point3 step = {0, kLift * 16 * s * s * (1 - s) * (1 - s), 0.5 * kStride * kStance + on_floor};
        const Limb limb = {"UpperLeg" + end, "LowerLeg" + end, "Foot" + end, {0, 1, 0}};
        p->reach(limb, p->rest_position(limb.end) + step, {0, 1, 0});
        p->turn_in_world(limb.end, kNoRotation4);
      }
    }
  });
}

Motion with(const Puppet& puppet, Clip clip) {
  Motion motion = puppet.motion();
  motion.clips = {std::move(clip)};
  return motion;
}

}  // namespace

Motion bird_clips() {
  Puppet puppet("bird");
  Clip clip = flap(&puppet);
  return with(puppet, std::move(clip));
}
Motion fish_clips() {
  Puppet puppet("fish");
  Clip clip = swim(&puppet);
  return with(puppet, std::move(clip));
}
Motion spider_clips() {
  Puppet puppet("spider");
  Clip clip = crawl(&puppet);
  return with(puppet, std::move(clip));
}

}  // namespace sinew::clips
