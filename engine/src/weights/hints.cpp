// SPDX-License-Identifier: MIT
// Spreads the differences at hinted vertices by sparse systems (solve/), eight joints at a time.
#include <string.h>

#include "solve/factor.hpp"
#include "solve/iterative.hpp"
#include "solve/laplacian.hpp"
#include "weights/users_say.hpp"

namespace sinew {
namespace {

// Changed rows lose what is below 1/32: spreading leaves a little of everything (L1 0.187 with it, 0.191 without, same
// data as below).
constexpr uint32_t kPruned = 32;
constexpr int32_t kSmallestChange = 64;  // Q16: 1/1024
constexpr int kHoldBits = 8;             // a hint pulls 2^8 times as strongly as its edges
// Screening is area / length^2 with length = a quarter of the longest side. Chosen on 45 characters of all training
// families (README.md has the figures): longer reaches gain little from scattered hints and spoil what is far from a
// painted patch, shorter ones waste what scattered hints say.
constexpr uint64_t kLargestArea = static_cast<uint64_t>(1) << 52;  // a fan of thousands of faces
constexpr int kScreenBits = 4;  // (kSide / length)^2 = 2^4, in Q40 because (2^20)^2 = 2^40
// An edge between vertices whose predicted rows overlap by s conducts s^4 of what it did, at least 1/64: what was wrong
// about an arm says little about the torso beside it.
constexpr uint32_t kLeastConduction = kWholeRow / 64;

class Spreader {
 public:
  bool allocate(Arena& arena, const Counts& counts) {
    if (!edges_.allocate(arena, counts) || !ordering_.allocate(arena, counts) || !factor_.allocate(arena, counts))
      return false;
    const size_t entries = static_cast<size_t>(counts.vertices) * kBatch;
    matrix_.diagonal = arena.alloc<int64_t>(counts.vertices);
    pull_ = arena.alloc<int64_t>(counts.vertices);
    rhs_ = arena.alloc<int64_t>(entries);
    solution_ = arena.alloc<int32_t>(entries);
    predicted_.allocate(arena, counts);
    changed_ = arena.alloc<uint8_t>(counts.vertices);
    joints_ = arena.alloc<uint16_t>(counts.joints);
    member_of_ = arena.alloc<uint8_t>(counts.joints);
    return arena.ok();
  }

  sinew_status run(const Mesh& mesh, const Skeleton& skeleton, const GivenRows& given, const Counts& counts,
                   const Progress& progress, Arena& arena, Rows* rows) {
    const sinew_status status = weigh_edges(mesh, counts, arena, &edges_);
    if (status != SINEW_OK || arena.measuring()) return status;
    mesh_ = &mesh;
    skeleton_ = &skeleton;
    given_ = &given;
    rows_ = rows;
    weaken_edges();
    uint64_t done = 0;
    for (uint32_t c = 0; c < mesh.part_count; ++c) {
      if (has_hint(c)) steer_part(c);
      done += mesh.part_sizes[c];
      if (!progress.report(static_cast<uint32_t>(done * 1000 / mesh.welded_count))) return SINEW_ERROR_CANCELLED;
    }
    return SINEW_OK;
  }

 private:
  // Share of the two predicted rows that is the same, Q16.
  uint32_t overlap(uint32_t v, uint32_t u) const {
    uint64_t same = 0, sum_v = 0, sum_u = 0;
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      sum_u += rows_->weights_of(u)[i];
      const uint16_t joint = rows_->joints_of(v)[i];
      if (joint == kNoJoint) continue;
      const uint32_t a = rows_->weights_of(v)[i], b = rows_->weight(u, joint);
      same += a < b ? a : b;
      sum_v += a;
    }
    return static_cast<uint32_t>(same * kWholeRow / (sum_v > sum_u ? sum_v : sum_u));
  }

  void weaken_edges() {
    for (uint32_t v = 0; v < mesh_->welded_count; ++v) {
      for (uint32_t e = mesh_->row_offsets[v]; e < mesh_->row_offsets[v + 1]; ++e) {
        const uint64_t s = overlap(v, mesh_->col_indices[e]);  // symmetric, and so is the matrix
        const uint64_t squared = s * s >> 16;
        const uint64_t share =
            kLeastConduction + (squared * squared >> 16) * (kWholeRow - kLeastConduction) / kWholeRow;
        edges_.weight[e] = static_cast<int32_t>(round_shift(edges_.weight[e] * static_cast<int64_t>(share), 16));
      }
    }
  }

  bool has_hint(uint32_t part) const {
    for (uint32_t i = mesh_->part_offsets[part]; i < mesh_->part_offsets[part + 1]; ++i) {
      if (given_->kind[mesh_->part_vertices[i]] == GivenKind::kSteers) return true;
    }
    return false;
  }

  void steer_part(uint32_t part) {
    matrix_.mesh = mesh_;
    matrix_.edges = &edges_;
    matrix_.ordering = &ordering_;
    matrix_.rows = mesh_->part_sizes[part];
    matrix_.positive = true;
    ordering_.dissect(*mesh_, part);
    const bool iterative = !factor_.analyze(matrix_);
    set_pulls();
    matrix_.assemble(pull_, iterative ? kIterativeDiagonalBits : kFactorDiagonalBits);
    if (!iterative) factor_.factorise(matrix_);
    const uint32_t count = list_joints();
    // The differences come from the prediction, so that is kept until all joints are through.
    for (uint32_t k = 0; k < matrix_.rows; ++k) {
      const uint32_t v = ordering_.order[k];
      predicted_.copy(v, *rows_, v);
      changed_[v] = 0;
    }
    for (uint32_t first = 0; first < count; first += kBatch) {
      const uint32_t members = count - first < kBatch ? count - first : kBatch;
      fill_right_hand_sides(joints_ + first, members);
      if (iterative) {
        solve_iteratively(matrix_, rhs_, factor_.value, factor_.inverse, solution_);
      } else {
        factor_.solve(matrix_.rows, rhs_, solution_);
      }
      apply(joints_ + first, members);
    }
    finish();
  }

  void set_pulls() {
    for (uint32_t k = 0; k < matrix_.rows; ++k) {
      const uint32_t v = ordering_.order[k];
      int64_t stiffness = 0;
      for (uint32_t e = mesh_->row_offsets[v]; e < mesh_->row_offsets[v + 1]; ++e) stiffness += matrix_.weight(e);
      if (given_->kind[v] == GivenKind::kSteers) {
        constexpr int64_t kStiffest = static_cast<int64_t>(1) << 35;
        stiffness += 1 << kEdgeWeightBits;
        pull_[k] = (stiffness < kStiffest ? stiffness : kStiffest) *
                   (static_cast<int64_t>(1) << (40 - kEdgeWeightBits + kHoldBits));
      } else {
        pull_[k] = static_cast<int64_t>(mesh_->areas[v] < kLargestArea ? mesh_->areas[v] << kScreenBits
                                                                       : kLargestArea << kScreenBits) +
                   1;
      }
    }
  }

  uint32_t list_joints() {
    memset(member_of_, kNoMember, skeleton_->joint_count);
    uint32_t count = 0;
    for (uint32_t k = 0; k < matrix_.rows; ++k) {
      const uint32_t v = ordering_.order[k];
      if (given_->kind[v] != GivenKind::kSteers) continue;
      const Rows* both[2] = {&given_->rows, rows_};
      for (const Rows* rows : both) {
        for (uint32_t i = 0; i < kRowSlots; ++i) {
          const uint16_t joint = rows->joints_of(v)[i];
          if (joint == kNoJoint || member_of_[joint] == kListed || skeleton_->usable[joint] == 0) continue;
          member_of_[joint] = kListed;
          joints_[count++] = joint;
        }
      }
    }
    memset(member_of_, kNoMember, skeleton_->joint_count);
    return count;
  }

  void fill_right_hand_sides(const uint16_t* joints, uint32_t members) {
    memset(rhs_, 0, static_cast<size_t>(matrix_.rows) * kBatch * sizeof(rhs_[0]));
    for (uint32_t k = 0; k < matrix_.rows; ++k) {
      const uint32_t v = ordering_.order[k];
      if (given_->kind[v] != GivenKind::kSteers) continue;
      for (uint32_t member = 0; member < members; ++member) {
        const int64_t r =
            static_cast<int64_t>(given_->rows.weight(v, joints[member])) - predicted_.weight(v, joints[member]);
        rhs_[static_cast<size_t>(k) * kBatch + member] = mul_shift(matrix_.to_matrix(pull_[k]), r, 16);
      }
    }
  }

  void apply(const uint16_t* joints, uint32_t members) {
    for (uint32_t k = 0; k < matrix_.rows; ++k) {
      const uint32_t v = ordering_.order[k];
      for (uint32_t member = 0; member < members; ++member) {
        const int64_t x = round_shift(solution_[static_cast<size_t>(k) * kBatch + member], kSolutionBits - 16);
        if (x > -kSmallestChange && x < kSmallestChange) continue;
        changed_[v] = 1;
        if (x > 0) {
          rows_->add(v, joints[member], static_cast<uint32_t>(x > kWholeRow ? kWholeRow : x));
        } else {
          reduce(v, joints[member], static_cast<uint32_t>(-x));
        }
      }
    }
  }

  void reduce(uint32_t v, uint16_t joint, uint32_t by) {
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      if (rows_->joints_of(v)[i] != joint) continue;
      uint32_t* weight = rows_->weights_of(v) + i;
      *weight = *weight > by ? *weight - by : 0;
    }
  }

  void finish() {
    for (uint32_t k = 0; k < matrix_.rows; ++k) {
      const uint32_t v = ordering_.order[k];
      if (given_->kind[v] == GivenKind::kSteers) {
        rows_->copy(v, given_->rows, v);
        continue;
      }
      if (changed_[v] == 0) continue;
      uint32_t sum = 0;
      for (uint32_t i = 0; i < kRowSlots; ++i) sum += rows_->weights_of(v)[i];
      if (sum == 0) {
        rows_->copy(v, predicted_, v);
        continue;
      }
      for (uint32_t i = 0; i < kRowSlots; ++i) {
        if (rows_->weights_of(v)[i] < sum / kPruned) {
          rows_->weights_of(v)[i] = 0;
          rows_->joints_of(v)[i] = kNoJoint;
        }
      }
    }
  }

  const Mesh* mesh_ = nullptr;
  const Skeleton* skeleton_ = nullptr;
  const GivenRows* given_ = nullptr;
  Rows* rows_ = nullptr;
  Rows predicted_;
  EdgeWeights edges_;
  SparseMatrix matrix_;
  Ordering ordering_;
  Factor factor_;
  int64_t* pull_ = nullptr;
  int64_t* rhs_ = nullptr;
  int32_t* solution_ = nullptr;
  uint8_t* changed_ = nullptr;
  uint16_t* joints_ = nullptr;
  uint8_t* member_of_ = nullptr;
};

}  // namespace

sinew_status steer_rows(const Mesh& mesh, const Skeleton& skeleton, const GivenRows& given, const Counts& counts,
                        const Progress& progress, Arena& arena, Rows* rows) {
  const ArenaScope scope(arena);
  Spreader spreader;
  if (!spreader.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  return spreader.run(mesh, skeleton, given, counts, progress, arena, rows);
}

}  // namespace sinew
