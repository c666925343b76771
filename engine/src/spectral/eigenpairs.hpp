// SPDX-License-Identifier: MIT
// Lowest eigenpairs of one part's Laplacian by subspace iteration with the inverse of L + shift M (spectral
// stage).
#ifndef SINEW_SPECTRAL_EIGENPAIRS_HPP
#define SINEW_SPECTRAL_EIGENPAIRS_HPP

#include "solve/factor.hpp"
#include "solve/ordering.hpp"
#include "spectral/operator.hpp"
#include "spectral/symmetric.hpp"

namespace sinew {

constexpr int kVectorBits = 20;            // eigenvectors of mass norm 1 are numbers around 1
constexpr int32_t kVectorLimit = 1 << 28;  // +-256
constexpr int kEigenvalueBits = 20;
constexpr uint32_t kSubspaceSteps = 5;

// L phi = 4 pi lambda M phi with the masses' sum 1: lambda counts in units in which the k-th eigenvalue of a large
// smooth surface is about k (Weyl's law), whatever the size of the part.
struct Eigenpairs {
  uint32_t count = 0;                    // pairs found, by rising eigenvalue; the constant one is not among them
  int64_t value[kSpectralModes];         // Q20
  int64_t square_scale[kSpectralModes];  // Q30: 1 / squared mass norm of the vector
  uint32_t column[kSpectralModes];       // of its vector
};

class EigenSolver {
 public:
  bool allocate(Arena& arena, const Counts& counts);
  // Eigenpairs of one part (at least two vertices); fewer than kSpectralModes - 1 when the part is smaller.
  // False when the factor of a tangle of faces would not fit (Factor::capacity_for): its spectrum says nothing, and
  // iterating without a factor would take seconds.
  bool solve(const Mesh& mesh, SpectralOperator& op, uint32_t part, Eigenpairs* out);
  // Values of all columns at a vertex of that part, Q20: out [kSpectralModes].
  void row(uint32_t vertex, int32_t* out) const { load(ordering_.position[vertex], out); }

 private:
  int32_t* at(uint32_t batch, uint32_t position) {
    return vectors_ + (static_cast<size_t>(batch) * matrix_.rows + position) * kBatch;
  }
  const int32_t* at(uint32_t batch, uint32_t position) const {
    return vectors_ + (static_cast<size_t>(batch) * matrix_.rows + position) * kBatch;
  }
  void load(uint32_t position, int32_t* row) const;
  void store(uint32_t position, const int32_t* row);
  void start();
  void image(uint32_t batch);
  void gram();
  void orthonormalize();
  void project(uint32_t batch);
  void finish(Eigenpairs* out);

  SparseMatrix matrix_;
  Ordering ordering_;
  Factor factor_;
  uint32_t columns_ = 0, batches_ = 0;
  const SpectralOperator* op_ = nullptr;
  int32_t* vectors_ = nullptr;                  // [kSpectralModes / kBatch][rows x kBatch] Q20
  int64_t* rhs_ = nullptr;                      // [U x kBatch]
  int32_t* image_ = nullptr;                    // [U x kBatch]
  int64_t* mass_ = nullptr;                     // [U] by elimination position, Q40
  int64_t (*small_)[kSpectralModes] = nullptr;  // Gram or projected matrix
  int64_t (*rotation_)[kSpectralModes] = nullptr;
  Orthonormalizer* orthonormalizer_ = nullptr;
};

}  // namespace sinew
#endif
