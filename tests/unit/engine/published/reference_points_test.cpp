// SPDX-License-Identifier: MIT
// sinew_retarget_reference_points() against its equations, written down anew.
#include "motion/reference_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "motion_clip.hpp"
#include "sinew/published.h"

namespace {

using namespace sinew_test;
using sinew::dot;

// The corners of a rigid body in a pose.
std::vector<Vec3d> posed(const MotionScene& scene, const BoxBody& body, const WorldPose& pose) {
  std::vector<Vec3d> out;
  for (size_t v = 0; v < body.joints.size(); ++v) {
    const size_t j = body.joints[v];
    out.push_back(pose.positions[j] + rotate(pose.rotations[j], vec(&body.positions[3 * v]) - scene.at(j)));
  }
  return out;
}

struct Triangle {
  Vec3d middle, normal;
  double area;
};
std::vector<Triangle> triangles(const BoxBody& body, const std::vector<Vec3d>& corners) {
  std::vector<Triangle> out;
  for (size_t t = 0; t < body.triangles.size(); t += 3) {
    const Vec3d a = corners[body.triangles[t]], b = corners[body.triangles[t + 1]], c = corners[body.triangles[t + 2]];
    const Vec3d n = sinew::cross(b - a, c - a);
    const double size = std::sqrt(dot(n, n));
    out.push_back({(1.0 / 3) * (a + b + c), (1 / size) * n, size / 2});
  }
  return out;
}

bool is_below(const MotionScene& scene, uint32_t joint, uint32_t ancestor) {
  for (int32_t at = static_cast<int32_t>(joint); at >= 0; at = scene.parents[static_cast<size_t>(at)])
    if (at == static_cast<int32_t>(ancestor)) return true;
  return false;
}

struct GoalOptions {
  int power = 3;
  double falloff = 0.05, eps = 1e-5;
  bool own_limb = false;
  bool as_drawn = false;  // one part; points of the source, of a target as tall
};

// The position of a joint by the equations, in double with the maths library.
Vec3d expected_position(const MotionScene& source, const MotionScene& target, const BoxBody& a, const BoxBody& b,
                        const WorldPose& from, const WorldPose& copied, uint32_t joint, uint32_t shoulder,
                        const GoalOptions& goal_options) {
  const auto source_triangles = triangles(a, posed(source, a, from));
  const auto target_triangles = triangles(b, posed(target, b, copied));
  std::vector<Vec3d> rest;
  for (size_t v = 0; v < a.joints.size(); ++v) rest.push_back(vec(&a.positions[3 * v]));
  const auto rest_triangles = triangles(a, rest);
  const auto height = [](const BoxBody& body) {
    double low = 1e9, high = -1e9;
    for (size_t v = 1; v < body.positions.size(); v += 3) {
      low = std::min(low, double{body.positions[v]});
      high = std::max(high, double{body.positions[v]});
    }
    return high - low;
  };
  double mean = 0;
  for (const Triangle& t : source_triangles) mean += t.area / static_cast<double>(source_triangles.size());
  // Torso, head, arms and legs have goals of their own. A box is one joint's.
  struct Part {
    Vec3d sum = {0, 0, 0};
    double all = 0, near = 1e9;
  };
  Part parts[6];
  const uint32_t tops[6] = {0, kHead, kLeftUpperArm, kRightUpperArm, kLeftThigh, kRightThigh};
  for (size_t i = 0; i < source_triangles.size(); ++i) {
    size_t part = 0;
    for (size_t k = 1; k < 6; ++k)
      if (is_below(source, a.joints[a.triangles[3 * i]], tops[k])) part = k;
    if (tops[part] == shoulder && !goal_options.own_limb) continue;
    uint32_t nearest = 0;
    for (uint32_t j = 1; j < source.count(); ++j)
      if (j != kLeftFinger &&
          distance(source.at(j), rest_triangles[i].middle) < distance(source.at(nearest), rest_triangles[i].middle))
        nearest = j;
    const Vec3d v = from.positions[joint] - source_triangles[i].middle;
    const double far = std::sqrt(dot(v, v));
    const Vec3d along = (1 / far) * v;
    double own = std::pow(source_triangles[i].area / mean, goal_options.power) *
                 std::max(std::abs(dot(along, source_triangles[i].normal)), goal_options.eps);
    if (goal_options.falloff > 0) own *= std::exp(-std::pow(far / (goal_options.falloff * height(a)), 2));
    // Bones of the way: those that are above just one of the two ends.
    double way = 0, other = 0;
    bool any = false;
    for (uint32_t j = 1; j < source.count(); ++j) {
      if (is_below(source, nearest, j) == is_below(source, joint, j)) continue;
      any = true;
      const size_t up = static_cast<size_t>(source.parents[j]);
      way += std::abs(dot(along, from.positions[j] - from.positions[up]));
      other += std::abs(dot(along, copied.positions[j] - copied.positions[up]));
    }
    const double factor = !any ? 1 : way < 1e-6 * height(a) ? height(b) / height(a) : other / way;
    if (goal_options.as_drawn) part = 0;
    const Vec3d point = goal_options.as_drawn ? source_triangles[i].middle + copied.positions[0] - from.positions[0]
                                              : target_triangles[i].middle;
    parts[part].all += own;
    parts[part].sum = parts[part].sum + own * (point + factor * v);
    parts[part].near = std::min(parts[part].near, far);
  }
  Vec3d sum = {0, 0, 0};
  double all = 0;
  for (const Part& part : parts) {
    if (part.all <= 0) continue;
    const double share = std::pow(part.near * part.near + std::pow(1e-3 * height(a), 2), -2);
    all += share;
    sum = sum + (share / part.all) * part.sum;
  }
  return (1 / all) * sum;
}

// A child-like, broad body on which a grown one's poses are played.
struct Bodies {
  MotionScene source = body(20), target = body(35, 0.7);
  BoxBody a, b;
  Bodies() : a(source, 0.1), b((widen(&target), target), 0.16, 0.7) {}
  static void widen(MotionScene* scene) {
    for (uint32_t j = 0; j < scene->count(); ++j) scene->positions[3 * j] *= 1.3f;
  }
};

Pose arms_forward(const MotionScene& scene, double amount) {
  Pose pose = random_pose(scene, 3, 0.4, {0.2, 0.05, 0});
  for (const uint32_t arm : {kLeftUpperArm, kRightUpperArm}) {
    const double side = arm == kLeftUpperArm ? 1 : -1;
    pose.set(arm, sinew::motion::shortest_arc({side, -0.36, 0}, {side * 0.3, -0.5, amount}),
             vec(&pose.translations[3 * arm]));
    pose.set(arm + 1, sinew::motion::shortest_arc({side, -0.36, 0.1}, {-side * 0.4, -0.36, 0.5}),
             vec(&pose.translations[3 * (arm + 1)]));
  }
  return pose;
}

TEST(ReferencePoints, ArmsGoWhereTheEquationsSay) {
  const Bodies bodies;
  for (const GoalOptions& goal_options :
       {GoalOptions{}, GoalOptions{4, 0, 1e-5, true}, GoalOptions{0, 0, 1e-5, false}, GoalOptions{1, 0, 0.3, true},
        GoalOptions{2, 0.2, 1e-5, true}, GoalOptions{0, 0.1, 1e-5, false}}) {
    PlayedClip clip(bodies.source, bodies.target);
    const Pose pose = arms_forward(bodies.source, 0.6);
    clip.add(pose);
    const WorldPose from = world_pose(bodies.source, pose), copied = clip.frame(0);
    sinew_reference_options settings = SINEW_INIT(sinew_reference_options);
    settings.area_power = goal_options.power == 0 ? SINEW_NO_AREA : static_cast<uint32_t>(goal_options.power);
    settings.falloff = goal_options.falloff > 0 ? static_cast<float>(goal_options.falloff) : SINEW_NO_FALLOFF;
    settings.own_limb = goal_options.own_limb ? 1 : 0;
    settings.least_cosine = static_cast<float>(goal_options.eps);
    ASSERT_EQ(clip.reference_points(bodies.a, bodies.b, settings), SINEW_OK);
    const WorldPose made = clip.frame(0);
    double moved = 0;
    for (const uint32_t arm : {kLeftUpperArm, kRightUpperArm}) {
      const auto goal = [&](uint32_t joint) {
        return expected_position(bodies.source, bodies.target, bodies.a, bodies.b, from, copied, joint, arm,
                                 goal_options);
      };
      const Vec3d shoulder = copied.positions[arm], elbow = goal(arm + 1), wrist = goal(arm + 2);
      const double upper = distance(copied.positions[arm], copied.positions[arm + 1]),
                   lower = distance(copied.positions[arm + 1], copied.positions[arm + 2]);
      const double reach = std::min(distance(wrist, shoulder), 0.9995 * (upper + lower));
      const Vec3d along = sinew::unit(wrist - shoulder);
      EXPECT_LT(distance(made.positions[arm + 2], shoulder + reach * along), 2e-4)
          << goal_options.power << " " << goal_options.falloff;
      // The elbow lies in the plane of shoulder, wrist and wanted elbow, on its side.
      const Vec3d side = sinew::unit(elbow - shoulder - dot(elbow - shoulder, along) * along);
      const Vec3d bend = made.positions[arm + 1] - shoulder;
      EXPECT_NEAR(dot(bend, side), std::sqrt(dot(bend, bend) - std::pow(dot(bend, along), 2)), 1e-3);
      moved = std::max(moved, distance(made.positions[arm + 2], copied.positions[arm + 2]));
      EXPECT_NEAR(distance(made.positions[arm], made.positions[arm + 1]), upper, 1e-5);
      EXPECT_NEAR(distance(made.positions[arm + 1], made.positions[arm + 2]), lower, 1e-5);
    }
    EXPECT_GT(moved, 0.001) << "it does something";
    for (const uint32_t joint : {kHead, kLeftFoot, kRightCalf, kLeftUpperArm})
      EXPECT_LT(distance(made.positions[joint], copied.positions[joint]), 1e-5) << "all else stays";
  }
}

// As published: one sum over all triangles, the limb's own too, of the source's points; arms and legs.
TEST(ReferencePoints, AsDrawnAllTrianglesHaveOneSum) {
  const MotionScene source = body(20);
  MotionScene target = body(20);
  Bodies::widen(&target);
  const BoxBody a(source, 0.1), b(target, 0.16);
  PlayedClip clip(source, target);
  const Pose pose = arms_forward(source, 0.6);
  clip.add(pose);
  const WorldPose from = world_pose(source, pose), copied = clip.frame(0);
  sinew_reference_options settings = SINEW_INIT(sinew_reference_options);
  settings.as_drawn = 1;
  settings.falloff = 0.2f;  // says nothing
  ASSERT_EQ(clip.reference_points(a, b, settings), SINEW_OK);
  const WorldPose made = clip.frame(0);
  const GoalOptions drawn = {3, 0, 1e-5, true, true};
  double moved = 0;
  for (const uint32_t limb : {kLeftUpperArm, kRightUpperArm, kLeftThigh, kRightThigh}) {
    const Vec3d top = made.positions[limb];
    const Vec3d goal = expected_position(source, target, a, b, from, copied, limb + 2, limb, drawn);
    const double reach =
        std::min(distance(goal, top), 0.9995 * (distance(made.positions[limb], made.positions[limb + 1]) +
                                                distance(made.positions[limb + 1], made.positions[limb + 2])));
    EXPECT_LT(distance(made.positions[limb + 2], top + reach * sinew::unit(goal - top)), 2e-4) << limb;
    moved = std::max(moved, distance(made.positions[limb + 2], copied.positions[limb + 2]));
  }
  EXPECT_GT(moved, 0.001) << "it does something";
}

TEST(ReferencePoints, LegsGoAlongWhereTheyAreWanted) {
  const Bodies bodies;
  PlayedClip clip(bodies.source, bodies.target);
  clip.add(arms_forward(bodies.source, 0.6));
  const WorldPose copied = clip.frame(0);
  sinew_reference_options settings = SINEW_INIT(sinew_reference_options);
  settings.legs = 1;
  ASSERT_EQ(clip.reference_points(bodies.a, bodies.b, settings), SINEW_OK);
  const WorldPose made = clip.frame(0);
  EXPECT_GT(distance(made.positions[kLeftFoot], copied.positions[kLeftFoot]), 0.005);
  EXPECT_NEAR(distance(made.positions[kLeftCalf], made.positions[kLeftFoot]),
              distance(copied.positions[kLeftCalf], copied.positions[kLeftFoot]), 1e-5);
}

// A body of twice the size in all is nearly where the copy puts it: only triangles of the joint itself say otherwise.
TEST(ReferencePoints, AScaledBodyStaysNearlyAsItIsCopied) {
  const MotionScene source = body(20), target = body(20, 2);
  const BoxBody a(source, 0.1), b(target, 0.1, 2);
  PlayedClip clip(source, target);
  for (uint32_t f = 0; f < 4; ++f) clip.add(arms_forward(source, 0.3 + 0.2 * f));
  std::vector<WorldPose> copied;
  for (uint32_t f = 0; f < 4; ++f) copied.push_back(clip.frame(f));
  ASSERT_EQ(clip.reference_points(a, b), SINEW_OK);
  for (uint32_t f = 0; f < 4; ++f)
    for (const uint32_t joint : {kLeftForearm, kLeftHand, kRightHand})
      EXPECT_LT(distance(clip.frame(f).positions[joint], copied[f].positions[joint]), 0.01);
}

TEST(ReferencePoints, TheSameBodyIsLeftAsItIs) {
  const MotionScene scene = body(20);
  PlayedClip clip(scene, scene);
  for (uint32_t f = 0; f < 5; ++f) clip.add(random_pose(scene, f, 1.2));
  const BoxBody own(scene, 0.2);
  const std::vector<float> before = clip.rotations;
  ASSERT_EQ(clip.reference_points(own, own), SINEW_OK);
  EXPECT_EQ(clip.rotations, before);
}

TEST(ReferencePoints, AHeadAndATorsoMoveWhereAskedAndKeepTheirBones) {
  const Bodies bodies;
  for (const bool torso : {false, true}) {
    PlayedClip clip(bodies.source, bodies.target);
    const Pose pose = arms_forward(bodies.source, 0.6);
    clip.add(pose);
    const WorldPose from = world_pose(bodies.source, pose), copied = clip.frame(0);
    sinew_reference_options settings = SINEW_INIT(sinew_reference_options);
    (torso ? settings.torso : settings.head) = 1;
    ASSERT_EQ(clip.reference_points(bodies.a, bodies.b, settings), SINEW_OK);
    const WorldPose made = clip.frame(0);
    if (!torso) {
      EXPECT_GT(distance(made.positions[kHead], copied.positions[kHead]), 1e-4);
    }
    const auto up = [&](uint32_t j) { return static_cast<size_t>(bodies.target.parents[j]); };
    EXPECT_NEAR(distance(made.positions[kHead], made.positions[up(kHead)]),
                distance(copied.positions[kHead], copied.positions[up(kHead)]), 1e-5);
    EXPECT_LT(distance(made.positions[kLeftFoot], copied.positions[kLeftFoot]), 1e-5) << "legs stay";
    if (!torso) continue;
    // The spine points where the source's does.
    const Vec3d own = sinew::unit(made.positions[kSpine] - made.positions[up(kSpine)]);
    const Vec3d wanted = sinew::unit(from.positions[kSpine] - from.positions[up(kSpine)]);
    EXPECT_LT(distance(own, wanted), 1e-5);
  }
}

// The source's points, in the target's size: of a body that is only scaled they are the target's.
TEST(ReferencePoints, TheSourcesPointsOfAScaledBodyAreTheTargets) {
  const MotionScene source = body(20), target = body(20, 2);
  const BoxBody a(source, 0.1), b(target, 0.1, 2);
  PlayedClip own(source, target), others(source, target);
  for (PlayedClip* clip : {&own, &others}) clip->add(arms_forward(source, 0.6));
  sinew_reference_options settings = SINEW_INIT(sinew_reference_options);
  ASSERT_EQ(own.reference_points(a, b, settings), SINEW_OK);
  settings.source_points = 1;
  ASSERT_EQ(others.reference_points(a, b, settings), SINEW_OK);
  EXPECT_LT(distance(own.frame(0).positions[kLeftHand], others.frame(0).positions[kLeftHand]), 1e-4);
  const Bodies bodies;  // of another it is not
  PlayedClip first(bodies.source, bodies.target), second(bodies.source, bodies.target);
  for (PlayedClip* clip : {&first, &second}) clip->add(arms_forward(bodies.source, 0.6));
  ASSERT_EQ(first.reference_points(bodies.a, bodies.b), SINEW_OK);
  ASSERT_EQ(second.reference_points(bodies.a, bodies.b, settings), SINEW_OK);
  EXPECT_GT(distance(first.frame(0).positions[kLeftHand], second.frame(0).positions[kLeftHand]), 1e-3);
}

// A motion without a mesh: both skeletons get the same capsules, so that a skeleton that is only scaled stays nearly as copied.
TEST(ReferencePoints, CapsulesStandForABodyThatIsNotThere) {
  const Bodies bodies;
  const BoxBody thick(bodies.target, 0.3, 0.7);
  PlayedClip clip(bodies.source, bodies.target);
  for (uint32_t f = 0; f < 6; ++f) clip.add(arms_forward(bodies.source, 0.1 * f));
  std::vector<WorldPose> copied;
  for (uint32_t f = 0; f < 6; ++f) copied.push_back(clip.frame(f));
  ASSERT_EQ(clip.reference_points(nullptr, thick), SINEW_OK);
  double moved = 0;
  for (uint32_t f = 0; f < 6; ++f) {
    for (const uint32_t hand : {kLeftHand, kRightHand})
      moved = std::max(moved, distance(clip.frame(f).positions[hand], copied[f].positions[hand]));
    EXPECT_LT(distance(clip.frame(f).positions[kHead], copied[f].positions[kHead]), 1e-5);
  }
  EXPECT_GT(moved, 1e-3) << "a thick body pushes hands out";
  const MotionScene source = body(20), larger = body(20, 2);
  PlayedClip scaled(source, larger);
  scaled.add(arms_forward(source, 0.6));
  const WorldPose before = scaled.frame(0);
  ASSERT_EQ(scaled.reference_points(nullptr, BoxBody(larger, 0.1, 2)), SINEW_OK);
  for (const uint32_t joint : {kLeftForearm, kLeftHand, kRightHand})
    EXPECT_LT(distance(scaled.frame(0).positions[joint], before.positions[joint]), 0.02);
}

// Live: a frame alone gives what it gives in a clip.
TEST(ReferencePoints, FramesDoNotKnowOfEachOther) {
  const Bodies bodies;
  PlayedClip whole(bodies.source, bodies.target), one(bodies.source, bodies.target);
  for (uint32_t f = 0; f < 5; ++f) whole.add(random_pose(bodies.source, f, 0.7));
  one.add(random_pose(bodies.source, 3, 0.7));
  ASSERT_EQ(whole.reference_points(bodies.a, bodies.b), SINEW_OK);
  ASSERT_EQ(one.reference_points(bodies.a, bodies.b), SINEW_OK);
  const size_t four = 4 * size_t{one.target.count()};
  EXPECT_TRUE(std::equal(one.rotations.begin(), one.rotations.end(),
                         whole.rotations.begin() + static_cast<ptrdiff_t>(3 * four)));
}

// The command says it, other front-ends do not: the same bytes.
TEST(ReferencePoints, TheDefaultFalloffIsTheOneThatACallerCanSay) {
  sinew_reference_options options = SINEW_INIT(sinew_reference_options);
  sinew::motion::ReferenceOptions unsaid, said;
  sinew::Progress progress;
  ASSERT_EQ(sinew::motion::read_reference_options(&options, &unsaid, &progress), SINEW_OK);
  options.falloff = 0.05f;
  ASSERT_EQ(sinew::motion::read_reference_options(&options, &said, &progress), SINEW_OK);
  EXPECT_EQ(unsaid.falloff, said.falloff);
}

TEST(ReferencePoints, WhatIsWrongIsRefused) {
  const Bodies bodies;
  PlayedClip clip(bodies.source, bodies.target);
  for (uint32_t f = 0; f < 3; ++f) clip.add(random_pose(bodies.source, f, 0.5));
  const std::vector<float> before = clip.rotations;
  const auto refused = [&](const auto& change) {
    sinew_reference_options settings = SINEW_INIT(sinew_reference_options);
    change(&settings);
    EXPECT_EQ(clip.reference_points(bodies.a, bodies.b, settings), SINEW_ERROR_ARGUMENT);
  };
  refused([](sinew_reference_options* s) { s->struct_size = 8; });
  refused([](sinew_reference_options* s) { s->area_power = 5; });
  refused([](sinew_reference_options* s) { s->own_limb = 2; });
  refused([](sinew_reference_options* s) { s->legs = 2; });
  refused([](sinew_reference_options* s) { s->own_limb = 2; });
  refused([](sinew_reference_options* s) { s->head = 2; });
  refused([](sinew_reference_options* s) { s->torso = 2; });
  refused([](sinew_reference_options* s) { s->source_points = 2; });
  refused([](sinew_reference_options* s) { s->falloff = -2; });
  refused([](sinew_reference_options* s) { s->falloff = std::numeric_limits<float>::infinity(); });
  refused([](sinew_reference_options* s) { s->least_cosine = 2; });
  refused([](sinew_reference_options* s) { s->least_cosine = std::numeric_limits<float>::quiet_NaN(); });
  BoxBody broken = bodies.b;
  broken.joints[5] = 17;
  EXPECT_EQ(clip.reference_points(bodies.a, broken), SINEW_ERROR_RANGE);
  broken = bodies.b;
  broken.triangles[7] = 99999;
  EXPECT_EQ(clip.reference_points(bodies.a, broken), SINEW_ERROR_INDEX);
  clip.from_rotations[30] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(clip.reference_points(bodies.a, bodies.b), SINEW_ERROR_NOT_FINITE);
  clip.from_rotations[30] = 0;
  EXPECT_EQ(clip.rotations, before);
  int calls = 0;
  sinew_reference_options settings = SINEW_INIT(sinew_reference_options);
  settings.progress_user = &calls;
  settings.progress = [](void* user, uint32_t) { return ++*static_cast<int*>(user) == 2 ? 1 : 0; };
  EXPECT_EQ(clip.reference_points(bodies.a, bodies.b, settings), SINEW_ERROR_CANCELLED);
  EXPECT_EQ(calls, 2);
  // Nothing to look at, nothing done.
  BoxBody empty = bodies.b;
  empty.triangles.clear();
  EXPECT_EQ(clip.reference_points(bodies.a, empty), SINEW_OK);
}

}  // namespace
