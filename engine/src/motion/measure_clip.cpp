// SPDX-License-Identifier: MIT
// Sums over the frames of a clip.
#include "motion/contacts.hpp"
#include "motion/foot_search.hpp"
#include "motion/natural_range.hpp"

namespace sinew::motion {
namespace {

constexpr double kDeep = 0.006;  // share of the height

// Sums over the frames of one limb.
struct Tally {
  double depth = 0, greatest_depth = 0, error = 0, greatest_error = 0;
  uint32_t deep = 0, contacts = 0, out = 0;

  void add_depth(double share) {
    if (share <= 0) return;
    depth += share;
    if (share > greatest_depth) greatest_depth = share;
    if (share > kDeep) ++deep;
  }
  void add_error(double share) {
    const double own = share < 0 ? -share : share;
    error += own;
    if (own > greatest_error) greatest_error = own;
    ++contacts;
  }
};

class Measure {
 public:
  // spots: [frames x kMostLimbs], or null
  Measure(ContactScene* scene, sinew_contact_spot* spots)
      : s_(*scene),
        spots_(spots),
        feet_(scene),
        source_share_(share_of(scene->source_height)),
        share_(share_of(scene->target.height)) {
    find_hinges(s_, hinges_);
    s_.search.open(s_);
  }

  sinew_status run(sinew_limb_quality* out, uint32_t* count) {
    Tally tallies[kMostLimbs];
    const uint32_t frames = s_.in->frames;
    for (size_t i = 0; spots_ != nullptr && i < size_t{frames} * kMostLimbs; ++i) spots_[i] = {};
    if (!s_.has_source) find_rest_depths();
    for (uint32_t l = 0; l < s_.limbs.count; ++l) {
      if (s_.limbs.limbs[l].leg) measure_slide(l, &tallies[l]);
    }
    for (uint32_t f = 0; f < frames; ++f) {
      s_.search_source(f);
      s_.search_target(f, false);
      for (uint32_t a = 0; a < s_.search.count(); ++a) measure_arm(f, a, &tallies[s_.search.limb(a)]);
      for (uint32_t l = 0; l < s_.limbs.count; ++l) {
        const Limb& limb = s_.limbs.limbs[l];
        if (is_out_of_range(*s_.plan, limb, hinges_[l])) ++tallies[l].out;
        if (!limb.leg) continue;
        const FootHeights low = feet_.lowest(limb, l);
        tallies[l].add_depth((low.source < 0 ? source_share_ * low.source : 0) - share_ * low.target);
      }
      if (!s_.in->progress.report(static_cast<uint32_t>(uint64_t{f + 1} * 1000 / frames))) return SINEW_ERROR_CANCELLED;
    }
    for (uint32_t l = 0; l < s_.limbs.count; ++l) write(s_.limbs.limbs[l], tallies[l], frames, &out[l]);
    *count = s_.limbs.count;
    return SINEW_OK;
  }

 private:
  // 1 / height; a flat body has no shares.
  static double share_of(double height) { return height > 0 ? 1 / height : 0; }

  void find_rest_depths() {
    s_.search_target_at_rest();
    for (uint32_t a = 0; a < s_.search.count(); ++a)
      rest_depths_[a] = s_.search.deepest(&s_.target_tree, a, {0, 0, 0}, 0).depth;
  }

  void measure_arm(uint32_t f, uint32_t arm, Tally* tally) {
    const uint32_t limb = s_.search.limb(arm);
    const double least = s_.has_source ? 0 : rest_depths_[arm];
    const ArmDepth deepest = s_.has_source ? s_.search.deepest(&s_.target_tree, arm, {0, 0, 0}, least)
                                           : s_.search.deepest_inside(&s_.target_tree, arm, {0, 0, 0}, least);
    double depth = share_ * deepest.depth;
    depth -=
        s_.has_source ? source_share_ * s_.search.deepest(&s_.source_tree, arm, {0, 0, 0}, 0).depth : share_ * least;
    tally->add_depth(depth);
    if (depth > kDeep) set_spot(f, limb, SINEW_SPOT_INSIDE, s_.target.vertices[deepest.vertex], depth);
    if (!s_.has_source) return;
    const HandReach from = s_.search.nearest(s_.source_tree, arm);
    if (!from.near || from.square > kTouch * kTouch * s_.source.height * s_.source.height) return;
    // The same point of the target's hand: farther than it can see it counts as that far.
    const double now = s_.search.distance(s_.target_tree, arm, from.vertex);
    const double error = share_ * now - source_share_ * root(from.square);
    tally->add_error(error);
    if (depth <= kDeep)
      set_spot(f, limb, SINEW_SPOT_TOUCHES, s_.target.vertices[from.vertex], error < 0 ? -error : error);
  }

  void measure_slide(uint32_t number, Tally* tally) {
    const Limb& limb = s_.limbs.limbs[number];
    feet_.find_standing(limb, s_.standing);
    Vec3d before = {0, 0, 0};
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      s_.load(f);
      const Vec3d position = s_.plan->target_positions[feet_.sole_joint(limb)];
      const Vec3d flat = position - dot(position, s_.plan->up) * s_.plan->up;
      const bool stood = f > 0 && s_.standing[f - 1] != 0;
      const double slide = stood ? share_ * length(flat - before) : 0;
      if (s_.standing[f] != 0) {
        if (stood) tally->add_error(slide);
        set_spot(f, number, SINEW_SPOT_STANDS, position, slide);
      }
      before = flat;
    }
  }

  void set_spot(uint32_t f, uint32_t limb, sinew_spot_kind kind, Vec3d position, double error) {
    if (spots_ == nullptr) return;
    sinew_contact_spot* const spot = &spots_[size_t{f} * kMostLimbs + limb];
    spot->kind = static_cast<uint32_t>(kind);
    spot->position[0] = static_cast<float>(position.x);
    spot->position[1] = static_cast<float>(position.y);
    spot->position[2] = static_cast<float>(position.z);
    spot->error = static_cast<float>(error);
  }

  static void write(const Limb& limb, const Tally& tally, uint32_t frames, sinew_limb_quality* out) {
    *out = {};
    out->joint = limb.last;
    out->leg = limb.leg ? 1 : 0;
    out->frames = frames;
    out->deep_frames = tally.deep;
    out->contact_frames = tally.contacts;
    out->range_frames = tally.out;
    out->depth = static_cast<float>(frames > 0 ? tally.depth / frames : 0);
    out->greatest_depth = static_cast<float>(tally.greatest_depth);
    out->error = static_cast<float>(tally.contacts > 0 ? tally.error / tally.contacts : 0);
    out->greatest_error = static_cast<float>(tally.greatest_error);
  }

  ContactScene& s_;
  sinew_contact_spot* spots_;
  FootSearch feet_;
  double source_share_, share_;
  Hinge hinges_[kMostLimbs];
  double rest_depths_[kMostArms] = {};
};

}  // namespace

sinew_status measure_clip(sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body& target,
                          const ClipInputs& inputs, Arena& arena, sinew_limb_quality* limbs, uint32_t* limb_count,
                          sinew_contact_spot* spots) {
  ContactScene scene;
  if (!scene.allocate_all(arena, plan->source.count, plan->target.count, target.vertex_count, target.triangle_count,
                          inputs.frames)) {
    return SINEW_ERROR_WORKSPACE;
  }
  const sinew_status status = scene.open(plan, source, target, inputs);
  return status == SINEW_OK ? Measure(&scene, spots).run(limbs, limb_count) : status;
}

}  // namespace sinew::motion
