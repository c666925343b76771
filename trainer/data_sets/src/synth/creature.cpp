// SPDX-License-Identifier: MIT
// Creatures of every proportion for skeleton prediction: a few joints drawn freely around a body plan, every bone a
// capsule from its joint to the next, both sides alike.
// Draws stand in statements of their own: arguments of a call are evaluated in any order.
#include <algorithm>
#include <utility>

#include "synth/blueprint.hpp"
#include "synth/sketch.hpp"

namespace sinew::synth {
namespace {

Body dinosaur(Sketch* s) {
  const bool upright = s->chance(0.3);
  const Point direction = unit(s->about_plane({0, upright ? 1.0 : s->range(-0.15, 0.5), upright ? 0.25 : 1.0}, 0.06));
  const double height = s->range(0.35, 1.2), radius = s->range(0.15, 0.4);
  const auto trunk_spines = s->integer(1, 4);
  const auto trunk_length = s->range(0.2, upright ? 0.35 : 0.45);
  const auto trunk_first = s->range(0.1, 0.3);
  Body body = make_trunk(s, height, radius, direction, trunk_first, trunk_length, trunk_spines);
  const auto legs_forward = s->range(-0.1, 0.5);
  const auto legs_radius = s->range(0.07, 0.2);
  const auto legs_spread = s->range(-0.02, 0.2);
  const auto legs_names = hind_leg(s->integer(3, 4));
  const Point legs_hip = {radius * s->range(0.5, 0.9), height - 0.03, -0.05};
  legs(s, legs_hip, body.trunk[0], legs_names, legs_spread, height * 0.92, legs_radius, legs_forward);
  if (s->chance(0.92)) {
    const auto arms_down = s->range(0.3, 2.0);
    const auto arms_length = s->range(0.1, 0.35);
    const auto arms_width = radius * s->range(0.5, 0.9);
    const auto arms_shoulder = body.top - Point{0, s->range(0.05, 0.2), upright ? 0.0 : 0.1};
    arms(s, arms_shoulder, body.chest(), arms_width, arms_length, arms_down);
  }
  const auto head_radius = s->range(0.15, 0.45);
  const Point head_direction = {0, s->range(0.2, 1.2), 1};
  const auto head_neck_length = s->range(0.08, 0.4);
  const auto head_necks = s->integer(0, 3);
  head(s, &body, head_necks, head_neck_length, head_direction, head_radius, 0.15);
  if (s->chance(0.95)) {
    const auto tail_length = s->range(0.15, 0.5);
    const auto tail_thickness = radius * s->range(0.3, 0.95);
    const auto tail_joints = s->integer(1, 6);
    any_tail(s, body, tail_joints, tail_thickness, tail_length);
  }
  return body;
}

Body beast(Sketch* s) {
  const Point direction = unit(s->about_plane({0, s->range(-0.15, 0.35), 1}, 0.06));
  const double height = s->range(0.25, 1.2), radius = s->range(0.13, 0.4);
  const auto trunk_spines = s->integer(1, 4);
  const auto trunk_length = s->range(0.15, 0.5);
  const auto trunk_first = s->range(0.1, 0.3);
  Body body = make_trunk(s, height, radius, direction, trunk_first, trunk_length, trunk_spines);
  const auto legs_forward = s->range(-0.1, 0.5);
  const auto legs_radius = s->range(0.05, 0.2);
  const auto legs_spread = s->range(-0.02, 0.2);
  const auto legs_names = hind_leg(s->integer(2, 4));
  const Point legs_hip = {radius * s->range(0.5, 0.9), height - 0.03, -0.05};
  legs(s, legs_hip, body.trunk[0], legs_names, legs_spread, height * 0.92, legs_radius, legs_forward);
  const double shoulder = body.top.y - s->range(0, 0.1);
  const Point front = {radius * s->range(0.4, 0.8), shoulder, body.top.z - s->range(0, 0.15)};
  const double front_height = std::max(0.2, shoulder * 0.92), front_radius = s->range(0.05, 0.17);
  const double spread = s->range(-0.02, 0.2), forward = s->range(-0.3, 0.2);
  int parent = body.chest();
  std::vector<std::string> names = {"upper_arm", "forearm", "hand"};
  if (s->chance(0.2)) names.pop_back();
  if (s->chance(0.25)) {
    s->both_sides([&] {
      const int blade = s->add("shoulder", parent, front + Point{-front.x * 0.4, 0.05, 0}, front_radius);
      const auto chain_r1 = front_radius * s->range(0.4, 0.8);
      const std::vector<Point> chain_directions = {s->about({spread, -1, forward}, 0.1),
                                                   s->about({0, -1, -forward * 0.6}, 0.1)};
      s->chain(names, front, blade, chain_directions, {front_height * 0.5, front_height * 0.45, front_height * 0.15},
               front_radius, chain_r1);
    });
  } else {
    legs(s, front, parent, names, spread, front_height, front_radius, forward);
  }
  const auto head_radius = s->range(0.13, 0.45);
  const Point head_direction = {0, s->range(0.2, 1.5), 1};
  const auto head_neck_length = s->range(0.08, 0.45);
  const auto head_necks = s->integer(0, 3);
  head(s, &body, head_necks, head_neck_length, head_direction, head_radius, 0.5);
  const int tails = s->integer(0, 5);
  if (tails > 0) {
    const auto tail_length = s->range(0.08, 0.45);
    const auto tail_thickness = radius * s->range(0.15, 0.7);
    any_tail(s, body, tails, tail_thickness, tail_length);
  }
  return body;
}

Body toy(Sketch* s) {
  const double height = s->range(0.25, 1.1), radius = s->range(0.13, 0.35);
  const Point up = unit(s->about_plane({0, 1, s->range(-0.1, 0.3)}, 0.06));
  const auto trunk_spines = s->integer(1, 4);
  const auto trunk_length = s->range(0.12, 0.35);
  const auto trunk_first = s->range(0.08, 0.2);
  Body body = make_trunk(s, height, radius, up, trunk_first, trunk_length, trunk_spines);
  const auto legs_forward = s->range(-0.1, 0.25);
  const auto legs_radius = s->range(0.06, 0.18);
  const auto legs_spread = s->range(-0.05, 0.25);
  const auto legs_names = hind_leg(s->integer(2, 4));
  const Point legs_hip = {radius * s->range(0.4, 0.8), height - 0.05, 0};
  legs(s, legs_hip, body.trunk[0], legs_names, legs_spread, height * 0.9, legs_radius, legs_forward);
  const auto arms_down = s->range(-0.1, 1.5);
  const auto arms_length = s->range(0.2, 0.5);
  const auto arms_width = radius * s->range(0.7, 1.1);
  const auto arms_shoulder = body.top - Point{0, s->range(0, 0.15), 0};
  arms(s, arms_shoulder, body.chest(), arms_width, arms_length, arms_down);
  if (s->chance(0.1))
    wings(s, "wing", body.top - Point{0, 0.05, radius * 0.6}, body.chest(), radius * 0.4, 0.3, {1, 0.4, -0.5});
  const auto head_radius = s->range(0.12, 0.5);
  const auto head_neck_length = s->range(0.05, 0.2);
  const auto head_necks = s->integer(0, 2);
  head(s, &body, head_necks, head_neck_length, {0, 1, 0.1}, head_radius, 0.25);
  if (s->chance(0.2)) {
    const auto tail_length = s->range(0.1, 0.4);
    const auto tail_thickness = radius * s->range(0.2, 0.6);
    const auto tail_joints = s->integer(1, 5);
    any_tail(s, body, tail_joints, tail_thickness, tail_length);
  }
  return body;
}

Body blob(Sketch* s) {
  const double leg = s->range(0.08, 0.35), radius = s->range(0.25, 0.5), height = leg + radius * s->range(0.5, 1.0);
  const Point up = unit(s->about_plane({0, 1, s->range(-0.1, 0.4)}, 0.06));
  const auto trunk_spines = s->integer(0, 2);
  const auto trunk_length = s->range(0.1, 0.25);
  const auto trunk_first = s->range(0.08, 0.25);
  Body body = make_trunk(s, height, radius, up, trunk_first, trunk_length, trunk_spines);
  const auto legs_forward = s->range(-0.1, 0.2);
  const auto legs_radius = s->range(0.06, 0.18);
  const auto legs_height = leg * s->range(0.8, 1.1);
  const auto legs_spread = s->range(-0.05, 0.25);
  const auto legs_names = hind_leg(s->integer(2, 3));
  const Point legs_hip = {radius * s->range(0.35, 0.7), height - radius * s->range(0.3, 0.7), 0};
  legs(s, legs_hip, body.trunk[0], legs_names, legs_spread, legs_height, legs_radius, legs_forward, 2);
  if (s->chance(0.7)) {
    const auto arms_down = s->range(-0.6, 1.5);
    const auto arms_length = s->range(0.1, 0.35);
    const auto arms_width = radius * s->range(0.8, 1.1);
    const auto arms_shoulder = body.top - Point{0, s->range(0, 0.2), 0};
    arms(s, arms_shoulder, body.chest(), arms_width, arms_length, arms_down);
  }
  if (s->chance(0.2))
    wings(s, "wing", body.top - Point{0, 0.05, radius * 0.6}, body.chest(), radius * 0.4, s->range(0.15, 0.4),
          {1, 0.5, -0.4});
  const auto head_radius = radius * s->range(0.6, 1.3);
  const auto head_neck_length = s->range(0.05, 0.12);
  const auto head_necks = s->chance(0.2) ? 1 : 0;
  head(s, &body, head_necks, head_neck_length, {0, 1, 0.2}, head_radius, 0.4);
  if (s->chance(0.3)) {
    const auto tail_length = s->range(0.08, 0.3);
    const auto tail_thickness = radius * s->range(0.15, 0.5);
    const auto tail_joints = s->integer(1, 4);
    any_tail(s, body, tail_joints, tail_thickness, tail_length);
  }
  return body;
}

Body fowl(Sketch* s) {
  const double height = s->range(0.25, 1.1), radius = s->range(0.15, 0.4);
  const Point up = unit(s->about_plane({0, 1, s->range(0.2, 2.5)}, 0.06));
  const auto trunk_spines = s->integer(1, 3);
  const auto trunk_length = s->range(0.12, 0.3);
  const auto trunk_first = s->range(0.08, 0.2);
  Body body = make_trunk(s, height, radius, up, trunk_first, trunk_length, trunk_spines);
  const auto legs_forward = s->range(-0.2, 0.4);
  const auto legs_radius = s->range(0.04, 0.13);
  const auto legs_spread = s->range(-0.05, 0.15);
  const auto legs_names = hind_leg(s->integer(2, 4));
  const Point legs_hip = {radius * s->range(0.4, 0.8), height - radius * 0.4, 0};
  legs(s, legs_hip, body.trunk[0], legs_names, legs_spread, height * 0.9 - radius * 0.4, legs_radius, legs_forward);
  const Point out = {1, s->range(-0.9, 0.6), s->range(-0.6, 0.0)};
  const auto wings_length = s->range(0.15, 0.5);
  const auto wings_width = radius * s->range(0.5, 0.9);
  wings(s, "wing", body.top - Point{0, 0.05, 0}, body.chest(), wings_width, wings_length, out);
  const auto head_radius = s->range(0.1, 0.4);
  const Point head_direction = {0, 1, s->range(0.0, 0.8)};
  const auto head_neck_length = s->range(0.05, 0.3);
  const auto head_necks = s->integer(0, 3);
  head(s, &body, head_necks, head_neck_length, head_direction, head_radius, 0.1);
  if (s->chance(0.7)) {
    const auto tail_length = s->range(0.1, 0.3);
    const auto tail_thickness = radius * s->range(0.2, 0.7);
    const auto tail_joints = s->integer(1, 3);
    any_tail(s, body, tail_joints, tail_thickness, tail_length);
  }
  return body;
}

Body fish(Sketch* s) {
  const double radius = s->range(0.15, 0.4), height = radius * s->range(1.0, 1.6);
  const Point direction = unit(s->about_plane({0, s->range(-0.1, 0.15), 1}, 0.05));
  const auto trunk_spines = s->integer(1, 4);
  const auto trunk_length = s->range(0.12, 0.4);
  const auto trunk_first = s->range(0.1, 0.3);
  Body body = make_trunk(s, height, radius, direction, trunk_first, trunk_length, trunk_spines);
  const double wide = radius * s->range(0.5, 0.8);
  const size_t past_trunk = s->nodes.size();
  const double thin = s->range(0.45, 1.2);
  for (size_t i = 1; i < past_trunk; ++i) s->nodes[i].scale.x = thin;
  const std::string fin = s->chance(0.5) ? "flipper" : "fin";
  if (s->chance(0.8)) {
    const Point wings_direction = {1, s->range(-0.6, 0.3), -0.4};
    const auto wings_length = s->range(0.1, 0.35);
    wings(s, fin, s->at(body.trunk[1]), body.trunk[1], wide * thin, wings_length, wings_direction);
  }
  if (s->chance(0.3))
    wings(s, "back_" + fin, s->at(body.trunk[0]), body.trunk[0], wide * thin, s->range(0.08, 0.2), {1, -0.4, -0.6});
  // The tail ends in a fin, upright as a fish's or flat as a whale's.
  const int joints = s->integer(1, 5);
  const Point lift = s->about_plane({0, 0.1, -1}, 0.1);
  const auto tail_length = s->range(0.12, 0.35);
  const auto tail_thickness = radius * s->range(0.4, 0.9);
  tail(s, body, joints, tail_thickness, tail_length, lift, lift);
  if (s->chance(0.75)) {
    Node& end = s->nodes.back();
    end.radius = radius * s->range(0.5, 1.0);
    end.scale = s->chance(0.7) ? Point{0.2, 1, 1} : Point{1, 0.2, 1};
    end.start_share = 0.5;
  }
  const auto head_radius = radius * s->range(0.6, 1.1);
  const auto head_neck_length = s->range(0.05, 0.2);
  const auto head_necks = s->chance(0.2) ? 1 : 0;
  head(s, &body, head_necks, head_neck_length, {0, 0.1, 1}, head_radius, 0);
  return body;
}

Body crawler(Sketch* s) {
  const double height = s->range(0.2, 0.7), radius = s->range(0.12, 0.4);
  const Point direction = unit(s->about_plane({0, s->range(-0.1, 0.3), 1}, 0.05));
  const auto trunk_spines = s->integer(1, 3);
  const auto trunk_length = s->range(0.12, 0.35);
  const auto trunk_first = s->range(0.1, 0.3);
  Body body = make_trunk(s, height, radius, direction, trunk_first, trunk_length, trunk_spines);
  const double length = body.top.z, spread = s->range(0.4, 2.0);
  const int pairs = s->integer(1, 4), joints = s->integer(2, 3);
  const double radius_of_legs = s->range(0.04, 0.11), fan = s->range(0.1, 0.6);
  for (int pair = 0; pair < pairs; ++pair) {
    const double t = pairs > 1 ? static_cast<double>(pair) / (pairs - 1) : 0.0;
    const size_t bone = static_cast<size_t>(t * static_cast<double>(body.trunk.size()) * 0.8);
    const Point hip = {radius * 0.8, height, mix(-0.2, length * 0.7, t)};
    legs(s, hip, body.trunk[std::min(bone, body.trunk.size() - 1)], with_number(hind_leg(joints), pair + 1), spread,
         height * 1.1, radius_of_legs, mix(-fan, fan, t), 0.8);
  }
  const Point front = {0, height, body.top.z - 0.05};
  if (s->chance(0.5)) {  // claws
    const auto arms_end = s->range(1.2, 2.2);
    const auto arms_forward = s->range(0.8, 2.5);
    const auto arms_down = s->range(-0.3, 0.4);
    const auto arms_length = s->range(0.2, 0.45);
    arms(s, front, body.chest(), radius * 0.8, arms_length, arms_down, arms_forward, arms_end);
  } else {
    std::vector<std::string> names = {"upper_arm", "forearm", "hand"};
    names.resize(static_cast<size_t>(joints));
    legs(s, front + Point{radius * 0.8, 0, 0}, body.chest(), names, spread, height * 1.1, radius_of_legs,
         s->range(0.0, 0.7), 0.8);
  }
  if (s->chance(0.8)) head(s, &body, 0, 0.1, {0, 0.1, 1}, radius * s->range(0.4, 0.9), 0.15);
  if (s->chance(0.5)) {
    const auto tail_length = s->range(0.1, 0.4);
    const auto tail_thickness = radius * s->range(0.2, 0.7);
    const auto tail_joints = s->integer(1, 5);
    any_tail(s, body, tail_joints, tail_thickness, tail_length);
  }
  return body;
}

Body sketch(BodyPlan plan, Sketch* s) {
  switch (plan) {
    case BodyPlan::kDinosaur:
      return dinosaur(s);
    case BodyPlan::kFish:
      return fish(s);
    case BodyPlan::kBlob:
      return blob(s);
    case BodyPlan::kBeast:
      return beast(s);
    case BodyPlan::kToy:
      return toy(s);
    case BodyPlan::kFowl:
      return fowl(s);
    case BodyPlan::kMascot:
      return mascot(s);
    default:
      return crawler(s);
  }
}

// The bone that ends at a node, as its parent's primitive.
Primitive bone_of(const std::vector<Node>& nodes, const Node& end, int joint) {
  const Node& start = nodes[static_cast<size_t>(end.parent)];
  Primitive bone = {joint, start.at, end.at, start.radius * end.start_share, end.radius * end.end_share, end.scale};
  // From the torso to a limb: no wider than the limb needs.
  if (Sketch::on_plane(start.at) && !Sketch::on_plane(end.at)) bone.ra = std::min(bone.ra, bone.rb * 1.5);
  return bone;
}

// Moves the body onto the floor and sets the cell by its longest side. What a smooth body is made of must not be
// thinner than the voxels show.
void set_on_floor(int resolution, Blueprint* made) {
  Point low = made->body[0].a, high = low;
  for (const Primitive& bone : made->body) {
    for (const auto& [end, r] : {std::pair(bone.a, bone.ra), std::pair(bone.b, bone.rb)}) {
      const Point reach = bone.scale * r;
      low = {std::min(low.x, end.x - reach.x), std::min(low.y, end.y - reach.y), std::min(low.z, end.z - reach.z)};
      high = {std::max(high.x, end.x + reach.x), std::max(high.y, end.y + reach.y), std::max(high.z, end.z + reach.z)};
    }
  }
  const Point size = high - low, up = {0, -low.y, 0};
  made->cell = std::max({size.x, size.y, size.z}) / resolution;
  for (PlanJoint& joint : made->joints) {
    joint.position = joint.position + up;
    joint.tip = joint.tip + up;
  }
  for (Primitive& bone : made->body) {
    bone.a = bone.a + up;
    bone.b = bone.b + up;
    const double thinnest = 1.05 * made->cell;
    bone.ra = std::max(bone.ra, thinnest);
    bone.rb = std::max(bone.rb, thinnest);
    const double flattest = thinnest / std::min(bone.ra, bone.rb);
    for (double* s : {&bone.scale.x, &bone.scale.y, &bone.scale.z}) *s = std::max(*s, flattest);
  }
  made->head_center = made->head_center + up;
}

}  // namespace

Blueprint make_creature(BodyPlan plan, int resolution, Random* random) {
  Sketch drawn(random);
  const Body body = sketch(plan, &drawn);
  Blueprint made;
  made.softness = random->range(0.35, 0.8);
  made.blend = random->range(0.2, 0.6);
  const double build = random->range(0, 1);
  made.build = build < 0.45 ? Build::kCapsules : build < 0.75 ? Build::kSmooth : Build::kBoxes;

  // Half of them are stretched along the axes, joints and capsules alike.
  Point stretch = {1, 1, 1};
  if (random->chance(0.5)) {
    stretch.x = exponential(random->normal() * 0.15);
    stretch.y = exponential(random->normal() * 0.15);
    stretch.z = exponential(random->normal() * 0.15);
  }
  const auto stretched = [&](Point p) { return Point{p.x * stretch.x, p.y * stretch.y, p.z * stretch.z}; };

  std::vector<int> joint_of(drawn.nodes.size(), kNoJoint);
  for (size_t n = 0; n < drawn.nodes.size(); ++n) {
    const Node& node = drawn.nodes[n];
    const int parent = node.parent == kNoJoint ? kNoJoint : joint_of[static_cast<size_t>(node.parent)];
    if (!node.tip) joint_of[n] = made.add_joint(node.name, parent, stretched(node.at));
    if (node.parent == kNoJoint) continue;
    const Primitive bone = bone_of(drawn.nodes, node, parent);
    made.add_bone(parent, stretched(bone.a), stretched(bone.b), bone.ra, bone.rb, stretched(bone.scale));
  }
  for (const int node : body.trunk) made.trunk.push_back(joint_of[static_cast<size_t>(node)]);
  const size_t head = static_cast<size_t>(body.head == kNoJoint ? body.chest() : body.head);
  made.head = made.neck = joint_of[head];
  made.head_center = stretched(drawn.nodes[head].at);
  made.head_radius = drawn.nodes[head].radius * 0.9 * std::min(stretch.x, stretch.z);
  set_on_floor(resolution, &made);
  return made;
}

}  // namespace sinew::synth
