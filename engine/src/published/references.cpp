// SPDX-License-Identifier: MIT
// Rays across the bones of both skeletons, and vertices whose nearest points agree in both directions.
#include "published/references.hpp"

namespace sinew::transferring {
namespace {

constexpr uint32_t kRays = 4, kStations = 2;
constexpr double kShortestBone = 1e-3, kLongestRay = 0.25;  // of the longest side
constexpr double kLeastRatio = 0.35, kMostRatio = 2.8;      // of the two rays' lengths, beside the skeletons' ratio
constexpr double kFarthestApart = 0.03;                     // of a ray's two hits, the source brought to the target
constexpr double kConsistent = 0.012;    // distance from the start to the end of a path there and back
constexpr double kLeastCosine = 0.5;     // between the two surfaces' normals
constexpr double kLayers = 0.06;         // the same along the normal: cloth and the skin below it
constexpr double kOtherPart = 0.01;      // added to distances between points of two parts
constexpr double kLeastSpacing = 0.004;  // of reference points
constexpr double kLeastOfPart = 1e-4;    // the same inside a part
constexpr uint32_t kOfPart = 8, kMostParts = 256;
constexpr uint32_t kAnyPart = 0xFFFFFFFFu;
constexpr double kHalfRoot = 0.70710678118654752440;  // the cosine of 45 degrees

// The first triangle that the ray hits. False where there is none.
bool first_hit(const Mesh& mesh, Vec3d origin, Vec3d direction, TrianglePosition* position, double* distance) {
  bool any = false;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const uint32_t* const c = mesh.triangles + 3 * static_cast<size_t>(t);
    const Vec3d a = position_of(mesh.positions[c[0]]);
    const Vec3d e1 = position_of(mesh.positions[c[1]]) - a, e2 = position_of(mesh.positions[c[2]]) - a;
    const Vec3d h = cross(direction, e2);
    const double det = dot(e1, h);
    if (absolute(det) < 1e-14) continue;
    const Vec3d s = origin - a;
    const double u = dot(s, h) / det;
    if (u < 0 || u > 1) continue;
    const Vec3d q = cross(s, e1);
    const double w = dot(direction, q) / det;
    if (w < 0 || u + w > 1) continue;
    const double length = dot(e2, q) / det;
    if (length <= 1e-6 || (any && length >= *distance)) continue;
    any = true;
    *distance = length;
    *position = {{c[0], c[1], c[2]}, {1 - u - w, u, w}};
  }
  return any;
}

// The part of v across the unit vector u, as a unit vector.
Vec3d across(Vec3d v, Vec3d u) { return unit(v - dot(v, u) * u); }

struct Bone {
  Vec3d source, target;                      // where it begins
  Vec3d source_direction, target_direction;  // to its end
};

// From the joint to its first mapped joint below; of a leaf half its parent's bone on.
bool bone_of(const Pair& pair, uint32_t joint, Bone* bone) {
  const Skeleton& source = pair.source_joints;
  const Skeleton& target = pair.target_joints;
  bone->source = position_of(source.positions[joint]);
  bone->target = position_of(target.positions[pair.map.same[joint]]);
  for (uint32_t k = 0; k < source.joint_count; ++k) {
    if (pair.map.same[k] < 0) continue;
    int32_t above = source.parents[k];
    while (above >= 0 && pair.map.same[above] < 0) above = source.parents[above];
    if (above != static_cast<int32_t>(joint)) continue;
    bone->source_direction = position_of(source.positions[k]) - bone->source;
    bone->target_direction = position_of(target.positions[pair.map.same[k]]) - bone->target;
    return true;
  }
  const int32_t parent = source.parents[joint];
  if (parent < 0 || pair.map.same[parent] < 0) return false;
  bone->source_direction = 0.5 * (bone->source - position_of(source.positions[parent]));
  bone->target_direction = 0.5 * (bone->target - position_of(target.positions[pair.map.same[parent]]));
  return true;
}

TrianglePosition position_at(const MatchedPoint& p) {
  return {{p.corners[0], p.corners[1], p.corners[2]}, {p.shares[0], p.shares[1], p.shares[2]}};
}

// Chooses reference points.
class Choice {
 public:
  Choice(const TransferPlan& plan, const Pair& pair, const Rows& source_rows, const uint8_t* of_use)
      : plan_(plan), pair_(pair), rows_(source_rows), of_use_(of_use) {}

  bool allocate(Arena& arena) {
    const uint32_t joints = plan_.source.joints;
    (void)alignment_.allocate(arena, joints);
    scratch_ = arena.alloc<uint32_t>(3 * size_t{joints} + 1);
    candidates_ =
        arena.alloc<Candidate>(size_t{kRays} * kStations * joints + plan_.source.vertices + plan_.target.vertices);
    brought_ = arena.alloc<Vec3d>(plan_.source.vertices);
    brought_normals_ = arena.alloc<Vec3d>(plan_.source.vertices);
    target_ = arena.alloc<Vec3d>(plan_.target.vertices);
    all_ = arena.alloc<uint8_t>(plan_.target.vertices);
    (void)source_tree_.allocate(arena, plan_.source);
    (void)target_tree_.allocate(arena, plan_.target);
    if (arena.measuring()) {
      SurfaceTree::measure(arena, plan_.source);
      SurfaceTree::measure(arena, plan_.target);
    }
    return arena.ok();
  }

  uint32_t run(Arena& arena, Reference* points) {
    alignment_.find(pair_.map, pair_.source_joints, pair_.target_joints, scratch_);
    bring();
    source_tree_.build(pair_.source, brought_, of_use_, arena);
    target_tree_.build(pair_.target, target_, all_, arena);
    if (source_tree_.item_count() == 0 || target_tree_.item_count() == 0) return 0;
    for (uint32_t j = 0; j < pair_.source_joints.joint_count; ++j) add_rays(j);
    add_source_vertices();
    add_target_vertices();
    return spread(points);
  }

 private:
  struct Candidate {
    Reference reference;
    Vec3d position;  // on the target
    double distance;
  };

  // The source's vertices and normals to the target's space.
  void bring() {
    constexpr double kNormalUnit = 1.0 / (1 << kNormalBits);
    for (uint32_t v = 0; v < pair_.source.welded_count; ++v) {
      const uint16_t* const joints = rows_.joints_of(v);
      const uint32_t* const weights = rows_.weights_of(v);
      brought_[v] = alignment_.warp(position_of(pair_.source.positions[v]), joints, weights);
      uint32_t most = 0;
      for (uint32_t i = 1; i < kRowSlots; ++i) most = weights[i] > weights[most] ? i : most;
      const uint32_t joint = joints[most] == kNoJoint ? 0 : joints[most];
      brought_normals_[v] = alignment_.joints[joint].rotation * (kNormalUnit * to_double(pair_.source.normals[v]));
    }
    for (uint32_t v = 0; v < pair_.target.welded_count; ++v) {
      target_[v] = position_of(pair_.target.positions[v]);
      all_[v] = 1;
    }
  }

  Vec3d target_normal(const TrianglePosition& p) const {
    Vec3d sum;
    for (uint32_t k = 0; k < 3; ++k) sum = sum + p.shares[k] * to_double(pair_.target.normals[p.corners[k]]);
    return unit(sum);
  }

  void add(const Reference& reference) {
    candidates_[count_++] = {reference, mean_at(reference.target, target_), 1e300};
  }

  void add_rays(uint32_t joint) {
    Bone bone;
    if (pair_.map.same[joint] < 0 || !bone_of(pair_, joint, &bone)) return;
    if (length(bone.source_direction) < kShortestBone || length(bone.target_direction) < kShortestBone) return;
    const Vec3d along = unit(bone.source_direction), target_along = unit(bone.target_direction);
    const Vec3d first = across(absolute(along.z) < 0.8 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0}, along);
    const Vec3d second = cross(along, first);
    for (uint32_t station = 0; station < kStations; ++station) {
      const double at = 0.5 * station;
      for (uint32_t ray = 0; ray < kRays; ++ray) {
        // Rotations by 90 degrees, at the middle by 45 more.
        Vec3d direction = ray % 2 == 0 ? first : second, next = ray % 2 == 0 ? second : -1.0 * first;
        if (ray >= 2) {
          direction = -1.0 * direction;
          next = -1.0 * next;
        }
        if (station > 0) direction = kHalfRoot * (direction + next);
        const Vec3d target_direction = across(alignment_.joints[joint].rotation * direction, target_along);
        Reference found;
        double source_length = 0, target_length = 0;
        if (!first_hit(pair_.source, bone.source + at * bone.source_direction, direction, &found.source,
                       &source_length) ||
            source_length > kLongestRay ||
            !first_hit(pair_.target, bone.target + at * bone.target_direction, target_direction, &found.target,
                       &target_length))
          continue;
        const double ratio = target_length / (source_length * alignment_.scale);
        if (ratio < kLeastRatio || ratio > kMostRatio) continue;
        if (length(mean_at(found.source, brought_) - mean_at(found.target, target_)) < kFarthestApart) add(found);
      }
    }
  }

  // Whether a path there and back ends at its start, or above or below it: on another layer.
  static bool returns(Vec3d apart, Vec3d normal) {
    const double above = dot(apart, normal);
    return length(apart - above * normal) < kConsistent && absolute(above) < kLayers;
  }

  void add_source_vertices() {
    for (uint32_t v = 0; v < pair_.source.welded_count; ++v) {
      if (of_use_[v] == 0) continue;
      const MatchedPoint there = target_tree_.nearest(brought_[v], brought_normals_[v], Facing::kSame);
      const TrianglePosition on_target = position_at(there);
      if (there.cosine < kLeastCosine) continue;
      const MatchedPoint back =
          source_tree_.nearest(mean_at(on_target, target_), target_normal(on_target), Facing::kSame);
      if (returns(mean_at(position_at(back), brought_) - brought_[v], brought_normals_[v]))
        add({{{v, v, v}, {1, 0, 0}}, on_target});
    }
  }

  void add_target_vertices() {
    for (uint32_t v = 0; v < pair_.target.welded_count; ++v) {
      const MatchedPoint there =
          source_tree_.nearest(target_[v], unit(to_double(pair_.target.normals[v])), Facing::kSame);
      const TrianglePosition on_source = position_at(there);
      if (there.cosine < kLeastCosine) continue;
      const MatchedPoint back =
          target_tree_.nearest(mean_at(on_source, brought_), unit(mean_at(on_source, brought_normals_)), Facing::kSame);
      if (returns(mean_at(position_at(back), target_) - target_[v], unit(to_double(pair_.target.normals[v]))))
        add({on_source, {{v, v, v}, {1, 0, 0}}});
    }
  }

  uint32_t target_part(const Candidate& one) const { return pair_.target.part[one.reference.target.corners[0]]; }

  // Adds the candidate that is farthest from those chosen, of one part of the target or of all. False where there is none.
  bool choose(uint32_t part, uint32_t* chosen, Reference* points) {
    uint32_t next = count_;
    for (uint32_t i = 0; i < count_; ++i) {
      if (part != kAnyPart && target_part(candidates_[i]) != part) continue;
      if (next == count_ || candidates_[i].distance > candidates_[next].distance) next = i;
    }
    if (next == count_ || candidates_[next].distance < (part == kAnyPart ? kLeastSpacing : kLeastOfPart)) return false;
    const Candidate one = candidates_[next];
    points[(*chosen)++] = one.reference;
    const uint32_t source = pair_.source.part[one.reference.source.corners[0]], target = target_part(one);
    for (uint32_t i = 0; i < count_; ++i) {
      Candidate& other = candidates_[i];
      const bool same = pair_.source.part[other.reference.source.corners[0]] == source && target_part(other) == target;
      other.distance = lesser(other.distance, length(other.position - one.position) + (same ? 0 : kOtherPart));
    }
    return true;
  }

  // Some in every larger part of the target, to half of all, then those that are farthest from each other anywhere.
  uint32_t spread(Reference* points) {
    const uint32_t most = References::most(plan_);
    uint32_t chosen = 0;
    const uint32_t parts = pair_.target.part_count < kMostParts ? pair_.target.part_count : kMostParts;
    for (uint32_t part = 0; part < parts; ++part) {
      for (uint32_t i = 0; i < kOfPart && chosen < most / 2; ++i)
        if (!choose(part, &chosen, points)) break;
    }
    while (chosen < most && choose(kAnyPart, &chosen, points)) {
    }
    return chosen;
  }

  const TransferPlan& plan_;
  const Pair& pair_;
  const Rows& rows_;
  const uint8_t* of_use_;
  Alignment alignment_;
  SurfaceTree source_tree_, target_tree_;
  Candidate* candidates_ = nullptr;
  uint32_t count_ = 0;
  Vec3d *brought_ = nullptr, *brought_normals_ = nullptr, *target_ = nullptr;
  uint8_t* all_ = nullptr;  // [target U] every vertex is of use
  uint32_t* scratch_ = nullptr;
};

}  // namespace

uint32_t References::most(const TransferPlan& plan) {
  constexpr uint32_t kFound = 1200, kNumbers = 1u << 24;
  if (plan.pair_count > 0) return plan.pair_count;
  if (plan.as_drawn) return SINEW_MAX_TRANSFER_PAIRS;  // every vertex is compared at all of them
  const uint32_t larger = plan.source.vertices > plan.target.vertices ? plan.source.vertices : plan.target.vertices;
  return kNumbers / larger < kFound ? kNumbers / larger : kFound;
}

sinew_status References::find(const TransferPlan& plan, const Pair& pair, const Rows& source_rows,
                              const uint8_t* of_use, Arena& arena) {
  const ArenaScope scope(arena);
  count = 0;
  if (plan.pair_count == 0) {
    Choice choice(plan, pair, source_rows, of_use);
    if (!choice.allocate(arena)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring()) count = choice.run(arena, points);
    return SINEW_OK;
  }
  if (arena.measuring()) return SINEW_OK;
  for (uint32_t i = 0; i < plan.pair_count; ++i) {
    const sinew_vertex_pair& one = plan.pairs[i];
    if (one.source >= pair.source.vertex_count || one.target >= pair.target.vertex_count) return SINEW_ERROR_RANGE;
    const uint32_t s = pair.source.vertex_to_welded[one.source], t = pair.target.vertex_to_welded[one.target];
    points[count++] = {{{s, s, s}, {1, 0, 0}}, {{t, t, t}, {1, 0, 0}}};
  }
  return SINEW_OK;
}

}  // namespace sinew::transferring
