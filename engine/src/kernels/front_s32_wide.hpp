// SPDX-License-Identifier: MIT
// The factorisation's inner loops, once for all registers. A file that is compiled with an instruction set's flags
// includes this and defines the register types and operations:
//   Int32, kWidth             int32 of a register
//   Mask, first(n)            the first n of them, n < kWidth
//   load, store               of a whole register; with a mask: of those, zero elsewhere, nothing else touched
//   Values, values(Int32)     what sums are fed with
//   Sums, zero(), add(...)    kWidth sums of int64; += values * factor
//   less(out, sums)           out - the low 32 bits of (sum + 2^29) >> kFrontBits
//   store_sums(to, sums)      in their order
#ifndef SINEW_KERNELS_FRONT_S32_WIDE_HPP
#define SINEW_KERNELS_FRONT_S32_WIDE_HPP

#include "kernels/front.hpp"
#include "kernels/front_s32_rows.hpp"
#include "kernels/isolated.hpp"

namespace sinew {
namespace {

template <class Isa, uint32_t kColumns>
struct FrontSums {
  typename Isa::Sums column[kColumns];

  SINEW_INLINE FrontSums() {
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) column[c] = Isa::zero();
  }
  // factors[c * next] for column c.
  SINEW_INLINE void add(typename Isa::Int32 row, const int32_t* factors, size_t next) {
    const typename Isa::Values values = Isa::values(row);
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) column[c] = Isa::add(column[c], values, factors[c * next]);
  }
};

template <class Isa, uint32_t kColumns>
SINEW_INLINE void front_update_columns(const int32_t* g, size_t stride, uint32_t pivots, uint32_t rows, int32_t* target,
                                       size_t target_stride) {
  uint32_t i = 0;
  for (; i + Isa::kWidth <= rows; i += Isa::kWidth) {
    FrontSums<Isa, kColumns> sums;
    const int32_t* column = g;
    for (uint32_t k = 0; k < pivots; ++k, column += stride) sums.add(Isa::load(column + i), column, 1);
    SINEW_UNROLL
    for (uint32_t c = 0; c < kColumns; ++c) {
      int32_t* const out = target + c * target_stride + i;
      Isa::store(out, Isa::less(Isa::load(out), sums.column[c]));
    }
  }
  if (i == rows) return;
  const typename Isa::Mask mask = Isa::first(rows - i);
  FrontSums<Isa, kColumns> sums;
  const int32_t* column = g;
  for (uint32_t k = 0; k < pivots; ++k, column += stride) sums.add(Isa::load(column + i, mask), column, 1);
  SINEW_UNROLL
  for (uint32_t c = 0; c < kColumns; ++c) {
    int32_t* const out = target + c * target_stride + i;
    Isa::store(out, Isa::less(Isa::load(out, mask), sums.column[c]), mask);
  }
}

template <class Isa>
void front_update(const int32_t* g, size_t stride, uint32_t pivots, uint32_t columns, uint32_t rows, int32_t* target,
                  size_t target_stride) {
  switch (columns) {
    case 4:
      return front_update_columns<Isa, 4>(g, stride, pivots, rows, target, target_stride);
    case 3:
      return front_update_columns<Isa, 3>(g, stride, pivots, rows, target, target_stride);
    case 2:
      return front_update_columns<Isa, 2>(g, stride, pivots, rows, target, target_stride);
    default:
      return front_update_columns<Isa, 1>(g, stride, pivots, rows, target, target_stride);
  }
}

// A register of the batch at a time: sums of more would not stay in registers.
template <class Isa>
void front_multiply(const int32_t* g, size_t next, size_t step, uint32_t terms, const int32_t* scaled, int64_t* sums) {
  for (uint32_t member = 0; member < kFrontBatch; member += Isa::kWidth) {
    FrontSums<Isa, kFrontColumns> part;
    const int32_t* factors = g;
    const int32_t* row = scaled + member;
    for (uint32_t t = 0; t < terms; ++t, factors += step, row += kFrontBatch) part.add(Isa::load(row), factors, next);
    SINEW_UNROLL
    for (uint32_t c = 0; c < kFrontColumns; ++c) Isa::store_sums(sums + c * kFrontBatch + member, part.column[c]);
  }
}

// With front_s32_rows.hpp as the including file's flags make of it.
template <class Isa>
SINEW_INLINE void add_fronts(FrontKernels* kernels) {
  kernels->update = front_update<Isa>;
  kernels->multiply = front_multiply<Isa>;
  kernels->solve = front_solve_rows;
  kernels->subtract = front_subtract_rows;
  kernels->load = front_load_rows;
  kernels->above = front_above_in_row;
}

}  // namespace
}  // namespace sinew
#endif
