// SPDX-License-Identifier: MIT
// Solves one part of one heat field for all of its joints (stage 4).
#ifndef SINEW_HEAT_SOLVER_HPP
#define SINEW_HEAT_SOLVER_HPP

#include "heat/heat.hpp"
#include "heat/sources.hpp"
#include "solve/factor.hpp"
#include "solve/fronts.hpp"

namespace sinew {

// A lane's own data to solve a batch of joints in parallel.
struct HeatLane {
  FrontSolve front;
  uint8_t* member_of = nullptr;  // [J] as HeatSolver's
  uint32_t solver = 0, batch = 0;
  bool tame = true;
};

class HeatSolver {
 public:
  bool allocate(Arena& arena, const Counts& counts);
  // A lane's memory. The first lanes may take that of a solver each, `own`; null for the others.
  bool allocate_lane(Arena& arena, const Counts& counts, const HeatSolver* own, HeatLane* lane) const;
  void use(const FrontKernels& kernels) { kernels_ = kernels; }
  // Orders and analyzes a part. The fields that are solved next share the result.
  void begin_part(const Mesh& mesh, const EdgeWeights& edges, uint32_t part);
  // Solves one field of that part and writes its rows. Rows of the exact solution sum to 1, so every row is divided by
  // its sum; what was too small to keep is missing from it.
  //
  // Negative edge weights are kept wherever that works. They count as 0
  //   where the solution leaves [-1, 2], as only that of an indefinite matrix can,
  //   where a row's sum shows that fixed point did not do, even with refinement,
  //   in parts that are solved iteratively,
  //   and in parts of more than 65,536 vertices that fronts refuse: the sparse factor would take too long.
  // L1 on val is 0.399 with these exceptions; it is 0.401 where negative weights are always kept.
  void solve_field(const HeatSources& sources, uint32_t field, HeatField* out);

  // The same in steps that lanes share, for parts that fronts fit. Where a step says false, nothing but solve_field() of
  // all fields, one after the other, brings the rows that one lane has.
  //   begin_fronts   matrix and factor. Fields have a solver each here
  //   solve_batch    one batch of batch_count(); batches may be solved at the same time
  //   keep_batch     what a solved batch has in the fronts [begin, end), into the rows. Fronts at the same time, batches
  //                  not. False where the solution is wild
  //   close_totals   after the last batch: whether the rows at the positions [begin, end) were solved well enough
  //   finish_rows    those rows
  bool begin_fronts(const HeatSources& sources, uint32_t field, HeatField* out);
  uint32_t batch_count() const { return (listed_ + kFrontBatch - 1) / kFrontBatch; }
  uint32_t front_count() const { return fronts_.front_count(); }
  void solve_batch(const HeatSources& sources, uint32_t field, const HeatLane& lane) const;
  bool keep_batch(const HeatLane& lane, uint32_t begin, uint32_t end, HeatField* out);
  bool close_totals(uint32_t begin, uint32_t end);
  void finish_rows(uint32_t begin, uint32_t end, HeatField* out);

  bool iterative() const { return iterative_; }
  // False where fronts do not fit the part, and from the first field on that fronts refused.
  bool with_fronts() const { return with_fronts_; }
  // Entries of the factor of the current part (0 when it is solved iteratively).
  uint64_t factor_entries() const {
    return with_fronts_ ? fronts_.factor_entries() : iterative_ ? 0 : factor_.column_start[matrix_.rows];
  }
  // For tests: pretends that no more than this fits.
  void limit_factor(size_t entries) {
    fronts_.limit(entries);
    if (entries < factor_.capacity) factor_.capacity = entries;
  }

 private:
  void set_pulls(const HeatSources& sources, uint32_t field);
  void add_row_pulls(const HeatSources& sources, uint32_t field);
  void leave_fronts();
  // Solves all joints by fronts. False when they refuse the matrix or the solution is not good enough.
  bool try_fronts(const HeatSources& sources, uint32_t field, HeatField* out);
  void clear_rows(HeatField* out);
  // False where the solution is wild.
  bool keep_front(uint32_t batch, uint32_t first, uint32_t count, const int32_t* x, HeatField* out);
  uint32_t members_of(uint32_t batch) const {
    const uint32_t left = listed_ - batch * kFrontBatch;
    return left < kFrontBatch ? left : kFrontBatch;
  }
  bool factorise_fronts(const HeatSources& sources, uint32_t field, HeatField* out);
  void eliminate_batch(const HeatSources& sources, uint32_t field, uint32_t batch, const FrontSolve& front,
                       uint8_t* member_of) const;
  // One pass over all joints. True when every row's total came out as 1 within 2^-12.
  bool try_field(const HeatSources& sources, uint32_t field, HeatField* out);
  uint32_t list_joints(const HeatSources& sources, uint32_t field);
  void fill_right_hand_sides(const HeatSources& sources, uint32_t field, const uint16_t* batch, uint32_t members);
  void solve_sparse(const HeatSources& sources, uint32_t field, const uint16_t* batch, uint32_t members);
  void keep(const uint16_t* batch, uint32_t members, HeatField* out);
  void strengthen_pulls();

  const Mesh* mesh_ = nullptr;
  SparseMatrix matrix_;
  Ordering ordering_;
  FrontKernels kernels_;
  // Both factors lie in the same memory: factor_ is used where fronts_ are refused. The ordering's scratch lies there,
  // too.
  FrontFactor fronts_;
  Factor factor_;
  bool with_fronts_ = false;
  bool iterative_ = false;
  uint32_t refinements_ = 0;
  bool wild_ = false;
  int64_t* pull_ = nullptr;        // [U] Q40 of one tied bone, by elimination position
  int64_t* rhs_ = nullptr;         // [U x kBatch]
  int32_t* solution_ = nullptr;    // [U x kBatch] Q24
  int32_t* refinement_ = nullptr;  // [U x kBatch] Q24
  int64_t* total_ = nullptr;      // [U] Q40 pulls of all tied bones; then the sum of the solutions over all joints, Q24
  uint16_t* joints_ = nullptr;    // [J] joints with a source in this part and field
  uint32_t listed_ = 0;           // of those, for fronts
  uint8_t* member_of_ = nullptr;  // [J] kNoMember or the joint's member in the batch at hand
  uint32_t joint_count_ = 0;      // J
};

}  // namespace sinew
#endif
