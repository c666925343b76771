// SPDX-License-Identifier: MIT
// A loose part that begins at a hand and reaches far beyond it, away from the arm, is held by it.
#include "core/vector_math.hpp"
#include "details/details.hpp"
#include "details/given_skeleton.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kLeastPropVertices = 4;
// Percent of the forearm: a part comes so near to the hand's bone, reaches so far from the hand, and stays so far from the
// elbow. Sleeves, gloves and bracelets do not.
constexpr int64_t kNear = 35, kFar = 90, kFromElbow = 45;
// And a hand is there without it: something else goes so far beyond the wrist, so near to the arm's line.
constexpr int64_t kBeyondHand = 15, kBeside = 30;
constexpr uint16_t kConfidence = 16384;

int64_t squared(Vec3i v) { return dot(v, v); }

// The relation of one part to one hand.
struct Hold {
  int64_t nearest = INT64_MAX;  // squared, of its points to the hand's bone
  int64_t farthest = -1;        // squared, of its points from the hand's joint
  Vec3i grip = {}, tip = {};    // these points
};

Hold hold_of(const Mesh& mesh, uint32_t part, Vec3i hand, Vec3i hand_end) {
  Hold hold;
  for (uint32_t i = mesh.part_offsets[part]; i < mesh.part_offsets[part + 1]; ++i) {
    const Vec3i p = mesh.positions[mesh.part_vertices[i]];
    const int64_t near = squared(nearest_on_segment(hand, hand_end, p) - p), far = squared(p - hand);
    if (near < hold.nearest) {
      hold.nearest = near;
      hold.grip = p;
    }
    if (far > hold.farthest) {
      hold.farthest = far;
      hold.tip = p;
    }
  }
  return hold;
}

// Whether the part keeps away from the arm behind the hand, as no sleeve does.
bool is_free_of_arm(const Mesh& mesh, uint32_t part, Vec3i elbow, int64_t least) {
  for (uint32_t i = mesh.part_offsets[part]; i < mesh.part_offsets[part + 1]; ++i)
    if (squared(mesh.positions[mesh.part_vertices[i]] - elbow) < least) return false;
  return true;
}

// Whether other parts show a hand. Those of robots and skeletons are loose parts themselves.
bool has_hand_beside(const Mesh& mesh, uint32_t part, Vec3i elbow, Vec3i hand, int64_t forearm) {
  const Vec3i along = hand - elbow;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    if (mesh.part[v] == part) continue;
    const Vec3i p = mesh.positions[v] - hand;
    const int64_t forward = dot(p, along);  // forearm times the distance beyond the wrist
    if (forward * 100 < forearm * forearm * kBeyondHand || forward > forearm * forearm) continue;
    const int64_t distance = forward / forearm, beside = forearm * kBeside / 100;
    if (squared(p) - distance * distance <= beside * beside) return true;
  }
  return false;
}

int64_t percent_squared(int64_t length, int64_t percent) {
  const int64_t value = length * percent / 100;
  return value * value;
}

// A hand without a prop, with an arm.
bool is_free_hand(const GivenSkeleton& s, uint32_t j) {
  if (s.end[j] || s.joints.joint_classes[j] != SINEW_CLASS_HAND || s.joints.parents[j] < 0) return false;
  for (uint32_t c = j + 1; c < s.joints.joint_count; ++c)
    if (s.joints.parents[c] == static_cast<int32_t>(j) && s.joints.joint_classes[c] == SINEW_CLASS_PROP) return false;
  return true;
}

// More parts than these are the fingers of a skeleton or a robot.
constexpr uint32_t kMostParts = 3;

struct Prop {
  uint32_t hand = 0, parts = 1;
  Hold hold;
};

struct HeldParts {
  const Mesh& mesh;
  const GivenSkeleton& skeleton;

  // The hand that holds a part, and where; false where none does.
  bool find(uint32_t part, Prop* prop) const {
    int64_t best = INT64_MAX;
    for (uint32_t j = 0; j < skeleton.joints.joint_count; ++j) {
      if (!is_free_hand(skeleton, j)) continue;
      const Vec3i hand = skeleton.at[j], elbow = skeleton.at[skeleton.joints.parents[j]];
      const int32_t e = skeleton.end_of(j);
      const auto forearm = static_cast<int64_t>(length(hand - elbow));
      if (forearm == 0) continue;
      const Hold hold = hold_of(mesh, part, hand, e >= 0 ? skeleton.at[e] : hand);
      if (hold.nearest >= best || hold.nearest > percent_squared(forearm, kNear) ||
          hold.farthest < percent_squared(forearm, kFar) ||
          !is_free_of_arm(mesh, part, elbow, percent_squared(forearm, kFromElbow)) ||
          !has_hand_beside(mesh, part, elbow, hand, forearm)) {
        continue;
      }
      best = hold.nearest;
      prop->hand = j;
      prop->hold = hold;
    }
    return best != INT64_MAX;
  }
};

SINEW_RARE void add_prop(const Prop& prop, const Units& units, uint32_t up_axis, sinew_rig_outputs* out) {
  if (out->joint_count + 2 > kMostGivenJoints) return;
  NewJoint joint = {};
  joint.name = "Prop";
  joint.named_after = static_cast<int32_t>(prop.hand);
  joint.at = prop.hold.grip;
  joint.side = PointSide::kHere;
  joint.parent = static_cast<int32_t>(prop.hand);
  joint.partner = -1;
  joint.joint_class = SINEW_CLASS_PROP;
  joint.confidence = kConfidence;
  append_joint(units, up_axis, joint, out);
  joint.name = "Prop_end";
  joint.at = prop.hold.tip;
  joint.parent = static_cast<int32_t>(out->joint_count) - 1;
  joint.end = true;
  append_joint(units, up_axis, joint, out);
}

struct Props {
  Prop* found = nullptr;
  uint32_t count = 0;

  void room(Arena& arena) { found = arena.alloc<Prop>(kMostGivenJoints); }
  void find(const Mesh& mesh, const GivenSkeleton& skeleton) {
    const HeldParts parts = {mesh, skeleton};
    // Part 0 is the largest: a body.
    for (uint32_t part = 1; part < mesh.part_count; ++part) {
      if (mesh.part_sizes[part] < kLeastPropVertices) break;  // sizes fall
      Prop prop;
      if (parts.find(part, &prop)) keep(prop);
    }
  }
  void add(const Units& units, uint32_t up_axis, sinew_rig_outputs* outputs) const {
    for (uint32_t i = 0; i < count; ++i)
      if (found[i].parts <= kMostParts) add_prop(found[i], units, up_axis, outputs);
  }

 private:
  // Handle and blade are one prop.
  void keep(const Prop& prop) {
    uint32_t at = 0;
    while (at < count && found[at].hand != prop.hand) ++at;
    if (at == count) {
      found[count++] = prop;
      return;
    }
    ++found[at].parts;
    Hold& hold = found[at].hold;
    if (prop.hold.nearest < hold.nearest) {
      hold.nearest = prop.hold.nearest;
      hold.grip = prop.hold.grip;
    }
    if (prop.hold.farthest > hold.farthest) {
      hold.farthest = prop.hold.farthest;
      hold.tip = prop.hold.tip;
    }
  }
};

}  // namespace

sinew_status run_props(const RigPlan& plan, const sinew_mesh& mesh, Arena& arena, sinew_rig_outputs* outputs) {
  return grow_given(plan, mesh, arena, Props(), outputs);
}

}  // namespace sinew::rigging
