// SPDX-License-Identifier: MIT
// Up-looking sparse L D L^T (Davis 2005, "Algorithm 849", for the row-by-row scheme) in fixed point, and its solves.
#include "solve/factor.hpp"

namespace sinew {
namespace {

constexpr int kFactorBits = 40;
constexpr int kFactorHeadroom = 20;
constexpr int kLargestMatrixBits = 50;

}  // namespace

Reciprocal reciprocal(int64_t d) {
  const uint64_t magnitude = d < 0 ? 0 - static_cast<uint64_t>(d) : static_cast<uint64_t>(d);
  const int exponent = top_bit(magnitude);
  const int64_t scaled =
      static_cast<int64_t>((exponent > 62 ? magnitude >> 1 : magnitude << (62 - exponent)));  // [2^62, 2^63)
  // 31 correct bits from one division, the rest by one Newton step: r += r (2^62 - scaled r / 2^62) / 2^62.
  const uint64_t seed = (static_cast<uint64_t>(1) << 63) / static_cast<uint64_t>(scaled >> 31);
  int64_t r = static_cast<int64_t>(seed << 30);
  constexpr int64_t one = static_cast<int64_t>(1) << 62;
  r += mul_shift(r, one - mul_shift(scaled, r, 62), 62);
  return {d < 0 ? -r : r, magnitude, exponent};
}

void SparseMatrix::assemble(const int64_t* pull_q40, int diagonal_bits) {
  int64_t largest = 1;
  for (uint32_t k = 0; k < rows; ++k) {
    const uint32_t v = ordering->order[k];
    int64_t sum = 0;
    for (uint32_t e = mesh->row_offsets[v]; e < mesh->row_offsets[v + 1]; ++e) sum += weight(e);
    diagonal[k] = sum;  // Q24 for now
    const int64_t whole = abs64(sum) + (pull_q40[k] >> (40 - kEdgeWeightBits)) + 1;
    if (whole > largest) largest = whole;
  }
  matrix_bits = diagonal_bits - 1 - top_bit(static_cast<uint64_t>(largest)) + kEdgeWeightBits;
  if (matrix_bits > kLargestMatrixBits) matrix_bits = kLargestMatrixBits;
  if (matrix_bits < kEdgeWeightBits) matrix_bits = kEdgeWeightBits;
  for (uint32_t k = 0; k < rows; ++k) {
    diagonal[k] = diagonal[k] * (static_cast<int64_t>(1) << (matrix_bits - kEdgeWeightBits)) + to_matrix(pull_q40[k]);
  }
}

int64_t SparseMatrix::to_matrix(int64_t value_q40) const {
  if (matrix_bits >= 40) return value_q40 * (static_cast<int64_t>(1) << (matrix_bits - 40));
  const int64_t value = round_shift(value_q40, 40 - matrix_bits);
  return value == 0 && value_q40 != 0 ? 1 : value;
}

void SparseMatrix::subtract_image(const int32_t* x, int64_t* rhs) const {
  for (uint32_t k = 0; k < rows; ++k) {
    const uint32_t v = ordering->order[k];
    int64_t* r = rhs + static_cast<size_t>(k) * kBatch;
    for (uint32_t member = 0; member < kBatch; ++member) {
      r[member] = wrapping_subtract(r[member],
                                    mul_shift(diagonal[k], x[static_cast<size_t>(k) * kBatch + member], kSolutionBits));
    }
    for (uint32_t e = mesh->row_offsets[v]; e < mesh->row_offsets[v + 1]; ++e) {
      const int32_t* neighbor = x + static_cast<size_t>(ordering->position[mesh->col_indices[e]]) * kBatch;
      const int64_t m = entry(e);
      for (uint32_t member = 0; member < kBatch; ++member)
        r[member] = wrapping_subtract(r[member], mul_shift(m, neighbor[member], kSolutionBits));
    }
  }
}

size_t Factor::capacity_for(const Counts& counts) {
  size_t levels = 0;
  for (uint32_t v = counts.vertices; v > 1; v = (v + 1) / 2) ++levels;
  const size_t most = 12 + 4 * levels, usual = 10 + levels * levels / 5;
  return (usual < most ? usual : most) * counts.vertices;
}

bool Factor::allocate(Arena& arena, const Counts& counts, size_t* solve_mark) {
  capacity = capacity_for(counts);
  parent = arena.alloc<uint32_t>(counts.vertices);
  column_start = arena.alloc<uint32_t>(static_cast<size_t>(counts.vertices) + 1);
  inverse = arena.alloc<Reciprocal>(counts.vertices);
  short_bits = arena.alloc<uint8_t>(counts.vertices);
  row = arena.alloc<uint32_t>(capacity);
  const size_t values = arena.mark();
  (void)arena.alloc<int32_t>(capacity);  // what solves leave of `value`
  if (solve_mark != nullptr) *solve_mark = arena.mark();
  arena.release(values);
  value = arena.alloc<int64_t>(capacity);
  mark = arena.alloc<uint32_t>(counts.vertices);
  pattern = arena.alloc<uint32_t>(counts.vertices);
  column_fill = arena.alloc<uint32_t>(counts.vertices);
  work = arena.alloc<int64_t>(counts.vertices);
  return arena.ok();
}

bool Factor::analyze(const SparseMatrix& matrix) {
  const Mesh& mesh = *matrix.mesh;
  const Ordering& ordering = *matrix.ordering;
  uint64_t total = 0;
  for (uint32_t k = 0; k < matrix.rows; ++k) {
    parent[k] = kNoIndex;
    mark[k] = k;
    column_fill[k] = 0;
    const uint32_t v = ordering.order[k];
    for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
      // Row k of L holds every node on the tree path from its neighbors up to k.
      for (uint32_t i = ordering.position[mesh.col_indices[e]]; i < k && mark[i] != k; i = parent[i]) {
        if (parent[i] == kNoIndex) parent[i] = k;
        ++column_fill[i];
        ++total;
        mark[i] = k;
      }
    }
    if (total > capacity) return false;
  }
  column_start[0] = 0;
  for (uint32_t k = 0; k < matrix.rows; ++k) column_start[k + 1] = column_start[k] + column_fill[k];
  return true;
}

void Factor::factorise(const SparseMatrix& matrix) {
  const Mesh& mesh = *matrix.mesh;
  const Ordering& ordering = *matrix.ordering;
  const uint32_t rows = matrix.rows;
  for (uint32_t k = 0; k < rows; ++k) {
    column_fill[k] = 0;
    work[k] = 0;
    mark[k] = k;
    // Pattern of row k in topological order, in pattern[top .. rows), and row k of the matrix in `work`.
    uint32_t top = rows;
    const uint32_t v = ordering.order[k];
    for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
      const uint32_t neighbor = ordering.position[mesh.col_indices[e]];
      if (neighbor > k) continue;
      work[neighbor] = wrapping_add(work[neighbor], matrix.entry(e));
      uint32_t length = 0;
      for (uint32_t i = neighbor; mark[i] != k; i = parent[i]) {
        pattern[length++] = i;
        mark[i] = k;
      }
      while (length > 0) pattern[--top] = pattern[--length];
    }
    int64_t d = matrix.diagonal[k];
    for (; top < rows; ++top) {
      const uint32_t i = pattern[top];
      const int64_t y = work[i];
      work[i] = 0;
      const uint32_t begin = column_start[i], end = begin + column_fill[i];
      for (uint32_t p = begin; p < end; ++p)
        work[row[p]] = wrapping_subtract(work[row[p]], mul_shift(value[p], y, kFactorBits));
      const int64_t l = divide(y, inverse[i], kFactorBits, kFactorHeadroom);
      d = wrapping_subtract(d, mul_shift(l, y, kFactorBits));
      row[end] = k;
      value[end] = l;
      ++column_fill[i];
    }
    // Rounding may not leave a pivot smaller than this part of the diagonal.
    const int64_t smallest = (abs64(matrix.diagonal[k]) >> 34) + 1;
    if (d > -smallest && d < smallest) d = d < 0 ? -smallest : smallest;
    inverse[k] = reciprocal(d);
  }
  smallest_bits = 31;
  for (uint32_t k = 0; k < rows; ++k) {
    uint64_t sum = 1;
    for (uint32_t p = column_start[k]; p < column_start[k + 1]; ++p) {
      sum += static_cast<uint64_t>(abs64(value[p])) >> 8;  // Q32, so that 2^24 saturated entries still fit
    }
    int bits = 31 + 32 - 1 - top_bit(sum);
    if (bits > 31) bits = 31;
    if (bits < 0) bits = 0;
    short_bits[k] = static_cast<uint8_t>(bits);
    if (bits < smallest_bits) smallest_bits = bits;
    for (uint32_t p = column_start[k]; p < column_start[k + 1]; ++p) {
      // Four bytes of eight: what is overwritten was read before.
      const int32_t entry = clamp32(round_shift(value[p], kFactorBits - bits), -0x7FFFFFFF, 0x7FFFFFFF);
      memcpy(reinterpret_cast<uint8_t*>(value) + size_t{p} * sizeof(entry), &entry, sizeof(entry));
    }
  }
}

void Factor::solve(uint32_t rows, int64_t* rhs, int32_t* out) const {
  for (uint32_t k = 0; k < rows; ++k) {
    int64_t* z = rhs + static_cast<size_t>(k) * kBatch;
    int32_t* x = out + static_cast<size_t>(k) * kBatch;
    int64_t any = 0;
    for (uint32_t member = 0; member < kBatch; ++member) any |= z[member];
    if (any == 0) {  // most columns below the top separators see none of these right-hand sides
      for (uint32_t member = 0; member < kBatch; ++member) x[member] = 0;
      continue;
    }
    const int bits = short_bits[k];
    for (uint32_t p = column_start[k]; p < column_start[k + 1]; ++p) {
      int64_t* target = rhs + static_cast<size_t>(row[p]) * kBatch;
      const int64_t l = short_value(p);
      for (uint32_t member = 0; member < kBatch; ++member)
        target[member] = wrapping_subtract(target[member], mul_shift(z[member], l, bits));
    }
    for (uint32_t member = 0; member < kBatch; ++member) {
      x[member] = clamp32(divide(z[member], inverse[k], kSolutionBits, 7), -0x7FFFFFFF, 0x7FFFFFFF);
    }
  }
  for (uint32_t k = rows; k-- > 0;) {
    uint64_t sum[kBatch] = {};  // two's complement; below 2^62 in magnitude, see the header
    for (uint32_t p = column_start[k]; p < column_start[k + 1]; ++p) {
      const int32_t* x = out + static_cast<size_t>(row[p]) * kBatch;
      const int64_t l = short_value(p);
      for (uint32_t member = 0; member < kBatch; ++member) sum[member] += static_cast<uint64_t>(l * x[member]);
    }
    int32_t* x = out + static_cast<size_t>(k) * kBatch;
    for (uint32_t member = 0; member < kBatch; ++member) {
      x[member] =
          clamp32(x[member] - round_shift(static_cast<int64_t>(sum[member]), short_bits[k]), -0x7FFFFFFF, 0x7FFFFFFF);
    }
  }
}

}  // namespace sinew
