// SPDX-License-Identifier: MIT
// Joints that are drawn freely, a chain at a time, and the limbs that creatures have of them.
// Draws stand in statements of their own: arguments of a call are evaluated in any order.
#ifndef SINEW_DATA_SETS_SYNTH_SKETCH_HPP
#define SINEW_DATA_SETS_SYNTH_SKETCH_HPP

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "synth/blueprint.hpp"

namespace sinew::synth {

// A joint or, with `tip`, only the end of its parent's bone. The bone that ends here has this shape.
struct Node {
  std::string name;
  int parent = kNoJoint;
  Point at;
  double radius = 0.1;
  bool tip = false;
  double start_share = 1, end_share = 1;  // of the radius at the parent, and of the one here
  Point scale = {1, 1, 1};                // as in Primitive
};

class Sketch {
 public:
  explicit Sketch(Random* random) : random_(random) {}

  std::vector<Node> nodes;

  Point at(int node) const { return nodes[static_cast<size_t>(node)].at; }

  int add(const std::string& name, int parent, Point at, double radius, bool tip = false) {
    Node node = {name, parent, at, radius, tip, range(0.8, 1.1), range(0.7, 1.0), {1, 1, 1}};
    if (on_plane(at)) node.scale.x = range(0.6, 1.2);
    nodes.push_back(std::move(node));
    return static_cast<int>(nodes.size()) - 1;
  }

  // One joint a name from `start` on and a bone end behind the last; of directions and lengths the last one repeats.
  // Returns the joints; `end` is where the last bone ends, which has a node only with `tip`.
  std::vector<int> chain(const std::vector<std::string>& names, Point start, int parent,
                         const std::vector<Point>& directions, const std::vector<double>& lengths, double r0, double r1,
                         bool tip = true, Point* end = nullptr) {
    std::vector<int> made;
    Point p = start;
    for (size_t i = 0; i < names.size(); ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(names.size());
      parent = add(names[i], parent, p, mix(r0, r1, t));
      made.push_back(parent);
      p = p + unit(directions[std::min(i, directions.size() - 1)]) * lengths[std::min(i, lengths.size() - 1)];
    }
    if (tip) add(names.back() + "_end", parent, p, r1, true);
    if (end != nullptr) *end = p;
    return made;
  }

  // What `build` adds stands on the left side (+x); the right side gets the same.
  template <typename Build>
  void both_sides(Build build) {
    const int first = static_cast<int>(nodes.size());
    build();
    const int last = static_cast<int>(nodes.size());
    for (int i = first; i < last; ++i) {
      Node copy = nodes[static_cast<size_t>(i)];
      copy.at.x = -copy.at.x;
      copy.name += ".R";
      if (copy.parent >= first) copy.parent += last - first;
      nodes[static_cast<size_t>(i)].name += ".L";
      nodes.push_back(std::move(copy));
    }
  }

  double range(double low, double high) { return random_->range(low, high); }
  int integer(int low, int high) { return random_->integer(low, high); }
  bool chance(double probability) { return random_->chance(probability); }
  // A direction with a little noise; the second kind stays on the mirror plane.
  Point about(Point direction, double noise = 0.12) {
    const double x = random_->normal(), y = random_->normal(), z = random_->normal();
    return direction + Point{x, y, z} * noise;
  }
  Point about_plane(Point direction, double noise = 0.12) {
    const Point p = about(direction, noise);
    return {0, p.y, p.z};
  }
  double factor(double deviation) { return exponential(random_->normal() * deviation); }

  static bool on_plane(Point p) { return p.x < 1e-6 && p.x > -1e-6; }

 private:
  Random* random_;
};

struct Body {
  double height = 1, radius = 0.3;  // of the hips over the floor, of the torso
  std::vector<int> trunk;
  int head = kNoJoint;
  Point top;  // where the torso ends
  int chest() const { return trunk.back(); }
};

std::vector<std::string> numbered(const std::string& name, int count);             // name_1, name_2; of one the name
std::vector<std::string> with_number(std::vector<std::string> names, int number);  // each name_NUMBER
std::vector<std::string> hind_leg(int joints);

Body make_trunk(Sketch* s, double height, double radius, Point direction, double first, double length, int spines);
// A pair of legs; `joints` of thigh, calf, foot and toe, the last one lies on the floor. `pair` numbers several.
void legs(Sketch* s, Point hip, int parent, std::vector<std::string> names, double spread, double height, double radius,
          double forward, double foot = 1);
// `end` widens the hands: claws.
void arms(Sketch* s, Point shoulder, int parent, double width, double length, double down, double forward = 0.3,
          double end = 1);
void wings(Sketch* s, const std::string& name, Point base, int parent, double width, double length, Point direction);
void tail(Sketch* s, const Body& body, int joints, double thickness, double length, Point direction, Point bent);
void any_tail(Sketch* s, const Body& body, int joints, double thickness, double length);
// Up to three neck joints, the head and its end, ears.
void head(Sketch* s, Body* body, int necks, double neck_length, Point direction, double radius, double ears);

// Upright, with one or more of pigtails, long ears, wings and a big tail. Positions as in make_creature().
Body mascot(Sketch* s);

}  // namespace sinew::synth
#endif
