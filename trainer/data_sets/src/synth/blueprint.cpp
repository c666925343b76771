// SPDX-License-Identifier: MIT
// Body plans of generated characters: biped, quadruped, bird, snake and many-legged, with seeded proportions.
#include "synth/blueprint.hpp"

#include <algorithm>

namespace sinew::synth {
namespace {

const char* const kSides[2] = {".L", ".R"};

Point mirrored(Point p, int side) { return side == 0 ? p : Point{-p.x, p.y, p.z}; }

// Radii under the voxel size would tear the mesh apart.
double thick(const Blueprint& plan, double radius) { return std::max(radius, 1.05 * plan.cell); }

int floor_root(Blueprint* plan, Random* random) {
  return random->chance(0.5) ? plan->add_joint("root", kNoJoint, {0, 0, 0}) : kNoJoint;
}

// A chain of joints along given points: joint i stands at points[i], its bone ends at points[i + 1].
std::vector<int> chain(Blueprint* plan, const std::string& name, const std::string& side, int parent,
                       const std::vector<Point>& points, double r0, double r1, Point scale = {1, 1, 1}) {
  std::vector<int> made;
  const size_t bones = points.size() - 1;
  for (size_t i = 0; i < bones; ++i) {
    const std::string number = bones > 1 ? "_" + std::to_string(i + 1) : "";
    const int joint = plan->add_joint(name + number + side, parent, points[i]);
    const double t0 = static_cast<double>(i) / static_cast<double>(bones);
    const double t1 = static_cast<double>(i + 1) / static_cast<double>(bones);
    plan->add_bone(joint, points[i], points[i + 1], thick(*plan, mix(r0, r1, t0)), thick(*plan, mix(r0, r1, t1)),
                   scale);
    made.push_back(joint);
    parent = joint;
  }
  return made;
}

// Random numbers of a biped, in the order of its draws.
struct BipedSizes {
  double leg, torso, girth, head, neck_length, hip_half, shoulder_half, waist, chest_radius;
  double thigh_radius, ankle_radius, arm_radius, wrist_radius;

  explicit BipedSizes(Random* random) {
    leg = random->range(0.55, 0.95), torso = random->range(0.42, 0.62), girth = random->range(0.8, 1.5);
    head = random->range(0.11, 0.21), neck_length = random->range(0.05, 0.12);
    hip_half = random->range(0.09, 0.13) * girth, shoulder_half = random->range(0.15, 0.22) * girth;
    waist = random->range(0.105, 0.135) * girth, chest_radius = waist * random->range(1.0, 1.25);
    thigh_radius = random->range(0.065, 0.085) * girth, ankle_radius = thigh_radius * random->range(0.5, 0.75);
    arm_radius = thigh_radius * random->range(0.6, 0.8), wrist_radius = arm_radius * random->range(0.65, 0.9);
  }
};
struct BipedLimbs {
  bool clavicles, toes, fingers;
  double droop, arm, hand, forward, spread;

  BipedLimbs(const Blueprint& plan, Random* random) {
    clavicles = random->chance(0.7), toes = random->chance(0.5), fingers = plan.cell < 0.032 && random->chance(0.6);
    droop = random->range(0.0, 0.95), arm = random->range(0.46, 0.62), hand = random->range(0.07, 0.1);
    forward = random->range(0.0, 0.12), spread = random->range(0.0, 0.16);
  }
};

// Returns the points of the spine, from the hips to the neck.
std::vector<Point> biped_trunk(Blueprint* plan, const BipedSizes& of, Random* random) {
  const Point flat = {1.25, 1, 0.9};
  const int root = floor_root(plan, random);
  const int spine_count = random->integer(2, 4);
  std::vector<Point> spine;
  for (int i = 0; i <= spine_count; ++i) {
    const double t = static_cast<double>(i) / spine_count;
    spine.push_back({0, of.leg + of.torso * t, -0.05 * sine(kPi * t)});
  }
  int parent = root;
  for (int i = 0; i < spine_count; ++i) {
    const std::string name = i == 0 ? "hips" : i == spine_count - 1 ? "chest" : "spine_" + std::to_string(i);
    parent = plan->add_joint(name, parent, spine[static_cast<size_t>(i)]);
    const double t0 = static_cast<double>(i) / spine_count, t1 = (i + 1.0) / spine_count;
    const double r0 = mix(of.waist, of.chest_radius, t0),
                 r1 = mix(of.waist, of.chest_radius, t1) * (i == spine_count - 1 ? 0.8 : 1.0);
    const Point top = i == spine_count - 1 ? spine.back() - Point{0, 0.5 * r1, 0} : spine[static_cast<size_t>(i) + 1];
    plan->add_bone(parent, spine[static_cast<size_t>(i)], top, r0, r1, flat);
    plan->trunk.push_back(parent);
  }
  plan->body.push_back({plan->trunk.front(),
                        {-of.hip_half * 0.7, of.leg, 0},
                        {of.hip_half * 0.7, of.leg, 0},
                        of.waist * 0.95,
                        of.waist * 0.95,
                        {1, 1, 1}});
  return spine;
}

void biped_head(Blueprint* plan, const BipedSizes& of, const Point& neck) {
  const double head = of.head;
  const Point skull = neck + Point{0, of.neck_length, 0.01};
  plan->neck = plan->add_joint("neck", plan->trunk.back(), neck);
  plan->add_bone(plan->neck, neck, skull, thick(*plan, head * 0.5), thick(*plan, head * 0.45));
  plan->head = plan->add_joint("head", plan->neck, skull);
  plan->head_center = skull + Point{0, head * 0.9, 0.02};
  plan->head_radius = head;
  plan->add_bone(plan->head, skull + Point{0, head * 0.75, 0.02}, skull + Point{0, head * 1.1, 0.02}, head * 0.92, head,
                 {0.95, 1.05, 1});
}

// Three thick fingers and a thumb, as far apart as the voxels need.
void biped_fingers(Blueprint* plan, int palm_joint, const Point& wrist, const Point& palm, const Point& bent,
                   int side) {
  const std::string suffix = kSides[side];
  const double gap = 3.4 * plan->cell;
  for (int f = 0; f < 3; ++f) {
    const Point base = palm + Point{0, 0, gap * (1 - f)};
    const Point out = unit(bent + Point{0, 0, 0.25 * (1 - f)});
    chain(plan, "finger_" + std::to_string(f + 1), suffix, palm_joint,
          {mirrored(base, side), mirrored(base + out * 0.07, side), mirrored(base + out * 0.14, side)},
          1.1 * plan->cell, plan->cell);
  }
  const Point base = mix(wrist, palm, 0.4) + Point{0, 0, 0.5 * gap};
  chain(plan, "thumb", suffix, palm_joint,
        {mirrored(base, side), mirrored(base + unit(bent + Point{0, 0, 2.0}) * 0.13, side)}, 1.1 * plan->cell,
        plan->cell);
}

void biped_arm(Blueprint* plan, const BipedSizes& of, const BipedLimbs& limbs, const Point& neck, int side) {
  const std::string suffix = kSides[side];
  const double arm_radius = of.arm_radius, wrist_radius = of.wrist_radius;
  const Point along = unit({cosine(limbs.droop), -sine(limbs.droop), 0.0});
  const Point bent = unit(along + Point{0, 0, limbs.forward});
  const Point shoulder = neck + Point{of.shoulder_half, -0.06, 0}, elbow = shoulder + along * (limbs.arm * 0.52);
  const Point wrist = elbow + bent * (limbs.arm * 0.48), palm = wrist + bent * limbs.hand;
  int up = plan->trunk.back();
  if (limbs.clavicles) {
    const Point inner = neck + Point{0.03, -0.04, 0};
    up = plan->add_joint("shoulder" + suffix, up, mirrored(inner, side));
    plan->add_bone(up, mirrored(mix(inner, shoulder, 0.6), side), mirrored(shoulder, side),
                   thick(*plan, arm_radius * 1.15), thick(*plan, arm_radius * 1.15));
  }
  const int upper = plan->add_joint("upper_arm" + suffix, up, mirrored(shoulder, side));
  plan->add_bone(upper, mirrored(shoulder, side), mirrored(elbow, side), thick(*plan, arm_radius * 1.1),
                 thick(*plan, arm_radius * 0.9));
  const int fore = plan->add_joint("forearm" + suffix, upper, mirrored(elbow, side));
  plan->add_bone(fore, mirrored(elbow, side), mirrored(wrist, side), thick(*plan, arm_radius * 0.92),
                 thick(*plan, wrist_radius));
  const int palm_joint = plan->add_joint("hand" + suffix, fore, mirrored(wrist, side));
  plan->add_bone(palm_joint, mirrored(wrist, side), mirrored(palm, side), thick(*plan, wrist_radius * 1.05),
                 thick(*plan, wrist_radius * 1.25), {1, 0.9, 1.2});
  if (limbs.fingers) biped_fingers(plan, palm_joint, wrist, palm, bent, side);
  Limb limb;
  limb.joints = {upper, fore, palm_joint};
  plan->arms.push_back(limb);
}

void biped_leg(Blueprint* plan, const BipedSizes& of, const BipedLimbs& limbs, int side, Random* random) {
  const std::string suffix = kSides[side];
  const double thigh_radius = of.thigh_radius, ankle_radius = of.ankle_radius;
  const Point hip = {of.hip_half, of.leg * 0.97, 0}, ankle = {of.hip_half + limbs.spread, 0.08, -0.02};
  const Point knee = mix(hip, ankle, 0.5) + Point{0, 0, 0.025};
  const double foot = random->range(0.15, 0.17);
  const Point ball = {ankle.x + 0.02, thick(*plan, ankle_radius), foot * 0.55}, tip = ball + Point{0, 0, foot * 0.5};
  const int thigh = plan->add_joint("thigh" + suffix, plan->trunk.front(), mirrored(hip, side));
  plan->add_bone(thigh, mirrored(hip, side), mirrored(knee, side), thigh_radius, thick(*plan, thigh_radius * 0.8));
  const int shin = plan->add_joint("shin" + suffix, thigh, mirrored(knee, side));
  plan->add_bone(shin, mirrored(knee, side), mirrored(ankle, side), thick(*plan, thigh_radius * 0.82),
                 thick(*plan, ankle_radius));
  const int foot_joint = plan->add_joint("foot" + suffix, shin, mirrored(ankle, side));
  plan->add_bone(foot_joint, mirrored(ankle, side), mirrored(limbs.toes ? ball : mix(ball, tip, 0.7), side),
                 thick(*plan, ankle_radius * 1.05), thick(*plan, ankle_radius));
  Limb lower;
  lower.joints = {thigh, shin, foot_joint};
  if (limbs.toes) {
    const int toe = plan->add_joint("toe" + suffix, foot_joint, mirrored(ball, side));
    plan->add_bone(toe, mirrored(ball, side), mirrored(tip, side), thick(*plan, ankle_radius),
                   thick(*plan, ankle_radius * 0.9));
    lower.joints.push_back(toe);
  }
  plan->legs.push_back(lower);
}

void biped(Blueprint* plan, Random* random) {
  const BipedSizes sizes(random);
  const std::vector<Point> spine = biped_trunk(plan, sizes, random);
  biped_head(plan, sizes, spine.back());
  const BipedLimbs limbs(*plan, random);
  for (int side = 0; side < 2; ++side) {
    biped_arm(plan, sizes, limbs, spine.back(), side);
    biped_leg(plan, sizes, limbs, side, random);
  }
  if (random->chance(0.25)) {
    const Point start = spine[0] + Point{0, 0, -sizes.waist * 0.8};
    chain(plan, "tail", "", plan->trunk.front(),
          {start, start + Point{0, -0.1, -0.16}, start + Point{0, -0.14, -0.32}, start + Point{0, -0.1, -0.48}}, 0.055,
          0.03);
  }
}

void quadruped(Blueprint* plan, Random* random) {
  const double leg = random->range(0.4, 0.8), body = random->range(0.7, 1.1), girth = random->range(0.13, 0.2);
  const double neck_length = random->range(0.15, 0.45), head = random->range(0.09, 0.15);
  const double height = leg + girth * 0.4;
  const int root = floor_root(plan, random);
  const int spine_count = random->integer(3, 5);
  int parent = root;
  for (int i = 0; i < spine_count; ++i) {
    const double t0 = static_cast<double>(i) / spine_count, t1 = (i + 1.0) / spine_count;
    const Point a = {0, height + 0.03 * sine(kPi * t0), mix(-body / 2, body / 2, t0)};
    const Point b = {0, height + 0.03 * sine(kPi * t1), mix(-body / 2, body / 2, t1)};
    parent = plan->add_joint(i == 0                 ? "hips"
                             : i == spine_count - 1 ? "chest"
                                                    : "spine_" + std::to_string(i),
                             parent, a);
    plan->add_bone(parent, a, b, girth * (i == 0 ? 0.9 : 1.0), girth * (i == spine_count - 1 ? 1.1 : 1.0),
                   {0.9, 1.1, 1});
    plan->trunk.push_back(parent);
  }
  const int hips = plan->trunk.front(), chest = plan->trunk.back();
  const Point throat = {0, height + girth * 0.4, body / 2 + girth * 0.3};
  const Point skull = throat + unit({0, random->range(0.5, 1.6), 1.0}) * neck_length;
  const int neck_bones = neck_length > 0.3 ? 2 : 1;
  std::vector<Point> neck_points = {throat, skull};
  if (neck_bones == 2) neck_points.insert(neck_points.begin() + 1, mix(throat, skull, 0.5));
  const std::vector<int> neck = chain(plan, "neck", "", chest, neck_points, girth * 0.75, head * 0.7);
  plan->neck = neck.back();
  plan->head = plan->add_joint("head", plan->neck, skull);
  const double snout = random->range(0.14, 0.28);
  plan->add_bone(plan->head, skull, skull + Point{0, -0.06, snout}, head, thick(*plan, head * 0.6));
  plan->head_center = skull;
  plan->head_radius = head;
  if (random->chance(0.5)) {
    const int jaw = plan->add_joint("jaw", plan->head, skull + Point{0, -head * 0.6, head * 0.3});
    plan->add_bone(jaw, plan->at(jaw), skull + Point{0, -0.06 - head * 0.55, snout * 0.9}, thick(*plan, head * 0.42),
                   thick(*plan, head * 0.38));
  }
  for (int side = 0; side < 2; ++side) {
    const Point base = skull + Point{head * 0.6, head * 0.6, -head * 0.2};
    chain(plan, "ear", kSides[side], plan->head,
          {mirrored(base, side), mirrored(base + Point{head * 0.35, head * random->range(0.9, 0.91), -0.01}, side)},
          head * 0.35, head * 0.2);
  }
  const int tail_bones = random->integer(2, 5);
  const double tail_length = random->range(0.25, 0.7), lift = random->range(-0.6, 0.6);
  std::vector<Point> tail;
  for (int i = 0; i <= tail_bones; ++i) {
    const double t = static_cast<double>(i) / tail_bones;
    tail.push_back(
        Point{0, height + girth * 0.4 + lift * tail_length * t * t, -body / 2 - girth * 0.6 - tail_length * t});
  }
  chain(plan, "tail", "", hips, tail, girth * 0.4, girth * random->range(0.15, 0.35));

  const double hoof = random->range(0.04, 0.06), hip_half = girth * 0.62;
  const bool long_foot = random->chance(0.6);
  for (int pair = 0; pair < 2; ++pair) {
    const double z = pair == 0 ? body / 2 - 0.02 : -body / 2 + 0.04, bend = pair == 0 ? -0.05 : 0.06;
    for (int side = 0; side < 2; ++side) {
      const std::string suffix = std::string(pair == 0 ? "_front" : "_back") + kSides[side];
      const Point top = {hip_half, leg * 0.95, z}, knee = {hip_half + 0.01, leg * 0.52, z + bend};
      const Point ankle = {hip_half + 0.01, leg * 0.2, z - bend * 0.6}, sole = {hip_half + 0.01, hoof, z + 0.03};
      const int trunk = pair == 0 ? chest : hips;
      const int upper = plan->add_joint("leg_upper" + suffix, trunk, mirrored(top, side));
      plan->add_bone(upper, mirrored(top, side), mirrored(knee, side), girth * 0.55, thick(*plan, girth * 0.38));
      const int lower = plan->add_joint("leg_lower" + suffix, upper, mirrored(knee, side));
      plan->add_bone(lower, mirrored(knee, side), mirrored(ankle, side), thick(*plan, girth * 0.36),
                     thick(*plan, hoof * 0.9));
      const int foot = plan->add_joint("foot" + suffix, lower, mirrored(ankle, side));
      plan->add_bone(foot, mirrored(ankle, side), mirrored(sole + Point{0, 0, long_foot ? 0.06 : 0.0}, side),
                     thick(*plan, hoof * 0.9), thick(*plan, hoof));
      plan->legs.push_back({{upper, lower, foot}});
    }
  }
}

void bird(Blueprint* plan, Random* random) {
  const double leg = random->range(0.2, 0.5), girth = random->range(0.14, 0.2), tilt = random->range(0.2, 0.9);
  const double neck_length = random->range(0.08, 0.4), head = random->range(0.08, 0.12),
               wing = random->range(0.55, 0.9);
  const int root = floor_root(plan, random);
  const Point hip = {0, leg + girth, 0}, forward = unit({0, tilt, 1});
  const Point chest_at = hip + forward * 0.18, throat = hip + forward * 0.34;
  const int hips = plan->add_joint("hips", root, hip);
  plan->add_bone(hips, hip - forward * 0.08, chest_at, girth, girth * 1.05, {0.95, 1, 1});
  const int chest = plan->add_joint("chest", hips, chest_at);
  plan->add_bone(chest, chest_at, mix(chest_at, throat, 0.7), girth * 1.05, girth * 0.8, {0.95, 1, 1});
  plan->trunk = {hips, chest};
  const Point skull = throat + unit({0, 1.4, 0.5}) * neck_length;
  std::vector<Point> points = {throat};
  const int neck_bones = neck_length > 0.22 ? 3 : 1;
  for (int i = 1; i <= neck_bones; ++i) {
    const double t = static_cast<double>(i) / neck_bones;
    points.push_back(mix(throat, skull, t) + Point{0, 0, 0.05 * sine(kPi * t)});
  }
  plan->neck = chain(plan, "neck", "", chest, points, girth * 0.5, head * 0.7).back();
  plan->head = plan->add_joint("head", plan->neck, skull);
  plan->add_bone(plan->head, skull, skull + Point{0, 0.02, 0.06}, head, head * 0.85);
  plan->head_center = skull + Point{0, 0.01, 0.03};
  plan->head_radius = head;
  const Point rump = hip - forward * 0.12;
  const int tail_bones = random->integer(1, 2);
  std::vector<Point> tail = {rump};
  for (int i = 1; i <= tail_bones; ++i) tail.push_back(rump - forward * (0.26 * i / tail_bones));
  chain(plan, "tail", "", hips, tail, 0.05, 0.06, {2.0, 0.9, 1});
  const double fold = random->range(-0.15, 0.3), chord = random->range(1.8, 2.6);
  for (int side = 0; side < 2; ++side) {
    const std::string suffix = kSides[side];
    const Point shoulder = mix(chest_at, throat, 0.35) + Point{girth * 0.75, 0.04, 0};
    const Point elbow = shoulder + Point{wing * 0.33, wing * fold * 0.4, 0.0};
    const Point wrist = elbow + Point{wing * 0.33, wing * fold * 0.3, 0.03},
                tip = wrist + Point{wing * 0.34, wing * fold * 0.1, -0.08};
    // Wings are as thin as the voxels allow and `chord` times as deep.
    const double thin = 1.15 * plan->cell;
    const Point scale = {1, 1, chord};
    const int upper = plan->add_joint("wing_upper" + suffix, chest, mirrored(shoulder, side));
    plan->add_bone(upper, mirrored(shoulder, side), mirrored(elbow, side), thin * 1.3, thin * 1.25, scale);
    const int fore = plan->add_joint("wing_fore" + suffix, upper, mirrored(elbow, side));
    plan->add_bone(fore, mirrored(elbow, side), mirrored(wrist, side), thin * 1.25, thin * 1.15, scale);
    const int hand = plan->add_joint("wing_tip" + suffix, fore, mirrored(wrist, side));
    plan->add_bone(hand, mirrored(wrist, side), mirrored(tip, side), thin * 1.15, thin, scale);
    plan->arms.push_back({{upper, fore, hand}});
    const Point top = hip + Point{girth * 0.45, -girth * 0.5, 0}, knee = {top.x, leg * 0.6, 0.05},
                ankle = {top.x, 0.07, -0.02};
    const int thigh = plan->add_joint("thigh" + suffix, hips, mirrored(top, side));
    plan->add_bone(thigh, mirrored(top, side), mirrored(knee, side), thick(*plan, 0.06), thick(*plan, 0.035));
    const int shin = plan->add_joint("shin" + suffix, thigh, mirrored(knee, side));
    plan->add_bone(shin, mirrored(knee, side), mirrored(ankle, side), thick(*plan, 0.032), thick(*plan, 0.028));
    const int foot = plan->add_joint("foot" + suffix, shin, mirrored(ankle, side));
    plan->add_bone(foot, mirrored(ankle, side), mirrored({top.x, thick(*plan, 0.03), 0.12}, side), thick(*plan, 0.03),
                   thick(*plan, 0.03), {1.3, 1, 1});
    plan->legs.push_back({{thigh, shin, foot}});
  }
}

void snake(Blueprint* plan, Random* random) {
  const int bones = random->integer(8, 16);
  const double total = random->range(1.6, 2.2), sway = random->range(0.05, 0.16), girth = random->range(0.07, 0.1);
  const double waves = random->range(1.0, 2.0), rise = random->range(0.0, 0.35);
  const int root = floor_root(plan, random);
  auto along = [&](double t) {
    const double lift = t > 0.75 ? (t - 0.75) * 4 : 0;
    return Point{sway * sine(2 * kPi * waves * t) * (1 - 0.5 * lift), girth * 1.1 + rise * lift * lift,
                 total * (t - 0.5)};
  };
  // The root is in the middle on some seeds, as artists do; else at the tail.
  const bool middle = random->chance(0.3);
  const int start = middle ? bones / 2 : 0;
  std::vector<int> front, back;
  int parent = root;
  auto radius = [&](double t) {
    return thick(*plan, girth * (t < 0.6 ? mix(0.3, 1.0, t / 0.6) : mix(1.0, 0.7, (t - 0.6) / 0.4)));
  };
  for (int i = start; i < bones; ++i) {
    const double t0 = static_cast<double>(i) / bones, t1 = (i + 1.0) / bones;
    parent = plan->add_joint("spine_" + std::to_string(i), parent, along(t0));
    plan->add_bone(parent, along(t0), along(t1), radius(t0), radius(t1));
    plan->trunk.push_back(parent);
  }
  const int last = parent;
  parent = middle ? plan->trunk.front() : kNoJoint;
  for (int i = start - 1; i >= 0; --i) {
    const double t0 = static_cast<double>(i) / bones, t1 = (i + 1.0) / bones;
    parent = plan->add_joint("tail_" + std::to_string(start - i), parent, along(t1));
    plan->add_bone(parent, along(t1), along(t0), radius(t1), radius(t0));
  }
  const Point skull = along(1.0);
  plan->neck = last;
  plan->head = plan->add_joint("head", last, skull);
  plan->add_bone(plan->head, skull, skull + Point{0, -0.01, 0.13}, girth * 1.05, girth * 0.7, {1.25, 0.9, 1});
  plan->head_center = skull + Point{0, 0.01, 0.04};
  plan->head_radius = girth;
  if (random->chance(0.6)) {
    const int jaw = plan->add_joint("jaw", plan->head, skull + Point{0, -girth * 0.6, 0.02});
    plan->add_bone(jaw, plan->at(jaw), skull + Point{0, -girth * 0.8, 0.13}, thick(*plan, girth * 0.5),
                   thick(*plan, girth * 0.4), {1.3, 0.8, 1});
  }
}

void many_legged(Blueprint* plan, Random* random) {
  const int segments = random->integer(2, 5), pairs = random->integer(3, 5);
  const double height = random->range(0.22, 0.4), girth = random->range(0.12, 0.18),
               step = girth * random->range(1.3, 1.7);
  const double reach = random->range(0.45, 0.8);
  const int root = floor_root(plan, random);
  const double body = step * segments;
  int parent = root;
  for (int i = 0; i < segments; ++i) {
    const Point a = {0, height, -body / 2 + step * i}, b = {0, height, -body / 2 + step * (i + 1)};
    parent = plan->add_joint("body_" + std::to_string(i + 1), parent, a);
    const double r = girth * (i == 0 ? 1.2 : 0.85 + 0.05 * (i % 2));
    plan->add_bone(parent, mix(a, b, 0.15), mix(a, b, 0.85), r, r, {1.1, 0.9, 1});
    plan->trunk.push_back(parent);
  }
  const Point front = {0, height, body / 2};
  plan->neck = parent;
  plan->head = plan->add_joint("head", parent, front);
  plan->add_bone(plan->head, front + Point{0, 0.02, 0.05}, front + Point{0, 0.02, 0.14}, girth * 0.75, girth * 0.65);
  plan->head_center = front + Point{0, 0.02, 0.12};
  plan->head_radius = girth * 0.7;
  const double ankle = thick(*plan, random->range(0.025, 0.04));
  // Feet stand at least four voxels apart, or legs would grow together.
  const double spacing = std::max(body * 0.9 / pairs, 5.0 * plan->cell), fan = random->range(1.1, 1.5);
  for (int pair = 0; pair < pairs; ++pair) {
    const double z = (pair - (pairs - 1) * 0.5) * spacing;
    // Each pair hangs on the body segment beside it.
    int segment = static_cast<int>((z + body / 2) / step);
    segment = std::clamp(segment, 0, segments - 1);
    for (int side = 0; side < 2; ++side) {
      const Point hip = {girth * 0.8, height, z * 0.85},
                  knee = {girth + reach * 0.4, height + random->range(0.1, 0.11), z * fan};
      const Point foot = {girth + reach * 0.75, height * 0.35, z * fan * 1.15};
      const Point toe = {girth + reach, ankle, z * fan * 1.3};
      const std::vector<int> joints = chain(
          plan, "leg" + std::to_string(pair + 1), kSides[side], plan->trunk[static_cast<size_t>(segment)],
          {mirrored(hip, side), mirrored(knee, side), mirrored(foot, side), mirrored(toe, side)}, ankle * 1.6, ankle);
      plan->legs.push_back({joints});
    }
  }
  if (random->chance(0.5)) {
    for (int side = 0; side < 2; ++side) {
      const Point base = plan->head_center + Point{girth * 0.3, girth * 0.4, 0.05};
      chain(plan, "feeler", kSides[side], plan->head,
            {mirrored(base, side), mirrored(base + Point{0.08, 0.14, 0.12}, side),
             mirrored(base + Point{0.14, 0.17, 0.28}, side)},
            plan->cell, plan->cell);
    }
  }
  if (random->chance(0.3)) {
    const Point rear = {0, height, -body / 2 - girth * 0.6};
    chain(plan, "tail", "", plan->trunk.front(),
          {rear, rear + Point{0, 0.12, -0.2}, rear + Point{0, 0.34, -0.26}, rear + Point{0, 0.52, -0.12}}, 0.07, 0.04);
  }
}

}  // namespace

Blueprint make_blueprint(BodyPlan plan, int resolution, Random* random) {
  if (plan >= kCreaturePlans[0]) return make_creature(plan, resolution, random);
  Blueprint made;
  // About the longest side of each plan; the polygoniser measures the real one.
  const double side = plan == BodyPlan::kSnake ? 2.0 : plan == BodyPlan::kBiped ? 1.7 : 1.9;
  made.cell = side / resolution;
  made.softness = random->range(0.35, 0.8);
  made.blend = random->range(0.3, 0.6);
  switch (plan) {
    case BodyPlan::kBiped:
      biped(&made, random);
      break;
    case BodyPlan::kQuadruped:
      quadruped(&made, random);
      break;
    case BodyPlan::kBird:
      bird(&made, random);
      break;
    case BodyPlan::kSnake:
      snake(&made, random);
      break;
    case BodyPlan::kManyLegged:
      many_legged(&made, random);
      break;
    default:
      break;
  }
  return made;
}

}  // namespace sinew::synth
