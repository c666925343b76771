// SPDX-License-Identifier: MIT
// A rig as mapping sees it: positions in doubles, children, an order in which every subtree is one run. Whether two are of the
// same rig: a motion of the character's own leaves nothing to find.
#ifndef SINEW_MAPPING_HIERARCHY_HPP
#define SINEW_MAPPING_HIERARCHY_HPP

#include "core/arena.hpp"
#include "mapping/maths.hpp"
#include "names/joint_name.hpp"
#include "sinew/map.h"

namespace sinew::mapping {

using names::JointName;
using names::Part;

struct Hierarchy {
  int32_t n = 0;  // joints
  Point* at = nullptr;
  int32_t* parent = nullptr;
  int32_t* kid_offsets = nullptr;  // [n + 2] into kids; row n holds the roots
  int32_t* kids = nullptr;         // [n] in the order of their numbers
  int32_t* order = nullptr;        // [n] parents first, a subtree in one run
  int32_t* position = nullptr;     // [n] index in order
  int32_t* depth = nullptr;        // [n] 0 for roots
  int32_t* count = nullptr;        // [n] joints of the subtree
  double* reach = nullptr;         // [n] longest path down
  uint8_t* end = nullptr;          // [n] only marks the end of a bone
  uint8_t* apart = nullptr;  // [n] farther from the body than the body is large: a root that stays where a stage begins
  JointName* names = nullptr;  // [n] what names say
  bool has_names = false;
  bool has_ends = false;  // ends are known from the caller or from names
  double size = 1;        // diagonal of the box of the body's joints

  bool allocate(Arena& arena, uint32_t joints);
  // From the caller's rig. SINEW_ERROR_NOT_FINITE, SINEW_ERROR_INDEX, SINEW_ERROR_HIERARCHY.
  sinew_status build(const sinew_skeleton& rig, bool with_names);

  // If ends are unknown: marks all leaves as ends, or none.
  void take_leaves_as_ends(bool yes);

  int32_t kid_count(int32_t joint) const { return kid_offsets[joint + 1] - kid_offsets[joint]; }
  int32_t kid(int32_t joint, int32_t k) const { return kids[kid_offsets[joint] + k]; }
  bool has_end_kid(int32_t joint) const {
    for (int32_t k = 0; k < kid_count(joint); ++k) {
      if (end[kid(joint, k)] != 0) return true;
    }
    return false;
  }
  int32_t first_root() const { return kids[kid_offsets[n]]; }
  int32_t first_of_body() const {
    int32_t k = 0;
    while (apart[order[k]] != 0) ++k;
    return order[k];
  }
  // Apart from the body, and no joint that carries it.
  bool is_beside_body(int32_t joint) const { return apart[joint] != 0 && !holds(joint, first_of_body()); }
  // Whether `above` is `joint` or one of its ancestors.
  bool holds(int32_t above, int32_t joint) const {
    return position[above] <= position[joint] && position[joint] < position[above] + count[above];
  }
  // The deepest joint that holds both, -1 = none.
  int32_t common(int32_t a, int32_t b) const {
    while (a >= 0 && !holds(a, b)) a = parent[a];
    return a;
  }
  double bone(int32_t a, int32_t b) const { return distance(at[a], at[b]); }
  Part part(int32_t joint) const { return names[joint].plain; }

 private:
  // Fills children, order, position, depth, count and reach from parents. SINEW_ERROR_HIERARCHY.
  sinew_status sort_joints();
  // Attaches roots that carry a part of one body to that body's nearest joint: a pelvis beside the spine. Returns
  // whether there are any. What is as small as a hand or a prop, stands away or repeats joints of the body (controls)
  // stays a root.
  bool join_roots();
  // Fills `apart` and `size`. The body is the smallest subtree of nearly all joints from which the rest is farther than it is large.
  void find_body();
};

// Calls body(child) for each child in the order of their numbers.
template <class Body>
void each_kid(const Hierarchy& rig, int32_t joint, const Body& body) {
  for (int32_t k = rig.kid_offsets[joint]; k < rig.kid_offsets[joint + 1]; ++k) body(rig.kids[k]);
}

// Whether joints have joints of their names in the other rig, below the one of their parent's name: all but leaves and what holds the
// whole rig, and at least half of either rig. Then sources [target n] are those joints, -1 for what has none. targets [source n] is
// scratch.
bool is_same_rig(const sinew_skeleton& target, const sinew_skeleton& source, const Hierarchy& own,
                 const Hierarchy& other, int32_t* sources, int32_t* targets);

// The same of rigs under other names: every joint has as many children, which lie from it as the other's do, up to 30 % of a bone, both
// rigs of one size and orientation; and no name says another side, nor one of ten another part. Then sources [target
// n] is whole. targets as above.
bool is_same_shape(const Hierarchy& own, const Hierarchy& other, int32_t* sources, int32_t* targets);

}  // namespace sinew::mapping
#endif
