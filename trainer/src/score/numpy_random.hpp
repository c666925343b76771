// SPDX-License-Identifier: MIT
// numpy's default_rng, draw for draw: the yardstick's random poses come from it, so ours must as well.
#ifndef SINEW_TRAINER_SCORE_NUMPY_RANDOM_HPP
#define SINEW_TRAINER_SCORE_NUMPY_RANDOM_HPP

#include <cstdint>

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

}  // namespace sinew
#endif
