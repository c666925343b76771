// SPDX-License-Identifier: MIT
// Influences of triangles on joints, lengths of bones along paths, and limbs moved to the weighted sum.
#include "motion/reference_points.hpp"

#include "motion/arm_search.hpp"
#include "motion/retarget.hpp"
#include "published/capsule_body.hpp"
#include "sinew/rig.h"

namespace sinew::motion {
namespace {

// Parts of the body that reference points belong to.
constexpr uint8_t kTorso = 0, kHead = 1, kFirstLimb = 2;
constexpr double kGivesWay = 0.005;  // share of the height: depth in the body up to which an arm yields
constexpr double kLeastLength =
    1e-6;  // share of the source's height: bones shorter than this along the path are ignored

// About exp(-x), x >= 0: 0.0003 off at most. A power of a fraction needs no libm.
double falling(double x) {
  double d = 1 + x * (1.0 / 256);
  for (int i = 0; i < 8; ++i) d = d * d;
  return 1 / d;
}

struct ReferenceScene : ClipScene {
  uint32_t* groups = nullptr;   // [target joints + 1] first triangle in `order` of each nearest joint
  uint32_t* order = nullptr;    // [triangles] by nearest joint
  uint32_t* nearest = nullptr;  // [triangles] scratch
  uint8_t* parts_of = nullptr;  // [triangles] kTorso, kHead, or kFirstLimb + limb
  double* areas = nullptr;      // [triangles] of the posed source, in shares of their mean
  Vec3d* normals = nullptr;     // [triangles] of the posed source
  uint32_t* above =
      nullptr;  // [target joints] the joint that its bone begins at, kNoIndex for others than nodes and roots
  uint8_t* is_node = nullptr;     // [target joints] mapped, as the first of its source
  Vec3d* source_bones = nullptr;  // [target joints] of one path
  Vec3d* target_bones = nullptr;
  ArmSearch search;
  TriangleTree source_tree, target_tree;

  bool allocate(Arena& arena, uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles) {
    (void)ClipScene::allocate(arena, source_joints, target_joints, vertices, triangles);
    groups = arena.alloc<uint32_t>(size_t{target_joints} + 1);
    order = arena.alloc<uint32_t>(triangles);
    nearest = arena.alloc<uint32_t>(triangles);
    parts_of = arena.alloc<uint8_t>(triangles);
    areas = arena.alloc<double>(triangles);
    normals = arena.alloc<Vec3d>(triangles);
    above = arena.alloc<uint32_t>(target_joints);
    is_node = arena.alloc<uint8_t>(target_joints);
    source_bones = arena.alloc<Vec3d>(target_joints);
    target_bones = arena.alloc<Vec3d>(target_joints);
    source_tree.allocate(arena, triangles);
    target_tree.allocate(arena, triangles);
    search.allocate(arena, vertices, triangles);
    return arena.ok();
  }
};

// Joints that move the body themselves; fingers, ends and accessories do not decide the part of a triangle.
bool is_body_class(uint32_t c) { return c <= SINEW_CLASS_TAIL || c == SINEW_CLASS_WING; }

class ReferencePoints {
 public:
  ReferencePoints(const ReferenceOptions& options, ReferenceScene* scene)
      : options_(options),
        s_(*scene),
        plan_(*scene->plan),
        rig_(scene->plan->target),
        triangles_(scene->body->triangle_count) {
    find_nodes();
    find_head();
    find_groups();
    if (pushes_out()) s_.search.open(s_);
    if (s_.source.height > 0) heights_ = s_.target.height / s_.source.height;
  }

  sinew_status run() {
    const uint32_t frames = s_.in->frames;
    for (uint32_t f = 0; f < frames; ++f) {
      (void)s_.load_source(f, true);
      s_.source.find_middles(s_.body->triangles, triangles_);
      measure_triangles();
      s_.load(f);
      if (options_.torso) take_torso();
      s_.target.pose(plan_.target_rotations, plan_.target_positions);
      s_.target.find_middles(s_.body->triangles, triangles_);
      if (pushes_out()) find_depths();
      Vec3d middles[kMostLimbs], lasts[kMostLimbs];
      for (uint32_t l = 0; l < s_.limbs.count; ++l) {
        if (!is_moved(l)) continue;
        middles[l] = position(s_.limbs.limbs[l].middle, kFirstLimb + l);
        lasts[l] = position(s_.limbs.limbs[l].last, kFirstLimb + l);
      }
      if (options_.head && neck_ != kNoIndex) move_head(position(head_, kHead));
      for (uint32_t l = 0; l < s_.limbs.count; ++l) {
        if (is_moved(l)) move_limb(s_.limbs.limbs[l], lasts[l], middles[l], &plan_);
      }
      if (pushes_out()) come_out();
      s_.store(f);
      if (!s_.in->progress.report(static_cast<uint32_t>(uint64_t{f + 1} * 1000 / frames))) return SINEW_ERROR_CANCELLED;
    }
    return SINEW_OK;
  }

 private:
  bool pushes_out() const { return !options_.outwards && !options_.as_drawn; }
  bool is_moved(uint32_t limb) const { return options_.legs || !s_.limbs.limbs[limb].leg; }
  uint32_t source_of(uint32_t t) const { return static_cast<uint32_t>(plan_.map[t]); }
  Vec3d source_rest(uint32_t t) const { return rotate(plan_.rotation, plan_.source.positions[source_of(t)]); }

  // Among joints with one source the first is a node of the path; its bone begins at the next node above.
  void find_nodes() {
    for (uint32_t i = 0; i < rig_.count; ++i) {
      const uint32_t t = rig_.order[i];
      uint32_t up = rig_.parents[t] < 0 ? kNoIndex : static_cast<uint32_t>(rig_.parents[t]);
      while (up != kNoIndex && s_.is_node[up] == 0)
        up = rig_.parents[up] < 0 ? kNoIndex : static_cast<uint32_t>(rig_.parents[up]);
      s_.above[t] = up;
      s_.is_node[t] = plan_.map[t] >= 0 && (up == kNoIndex || plan_.map[up] != plan_.map[t]) ? 1 : 0;
    }
  }

  // The first mapped head, and the first joint of its neck, else its parent.
  void find_head() {
    for (uint32_t i = 0; i < rig_.count && head_ == kNoIndex; ++i) {
      const uint32_t t = rig_.order[i];
      if (plan_.classes[t] != SINEW_CLASS_HEAD || s_.is_node[t] == 0 || rig_.parents[t] < 0) continue;
      head_ = t;
      neck_ = static_cast<uint32_t>(rig_.parents[t]);
      for (int32_t up = rig_.parents[t]; up >= 0 && plan_.classes[up] == SINEW_CLASS_NECK; up = rig_.parents[up])
        neck_ = static_cast<uint32_t>(up);
    }
  }

  // Triangles by the node that is nearest to their middle in the source's rest pose.
  void find_groups() {
    bool any_body = false;
    for (uint32_t t = 0; t < rig_.count; ++t)
      any_body = any_body || (s_.is_node[t] != 0 && is_body_class(plan_.classes[t]));
    for (uint32_t v = 0; v < s_.body->vertex_count; ++v)
      s_.source.vertices[v] = rotate(plan_.rotation, s_.source.rest(v));
    s_.source.find_middles(s_.body->triangles, triangles_);
    for (uint32_t j = 0; j <= rig_.count; ++j) s_.groups[j] = 0;
    for (uint32_t i = 0; i < triangles_; ++i) {
      double least = 0;
      uint32_t best = kNoIndex;
      for (uint32_t t = 0; t < rig_.count; ++t) {
        if (s_.is_node[t] == 0 || (any_body && !is_body_class(plan_.classes[t]))) continue;
        const Vec3d offset = source_rest(t) - s_.source.middles[i];
        const double own = dot(offset, offset);
        if (best != kNoIndex && own >= least) continue;
        least = own;
        best = t;
      }
      s_.nearest[i] = best;
      ++s_.groups[best + 1];
      s_.parts_of[i] = part_of(i);
    }
    for (uint32_t j = 0; j < rig_.count; ++j) s_.groups[j + 1] += s_.groups[j];
    for (uint32_t i = 0; i < triangles_; ++i) s_.order[s_.groups[s_.nearest[i]]++] = i;
    for (uint32_t j = rig_.count; j > 0; --j) s_.groups[j] = s_.groups[j - 1];
    s_.groups[0] = 0;
  }

  // A limb's where it has a corner there; the head's where most of a corner is.
  uint8_t part_of(uint32_t triangle) const {
    uint8_t part = kTorso;
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t v = s_.body->triangles[size_t{3} * triangle + c];
      if (s_.limb_of[v] < kMostLimbs) return static_cast<uint8_t>(kFirstLimb + s_.limb_of[v]);
      if (head_ != kNoIndex && rig_.is_below(heaviest_joint(*s_.body, v), head_)) part = kHead;
    }
    return part;
  }

  void measure_triangles() {
    double sum = 0;
    for (uint32_t i = 0; i < triangles_; ++i) {
      const uint32_t* const corner = s_.body->triangles + size_t{3} * i;
      const Vec3d a = s_.source.vertices[corner[0]];
      const Vec3d twice = cross(s_.source.vertices[corner[1]] - a, s_.source.vertices[corner[2]] - a);
      s_.areas[i] = length(twice);
      s_.normals[i] = unit(twice);
      sum += s_.areas[i];
    }
    const double mean = sum / triangles_;
    for (uint32_t i = 0; i < triangles_; ++i) s_.areas[i] = mean > 0 ? s_.areas[i] / mean : 0;
  }

  // Bones from a node to another, through the first that is above both. kNoIndex: nothing is above both.
  uint32_t offset(uint32_t from, uint32_t to) {
    uint32_t meet = from;
    while (meet != kNoIndex && !rig_.is_below(to, meet)) meet = s_.above[meet];
    if (meet == kNoIndex) return kNoIndex;
    uint32_t count = 0;
    const uint32_t ends[2] = {from, to};
    for (const uint32_t end : ends) {
      for (uint32_t t = end; t != meet; t = s_.above[t]) {
        const uint32_t up = s_.above[t];
        s_.source_bones[count] = plan_.source_positions[source_of(t)] - plan_.source_positions[source_of(up)];
        s_.target_bones[count++] = plan_.target_positions[t] - plan_.target_positions[up];
      }
    }
    return count;
  }

  bool is_left_out(uint32_t triangle, uint32_t own_part) const {
    return (!options_.own_limb || (own_part == kHead && !options_.as_drawn)) && s_.parts_of[triangle] == own_part;
  }

  double influence(uint32_t triangle, Vec3d along, double distance) const {
    const double cosine = absolute(dot(along, s_.normals[triangle]));
    double own = cosine > options_.least_cosine ? cosine : options_.least_cosine;
    for (uint32_t i = 0; i < options_.area_power; ++i) own *= s_.areas[triangle];
    if (options_.falloff > 0 && s_.source.height > 0) {
      const double share = distance / (options_.falloff * s_.source.height);
      own *= falling(share * share);
    }
    return own;
  }

  // Where the reference points of a part of the body want a joint, and how near the nearest of them is.
  struct PartGoal {
    Vec3d sum = {0, 0, 0};
    double all = 0, nearest = 0;
    uint32_t triangle = 0;  // the nearest
  };

  // Where all triangles together want a joint; where it is, if none has a say. The parts of the body have one goal each, the mean of
  // which counts by nearness; as drawn all triangles are one part.
  Vec3d position(uint32_t joint, uint32_t own_part) {
    const Vec3d goal = plan_.source_positions[source_of(joint)];
    PartGoal part_goals[kFirstLimb + kMostLimbs];
    uint32_t node = joint;
    while (s_.is_node[node] == 0) node = s_.above[node];
    for (uint32_t group = 0; group < rig_.count; ++group) {
      if (s_.groups[group] == s_.groups[group + 1]) continue;
      const uint32_t bones = offset(group, node);
      for (uint32_t k = s_.groups[group]; k < s_.groups[group + 1]; ++k) {
        const uint32_t i = s_.order[k];
        if (is_left_out(i, own_part)) continue;
        const Vec3d v = goal - s_.source.middles[i];
        const double distance = length(v);
        const Vec3d along = unit(v);
        double factor = 1;  // the nearest joint itself: nothing lies between
        if (bones > 0) {
          double from = 0, to = 0;
          for (uint32_t b = 0; bones != kNoIndex && b < bones; ++b) {
            from += absolute(dot(along, s_.source_bones[b]));
            to += absolute(dot(along, s_.target_bones[b]));
          }
          factor = from > kLeastLength * s_.source.height ? to / from : heights_;
        }
        const double own = influence(i, along, distance);
        PartGoal& part_goal = part_goals[options_.as_drawn ? kTorso : s_.parts_of[i]];
        if (own > 0 && (part_goal.all == 0 || distance < part_goal.nearest)) {
          part_goal.nearest = distance;
          part_goal.triangle = i;
        }
        part_goal.all += own;
        part_goal.sum = part_goal.sum + own * (point(i) + factor * v);
      }
    }
    Vec3d sum = {0, 0, 0};
    double all = 0;
    const double least = 1e-3 * s_.source.height;
    const PartGoal* nearest = nullptr;
    for (const PartGoal& part_goal : part_goals) {
      if (part_goal.all <= kLeastSquare) continue;
      if (nearest == nullptr || part_goal.nearest < nearest->nearest) nearest = &part_goal;
      const double near = 1 / (part_goal.nearest * part_goal.nearest + least * least);
      const double share = near * near;
      all += share;
      sum = sum + (share / part_goal.all) * part_goal.sum;
    }
    const Vec3d copied = plan_.target_positions[joint];
    if (!(all > 0)) return copied;
    const Vec3d shift = (1 / all) * sum - copied;
    if (!options_.outwards) return copied + shift;
    const Vec3d out = s_.target.normal(s_.body->triangles + size_t{3} * nearest->triangle);
    const double along = dot(shift, out);
    return copied + (along < 0 ? Vec3d{0, 0, 0} : along * out);
  }

  // How deep hands and forearms may lie in the body: as the source's, or as they were copied.
  void find_depths() {
    s_.search.fill(s_.source, true, &s_.source_tree);
    s_.search.fill(s_.target, true, &s_.target_tree);
    for (uint32_t a = 0; a < s_.search.count(); ++a) {
      const double source = heights_ * s_.search.deepest(&s_.source_tree, a, {0, 0, 0}, 0).depth;
      depths_[a] = kGivesWay * s_.target.height + s_.search.deepest(&s_.target_tree, a, {0, 0, 0}, source).depth;
    }
  }

  // Reference points bring joints, not skin: what is deeper than it may be comes out by as much.
  void come_out() {
    s_.target.pose(plan_.target_rotations, plan_.target_positions);
    s_.search.fill(s_.target, true, &s_.target_tree);
    for (uint32_t a = 0; a < s_.search.count(); ++a) {
      const ArmDepth most = s_.search.deepest(&s_.target_tree, a, {0, 0, 0}, depths_[a]);
      const Limb& limb = s_.limbs.limbs[s_.search.limb(a)];
      const Vec3d last = plan_.target_positions[limb.last] + (most.depth - depths_[a]) * most.out;
      if (most.depth > depths_[a]) move_limb(limb, last, plan_.target_positions[limb.middle], &plan_);
    }
  }

  // The target's reference point; or the source's, where it lies when the bodies' middles are laid over each other.
  Vec3d point(uint32_t triangle) const {
    if (!options_.source_points || plan_.mover < 0) return s_.target.middles[triangle];
    const uint32_t hips = static_cast<uint32_t>(plan_.mover);
    return plan_.target_positions[hips] +
           plan_.scale * (s_.source.middles[triangle] - plan_.source_positions[source_of(hips)]);
  }

  // Brings the head to the direction of `goal` from the neck's beginning; it keeps its rotation.
  void move_head(Vec3d goal) {
    const Vec3d pivot = plan_.target_positions[neck_];
    const Quat turn = shortest_arc(plan_.target_positions[head_] - pivot, goal - pivot);
    const Vec3d shift = pivot + rotate(turn, plan_.target_positions[head_] - pivot) - plan_.target_positions[head_];
    for (uint32_t t = 0; t < rig_.count; ++t) {
      if (!rig_.is_below(t, neck_)) continue;
      if (rig_.is_below(t, head_)) {
        plan_.target_positions[t] = plan_.target_positions[t] + shift;
      } else {
        plan_.target_positions[t] = pivot + rotate(turn, plan_.target_positions[t] - pivot);
        plan_.target_rotations[t] = turn * plan_.target_rotations[t];
      }
    }
  }

  bool is_torso(uint32_t t) const {
    const uint32_t c = plan_.classes[t];
    return s_.is_node[t] != 0 && (c == SINEW_CLASS_PELVIS || c == SINEW_CLASS_SPINE || c == SINEW_CLASS_NECK);
  }

  // Torso joints go where the source's are, seen from the one before: bones keep their lengths, their children their
  // rotations.
  void take_torso() {
    for (uint32_t i = 0; i < rig_.count; ++i) {
      const uint32_t t = rig_.order[i];
      const uint32_t up = s_.above[t];
      if (!is_torso(t) || up == kNoIndex || !is_torso(up)) continue;
      const Vec3d pivot = plan_.target_positions[up], now = plan_.target_positions[t] - pivot;
      const Vec3d wanted = plan_.source_positions[source_of(t)] - plan_.source_positions[source_of(up)];
      if (length(now) <= 0 || length(wanted) <= 0) continue;
      const Vec3d shift = length(now) * unit(wanted) - now;
      // The pelvis is the parent of the legs, so it keeps its rotation.
      const Quat turn = plan_.classes[up] == SINEW_CLASS_PELVIS ? kNoRotation : shortest_arc(now, wanted);
      for (uint32_t below = 0; below < rig_.count; ++below) {
        if (!rig_.is_below(below, up) || below == up) continue;
        const bool beyond = rig_.is_below(below, t);
        const Vec3d offset = plan_.target_positions[below] - pivot;
        plan_.target_positions[below] = beyond ? plan_.target_positions[below] + shift : pivot + rotate(turn, offset);
      }
      plan_.target_rotations[up] = turn * plan_.target_rotations[up];
    }
  }

  const ReferenceOptions& options_;
  ReferenceScene& s_;
  sinew_retarget& plan_;
  const MotionRig& rig_;
  uint32_t triangles_;
  uint32_t head_ = kNoIndex, neck_ = kNoIndex;  // target joints, and the pivot of the head
  double heights_ = 1;                          // of the target's body per the source's
  double depths_[kMostArms] = {};
};

}  // namespace

size_t measure_reference_points(uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles) {
  Arena arena;
  ReferenceScene scene;
  CapsuleBodies capsules;
  const uint32_t count = CapsuleBodies::capacity(target_joints);
  (void)capsules.allocate(arena, target_joints);
  const auto greater_of = [](uint32_t a, uint32_t b) { return a > b ? a : b; };
  (void)scene.allocate(arena, source_joints, target_joints, greater_of(vertices, count * CapsuleBodies::kVertices),
                       greater_of(triangles, count * CapsuleBodies::kTriangles));
  return arena.ok() ? arena.high_water() : 0;
}

sinew_status run_reference_points(sinew_retarget* plan, const sinew_motion_body* source_body,
                                  const sinew_motion_body& target_body, const ClipInputs& inputs,
                                  const ReferenceOptions& options, Arena& arena) {
  CapsuleBodies capsules;
  if (!capsules.allocate(arena, plan->target.count)) return SINEW_ERROR_WORKSPACE;
  if (source_body == nullptr) capsules.build(*plan, target_body);
  const sinew_motion_body source = source_body != nullptr ? *source_body : capsules.source();
  const sinew_motion_body target = source_body != nullptr ? target_body : capsules.target();
  ReferenceScene scene;
  if (!scene.allocate(arena, plan->source.count, plan->target.count, target.vertex_count, target.triangle_count))
    return SINEW_ERROR_WORKSPACE;
  if (target.vertex_count == 0) return SINEW_OK;  // no two mapped joints: nothing to look at
  const sinew_status status = scene.open(plan, &source, target, inputs);
  if (status != SINEW_OK || scene.has_all_contacts() || target.triangle_count == 0) return status;
  ReferenceOptions own = options;
  own.outwards = source_body == nullptr && !own.as_drawn;
  return ReferencePoints(own, &scene).run();
}

}  // namespace sinew::motion
