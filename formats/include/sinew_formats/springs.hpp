// SPDX-License-Identifier: MIT
// Springs of a character: chains that swing and their colliders, as in VRMC_springBone.
#ifndef SINEW_FORMATS_SPRINGS_HPP
#define SINEW_FORMATS_SPRINGS_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// The last three are those of VRMC_springBone_extended_collider.
enum class ColliderShape { kSphere, kCapsule, kInsideSphere, kInsideCapsule, kPlane };

// Springs that were read from a document keep their index in it: when they are written to it again, everything stays
// as it was, except for changed joint indices.

// Positions are relative to the joint, along the world axes at rest.
struct SpringCollider {
  std::string name;
  ColliderShape shape = ColliderShape::kSphere;
  size_t joint = 0;
  Point3 offset = {};  // center of a sphere, one end of a capsule, a point of a plane
  Point3 tail = {};    // the other end of a capsule, the normal of a plane
  double radius = 0;
  int source = -1;  // index in the document; -1: new
};

struct ColliderGroup {
  std::string name;
  std::vector<size_t> colliders;
  int source = -1;
};

// A joint that rotates so that the next joint of its chain swings. Defaults are those of VRMC_springBone.
struct SpringJoint {
  size_t joint = 0;
  double hit_radius = 0, stiffness = 1, gravity_power = 0;
  Point3 gravity = {0, -1, 0};  // direction in the world
  double drag = 0.5;            // 0..1
  double limit = 0;             // degrees; 0: no limit
  Point3 hinge = {};            // hinge axis, along the world axes at rest; length 0: any
};

struct SpringChain {
  std::string name;
  std::vector<SpringJoint> joints;  // from the first one down; each is a descendant of the one before
  std::optional<Point3>
      end;  // end of the last joint's bone relative to it, along the world axes at rest; none: the last joint is the end
  std::vector<size_t> groups;  // of colliders
  int center = -1;             // the joint in whose space the chain keeps its velocity; -1: the world
  int source = -1;

  size_t turning_joints() const { return end ? joints.size() : joints.empty() ? 0 : joints.size() - 1; }
};

// Returns the end at rest of the bone of a chain's joint, counted from 0.
inline Point3 tail_at_rest(const SpringChain& chain, size_t turning, const std::vector<Joint>& character) {
  if (turning + 1 < chain.joints.size()) return point(character[chain.joints[turning + 1].joint].position);
  return point(character[chain.joints[turning].joint].position) + *chain.end;
}

struct Springs {
  std::vector<SpringChain> chains;
  std::vector<SpringCollider> colliders;
  std::vector<ColliderGroup> groups;
  std::vector<std::string> notes;  // notes of the reader for the user, one line each
};

// Reads the springs of the character's file: VRMC_springBone, else secondaryAnimation of VRM 0.x; nullopt without
// either. Nodes that are not joints end a chain or are left out of it; colliders on them move to the ancestor joint;
// notes list what was left out. If the character has other joints than its file, springs are matched by joint name.
// Throws Error with the element for what the specification forbids: invalid indices, numbers out of range, joints
// that are not descendants of one another.
//   path  for messages
std::optional<Springs> read_springs(const std::string& path, const Character& character);

// Maps springs to other joints: `number` [J before] has each joint's new index or -1. Chains of fewer than two joints
// are removed, with a note; colliders of removed joints move to the nearest remaining ancestor.
//   before  the joints that `springs` refer to
Springs springs_of_fewer(const Springs& springs, const std::vector<Joint>& before, const std::vector<int>& number);

}  // namespace sinew
#endif
