// SPDX-License-Identifier: MIT
// Proportions that data of artists hardly has: the head is as high as all below it, arms and legs are short, and hair,
// ears, wings and tails are as long as limbs or longer.
// Draws stand in statements of their own: arguments of a call are evaluated in any order.
#include "synth/sketch.hpp"

namespace sinew::synth {
namespace {

// On stubby legs, the torso not much longer than they are.
Body stubby_body(Sketch* s) {
  const double height = s->range(0.2, 0.45), radius = s->range(0.16, 0.32);
  const Point up = unit(s->about_plane({0, 1, s->range(-0.1, 0.15)}, 0.04));
  const auto spines = s->integer(0, 3);
  const auto length = s->range(0.07, 0.14);
  const auto first = s->range(0.1, 0.2);
  Body body = make_trunk(s, height, radius, up, first, length, spines);
  const auto forward = s->range(-0.1, 0.15);
  const auto leg_radius = s->range(0.08, 0.18);
  const auto spread = s->range(-0.05, 0.25);
  const auto names = hind_leg(s->integer(2, 4));
  const Point hip = {radius * s->range(0.4, 0.7), height - 0.04, 0};
  legs(s, hip, body.trunk[0], names, spread, height * 0.85, leg_radius, forward);
  const auto down = s->range(-0.6, 2.0);
  const auto arm_length = s->range(0.1, 0.25);
  const auto width = radius * s->range(0.7, 1.0);
  const Point shoulder = body.top - Point{0, s->range(0, 0.1), 0};
  arms(s, shoulder, body.chest(), width, arm_length, down);
  return body;
}

// A ball or an egg that stands on the neck; the node is the neck's end, in the lower half. Returns the radius.
double big_head(Sketch* s, Body* body) {
  const double radius = body->top.y * s->range(0.4, 0.62);
  int parent = body->chest();
  Point p = body->top;
  if (s->chance(0.5)) {
    parent = s->add("neck", parent, p, body->radius * 0.5);
    p = p + Point{0, s->range(0.03, 0.08), 0};
  }
  p = p + Point{0, radius * s->range(0.3, 0.5), 0};
  body->head = s->add("head", parent, p, radius);
  s->nodes[static_cast<size_t>(body->head)].end_share = s->range(0.3, 0.5);  // what follows the neck stays slim
  const Point crown = p + Point{0, radius * s->range(0.5, 1.0), radius * s->range(-0.1, 0.15)};
  const int end = s->add("head_end", body->head, crown, radius * s->range(0.8, 1.0), true);
  s->nodes[static_cast<size_t>(end)].start_share = s->range(0.85, 1.0);
  return radius;
}

// Off the sides of the head, then down (or up, as in bunches).
void pigtails(Sketch* s, const Body& body, double radius) {
  const double thick = radius * s->range(0.14, 0.32), length = radius * s->range(0.8, 2.4);
  const int joints = s->integer(1, 4);
  const double rise = s->range(-0.3, 1.0), fall = s->chance(0.8) ? -1.0 : 0.6;
  const Point base = s->at(body.head) + Point{radius * 0.8, radius * s->range(0.1, 0.7), -radius * s->range(0, 0.4)};
  s->both_sides([&] {
    const std::vector<Point> directions = {s->about({1, rise, -0.2}), s->about({0.4, fall, 0}),
                                           s->about({0.1, fall, 0})};
    const auto end = thick * s->range(0.4, 1.3);
    s->chain(numbered("ponytail", joints), base, body.head, directions, {length / joints}, thick, end);
  });
}

// From the top of the head, upright as a hare's or hanging as a hound's.
void long_ears(Sketch* s, const Body& body, double radius) {
  const double thick = radius * s->range(0.12, 0.3), length = radius * s->range(0.8, 2.2);
  const int joints = s->integer(1, 3);
  const bool hanging = s->chance(0.35);
  const double out = hanging ? 1.0 : s->range(0.05, 0.8);
  const Point base = s->at(body.head) + Point{radius * s->range(0.35, 0.6), radius * s->range(0.9, 1.2), 0};
  s->both_sides([&] {
    const Point after = hanging ? Point{0.3, -1, 0} : Point{out, 1, 0};
    const std::vector<Point> directions = {s->about({out, hanging ? 0.4 : 1.0, 0}, 0.06), s->about(after, 0.06)};
    const size_t first = s->nodes.size();
    const auto end = thick * s->range(0.3, 1.1);
    s->chain(numbered("ear", joints), base, body.head, directions, {length / joints}, thick, end);
    const double flat = s->range(0.4, 1.0);
    for (size_t i = first + 1; i < s->nodes.size(); ++i) s->nodes[i].scale = {1, 1, flat};
  });
}

// Longer than the legs and as thick as the torso at the most: a squirrel's, a fox's.
void big_tail(Sketch* s, const Body& body) {
  const int joints = s->integer(2, 5);
  const double thick = body.radius * s->range(0.35, 0.9), length = s->range(0.3, 0.9);
  const double rise = s->range(-0.2, 0.6), bend = s->range(-0.5, 2.0);
  std::vector<Point> directions;
  for (int i = 0; i < joints; ++i)
    directions.push_back(
        s->about_plane(mix(Point{0, rise, -1}, Point{0, bend, -0.5}, static_cast<double>(i) / joints)));
  const auto end = thick * s->range(0.3, 1.2);
  s->chain(numbered("tail", joints), {0, body.height, -body.radius * 0.6}, body.trunk[0], directions, {length / joints},
           thick, end);
}

}  // namespace

Body mascot(Sketch* s) {
  Body body = stubby_body(s);
  const double radius = big_head(s, &body);
  const bool hair = s->chance(0.4), ears = s->chance(0.5), winged = s->chance(0.25), tailed = s->chance(0.45);
  if (hair || !(ears || winged || tailed)) pigtails(s, body, radius);
  if (ears) long_ears(s, body, radius);
  if (winged) {
    const Point out = {1, s->range(-0.2, 0.9), s->range(-0.9, -0.3)};
    const auto length = s->range(0.12, 0.35);
    wings(s, "wing", body.top - Point{0, 0.05, body.radius * 0.6}, body.chest(), body.radius * 0.4, length, out);
  }
  if (tailed) big_tail(s, body);
  return body;
}

}  // namespace sinew::synth
