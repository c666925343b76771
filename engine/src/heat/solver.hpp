// SPDX-License-Identifier: MIT
// Solves one component of one heat field for all of its joints (stage 4).
#ifndef SINEW_HEAT_SOLVER_HPP
#define SINEW_HEAT_SOLVER_HPP

#include "heat/heat.hpp"
#include "heat/sources.hpp"
#include "solve/factor.hpp"
#include "solve/fronts.hpp"

namespace sinew {

class HeatSolver {
 public:
  bool allocate(Arena& arena, const Counts& counts);
  void use(const FrontKernels& kernels) { kernels_ = kernels; }
  // Orders and analyses a component; the fields below share the result.
  void begin_component(const Mesh& mesh, const EdgeWeights& edges, uint32_t component);
  // Solves one field of that component and writes its rows. Every row sums to 1 up to what was too small to keep: the
  // exact solution does, so the rest of rounding is divided out. Negative edge weights count as 0 (they are
  // kept otherwise) where the solution leaves [-1, 2], which only an indefinite matrix can do, where fixed point was
  // defeated, in iterative components, and in those of more than 65,536 vertices whose matrix is not definite. Measured
  // on val: L1 0.399 with this exception, 0.401 without it.
  void solve_field(const HeatSources& sources, uint32_t field, HeatField* out);

  bool iterative() const { return iterative_; }
  // False from begin_component() on where they do not fit, or from a solve_field() on that they did not do for.
  bool with_fronts() const { return with_fronts_; }
  // Entries of the factor of the current component (0 when it is solved iteratively).
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
  // The fast way. False when the matrix is not for it.
  bool try_fronts(const HeatSources& sources, uint32_t field, HeatField* out);
  void clear_rows(HeatField* out);
  void keep_front(const uint16_t* batch, uint32_t members, uint32_t first, uint32_t count, const int32_t* x,
                  HeatField* out);
  // One pass over all joints. True when every row's total came out as 1 within 2^-12.
  bool try_field(const HeatSources& sources, uint32_t field, HeatField* out);
  uint32_t list_joints(const HeatSources& sources, uint32_t field);
  void fill_right_hand_sides(const HeatSources& sources, uint32_t field, const uint16_t* batch, uint32_t members);
  void solve_batch(const HeatSources& sources, uint32_t field, const uint16_t* batch, uint32_t members);
  void keep(const uint16_t* batch, uint32_t members, HeatField* out);
  void strengthen_pulls();
  void divide_by_totals(HeatField* out);

  const Mesh* mesh_ = nullptr;
  SparseMatrix matrix_;
  Ordering ordering_;
  FrontKernels kernels_;
  // These two share their memory: the second is for what the first cannot do. The ordering's scratch lies there, too.
  FrontFactor fronts_;
  Factor factor_;
  bool with_fronts_ = false;
  bool iterative_ = false;
  uint32_t refinements_ = 0;
  bool wild_ = false;
  int64_t* pull_ = nullptr;        // [U] Q40 of one tied bone, by elimination place
  int64_t* rhs_ = nullptr;         // [U x kBatch]
  int32_t* solution_ = nullptr;    // [U x kBatch] Q24
  int32_t* refinement_ = nullptr;  // [U x kBatch] Q24
  int64_t* total_ = nullptr;      // [U] Q40 pulls of all tied bones; then the sum of the solutions over all joints, Q24
  uint16_t* joints_ = nullptr;    // [J] joints with a source in this component and field
  uint8_t* member_of_ = nullptr;  // [J] kNoMember or the joint's member in the batch at hand
  uint32_t joint_count_ = 0;      // J
};

}  // namespace sinew
#endif
