// SPDX-License-Identifier: MIT
// Simplification of skeletons as published, on the samples: the body stays, animations move alike, maps of levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "sinew/names.h"
#include "sinew/published.h"
#include "sinew_character/jobs/simplify_job.hpp"
#include "sinew_character/motion/simplify_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

const std::string kSimplifyData = std::string(SINEW_SOURCE_DIR) + "/samples/data";
const char* const kSimplified[] = {"biped__robed", "biped__robot", "quadruped__tailed", "bird__winged",
                                   "many-legged__plated"};

Character sample(const std::string& name) { return read_character(kSimplifyData + "/" + name + ".obj"); }

size_t find(const Character& c, const std::string& name) {
  for (size_t j = 0; j < c.joints.size(); ++j)
    if (c.joints[j].name == name) return j;
  ADD_FAILURE() << name;
  return 0;
}

// A twist joint amid the left forearm, which moves the half of it next to the hand.
Character with_twist() {
  Character c = sample("biped__robed");
  const size_t arm = find(c, "forearm.L"), hand = find(c, "hand.L");
  const Vec3 &a = c.joints[arm].position, &b = c.joints[hand].position;
  Joint twist;
  twist.name = "forearm_twist.L";
  twist.parent = static_cast<int>(arm);
  twist.position = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  const uint32_t number = static_cast<uint32_t>(c.joints.size());
  c.joints.push_back(twist);
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    const Vec3& p = c.vertices[v];
    const float along = (p.x - twist.position.x) * (b.x - a.x) + (p.y - twist.position.y) * (b.y - a.y) +
                        (p.z - twist.position.z) * (b.z - a.z);
    for (Influence& one : c.influences[v])
      if (one.joint == arm && along > 0) one.joint = number;
  }
  return c;
}

// Every joint turns by up to `degrees` about an axis of its own.
Motion dance(const Character& c, double degrees) {
  Motion motion = motion_of(c.joints);
  Clip clip = {"dance", 0.1, {}};
  std::mt19937 random(3);
  const auto draw = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  for (int f = 0; f < 12; ++f) {
    MotionFrame frame;
    for (const MotionJoint& joint : motion.joints) {
      Point3 axis = {draw(), draw(), draw()};
      const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]) + 1e-9;
      const double half = draw() * degrees * 3.14159265358979 / 360, s = std::sin(half) / length;
      frame.rotations.push_back({axis[0] * s, axis[1] * s, axis[2] * s, std::cos(half)});
      const double size = std::sqrt(frame.rotations.back()[0] * frame.rotations.back()[0] +
                                    frame.rotations.back()[1] * frame.rotations.back()[1] +
                                    frame.rotations.back()[2] * frame.rotations.back()[2] +
                                    frame.rotations.back()[3] * frame.rotations.back()[3]);
      for (double& value : frame.rotations.back()) value /= size;
      frame.translations.push_back(joint.offset);
    }
    clip.frames.push_back(frame);
  }
  motion.clips.push_back(clip);
  return motion;
}

Point3 skinned(const Character& c, const std::vector<Affine>& palette, size_t v) {
  Point3 sum = {};
  for (const Influence& one : c.influences[v]) {
    const Point3 p = transform_point(palette[one.joint], c.vertices[v].x, c.vertices[v].y, c.vertices[v].z);
    for (size_t axis = 0; axis < 3; ++axis) sum[axis] += one.weight * p[axis];
  }
  return sum;
}

// The farthest that a vertex moved away, share of the height.
double largest_error(const Character& before, const Motion& was, const Character& after, const Motion& is) {
  float low = before.vertices[0].y, high = low;
  for (const Vec3& p : before.vertices) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  double most = 0;
  for (size_t f = 0; f < was.clips[0].frames.size(); ++f) {
    const std::vector<Affine> a = motion_palette(was, was.clips[0].frames[f], before.joints.size()),
                              b = motion_palette(is, is.clips[0].frames[f], after.joints.size());
    for (size_t v = 0; v < before.vertices.size(); ++v) {
      const Point3 p = skinned(before, a, v), q = skinned(after, b, v);
      most = std::max(most, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
  }
  return most / static_cast<double>(high - low);
}

bool stays(const Simplified& s, size_t j) { return s.into[j] == j; }

TEST(PublishedSimplify, AnimationsAtTheHighLevelMoveByLessThanOnePercent) {
  for (const std::string name : {"biped__robed", "biped__robot", "quadruped__tailed", "bird__winged", "twist"}) {
    const Character before = name == "twist" ? with_twist() : sample(name);
    const Motion motion = dance(before, 60);
    Character after = before;
    const SimplifiedCharacter out = simplify_character({}, {&motion}, &after);
    EXPECT_LT(largest_error(before, motion, after, out.motion), 0.01) << name;
  }
}

TEST(PublishedSimplify, ATwistGoesUnlessItIsSeen) {
  const Character before = with_twist();
  const size_t twist = find(before, "forearm_twist.L");
  Character after = before;
  EXPECT_FALSE(stays(simplify_character({}, {}, &after).simplified, twist));
  const Motion large = dance(before, 120), small = dance(before, 0.5);
  after = before;
  EXPECT_TRUE(stays(simplify_character({}, {&large}, &after).simplified, twist));
  after = before;
  EXPECT_FALSE(stays(simplify_character({}, {&small}, &after).simplified, twist));
}

TEST(PublishedSimplify, TheLowLevelTakesNoLimbsOff) {
  for (const std::string name : kSimplified) {
    const Character before = sample(name);
    std::vector<uint8_t> classes = limb_classes(map_rig_of(before), Axis::kY);
    SimplifyOptions low;
    low.low = true;
    Character after = before;
    const Simplified s = simplify_skeleton(low, &after);
    for (size_t j = 0; j < classes.size(); ++j) {
      const int c = classes[j];
      const bool limb = c == SINEW_CLASS_PELVIS || c == SINEW_CLASS_HEAD || c == SINEW_CLASS_UPPER_ARM ||
                        c == SINEW_CLASS_FOREARM || c == SINEW_CLASS_HAND || c == SINEW_CLASS_THIGH ||
                        c == SINEW_CLASS_CALF || c == SINEW_CLASS_FOOT;
      EXPECT_TRUE(!limb || stays(s, j)) << name << " " << before.joints[j].name;
    }
    for (size_t j = 0; j < before.joints.size(); ++j) {  // both sides alike
      std::string other = before.joints[j].name;
      const size_t side = other.find(".L");
      if (side == std::string::npos) continue;
      other[side + 1] = 'R';
      EXPECT_EQ(stays(s, j), stays(s, find(before, other))) << name << " " << other;
    }
    for (const auto& row : after.influences)
      for (const Influence& one : row) EXPECT_LT(one.joint, after.joints.size());
  }
}

TEST(PublishedSimplify, AMapOfTheHighLevelIsReducedByTheLowOne) {
  const Character target = with_twist(), source = sample("biped__robot");
  const MapRig to = map_rig_of(target), from = map_rig_of(source);
  const MapSkeletonOptions options;
  const MappedSkeleton high = map_at_level(to, from, options, false), low = map_at_level(to, from, options, true);
  ASSERT_EQ(low.sources.size(), target.joints.size());
  EXPECT_LE(low.mapped, high.mapped);
  EXPECT_EQ(high.sources[find(target, "forearm_twist.L")], -1);
  std::vector<int> used(source.joints.size(), 0);
  for (const int32_t one : low.sources) {
    if (one >= 0) {
      EXPECT_LE(++used[static_cast<size_t>(one)], 1);
    }
  }
  for (const std::string name : {"hips", "head", "upper_arm.L", "forearm.R", "hand.L", "thigh.R", "shin.L", "foot.R"})
    EXPECT_EQ(low.sources[find(target, name)], static_cast<int32_t>(find(source, name))) << name;
  MapSkeletonOptions pinned;
  pinned.pins = {
      {static_cast<uint32_t>(find(target, "forearm_twist.L")), static_cast<int32_t>(find(source, "forearm.L"))}};
  EXPECT_EQ(map_at_level(to, from, pinned, true).sources[find(target, "forearm_twist.L")],
            static_cast<int32_t>(find(source, "forearm.L")));
}

// The surfaces count at a level as they do without one.
TEST(PublishedSimplify, AMapAtALevelKnowsTheSurfaces) {
  const MapRig to = map_rig_of(with_twist()), from = map_rig_of(sample("biped__robot"));
  MapRig bare = to;
  bare.surfaces = {};
  MapSkeletonOptions options;
  options.method = SINEW_MAP_BRANCHES;
  for (const bool low : {false, true})
    EXPECT_NE(map_at_level(to, from, options, low).confidence, map_at_level(bare, from, options, low).confidence);
}

// Mean distance from every joint of one skeleton to the nearest of the other.
double mean_distance(const std::vector<Joint>& from, const std::vector<Joint>& to) {
  double sum = 0;
  for (const Joint& one : from) {
    double least = 1e30;
    for (const Joint& other : to) {
      const Vec3 &p = one.position, &q = other.position;
      least = std::min(least, std::hypot(double{p.x} - q.x, double{p.y} - q.y, double{p.z} - q.z));
    }
    sum += least;
  }
  return sum / static_cast<double>(from.size());
}

TEST(PublishedSimplify, RegionsOfASurfaceAreASkeleton) {
  for (const std::string name : {"biped__robed", "quadruped__tailed", "snake__long"}) {
    const Character c = sample(name);
    float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
    for (const Vec3& v : c.vertices) {
      const float p[3] = {v.x, v.y, v.z};
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
    const double side = double{std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]})};
    SkeletonOptions options;
    options.method = SINEW_RIG_REGIONS;
    const std::vector<Joint> joints = predict_skeleton(c, options).joints;
    ASSERT_GE(joints.size(), 4u) << name;
    EXPECT_LT((mean_distance(joints, c.joints) + mean_distance(c.joints, joints)) / 2, 0.12 * side) << name;
  }
}

}  // namespace
}  // namespace sinew
