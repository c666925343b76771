// SPDX-License-Identifier: MIT
// Functions of numpy and scipy for the benchmark: default_rng, draw for draw, the source of its random poses, and
// linear_sum_assignment, the cheapest pairing of rows with columns.
#ifndef SINEW_TRAINER_SCORE_NUMPY_HPP
#define SINEW_TRAINER_SCORE_NUMPY_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sinew {

// numpy.random.default_rng(seed): a SeedSequence (O'Neill's seed_seq_fe128) fills the 128-bit state of PCG64 (O'Neill
// 2014, XSL-RR output). Words and uniforms equal numpy's bit for bit. Normals take the same draws and differ by at most
// 4e-15 (5.2 million compared): numpy's printed tables carry rounding of their own, ours are computed.
class NumpyRandom {
 public:
  explicit NumpyRandom(uint64_t seed);
  uint64_t next_uint64();
  // [0, 1), 53 bits.
  double next_double();
  double uniform(double low, double high);
  // Standard normal by the 256-layer ziggurat (Marsaglia and Tsang 2000).
  double normal();

 private:
  struct Word128 {
    uint64_t high = 0, low = 0;
  };
  static Word128 add(Word128 a, Word128 b);
  static Word128 multiply(Word128 a, Word128 b);
  void step();

  Word128 state_, increment_;
};

// Pairs each row with a column of its own, or each column with a row where there are fewer columns, at the least sum of
// costs. Returns the column of every row, -1 for a row that is left over. `cost` [rows x columns] finite.
// Shortest augmenting paths with dual prices: D. F. Crouse, On implementing 2D rectangular assignment algorithms, IEEE
// Trans. Aerospace and Electronic Systems 52 (2016), O(rows^2 columns). Of equally cheap pairings the one that
// scipy.optimize.linear_sum_assignment gives: skeletons are symmetric, ties are common.
std::vector<int> cheapest_pairs(const std::vector<double>& cost, size_t rows, size_t columns);

}  // namespace sinew
#endif
