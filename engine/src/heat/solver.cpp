// SPDX-License-Identifier: MIT
// One part, one field: matrix, factor, batches of joints, the largest weights of every vertex (stage 4).
#include "heat/solver.hpp"

#include <string.h>

#include "solve/iterative.hpp"

namespace sinew {
namespace {

constexpr int kWellConditionedBits = 28;       // of Factor::smallest_bits; each bit less costs the solution one
constexpr uint32_t kRefinements = 3;           // each wins about 20 bits back
constexpr uint32_t kMostForFactor = 1u << 16;  // vertices: the sparse factor's time grows faster than they do
constexpr int32_t kSolutionOne = 1 << kSolutionBits;
constexpr int32_t kWild = kSolutionOne;
constexpr int32_t kSmallestHeat = 32768 >> 12;  // Q15

void prefetch(const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address, 1);
#else
  (void)address;
#endif
}

// Keeps a row of kHeatSlots sorted by descending weight, ties by lower joint.
void insert(uint16_t joint, uint16_t weight, uint16_t* joints, uint16_t* weights) {
  const auto comes_first = [&](uint32_t slot) {
    return weight > weights[slot] || (weight == weights[slot] && joint < joints[slot]);
  };
  if (!comes_first(kHeatSlots - 1)) return;
  uint32_t slot = kHeatSlots - 1;
  for (; slot > 0 && comes_first(slot - 1); --slot) {
    joints[slot] = joints[slot - 1];
    weights[slot] = weights[slot - 1];
  }
  joints[slot] = joint;
  weights[slot] = weight;
}

}  // namespace

bool HeatSolver::allocate(Arena& arena, const Counts& counts) {
  const size_t entries = static_cast<size_t>(counts.vertices) * kBatch;
  (void)ordering_.allocate_result(arena, counts);
  matrix_.diagonal = arena.alloc<int64_t>(counts.vertices);
  pull_ = arena.alloc<int64_t>(counts.vertices);
  total_ = arena.alloc<int64_t>(counts.vertices);
  joints_ = arena.alloc<uint16_t>(counts.joints);
  member_of_ = arena.alloc<uint8_t>(counts.joints);
  joint_count_ = counts.joints;

  const size_t shared = arena.mark();
  (void)ordering_.allocate_scratch(arena, counts);
  size_t end = arena.used(), solve_mark = 0;
  arena.release(shared);
  (void)fronts_.allocate(arena, counts);
  if (arena.used() > end) end = arena.used();
  arena.release(shared);
  // An iterative solver's five vectors lie in the lower half of the factor's values: 10 entries are reserved at least.
  (void)factor_.allocate(arena, counts, &solve_mark);
  if (arena.used() > end) end = arena.used();
  arena.release(solve_mark);
  rhs_ = arena.alloc<int64_t>(entries);
  solution_ = arena.alloc<int32_t>(entries);
  refinement_ = arena.alloc<int32_t>(entries);
  if (arena.used() < end) (void)arena.alloc<uint8_t>(end - arena.used());
  return arena.ok();
}

bool HeatSolver::allocate_lane(Arena& arena, const Counts& counts, const HeatSolver* own, HeatLane* lane) const {
  lane->member_of = arena.alloc<uint8_t>(counts.joints);
  if (own == nullptr) return fronts_.allocate_solve(arena, counts, &lane->front);
  lane->front = own->fronts_.own_solve();
  return arena.ok();
}

void HeatSolver::begin_part(const Mesh& mesh, const EdgeWeights& edges, uint32_t part) {
  mesh_ = &mesh;
  matrix_.mesh = &mesh;
  matrix_.edges = &edges;
  matrix_.ordering = &ordering_;
  matrix_.rows = mesh.part_sizes[part];
  ordering_.dissect(mesh, part, kSmallestFront);
  with_fronts_ = fronts_.analyze(matrix_);
  iterative_ = false;
  if (!with_fronts_) leave_fronts();
}

void HeatSolver::leave_fronts() {
  with_fronts_ = false;
  ordering_.dissect(*mesh_, mesh_->part[ordering_.order[0]]);
  iterative_ = !factor_.analyze(matrix_);
}

// Joints in order of their first source in the elimination order, so that the joints of a batch lie near each other and
// share the zero part of the forward solve.
uint32_t HeatSolver::list_joints(const HeatSources& sources, uint32_t field) {
  memset(member_of_, kNoMember, joint_count_);
  uint32_t count = 0;
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const uint32_t v = ordering_.order[k];
    const uint16_t* ties = sources.ties[HeatSources::metric_of(field)] + static_cast<size_t>(v) * kMaxTies;
    for (uint32_t t = 0; t < kMaxTies; ++t) {
      if ((sources.mask[field][v] >> t & 1) == 0 || member_of_[ties[t]] == kListed) continue;
      member_of_[ties[t]] = kListed;
      joints_[count++] = ties[t];
    }
  }
  memset(member_of_, kNoMember, joint_count_);
  return count;
}

void HeatSolver::fill_right_hand_sides(const HeatSources& sources, uint32_t field, const uint16_t* batch,
                                       uint32_t members) {
  for (uint32_t member = 0; member < members; ++member) member_of_[batch[member]] = static_cast<uint8_t>(member);
  memset(rhs_, 0, static_cast<size_t>(matrix_.rows) * kBatch * sizeof(rhs_[0]));
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const uint32_t v = ordering_.order[k];
    const uint16_t* ties = sources.ties[HeatSources::metric_of(field)] + static_cast<size_t>(v) * kMaxTies;
    for (uint32_t mask = sources.mask[field][v], t = 0; mask != 0; mask >>= 1, ++t) {
      if ((mask & 1) == 0 || member_of_[ties[t]] == kNoMember) continue;
      rhs_[static_cast<size_t>(k) * kBatch + member_of_[ties[t]]] = matrix_.to_matrix(pull_[k]);
    }
  }
  for (uint32_t member = 0; member < members; ++member) member_of_[batch[member]] = kNoMember;
}

void HeatSolver::keep(const uint16_t* batch, uint32_t members, HeatField* out) {
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const int32_t* x = solution_ + static_cast<size_t>(k) * kBatch;
    const size_t slots = static_cast<size_t>(ordering_.order[k]) * kHeatSlots;
    for (uint32_t member = 0; member < members; ++member) {
      total_[k] += x[member];
      wild_ = wild_ || x[member] < -kWild || x[member] > kSolutionOne + kWild;
      const int64_t weight = round_shift(x[member], kSolutionBits - 15);
      if (weight < kSmallestHeat) continue;
      insert(batch[member], static_cast<uint16_t>(weight > 65535 ? 65535 : weight), out->joints + slots,
             out->weights + slots);
    }
  }
}

// Rows are divided by their totals.
void HeatSolver::finish_rows(uint32_t begin, uint32_t end, HeatField* out) {
  for (uint32_t k = begin; k < end; ++k) {
    const uint32_t v = ordering_.order[k];
    uint16_t* joints = out->joints + static_cast<size_t>(v) * kHeatSlots;
    uint16_t* weights = out->weights + static_cast<size_t>(v) * kHeatSlots;
    const int64_t total = total_[k];
    // Below 1 / 1024 nothing but noise is left of a matrix that is singular to working precision.
    const bool usable = total >> (kSolutionBits - 10) > 0;
    uint32_t used = 0;
    for (uint32_t slot = 0; slot < kHeatSlots && joints[slot] != kNoJoint; ++slot) {
      const uint16_t joint = joints[slot];
      const int64_t scaled =
          usable ? ((static_cast<int64_t>(weights[slot]) << (kSolutionBits + 1)) / total + 1) >> 1 : 0;
      joints[slot] = kNoJoint;
      weights[slot] = 0;
      if (scaled < kSmallestHeat) continue;
      // Rounding may have made two weights equal: the lower joint goes first.
      const uint16_t weight = static_cast<uint16_t>(scaled > 32768 ? 32768 : scaled);
      uint32_t position = used++;
      for (; position > 0 && weights[position - 1] == weight && joints[position - 1] > joint; --position) {
        joints[position] = joints[position - 1];
        weights[position] = weights[position - 1];
      }
      joints[position] = joint;
      weights[position] = weight;
    }
    if (used == 0) {
      joints[0] = out->nearest[v];
      weights[0] = 32768;
    }
  }
}

void HeatSolver::solve_sparse(const HeatSources& sources, uint32_t field, const uint16_t* batch, uint32_t members) {
  fill_right_hand_sides(sources, field, batch, members);
  if (iterative_) {
    solve_iteratively(matrix_, rhs_, factor_.value, factor_.inverse, solution_);
    return;
  }
  factor_.solve(matrix_.rows, rhs_, solution_);
  for (uint32_t step = 0; step < refinements_; ++step) {
    fill_right_hand_sides(sources, field, batch, members);
    matrix_.subtract_image(solution_, rhs_);
    factor_.solve(matrix_.rows, rhs_, refinement_);
    for (size_t i = 0; i < static_cast<size_t>(matrix_.rows) * kBatch; ++i) {
      solution_[i] = clamp32(static_cast<int64_t>(solution_[i]) + refinement_[i], -0x7FFFFFFF, 0x7FFFFFFF);
    }
  }
}

void HeatSolver::clear_rows(HeatField* out) {
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const size_t slots = static_cast<size_t>(ordering_.order[k]) * kHeatSlots;
    total_[k] = 0;
    for (uint32_t slot = 0; slot < kHeatSlots; ++slot) {
      out->joints[slots + slot] = kNoJoint;
      out->weights[slots + slot] = 0;
    }
  }
  wild_ = false;
}

bool HeatSolver::keep_front(uint32_t batch, uint32_t first, uint32_t count, const int32_t* x, HeatField* out) {
  constexpr int kToQ15 = kFrontSolutionBits - 15;
  constexpr int32_t kHalf = 1 << (kToQ15 - 1);
  const uint16_t* const batch_joints = joints_ + batch * kFrontBatch;
  const uint32_t members = members_of(batch);
  int32_t range = 0;
  for (uint32_t k = first; k < first + count; ++k, x += kFrontBatch) {
    if (k < 2 * first) {  // waiting for rows was half of the time; those before the front come next
      const size_t next = static_cast<size_t>(ordering_.order[2 * first - 1 - k]) * kHeatSlots;
      prefetch(out->weights + next);
      prefetch(out->joints + next);
    }
    const size_t slots = static_cast<size_t>(ordering_.order[k]) * kHeatSlots;
    uint16_t* const joints = out->joints + slots;
    uint16_t* const weights = out->weights + slots;
    // Values that round to less than the row's last weight are dropped; solutions are within +-4, so differences fit.
    const int32_t last = weights[kHeatSlots - 1] > kSmallestHeat ? weights[kHeatSlots - 1] : kSmallestHeat;
    const int32_t below = last * (1 << kToQ15) - kHalf - 1;
    for (uint32_t rest = kernels_.above(x, below, &total_[k], &range); rest != 0; rest &= rest - 1) {
      const uint32_t member = static_cast<uint32_t>(low_bit(rest));
      if (member >= members) break;
      const int64_t weight = round_shift(x[member], kToQ15);
      insert(batch_joints[member], static_cast<uint16_t>(weight > 65535 ? 65535 : weight), joints, weights);
    }
  }
  return range >= 0;
}

bool HeatSolver::begin_fronts(const HeatSources& sources, uint32_t field, HeatField* out) {
  if (!with_fronts_) return false;
  set_pulls(sources, field);
  matrix_.positive = false;
  return factorise_fronts(sources, field, out);
}

// The factor of the matrix with the pulls that are set, empty rows, and the list of joints.
bool HeatSolver::factorise_fronts(const HeatSources& sources, uint32_t field, HeatField* out) {
  add_row_pulls(sources, field);
  matrix_.assemble(total_, kFactorDiagonalBits);
  clear_rows(out);
  if (!fronts_.factorise(matrix_, kernels_)) return false;
  listed_ = list_joints(sources, field);
  return true;
}

void HeatSolver::eliminate_batch(const HeatSources& sources, uint32_t field, uint32_t batch, const FrontSolve& front,
                                 uint8_t* member_of) const {
  const uint16_t* const ties = sources.ties[HeatSources::metric_of(field)];
  const uint16_t* const joints = joints_ + batch * kFrontBatch;
  const uint32_t members = members_of(batch);
  for (uint32_t member = 0; member < members; ++member) member_of[joints[member]] = static_cast<uint8_t>(member);
  fronts_.begin(front);
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const uint32_t v = ordering_.order[k];
    for (uint32_t mask = sources.mask[field][v], t = 0; mask != 0; mask >>= 1, ++t) {
      const uint8_t member = member_of[ties[static_cast<size_t>(v) * kMaxTies + t]];
      if ((mask & 1) != 0 && member != kNoMember) fronts_.add(front, k, member, pull_[k]);
    }
  }
  for (uint32_t member = 0; member < members; ++member) member_of[joints[member]] = kNoMember;
  fronts_.eliminate(kernels_, front);
}

void HeatSolver::solve_batch(const HeatSources& sources, uint32_t field, const HeatLane& lane) const {
  memset(lane.member_of, kNoMember, joint_count_);
  eliminate_batch(sources, field, lane.batch, lane.front, lane.member_of);
  fronts_.substitute(kernels_, lane.front, [](uint32_t, uint32_t, const int32_t*) {});
}

bool HeatSolver::keep_batch(const HeatLane& lane, uint32_t begin, uint32_t end, HeatField* out) {
  bool tame = true;
  fronts_.each_taken(lane.front, begin, end, [&](uint32_t position, uint32_t vertices, const int32_t* x) {
    tame = keep_front(lane.batch, position, vertices, x, out) && tame;
  });
  return tame;
}

// Ignored small values, and rounding where the sources are weak, are divided out.
bool HeatSolver::close_totals(uint32_t begin, uint32_t end) {
  for (uint32_t k = begin; k < end; ++k) {
    if (abs64(total_[k] - kFrontOne) > kFrontOne / 256) return false;
    total_[k] = round_shift(total_[k], kFrontSolutionBits - kSolutionBits);
  }
  return true;
}

bool HeatSolver::try_fronts(const HeatSources& sources, uint32_t field, HeatField* out) {
  if (!factorise_fronts(sources, field, out)) return false;
  const FrontSolve& front = fronts_.own_solve();
  bool tame = true;
  for (uint32_t batch = 0; batch < batch_count(); ++batch) {
    eliminate_batch(sources, field, batch, front, member_of_);
    fronts_.substitute(kernels_, front, [&](uint32_t position, uint32_t vertices, const int32_t* x) {
      tame = keep_front(batch, position, vertices, x, out) && tame;
    });
  }
  if (!tame || !close_totals(0, matrix_.rows)) return false;
  finish_rows(0, matrix_.rows, out);
  return true;
}

bool HeatSolver::try_field(const HeatSources& sources, uint32_t field, HeatField* out) {
  add_row_pulls(sources, field);
  matrix_.assemble(total_, iterative_ ? kIterativeDiagonalBits : kFactorDiagonalBits);
  clear_rows(out);
  if (!iterative_) {
    factor_.factorise(matrix_);
    if (factor_.smallest_bits < kWellConditionedBits) refinements_ = kRefinements;
  }
  const uint32_t count = list_joints(sources, field);
  for (uint32_t first = 0; first < count; first += kBatch) {
    const uint32_t members = count - first < kBatch ? count - first : kBatch;
    solve_sparse(sources, field, joints_ + first, members);
    keep(joints_ + first, members, out);
  }
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    if (abs64(total_[k] - kSolutionOne) > kSolutionOne / 4096) return false;
  }
  return true;
}

// A part so small and far from its bones that its sources pull less than 2^-24 of its stiffness has the same weights
// all over, whatever that pull is exactly: doubled until fixed point can hold it.
void HeatSolver::strengthen_pulls() {
  int64_t stiffness = 0, sum = 0;  // Q24, Q40
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const uint32_t v = ordering_.order[k];
    int64_t row = 0;
    for (uint32_t e = mesh_->row_offsets[v]; e < mesh_->row_offsets[v + 1]; ++e) row += matrix_.edges->weight[e];
    if (row > stiffness) stiffness = row;
    if (total_[k] >> 40 != 0) return;  // one strong source is enough
    sum += total_[k];
  }
  int shift = 0;
  while (sum > 0 && sum < (stiffness >> 8)) {
    sum *= 2;
    ++shift;
  }
  if (shift == 0) return;
  for (uint32_t k = 0; k < matrix_.rows; ++k) pull_[k] *= static_cast<int64_t>(1) << shift;
}

void HeatSolver::add_row_pulls(const HeatSources& sources, uint32_t field) {
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    total_[k] = 0;
    for (uint32_t mask = sources.mask[field][ordering_.order[k]]; mask != 0; mask &= mask - 1) total_[k] += pull_[k];
  }
}

void HeatSolver::set_pulls(const HeatSources& sources, uint32_t field) {
  const int metric = HeatSources::metric_of(field);
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const uint32_t v = ordering_.order[k];
    int64_t bones = 0;
    for (uint32_t mask = sources.mask[field][v]; mask != 0; mask &= mask - 1) ++bones;
    pull_[k] = bones == 0 ? 0 : source_pull_q40(mesh_->areas[v], sources.distance[metric][v], field);
    // A bone through a vertex holds it fast long before this, and the others keep their precision.
    constexpr int64_t kStrongest = static_cast<int64_t>(1) << 59;
    if (bones > 0 && pull_[k] > kStrongest / bones) pull_[k] = kStrongest / bones;
  }
  add_row_pulls(sources, field);
  strengthen_pulls();
}

void HeatSolver::solve_field(const HeatSources& sources, uint32_t field, HeatField* out) {
  set_pulls(sources, field);
  matrix_.positive = false;
  if (with_fronts_) {
    bool done = try_fronts(sources, field, out);
    if (!done && matrix_.rows > kMostForFactor) {
      matrix_.positive = true;
      done = try_fronts(sources, field, out);
    }
    if (done) return;
    leave_fronts();
    set_pulls(sources, field);  // by elimination position
  }
  matrix_.positive = iterative_;
  refinements_ = 0;
  bool done = try_field(sources, field, out);
  if (!done && !wild_ && refinements_ == 0) {
    refinements_ = kRefinements;
    done = try_field(sources, field, out);
  }
  if ((!done || wild_) && !iterative_) {
    matrix_.positive = true;
    refinements_ = 0;
    (void)try_field(sources, field, out);
  }
  finish_rows(0, matrix_.rows, out);
}

}  // namespace sinew
