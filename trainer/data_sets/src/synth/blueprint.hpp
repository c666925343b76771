// SPDX-License-Identifier: MIT
// The plan of a generated character before it becomes a mesh: joints, body primitives, and who is who for the
// tailor.
#ifndef SINEW_DATA_SETS_SYNTH_BLUEPRINT_HPP
#define SINEW_DATA_SETS_SYNTH_BLUEPRINT_HPP

#include <string>
#include <vector>

#include "sinew_data_sets/synthesize.hpp"
#include "synth/maths.hpp"

namespace sinew::synth {

constexpr int kNoJoint = -1;

// A capsule from a to b whose radius goes from ra to rb, measured in space divided by `scale` (so a limb can be flat).
// It moves with `joint`, the joint at the head of its bone.
struct Primitive {
  int joint = 0;
  Point a, b;
  double ra = 0, rb = 0;
  Point scale = {1, 1, 1};
};

struct PlanJoint {
  std::string name;
  int parent = kNoJoint;
  Point position;
  Point tip;  // where its bone ends; used for end markers of leaves
  bool has_tip = false;
};

// Kinds of a body's surface: one smooth skin with blended weights, or rigid parts, one or two for every bone.
enum class Build { kSmooth, kCapsules, kBoxes };

struct Limb {
  std::vector<int> joints;  // from the torso outwards
};

struct Blueprint {
  std::vector<PlanJoint> joints;
  std::vector<Primitive> body;
  double softness = 0.5;  // width of the blend between joints, in radii
  double blend = 0.4;     // width of the smooth union, in radii
  double cell = 0.03;     // edge of a voxel; nothing thinner than about two survives
  Build build = Build::kSmooth;

  // Roles, for clothes and parts. Joints that a plan lacks are kNoJoint.
  std::vector<int> trunk;  // from the hips to the chest
  int neck = kNoJoint, head = kNoJoint;
  Point head_center;
  double head_radius = 0.1;
  std::vector<Limb> arms, legs;

  int add_joint(const std::string& name, int parent, Point position) {
    joints.push_back({name, parent, position, {}, false});
    return static_cast<int>(joints.size()) - 1;
  }
  void add_bone(int joint, Point a, Point b, double ra, double rb, Point scale = {1, 1, 1}) {
    body.push_back({joint, a, b, ra, rb, scale});
    joints[static_cast<size_t>(joint)].tip = b;
    joints[static_cast<size_t>(joint)].has_tip = true;
  }
  Point at(int joint) const { return joints[static_cast<size_t>(joint)].position; }
};

// Seeded proportions of a body plan, about 1 to 2 units tall, +Y up, facing +Z, floor at y = 0, the left side at +X.
// `resolution` is the voxel count along the longest side; cell is set from it.
Blueprint make_blueprint(BodyPlan plan, int resolution, Random* random);

// The plans of kCreaturePlans. Positions as in make_blueprint(); the cell is set from the body's real size.
Blueprint make_creature(BodyPlan plan, int resolution, Random* random);

}  // namespace sinew::synth
#endif
