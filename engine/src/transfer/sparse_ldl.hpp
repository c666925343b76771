// SPDX-License-Identifier: MIT
// Sparse L D L^T of a symmetric matrix in doubles: the equations of inpainting and of biharmonic distances are too badly
// conditioned for the fixed point of solve/factor.hpp. Up-looking (Davis 2005, "Algorithm 849").
#ifndef SINEW_TRANSFER_SPARSE_LDL_HPP
#define SINEW_TRANSFER_SPARSE_LDL_HPP

#include "core/arena.hpp"

namespace sinew {

// A matrix gives its rows: row(k, visit) calls visit(column, value) for every entry of row k, diagonal and upper half included
// or not, a column more than once or not; values of a column are added up.
class SparseLdl {
 public:
  static constexpr uint32_t kBatch = 8;  // right-hand sides that are solved together

  // Memory for `rows` rows and `entries` entries of L.
  bool allocate(Arena& arena, uint32_t rows, size_t entries) {
    capacity_ = entries;
    parent_ = arena.alloc<uint32_t>(rows);
    mark_ = arena.alloc<uint32_t>(rows);
    pattern_ = arena.alloc<uint32_t>(rows);
    fill_ = arena.alloc<uint32_t>(rows);
    start_ = arena.alloc<uint32_t>(static_cast<size_t>(rows) + 1);
    diagonal_ = arena.alloc<double>(rows);
    work_ = arena.alloc<double>(rows);
    row_ = arena.alloc<uint32_t>(entries);
    value_ = arena.alloc<double>(entries);
    return arena.ok();
  }

  // False when the factor would not fit.
  template <class Row>
  bool factorise(uint32_t rows, const Row& row);
  // in/out [rows x kBatch]
  void solve(double* x) const;
  // Memory for inverse_diagonal(): as many entries again.
  bool allocate_inverse(Arena& arena) {
    inverse_ = arena.alloc<double>(capacity_);
    return arena.ok();
  }
  // The diagonal of the inverse (Takahashi, Fagan and Chin 1973): entries of the inverse where L has some, last row first.
  // Uses up what factorise() needs as scratch, not the factor.
  //   out  [rows]
  void inverse_diagonal(double* out);

 private:
  static constexpr uint32_t kNone = 0xFFFFFFFFu;
  uint32_t rows_ = 0;
  size_t capacity_ = 0;
  uint32_t *parent_ = nullptr, *mark_ = nullptr, *pattern_ = nullptr, *fill_ = nullptr, *row_ = nullptr;
  uint32_t* start_ = nullptr;  // entries are below 2^32 by what is reserved
  double *diagonal_ = nullptr, *work_ = nullptr, *value_ = nullptr;
  double* inverse_ = nullptr;  // [entries]
};

template <class Row>
bool SparseLdl::factorise(uint32_t rows, const Row& row) {
  rows_ = rows;
  size_t total = 0;
  for (uint32_t k = 0; k < rows; ++k) {
    parent_[k] = kNone;
    mark_[k] = k;
    fill_[k] = 0;
    row(k, [&](uint32_t column, double) {
      // Row k of L holds every node on the way up the elimination tree from its entries.
      for (uint32_t i = column; i < k && mark_[i] != k; i = parent_[i]) {
        if (parent_[i] == kNone) parent_[i] = k;
        ++fill_[i];
        ++total;
        mark_[i] = k;
      }
    });
    if (total > capacity_) return false;
  }
  start_[0] = 0;
  for (uint32_t k = 0; k < rows; ++k) start_[k + 1] = start_[k] + fill_[k];
  for (uint32_t k = 0; k < rows; ++k) {
    fill_[k] = 0;
    mark_[k] = k;
    work_[k] = 0;
    uint32_t top = rows;
    double d = 0, largest = 0;
    row(k, [&](uint32_t column, double value) {
      if (column == k) {
        d += value;
        largest += value < 0 ? -value : value;
      }
      if (column >= k) return;
      work_[column] += value;
      uint32_t length = 0;
      for (uint32_t i = column; mark_[i] != k; i = parent_[i]) {
        pattern_[length++] = i;
        mark_[i] = k;
      }
      while (length > 0) pattern_[--top] = pattern_[--length];
    });
    for (; top < rows; ++top) {
      const uint32_t i = pattern_[top];
      const double y = work_[i];
      work_[i] = 0;
      const uint32_t end = start_[i] + fill_[i];
      for (uint32_t p = start_[i]; p < end; ++p) work_[row_[p]] -= value_[p] * y;
      const double l = y / diagonal_[i];
      d -= l * y;
      row_[end] = k;
      value_[end] = l;
      ++fill_[i];
    }
    // What rounding, or a matrix that is not definite, leaves too small.
    const double least = 1e-13 * largest + 1e-280;
    diagonal_[k] = d > least ? d : least;
  }
  return true;
}

inline void SparseLdl::solve(double* x) const {
  for (uint32_t k = 0; k < rows_; ++k) {
    const double* const from = x + static_cast<size_t>(k) * kBatch;
    for (uint32_t p = start_[k]; p < start_[k + 1]; ++p) {
      double* const to = x + static_cast<size_t>(row_[p]) * kBatch;
      for (uint32_t m = 0; m < kBatch; ++m) to[m] -= value_[p] * from[m];
    }
  }
  for (uint32_t k = rows_; k-- > 0;) {
    double* const to = x + static_cast<size_t>(k) * kBatch;
    for (uint32_t m = 0; m < kBatch; ++m) to[m] /= diagonal_[k];
    for (uint32_t p = start_[k]; p < start_[k + 1]; ++p) {
      const double* const from = x + static_cast<size_t>(row_[p]) * kBatch;
      for (uint32_t m = 0; m < kBatch; ++m) to[m] -= value_[p] * from[m];
    }
  }
}

inline void SparseLdl::inverse_diagonal(double* out) {
  uint32_t* const entry = mark_;  // of the column at hand, by row
  for (uint32_t k = 0; k < rows_; ++k) entry[k] = kNone;
  for (uint32_t k = rows_; k-- > 0;) {
    const uint32_t begin = start_[k], end = start_[k + 1];
    for (uint32_t p = begin; p < end; ++p) {
      entry[row_[p]] = p;
      inverse_[p] = 0;
    }
    for (uint32_t p = begin; p < end; ++p) {
      const uint32_t j = row_[p];
      double own = value_[p] * out[j];
      for (uint32_t q = start_[j]; q < start_[j + 1]; ++q) {
        const uint32_t s = entry[row_[q]];
        if (s == kNone) continue;
        inverse_[s] -= value_[p] * inverse_[q];
        own += value_[s] * inverse_[q];
      }
      inverse_[p] -= own;
    }
    double d = 1 / diagonal_[k];
    for (uint32_t p = begin; p < end; ++p) {
      d -= value_[p] * inverse_[p];
      entry[row_[p]] = kNone;
    }
    out[k] = d;
  }
}

}  // namespace sinew
#endif
