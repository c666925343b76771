// SPDX-License-Identifier: MIT
// Trunks, legs, arms, wings, tails and heads.
#include "synth/sketch.hpp"

namespace sinew::synth {

std::vector<std::string> numbered(const std::string& name, int count) {
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) names.push_back(count > 1 ? name + "_" + std::to_string(i) : name);
  return names;
}

Body make_trunk(Sketch* s, double height, double radius, Point direction, double first, double length, int spines) {
  Body body = {height, radius, {}, kNoJoint, {}};
  body.trunk = {s->add("hips", kNoJoint, {0, height, 0}, radius)};
  body.top = Point{0, height, 0} + direction * first;
  if (spines > 0) {
    const std::vector<int> spine = s->chain(numbered("spine", spines), body.top, body.trunk[0], {direction}, {length},
                                            radius, radius * s->range(0.6, 1.2), false, &body.top);
    body.trunk.insert(body.trunk.end(), spine.begin(), spine.end());
  }
  return body;
}

void legs(Sketch* s, Point hip, int parent, std::vector<std::string> names, double spread, double height, double radius,
          double forward, double foot) {
  s->both_sides([&] {
    const size_t bones = names.size() - 1;
    std::vector<double> lengths;
    for (size_t i = 0; i < bones; ++i) lengths.push_back(height / static_cast<double>(bones) * s->factor(0.15));
    lengths.push_back(height * s->range(0.12, 0.35) * foot);
    std::vector<Point> directions = {s->about({spread, -1, forward}, 0.1), s->about({0, -1, -forward * 0.6}, 0.1),
                                     s->about({0, -1, -0.1}, 0.1)};
    directions.resize(bones);
    directions.push_back(s->about({0, -0.15, 1}, 0.1));
    s->chain(names, hip, parent, directions, lengths, radius, radius * s->range(0.4, 0.8));
  });
}

std::vector<std::string> hind_leg(int joints) {
  if (joints == 2) return {"thigh", "foot"};
  std::vector<std::string> names = {"thigh", "shin", "foot", "toe"};
  names.resize(static_cast<size_t>(joints));
  return names;
}

std::vector<std::string> with_number(std::vector<std::string> names, int number) {
  for (std::string& name : names) name += "_" + std::to_string(number);
  return names;
}

void arms(Sketch* s, Point shoulder, int parent, double width, double length, double down, double forward, double end) {
  s->both_sides([&] {
    if (s->chance(0.5))
      parent = s->add("shoulder", parent, shoulder + Point{width * 0.3, 0, 0}, width * s->range(0.2, 0.4));
    std::vector<std::string> names = {"upper_arm", "forearm", "hand"};
    if (s->chance(0.3)) names.pop_back();
    const double radius = s->range(0.05, 0.14);
    const auto chain_r1 = radius * s->range(0.5, 1.3) * end;
    const std::vector<double> chain_lengths = {length * s->range(0.7, 1.2), length * s->range(0.7, 1.2),
                                               length * 0.4 * end};
    const std::vector<Point> chain_directions = {s->about({1, -down, forward * 0.3}), s->about({1, -down, forward}),
                                                 s->about({1, -down, forward})};
    s->chain(names, shoulder + Point{width, 0, 0}, parent, chain_directions, chain_lengths, radius, chain_r1);
  });
}

void wings(Sketch* s, const std::string& name, Point base, int parent, double width, double length, Point direction) {
  s->both_sides([&] {
    const size_t first = s->nodes.size();
    const auto chain_r1 = s->range(0.03, 0.1);
    const auto chain_r0 = s->range(0.08, 0.2);
    const std::vector<Point> chain_directions = {s->about(direction)};
    const auto chain_names = numbered(name, s->integer(1, 3));
    s->chain(chain_names, base + Point{width, 0, 0}, parent, chain_directions, {length}, chain_r0, chain_r1);
    const double flat = s->range(0.25, 1.0);
    for (size_t i = first + 1; i < s->nodes.size(); ++i) s->nodes[i].scale = {1, flat, 1};
  });
}

void tail(Sketch* s, const Body& body, int joints, double thickness, double length, Point direction, Point bent) {
  std::vector<Point> directions;
  for (int i = 0; i < joints; ++i) directions.push_back(mix(direction, bent, static_cast<double>(i) / joints));
  s->chain(numbered("tail", joints), {0, body.height, -body.radius * 0.7}, body.trunk[0], directions, {length},
           thickness, s->range(0.03, 0.06));
}

void any_tail(Sketch* s, const Body& body, int joints, double thickness, double length) {
  const Point direction = s->about_plane({0, s->range(-0.5, 0.8), -1}),
              bent = s->about_plane({0, s->range(-0.8, 0.5), -1});
  tail(s, body, joints, thickness, length, direction, bent);
}

void head(Sketch* s, Body* body, int necks, double neck_length, Point direction, double radius, double ears) {
  Point p = body->top;
  int parent = body->chest();
  if (necks > 0) {
    const auto chain_r0 = body->radius * s->range(0.3, 0.7);
    const std::vector<Point> chain_directions = {s->about_plane(direction)};
    parent = s->chain(numbered("neck", necks), p, parent, chain_directions, {neck_length}, chain_r0, body->radius * 0.4,
                      false, &p)
                 .back();
  }
  const bool level = direction.z > 0.5;
  const Point ahead = s->about_plane({0, level ? 0.1 : 0.4, 0.9}, 0.25), above = s->about_plane({0, 1, 0.1});
  const Point face = unit(s->chance(level ? 0.75 : 0.4) ? ahead : above);
  body->head = s->add("head", parent, p, radius);
  if (s->chance(level ? 0.4 : 0.2)) {
    const double snout_radius = radius * s->range(0.3, 0.7);
    const Point snout = p + unit({0, ahead.y - 0.3, ahead.z}) * (radius * s->range(1.0, 2.2));
    s->add("snout", body->head, snout, snout_radius, true);
  }
  const double end_radius = radius * s->range(0.7, 1.2);
  s->add("head_end", body->head, p + face * (radius * s->range(0.5, 1.5)), end_radius, true);
  if (!s->chance(ears)) return;
  s->both_sides([&] {
    const auto chain_r0 = s->range(0.04, 0.1);
    const std::vector<double> chain_lengths = {s->range(0.1, 0.5)};
    const std::vector<Point> chain_directions = {s->about({0.5, 1, 0})};
    s->chain({"ear"}, p + Point{radius * 0.6, radius * 0.7, 0}, body->head, chain_directions, chain_lengths, chain_r0,
             0.03);
  });
}

}  // namespace sinew::synth
