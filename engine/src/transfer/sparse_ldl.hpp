// SPDX-License-Identifier: MIT
// Sparse L D L^T of a symmetric matrix in doubles: the equations of inpainting and of biharmonic distances are too badly
// conditioned for the fixed point of solve/factor.hpp. Up-looking (Davis 2005, "Algorithm 849").
#ifndef SINEW_TRANSFER_SPARSE_LDL_HPP
#define SINEW_TRANSFER_SPARSE_LDL_HPP

#include "core/arena.hpp"

namespace sinew::transferring {

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
  // Memory for square_diagonal(), beside what allocate() took.
  bool allocate_rates(Arena& arena, uint32_t rows) {
    rate_ = arena.alloc<double>(capacity_);
    diagonal_rate_ = arena.alloc<double>(rows);
    sums_ = arena.alloc<double>(rows);
    sum_rates_ = arena.alloc<double>(rows);
    return arena.ok();
  }
  // The diagonal of M^-1 A M^-1 for the matrix M and a diagonal A = `weights` [rows], exactly and in about the time of the factor: it
  // is the rate at which the inverse's diagonal falls as t grows in M + t A. Rates of L and D come first, column by column, then
  // the inverse where L has entries (Takahashi, Fagan and Chin 1973) with its rate. The factor is used up by it.
  //   out  [rows]
  void square_diagonal(const double* weights, double* out);

 private:
  static constexpr uint32_t kNone = 0xFFFFFFFFu;
  uint32_t rows_ = 0;
  size_t capacity_ = 0;
  uint32_t *parent_ = nullptr, *mark_ = nullptr, *pattern_ = nullptr, *fill_ = nullptr, *row_ = nullptr;
  uint32_t* start_ = nullptr;  // entries are below 2^32 by what is reserved
  double *diagonal_ = nullptr, *work_ = nullptr, *value_ = nullptr;
  double *rate_ = nullptr, *diagonal_rate_ = nullptr, *sums_ = nullptr, *sum_rates_ = nullptr;

  // Calls take(a, b, p) for entries a and b of column k and the entry p of a's row as a column that is in b's row.
  template <class Take>
  void each_pair(uint32_t k, const Take& take) {
    uint32_t* const entry = mark_;  // of column k, by row
    for (uint32_t p = start_[k]; p < start_[k + 1]; ++p) entry[row_[p]] = p;
    for (uint32_t a = start_[k]; a < start_[k + 1]; ++a) {
      const uint32_t j = row_[a];
      for (uint32_t p = start_[j]; p < start_[j + 1]; ++p) {
        const uint32_t b = entry[row_[p]];
        if (b != kNone) take(a, b, p);
      }
    }
    for (uint32_t p = start_[k]; p < start_[k + 1]; ++p) entry[row_[p]] = kNone;
  }
  void find_rates(const double* weights);
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
      // Row k of L holds every node on the path up the elimination tree from its entries.
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
    // Pivots that are too small by rounding, or because the matrix is not definite.
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

inline void SparseLdl::find_rates(const double* weights) {
  for (uint32_t k = 0; k < rows_; ++k) {
    diagonal_rate_[k] = weights[k];
    mark_[k] = kNone;
  }
  for (uint32_t p = 0; p < start_[rows_]; ++p) rate_[p] = 0;
  for (uint32_t k = 0; k < rows_; ++k) {
    const double d = diagonal_[k], d_rate = diagonal_rate_[k];
    // In: the rate of an entry before its division, y = l d; out: that of l.
    for (uint32_t a = start_[k]; a < start_[k + 1]; ++a) {
      const double l = value_[a], y_rate = rate_[a], l_rate = (y_rate - l * d_rate) / d;
      diagonal_rate_[row_[a]] -= l_rate * (l * d) + l * y_rate;
      sums_[a - start_[k]] = y_rate;
      rate_[a] = l_rate;
    }
    each_pair(k, [&](uint32_t a, uint32_t b, uint32_t p) {
      rate_[p] -= rate_[b] * (value_[a] * d) + value_[b] * sums_[a - start_[k]];
    });
  }
}

inline void SparseLdl::square_diagonal(const double* weights, double* out) {
  find_rates(weights);
  for (uint32_t k = rows_; k-- > 0;) {
    const uint32_t first = start_[k], count = start_[k + 1] - first;
    for (uint32_t a = 0; a < count; ++a) sums_[a] = sum_rates_[a] = 0;
    each_pair(k, [&](uint32_t a, uint32_t b, uint32_t p) {
      const double z = value_[p], z_rate = rate_[p];
      sums_[a - first] += value_[b] * z;
      sums_[b - first] += value_[a] * z;
      sum_rates_[a - first] += rate_[b] * z + value_[b] * z_rate;
      sum_rates_[b - first] += rate_[a] * z + value_[a] * z_rate;
    });
    const double inverse = 1 / diagonal_[k];
    double z_own = inverse, rate_own = -inverse * inverse * diagonal_rate_[k];
    for (uint32_t a = 0; a < count; ++a) {
      // diagonal_ and its rate hold the inverse's in the rows that are done.
      const uint32_t row = row_[first + a];
      const double l = value_[first + a], l_rate = rate_[first + a];
      const double z = -(sums_[a] + l * diagonal_[row]);
      const double z_rate = -(sum_rates_[a] + l_rate * diagonal_[row] + l * diagonal_rate_[row]);
      z_own -= l * z;
      rate_own -= l_rate * z + l * z_rate;
      value_[first + a] = z;
      rate_[first + a] = z_rate;
    }
    diagonal_[k] = z_own;
    diagonal_rate_[k] = rate_own;
    out[k] = -rate_own;
  }
}

}  // namespace sinew::transferring
#endif
