// SPDX-License-Identifier: MIT
// Eigenpairs of a part to the signatures of its vertices (spectral stage).
#ifndef SINEW_SPECTRAL_SIGNATURES_HPP
#define SINEW_SPECTRAL_SIGNATURES_HPP

#include "spectral/eigenpairs.hpp"
#include "spectral/spectral.hpp"

namespace sinew {

constexpr uint32_t kTimeSamples = 33;  // 2^-3 .. 2^5, four per octave
constexpr uint32_t kTimeStride = 6;    // of the samples that are channels: 2^-3, 2^-1.5, 1, 2^1.5, 2^3, 2^4.5

// Factors of every vertex of a part.
class Signatures {
 public:
  void prepare(const Eigenpairs& pairs);
  // vector [kSpectralModes] Q20: the eigenvectors at a vertex. out [kSpectralChannels] Q10.
  void write(const int32_t* vector, int16_t* out) const;

 private:
  uint32_t count_ = 0;
  int32_t heat_[kSpectralModes][kTimeSamples];         // Q22: exp(-lambda t) over the squared norm
  int32_t wave_[kSpectralModes][kWaveKernelEnergies];  // Q22: sum over the modes is 1
};

}  // namespace sinew
#endif
