// SPDX-License-Identifier: MIT
// Meshes, map, match, binds, rows: strings the stages of a transfer together.
#include "sinew/published.h"
#include "transfer/balance.hpp"
#include "transfer/inpaint.hpp"
#include "transfer/plan.hpp"
#include "transfer/published.hpp"
#include "transfer/rebind.hpp"
#include "transfer/report.hpp"
#include "weights/users_say.hpp"

namespace sinew::transferring {
namespace {

// A match that is farther, in longest sides of the target, or faces elsewhere is none, and is filled in.
constexpr double kKnownDistance = 0.05, kKnownCosine = 0.5;
// Ends of the stages, permille.
constexpr uint32_t kMeshesEnd = 50, kMatchEnds = 200, kSourceBindsEnd = 550, kTargetBindEnds = 900, kRowsEnd = 1000;

class Transfer {
 public:
  Transfer(const TransferPlan& plan, const TransferInput& input, Arena& arena)
      : plan_(plan), input_(input), arena_(arena) {}

  sinew_status run(sinew_transfer_outputs* outputs) {
    if (!allocate()) return SINEW_ERROR_WORKSPACE;
    sinew_status status = read_both();
    if (status != SINEW_OK) return status;
    if (plan_.matches()) {
      status = find_match(plan_, input_, pair_, source_rows_.rows(), arena_, &match_);
      if (status != SINEW_OK) return status;
    }
    if (plan_.method == SINEW_TRANSFER_BIHARMONIC)
      status = match_by_distances(plan_, pair_, source_rows_.rows(), arena_, &distance_match_);
    if (status != SINEW_OK) return status;
    if (!arena_.measuring()) {
      for (uint32_t v = 0; v < pair_.source.welded_count; ++v) map_row(pair_.map, source_rows_.rows(), v);
      if (!plan_.progress.report(kMatchEnds)) return SINEW_ERROR_CANCELLED;
    }
    if (plan_.binds()) {
      status = bind_both();
      if (status != SINEW_OK) return status;
    }
    status = make_rows();
    if (status != SINEW_OK || arena_.measuring()) return status;
    if (!plan_.progress.report(kRowsEnd)) return SINEW_ERROR_CANCELLED;
    const TransferOutcome result = {plan_, pair_, rows_, match_, balance_, bound_by_, distance_match_.reference_count};
    write_transfer(result, report_, outputs);
    return SINEW_OK;
  }

 private:
  bool allocate() {
    (void)pair_.allocate(arena_, plan_);
    map_scratch_ = arena_.alloc<uint32_t>(size_t{2} * plan_.source.joints);
    source_flags_ = arena_.alloc<uint8_t>(plan_.source.joints);
    target_flags_ = arena_.alloc<uint8_t>(plan_.target.joints);
    ends_ = arena_.alloc<uint8_t>(plan_.source.joints);
    folds_to_ = arena_.alloc<uint16_t>(plan_.target.joints);
    (void)source_rows_.allocate(arena_, plan_.source);
    (void)rows_.allocate(arena_, plan_.target);
    (void)report_.allocate(arena_, plan_.target);
    (void)balance_.allocate(arena_, plan_.target);
    if (plan_.matches()) (void)match_.allocate(arena_, plan_.target);
    if (plan_.method == SINEW_TRANSFER_BIHARMONIC) (void)distance_match_.allocate(arena_, plan_.target);
    if (plan_.binds()) {
      (void)source_bound_.allocate(arena_, plan_.source);
      (void)source_other_.allocate(arena_, plan_.source);
      (void)bound_.allocate(arena_, plan_.target);
      if (plan_.garment) (void)other_.allocate(arena_, plan_.target);
      source_style_ = arena_.alloc<double>(plan_.source.vertices);
    }
    return arena_.ok();
  }

  sinew_status read_both() {
    const sinew_bound_character& source = input_.source;
    const sinew_status status = pair_.build(plan_, input_, arena_);
    if (status != SINEW_OK || arena_.measuring()) return status;
    pair_.map.complete(source.joint_map, pair_.source_joints, pair_.target_joints, map_scratch_);
    source_rows_.gather(pair_.source, source.skin.joint_indices, source.skin.weights, source.skin.weight_format,
                        source.skin.influence_count);
    set_flags();
    bool any = false;
    for (uint32_t v = 0; v < pair_.source.welded_count && !any; ++v) any = has_weight(source_rows_.rows(), v);
    if (!any) return SINEW_ERROR_RANGE;
    return plan_.progress.report(kMeshesEnd) ? SINEW_OK : SINEW_ERROR_CANCELLED;
  }

  // A joint that moves nothing in the source is to move nothing in the binds either. Ends of chains are an exception: whether
  // they or their parents move what is there is a matter of style, which the target's caller decides. Where rows are
  // compared, they count as their parents. A garment may cover what of the body is not there: all joints are as the caller says.
  void set_flags() {
    const auto given = [](const sinew_skeleton& skeleton, uint32_t j) -> uint8_t {
      return skeleton.flags != nullptr ? skeleton.flags[j] : 0;
    };
    const sinew_skeleton& source = *input_.source.skeleton;
    const sinew_skeleton& target = input_.skeleton;
    for (uint32_t j = 0; j < target.joint_count; ++j) {
      target_flags_[j] = given(target, j);
      folds_to_[j] = static_cast<uint16_t>(j);
    }
    for (uint32_t j = 0; j < source.joint_count; ++j) {
      source_flags_[j] = SINEW_JOINT_NEVER;
      ends_[j] = 0;
    }
    for (uint32_t v = 0; v < pair_.source.welded_count; ++v) {
      for (uint32_t i = 0; i < kRowSlots; ++i) {
        const uint16_t joint = source_rows_.rows().joints_of(v)[i];
        if (joint != kNoJoint && source_rows_.rows().weights_of(v)[i] > 0) source_flags_[joint] = 0;
      }
    }
    if (plan_.garment) return;
    const auto moves = [&](uint32_t j) { return source_flags_[j] == 0; };
    // Among several joints with one counterpart, one with weight is enough.
    for (uint32_t j = 0; j < source.joint_count; ++j) {
      if (pair_.map.same[j] >= 0 && !moves(j)) target_flags_[pair_.map.same[j]] = SINEW_JOINT_NEVER;
    }
    for (uint32_t j = 0; j < source.joint_count; ++j) {
      const int32_t to = pair_.map.same[j];
      if (to >= 0 && moves(j)) target_flags_[to] = given(target, static_cast<uint32_t>(to));
    }
    for (uint32_t j = 0; j < source.joint_count; ++j) {
      const int32_t parent = source.parents[j];
      if (moves(j) || pair_.source_joints.child_count[j] > 0 || parent < 0 || !moves(static_cast<uint32_t>(parent)) ||
          (given(source, j) & SINEW_JOINT_NEVER) != 0)
        continue;
      ends_[j] = 1;
    }
    for (uint32_t j = 0; j < source.joint_count; ++j) {
      if (ends_[j] == 0) continue;
      source_flags_[j] = given(source, j);
      const int32_t to = pair_.map.same[j];
      if (to < 0 || target_flags_[to] != SINEW_JOINT_NEVER || pair_.target_joints.child_count[to] > 0 ||
          target.parents[to] < 0)
        continue;
      target_flags_[to] = given(target, static_cast<uint32_t>(to));
      folds_to_[to] = static_cast<uint16_t>(target.parents[to]);
    }
    bool usable = false;
    for (uint32_t j = 0; j < target.joint_count; ++j) usable = usable || (target_flags_[j] & SINEW_JOINT_NEVER) == 0;
    for (uint32_t j = 0; j < target.joint_count && !usable; ++j) target_flags_[j] = given(target, j);
  }

  // Ends of chains give their weight to their parents.
  void fold_ends(const Rows& rows, uint32_t count) const {
    for (uint32_t v = 0; v < count; ++v) {
      for (uint32_t i = 0; i < kRowSlots; ++i) {
        const uint16_t joint = rows.joints_of(v)[i];
        if (joint == kNoJoint || folds_to_[joint] == joint) continue;
        const uint32_t weight = rows.weights_of(v)[i];
        rows.joints_of(v)[i] = kNoJoint;
        rows.weights_of(v)[i] = 0;
        rows.add(v, folds_to_[joint], weight);
      }
    }
  }

  // Binds the source by every binder at hand, and the target by the one that is nearest to the source's weights.
  sinew_status bind_both() {
    sinew_skeleton source = *input_.source.skeleton, target = input_.skeleton;
    source.flags = source_flags_;
    target.flags = target_flags_;
    DressedMesh dressed;
    const ArenaScope scope(arena_);
    if (plan_.garment && !dressed.allocate(arena_, plan_.dressed)) return SINEW_ERROR_WORKSPACE;
    if (plan_.garment && !arena_.measuring()) dressed.join(*input_.source.mesh, input_.target);
    const uint32_t first = plan_.with_model ? SINEW_METHOD_MODEL : SINEW_METHOD_HEAT;
    double least = 0;
    for (uint32_t method = first; method <= SINEW_METHOD_HEAT; ++method) {
      const uint32_t half = kMatchEnds + (kSourceBindsEnd - kMatchEnds) / 2;
      const Progress progress = method == SINEW_METHOD_MODEL ? plan_.progress.part(kMatchEnds, half)
                                                             : plan_.progress.part(half, kSourceBindsEnd);
      const sinew_status status = plan_.garment
                                      ? bind_rows(plan_.target_binds[method], progress, dressed.mesh, target,
                                                  pair_.source, &pair_.target, arena_, &source_other_, &other_)
                                      : bind_rows(plan_.source_binds[method], progress, *input_.source.mesh, source,
                                                  pair_.source, nullptr, arena_, &source_other_, nullptr);
      if (status != SINEW_OK) return status;
      if (arena_.measuring()) continue;
      double sum = 0;
      for (uint32_t v = 0; v < pair_.source.welded_count; ++v) {
        // A garment's bind has the target's joints already.
        if (!plan_.garment) map_row(pair_.map, source_other_.rows(), v);
      }
      fold_ends(source_other_.rows(), pair_.source.welded_count);
      for (uint32_t v = 0; v < pair_.source.welded_count; ++v) {
        if (has_weight(source_rows_.rows(), v)) sum += row_distance(source_other_.rows(), v, source_rows_.rows(), v);
      }
      if (method > first && sum >= least) continue;
      least = sum;
      bound_by_ = method;
      swap(&source_bound_, &source_other_);
      if (plan_.garment) swap(&bound_, &other_);
    }
    if (plan_.garment) return SINEW_OK;
    const Progress progress = plan_.progress.part(kSourceBindsEnd, kTargetBindEnds);
    if (!arena_.measuring()) {
      return bind_rows(plan_.target_binds[bound_by_], progress, input_.target, target, pair_.target, nullptr, arena_,
                       &bound_, nullptr);
    }
    for (uint32_t method = first; method <= SINEW_METHOD_HEAT; ++method)
      (void)bind_rows(plan_.target_binds[method], progress, input_.target, target, pair_.target, nullptr, arena_,
                      &bound_, nullptr);
    return arena_.ok() ? SINEW_OK : SINEW_ERROR_WORKSPACE;
  }
  static void swap(OwnRows* a, OwnRows* b) {
    const OwnRows kept = *a;
    *a = *b;
    *b = kept;
  }

  sinew_status make_rows() {
    const ArenaScope scope(arena_);
    uint8_t* const known = arena_.alloc<uint8_t>(plan_.target.vertices);
    Rows one, folded;  // of a vertex
    Counts single;
    single.vertices = 1;
    (void)one.allocate(arena_, single);
    if (!folded.allocate(arena_, single)) return SINEW_ERROR_WORKSPACE;
    const uint32_t count = arena_.measuring() ? 0 : pair_.target.welded_count;
    for (uint32_t v = 0; v < count; ++v) {
      balance_.style[v] = balance_.mismatch[v] = 0;
      balance_.carried[v] = plan_.binds() ? 0 : 1;
      balance_.matched[v] = 0;
    }
    if (plan_.method == SINEW_TRANSFER_REBIND) {
      for (uint32_t v = 0; v < count; ++v) rows_.copy(v, bound_.rows(), v);
      return SINEW_OK;
    }
    if (plan_.method == SINEW_TRANSFER_BIHARMONIC) {
      for (uint32_t v = 0; v < count; ++v) distance_match_.carry(source_rows_.rows(), v, rows_);
      return SINEW_OK;
    }
    for (uint32_t v = 0; v < count; ++v) {
      match_.carry(source_rows_.rows(), v, rows_, v);
      const MatchedPoint& p = match_.points[v];
      known[v] = p.distance < kKnownDistance && p.cosine > kKnownCosine && has_weight(rows_, v) ? 1 : 0;
    }
    const sinew_status status = inpaint(pair_.target, known, plan_.target.joints, plan_.target, arena_, &rows_);
    if (status != SINEW_OK || plan_.method == SINEW_TRANSFER_NEAREST || arena_.measuring()) return status;

    constexpr double kUnit = 1.0 / kWholeRow;
    for (uint32_t v = 0; v < pair_.source.welded_count; ++v) {
      source_style_[v] = has_weight(source_rows_.rows(), v)
                             ? kUnit * row_distance(source_bound_.rows(), v, source_rows_.rows(), v)
                             : 0;
    }
    for (uint32_t v = 0; v < count; ++v) {
      balance_.style[v] = match_.carry(source_style_, v);
      match_.carry(source_bound_.rows(), v, one, 0);
      fold_new_joints(pair_.map, bound_.rows(), v, folded, 0);
      fold_ends(folded, 1);
      balance_.mismatch[v] = kUnit * row_distance(one, 0, folded, 0);
    }
    if (plan_.garment) {
      balance_.weigh_by_distance(pair_.target, match_);
    } else {
      balance_.weigh(pair_.target);
    }
    for (uint32_t v = 0; v < count; ++v) {
      balance_.matched[v] = has_weight(rows_, v) ? 1 : 0;
      if (balance_.matched[v] == 0) balance_.carried[v] = 0;
      share_with_new_joints(pair_.map, bound_.rows(), v, rows_);
      mix_rows(bound_.rows(), balance_.carried[v], v, rows_);
    }
    return SINEW_OK;
  }

  const TransferPlan& plan_;
  const TransferInput& input_;
  Arena& arena_;
  Pair pair_;
  OwnRows source_rows_;                  // in the source's joints until the match is found, then in the target's
  OwnRows source_bound_, source_other_;  // the best bind of the source so far, and the one at hand
  OwnRows bound_, other_;                // the target's bind; a garment's at hand
  Rows rows_;                            // what the target gets
  Match match_;
  DistanceMatch distance_match_;
  Balance balance_;
  PartReport report_;
  double* source_style_ = nullptr;
  uint32_t* map_scratch_ = nullptr;
  uint8_t *source_flags_ = nullptr, *target_flags_ = nullptr;
  uint8_t* ends_ = nullptr;       // [source joints] 1: the end of a chain, without weight
  uint16_t* folds_to_ = nullptr;  // [target joints] itself, or the parent of the end of a chain
  uint32_t bound_by_ = kNothingBound;
};

}  // namespace

sinew_status run_transfer(const TransferPlan& plan, const TransferInput& input, Arena& arena,
                          sinew_transfer_outputs* outputs) {
  Transfer transfer(plan, input, arena);
  const sinew_status status = transfer.run(outputs);
  if (status == SINEW_OK && !arena.measuring()) outputs->used_bytes = arena.high_water();
  return status;
}

}  // namespace sinew::transferring
