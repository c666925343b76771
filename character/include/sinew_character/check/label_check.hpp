// SPDX-License-Identifier: MIT
// Weights that look like an artist's or an exporter's mistake: what a training set should not teach.
#ifndef SINEW_CHARACTER_LABEL_CHECK_HPP
#define SINEW_CHARACTER_LABEL_CHECK_HPP

#include <array>
#include <string>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// One kind of suspicion about one joint. `joint` holds the weight, `better` is the joint that it was expected on.
//   far-weight    vertices with weight for a joint far away, on another branch of the skeleton, while another is near
//   island        a patch of the mesh bound across the body, apart from everything else of its joint
//   odd-vertex    vertices whose neighbors all agree on another joint
//   left-right    vertices bound to the mirror twin of the joint at their position
//   idle-twin     a joint without weight whose mirror twin has some
//   shared-position  much of the mesh is bound to joints at the position of a sibling with weight
struct LabelFinding {
  std::string code;
  uint32_t joint = 0, better = 0;
  std::vector<uint32_t> vertices;  // ascending; empty for idle-twin and shared-position
  std::string text;                // one line
};

// Compares weights with positions: distances to bones are relative to the longest side of the mesh. A character without
// weights, or with rows, joints or faces that check_character() calls errors, has no findings.
std::vector<LabelFinding> check_labels(const Character& character);

// Mirror twin of each joint ([J], own index when there is none): by the words left and right or l and r in the names,
// else by position about the YZ plane through the middle of all joints.
std::vector<uint32_t> mirror_twins(const Character& character);

// A joint moves the segments to its children; a leaf is a point until it is given an end.
class BoneDistance {
 public:
  explicit BoneDistance(const Character& character);
  double operator()(const Vec3& point, size_t joint) const;
  void set_leaf_end(size_t joint, const Point3& end);  // does nothing for a joint with children

 private:
  std::vector<Point3> joints_, ends_;
  std::vector<std::vector<size_t>> children_;
  double scale_ = 1;
};

}  // namespace sinew
#endif
