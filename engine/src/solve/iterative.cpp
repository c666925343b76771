// SPDX-License-Identifier: MIT
// Refined, Jacobi-preconditioned conjugate gradients on integers: the bounded-memory alternative for tangled meshes.
#include "solve/iterative.hpp"

namespace sinew {
namespace {

constexpr int kIterateBits = 40;  // solutions and directions
constexpr uint32_t kRounds = 24;
constexpr uint32_t kInnerSteps = 60;
constexpr int kLargestLift = 16;  // an error of 1 in the solution becomes a correction of 2^16, 2^56 in Q40
constexpr int64_t kSmallEnough = static_cast<int64_t>(1) << (kIterateBits - 24);  // of the Jacobi-scaled residual

uint64_t magnitude(int64_t v) { return v < 0 ? 0 - static_cast<uint64_t>(v) : static_cast<uint64_t>(v); }

// a / b for a, b > 0 as mantissa * 2^-shift with a mantissa below 2^33.
struct Ratio {
  int64_t mantissa;
  int shift;
};
Ratio ratio(int64_t a, int64_t b) {
  const int lift = 62 - top_bit(static_cast<uint64_t>(a));
  const int drop = top_bit(static_cast<uint64_t>(b)) - 30;
  const uint64_t divisor = static_cast<uint64_t>(drop > 0 ? b >> drop : b * (static_cast<int64_t>(1) << -drop));
  return {static_cast<int64_t>((static_cast<uint64_t>(a) << lift) / divisor), lift + drop};
}
// v * ratio, or 0 when the factor is out of range (only after a breakdown).
int64_t times(int64_t v, Ratio r) { return r.shift < 0 || r.shift > 63 ? 0 : mul_shift(v, r.mantissa, r.shift); }

class MemberSolver {
 public:
  MemberSolver(const SparseMatrix& matrix, int64_t* scratch, const Reciprocal* inverse)
      : matrix_(matrix),
        inverse_(inverse),
        x_(scratch),
        residual_(scratch + matrix.rows),
        correction_(scratch + 2 * static_cast<size_t>(matrix.rows)),
        direction_(scratch + 3 * static_cast<size_t>(matrix.rows)),
        image_(scratch + 4 * static_cast<size_t>(matrix.rows)) {}

  void run(const int64_t* rhs, uint32_t member, int32_t* out) {
    const uint32_t rows = matrix_.rows;
    for (uint32_t k = 0; k < rows; ++k) x_[k] = 0;
    for (uint32_t round = 0; round < kRounds; ++round) {
      multiply(x_);
      int64_t largest = 0;
      for (uint32_t k = 0; k < rows; ++k) {
        residual_[k] = wrapping_subtract(rhs[static_cast<size_t>(k) * kBatch + member], image_[k]);
        const int64_t scaled = abs64(preconditioned(k));
        if (scaled > largest) largest = scaled;
      }
      if (largest <= kSmallEnough) break;
      int lift = kIterateBits - 2 - top_bit(static_cast<uint64_t>(largest));  // largest becomes about a quarter
      lift = lift < 0 ? 0 : lift > kLargestLift ? kLargestLift : lift;
      for (uint32_t k = 0; k < rows; ++k)
        residual_[k] = static_cast<int64_t>(static_cast<uint64_t>(residual_[k]) << lift);
      correct();
      for (uint32_t k = 0; k < rows; ++k) x_[k] = wrapping_add(x_[k], round_shift(correction_[k], lift));
    }
    for (uint32_t k = 0; k < rows; ++k) {
      out[static_cast<size_t>(k) * kBatch + member] =
          clamp32(round_shift(x_[k], kIterateBits - kSolutionBits), -0x7FFFFFFF, 0x7FFFFFFF);
    }
  }

 private:
  int64_t preconditioned(uint32_t k) const { return divide(residual_[k], inverse_[k], kIterateBits, 4); }

  // image = M v for v in Q40.
  void multiply(const int64_t* v) {
    const Mesh& mesh = *matrix_.mesh;
    const Ordering& ordering = *matrix_.ordering;
    for (uint32_t k = 0; k < matrix_.rows; ++k) {
      const uint32_t vertex = ordering.order[k];
      int64_t sum = mul_shift(matrix_.diagonal[k], v[k], kIterateBits);
      for (uint32_t e = mesh.row_offsets[vertex]; e < mesh.row_offsets[vertex + 1]; ++e) {
        sum = wrapping_add(sum, mul_shift(matrix_.entry(e), v[ordering.position[mesh.col_indices[e]]], kIterateBits));
      }
      image_[k] = sum;
    }
  }

  // Shift after which the sum of products of the two arrays stays below 2^56.
  int product_shift(const int64_t* a, const int64_t* b) const {
    uint64_t bits_a = 1, bits_b = 1;
    for (uint32_t k = 0; k < matrix_.rows; ++k) {
      bits_a |= magnitude(a[k]);
      bits_b |= magnitude(b[k]);
    }
    const int shift = top_bit(bits_a) + 1 + top_bit(bits_b) + 1 + top_bit(matrix_.rows) + 1 - 56;
    return shift < 0 ? 0 : shift > 63 ? 63 : shift;
  }
  int64_t product(const int64_t* a, const int64_t* b, int shift) const {
    int64_t sum = 0;
    for (uint32_t k = 0; k < matrix_.rows; ++k) sum = wrapping_add(sum, mul_shift(a[k], b[k], shift));
    return sum;
  }

  // Conjugate gradients on M e = residual from e = 0 until the residual's energy has fallen by 2^-24.
  void correct() {
    const uint32_t rows = matrix_.rows;
    for (uint32_t k = 0; k < rows; ++k) {
      correction_[k] = 0;
      direction_[k] = preconditioned(k);
    }
    int rho_shift = product_shift(residual_, direction_);
    int64_t rho = product(residual_, direction_, rho_shift);
    const int64_t target = rho >> 24;
    for (uint32_t step = 0; step < kInnerSteps && rho > target && rho > 0; ++step) {
      multiply(direction_);
      const int shift = product_shift(direction_, image_);
      const int64_t energy = product(direction_, image_, shift);
      if (energy <= 0) return;  // only rounding noise is left
      Ratio alpha = ratio(rho, energy);
      alpha.shift += shift - rho_shift;
      for (uint32_t k = 0; k < rows; ++k) {
        correction_[k] = wrapping_add(correction_[k], times(direction_[k], alpha));
        residual_[k] = wrapping_subtract(residual_[k], times(image_[k], alpha));
      }
      int64_t next = 0;
      for (uint32_t k = 0; k < rows; ++k)
        next = wrapping_add(next, mul_shift(residual_[k], preconditioned(k), rho_shift));
      if (next <= 0) return;
      const Ratio beta = ratio(next, rho);
      for (uint32_t k = 0; k < rows; ++k) direction_[k] = wrapping_add(preconditioned(k), times(direction_[k], beta));
      rho = next;
    }
  }

  const SparseMatrix& matrix_;
  const Reciprocal* inverse_;
  int64_t* x_;
  int64_t* residual_;
  int64_t* correction_;
  int64_t* direction_;
  int64_t* image_;
};

}  // namespace

void solve_iteratively(const SparseMatrix& matrix, const int64_t* rhs, int64_t* scratch, Reciprocal* inverse,
                       int32_t* out) {
  for (uint32_t k = 0; k < matrix.rows; ++k) inverse[k] = reciprocal(matrix.diagonal[k]);
  MemberSolver solver(matrix, scratch, inverse);
  for (uint32_t member = 0; member < kBatch; ++member) solver.run(rhs, member, out);
}

}  // namespace sinew
