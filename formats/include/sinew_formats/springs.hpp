// SPDX-License-Identifier: MIT
// Springs of a character: chains that swing and what they collide with, as VRMC_springBone has them.
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

// Springs that were read from a document know their number in it: written into it again, they stay as they are there, with all that this
// structure does not know, but for joints' numbers that have changed.

// Positions count from the joint, along the world's axes at rest.
struct SpringCollider {
  std::string name;
  ColliderShape shape = ColliderShape::kSphere;
  size_t joint = 0;
  Point3 offset = {};  // a sphere's middle, one end of a capsule, a point of a plane
  Point3 tail = {};    // the other end of a capsule, the normal of a plane
  double radius = 0;
  int source = -1;  // its number in the document; -1: it is new
};

struct ColliderGroup {
  std::string name;
  std::vector<size_t> colliders;
  int source = -1;
};

// A joint that turns so that the next one of its chain swings. Defaults are those of VRMC_springBone.
struct SpringJoint {
  size_t joint = 0;
  double hit_radius = 0, stiffness = 1, gravity_power = 0;
  Point3 gravity = {0, -1, 0};  // direction in the world
  double drag = 0.5;            // 0..1
  double limit = 0;             // degrees; 0: none
  Point3 hinge = {};            // the axis that it turns about, along the world's axes at rest; of length 0: any
};

struct SpringChain {
  std::string name;
  std::vector<SpringJoint> joints;  // from the first one down; each hangs below the one before
  std::optional<Point3>
      end;  // where the last joint points to, from it, along the world's axes at rest; none: it is the end itself
  std::vector<size_t> groups;  // of colliders
  int center = -1;             // the joint in whose space the chain keeps its velocity; -1: the world
  int source = -1;

  size_t turning_joints() const { return end ? joints.size() : joints.empty() ? 0 : joints.size() - 1; }
};

// Where the bone of a turning joint of a chain, counted from 0, ends at rest.
inline Point3 tail_at_rest(const SpringChain& chain, size_t turning, const std::vector<Joint>& character) {
  if (turning + 1 < chain.joints.size()) return point(character[chain.joints[turning + 1].joint].position);
  return point(character[chain.joints[turning].joint].position) + *chain.end;
}

struct Springs {
  std::vector<SpringChain> chains;
  std::vector<SpringCollider> colliders;
  std::vector<ColliderGroup> groups;
  std::vector<std::string> notes;  // remarks of the reader for the user, a line each
};

// Springs of the character's own file: VRMC_springBone, else secondaryAnimation of VRM 0.x; nullopt where it has neither. Nodes that are no
// joints end a chain or are left out of it; colliders on them hang on the joint above; notes say what was left out. A character with other joints
// than its file's has the springs of those that are called alike. Throws Error naming the
// element for what the specification forbids: indices that name nothing, numbers out of their range, joints that do not lie below one another.
//   path  for messages
std::optional<Springs> read_springs(const std::string& path, const Character& character);

// Springs for other joints: `number` [J before] has each joint's new number or -1. Chains of fewer than two joints go, with a note each; colliders
// whose joint is gone hang on the nearest joint above that is left.
//   before  the joints that `springs` are of
Springs springs_of_fewer(const Springs& springs, const std::vector<Joint>& before, const std::vector<int>& number);

}  // namespace sinew
#endif
