// SPDX-License-Identifier: MIT
// Clips get chains that swing: loops close, body joints stay, skirts stay out of legs.
#include "sinew_character/springs/play_springs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "hairy_person.hpp"
#include "sinew_character/jobs/springs_job.hpp"
#include "sinew_formats/base/affine.hpp"

namespace sinew {
namespace {

using sinew_test::HairyPerson;

constexpr double kPi = 3.14159265358979;

HairyPerson ponytailed() {
  HairyPerson person;
  person.chain("Hair", static_cast<int>(person.index("Head")), {0, 1.75, -0.12}, {0, -0.08, -0.01}, 4);
  return person;
}

// The head shakes once, the body goes on by `travel`; the last frame is the first one again.
Clip shaking(const Motion& motion, size_t head, const Point3& travel, int frames = 41) {
  Clip clip = {"shake", 1.0 / 30, {}};
  for (int f = 0; f < frames; ++f) {
    MotionFrame frame;
    for (const MotionJoint& joint : motion.joints) {
      frame.rotations.push_back(kNoRotation4);
      frame.translations.push_back(joint.offset);
    }
    const double share = static_cast<double>(f) / (frames - 1);
    frame.rotations[head] = axis_rotation(size_t{1}, 0.8 * std::sin(2 * kPi * share));
    frame.translations[0] = frame.translations[0] + share * travel;
    clip.frames.push_back(frame);
  }
  return clip;
}

double degrees(const Quaternion& a, const Quaternion& b) {
  return 360 / kPi * std::acos(std::min(1.0, std::abs(dot(a, b))));
}

TEST(PlaySprings, ALoopCloses) {
  const HairyPerson person = ponytailed();
  const Motion motion = motion_of(person.character.joints);
  const Springs springs = springs_of({}, "person", person.character).springs;
  for (const Point3& travel : {Point3{}, Point3{0, 0, 1.5}}) {
    const Clip given = shaking(motion, person.index("Head"), travel);
    Clip clip = given;
    const SpringPlay play = play_springs(springs, motion, &clip);
    EXPECT_TRUE(play.loops);
    EXPECT_EQ(play.joints, 4u);
    EXPECT_LT(play.gap, 0.1);
    double swing = 0, seam = 0, step = 0;
    for (size_t j = 0; j < motion.joints.size(); ++j) {
      const bool hair = motion.joints[j].name.rfind("Hair", 0) == 0;
      for (size_t f = 0; f < clip.frames.size(); ++f) {
        EXPECT_EQ(clip.frames[f].translations[j], given.frames[f].translations[j]);
        if (!hair) {
          EXPECT_EQ(clip.frames[f].rotations[j], given.frames[f].rotations[j]);
        } else {
          swing = std::max(swing, degrees(clip.frames[f].rotations[j], kNoRotation4));
          if (f > 0) step = std::max(step, degrees(clip.frames[f].rotations[j], clip.frames[f - 1].rotations[j]));
        }
      }
      if (hair) seam = std::max(seam, degrees(clip.frames[0].rotations[j], clip.frames.back().rotations[j]));
    }
    EXPECT_GT(swing, 3);
    EXPECT_LT(seam, 0.1);
    EXPECT_LT(step, 20);
  }
}

TEST(PlaySprings, HipsBelowAJointForTheFloorMayTravel) {
  HairyPerson person = ponytailed();
  for (Joint& joint : person.character.joints)
    if (joint.parent < 0) joint.parent = static_cast<int>(person.character.joints.size());
  (void)person.add("Root", {0, 0, 0}, -1);
  const Motion motion = motion_of(person.character.joints);
  Clip clip = shaking(motion, person.index("Head"), {0, 0, 2});  // joint 0 is the hips
  const SpringPlay play = play_springs(springs_of({}, "person", person.character).springs, motion, &clip);
  EXPECT_TRUE(play.loops);
  EXPECT_LT(play.gap, 0.1);
}

TEST(PlaySprings, AClipThatEndsElsewhereBeginsAtRest) {
  const HairyPerson person = ponytailed();
  const Motion motion = motion_of(person.character.joints);
  Clip clip = shaking(motion, person.index("Head"), {});
  clip.frames.resize(20);
  SpringsOptions calm;
  calm.values = {"*:gravity=0"};
  const SpringPlay play = play_springs(springs_of(calm, "person", person.character).springs, motion, &clip);
  EXPECT_FALSE(play.loops);
  EXPECT_LT(degrees(clip.frames[0].rotations[person.index("Hair1")], kNoRotation4), 0.1);
}

TEST(PlaySprings, ChainsStayOutOfTheHeadThatComesAtThem) {
  const HairyPerson person = ponytailed();
  const Motion motion = motion_of(person.character.joints);
  const Springs springs = springs_of({}, "person", person.character).springs;
  Clip clip = shaking(motion, person.index("Head"), {});
  for (size_t f = 0; f < clip.frames.size(); ++f)  // nods far back
    clip.frames[f].rotations[person.index("Head")] =
        axis_rotation(size_t{0}, -0.9 * std::sin(kPi * static_cast<double>(f) / 40));
  (void)play_springs(springs, motion, &clip);
  const SpringCollider* chest = nullptr;
  for (const SpringCollider& one : springs.colliders)
    if (one.name == "chest") chest = &one;
  ASSERT_NE(chest, nullptr);
  const Point3 origin = point(person.character.joints[chest->joint].position);
  double nearest = 1;
  for (const MotionFrame& frame : clip.frames) {
    const WorldPose pose = world_pose(motion, frame);
    for (const char* name : {"Hair2", "Hair3", "Hair4"}) {
      const Point3 p = pose.positions[person.index(name)];
      const Point3 a = origin + chest->offset, b = chest->shape == ColliderShape::kCapsule ? origin + chest->tail : a;
      const Point3 along = b - a;
      const double t = dot(along, along) > 0 ? std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0) : 0;
      nearest = std::min(nearest, length(p - a - t * along) - chest->radius);
    }
  }
  EXPECT_GT(nearest, -0.01);
}

// A walk of a second, a stop, and two seconds more: ends are still within one and a half, below 0.1 % of the height.
TEST(PlaySprings, EveryPresetComesToRestAfterAStop) {
  const HairyPerson person = ponytailed();
  const Motion motion = motion_of(person.character.joints);
  std::string kinds = spring_kinds_text() + ", ";
  for (size_t at = 0; at < kinds.size(); at = kinds.find(", ", at) + 2) {
    const std::string kind = kinds.substr(at, kinds.find(", ", at) - at);
    SpringsOptions options;
    options.presets = {"Hair1=" + kind};
    Clip clip = shaking(motion, person.index("Head"), {}, 91);
    for (size_t f = 0; f < clip.frames.size(); ++f) {
      clip.frames[f].rotations[person.index("Head")] = kNoRotation4;
      clip.frames[f].translations[0] =
          motion.joints[0].offset + Point3{0, 0, 1.4 * std::min(1.0, static_cast<double>(f) / 30)};
    }
    clip.frames[0].rotations[person.index("LeftArm")] = axis_rotation(size_t{2}, 1);  // no loop
    (void)play_springs(springs_of(options, "person", person.character).springs, motion, &clip);
    const auto end_at = [&](size_t f) { return world_pose(motion, clip.frames[f]).positions[person.index("Hair4")]; };
    double swing = 0, jitter = 0;
    for (size_t f = 31; f < 91; ++f) swing = std::max(swing, length(end_at(f) - end_at(90)));
    for (size_t f = 75; f < 91; ++f) jitter = std::max(jitter, length(end_at(f) - end_at(90)));
    EXPECT_GT(swing, 0.005) << kind;
    EXPECT_LT(jitter, 0.001 * 1.8) << kind;
  }
}

TEST(PlaySprings, NothingThatSwingsIsAnError) {
  const HairyPerson person;
  const Motion motion = motion_of(person.character.joints);
  Clip clip = shaking(motion, 0, {});
  EXPECT_ERROR((void)play_springs(Springs(), motion, &clip), "no chains");
}

}  // namespace
}  // namespace sinew
