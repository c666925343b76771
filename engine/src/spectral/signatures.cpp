// SPDX-License-Identifier: MIT
// Heat-kernel signature (Sun, Ovsjanikov, Guibas 2009), wave-kernel signature (Aubry, Schlickewei, Cremers 2011) and
// scale-invariant heat-kernel signature (Bronstein, Kokkinos 2010) from eigenpairs, with tables for exp and cos.
#include "spectral/signatures.hpp"

namespace sinew {
namespace {

constexpr int kWeightBits = 22;
constexpr int64_t kLargestSquare = static_cast<int64_t>(1) << 34;  // Q20
constexpr int32_t kFloor = 256;                                    // of a magnitude, Q16: 2^-8

// round(log2(e) * 2^(i / 4) * 2^16)
constexpr int64_t kRates[4] = {94548, 112438, 133712, 159011};
// round(cos(2 pi i / 32) * 2^14)
constexpr int32_t kCosines[32] = {16384, 16069,  15137,  13623,  11585,  9102,   6270,   3196,   0,      -3196,  -6270,
                                  -9102, -11585, -13623, -15137, -16069, -16384, -16069, -15137, -13623, -11585, -9102,
                                  -6270, -3196,  0,      3196,   6270,   9102,   11585,  13623,  15137,  16069};
// log2 of the energies, Q16
constexpr int32_t kEnergies[kWaveKernelEnergies] = {-2 * 65536, -65536, 0, 65536, 2 * 65536, 3 * 65536};

int16_t channel(int64_t log2_in_q16) { return clamp16(round_shift(log2_in_q16, 16 - kSignatureBits), -16384, 16383); }

}  // namespace

void Signatures::prepare(const Eigenpairs& pairs) {
  count_ = pairs.count;
  int64_t logs[kSpectralModes];
  for (uint32_t k = 0; k < count_; ++k) {
    const int64_t value = pairs.value[k];  // below 2^31
    logs[k] = static_cast<int64_t>(log2_q16(static_cast<uint64_t>(value > 1024 ? value : 1024))) -
              (static_cast<int64_t>(kEigenvalueBits) << 16);
    for (uint32_t s = 0; s < kTimeSamples; ++s) {
      const int shift = 3 + 20 - static_cast<int>(s / 4);  // Q20 of the value, time / 2^3
      const int64_t decay = exp2_negative(round_shift(value * kRates[s % 4], shift));
      heat_[k][s] = static_cast<int32_t>(mul_shift(decay, pairs.square_scale[k], 30 + 30 - kWeightBits));
    }
  }
  for (uint32_t e = 0; e < kWaveKernelEnergies; ++e) {
    int64_t gauss[kSpectralModes], nearest = INT64_MAX, sum = 0;
    for (uint32_t k = 0; k < count_; ++k) {
      const int64_t distance = kEnergies[e] - logs[k];
      gauss[k] = (distance * distance) >> 16;
      if (gauss[k] < nearest) nearest = gauss[k];
    }
    // Divided by the largest of them first: an energy between far eigenvalues belongs to the nearest.
    for (uint32_t k = 0; k < count_; ++k) sum += gauss[k] = exp2_negative(gauss[k] - nearest);
    for (uint32_t k = 0; k < count_; ++k) {
      const int64_t share = (gauss[k] << 30) / sum;
      wave_[k][e] = static_cast<int32_t>(mul_shift(share, pairs.square_scale[k], 30 + 30 - kWeightBits));
    }
  }
}

void Signatures::write(const int32_t* vector, int16_t* out) const {
  // Weights are at most 2^23, squares 2^34, so 48 of their products stay below 2^63.
  int64_t heat[kTimeSamples], wave[kWaveKernelEnergies] = {};
  for (int64_t& h : heat) h = static_cast<int64_t>(1) << (kWeightBits + 20);  // the constant eigenvector
  for (uint32_t k = 0; k < count_; ++k) {
    int64_t square = (static_cast<int64_t>(vector[k]) * vector[k]) >> (2 * kVectorBits - 20);
    if (square > kLargestSquare) square = kLargestSquare;
    for (uint32_t s = 0; s < kTimeSamples; ++s) heat[s] += square * heat_[k][s];
    for (uint32_t e = 0; e < kWaveKernelEnergies; ++e) wave[e] += square * wave_[k][e];
  }
  constexpr int32_t kOne = (kWeightBits + 20) << 16;
  int32_t logs[kTimeSamples];
  for (uint32_t s = 0; s < kTimeSamples; ++s) logs[s] = log2_q16(static_cast<uint64_t>(heat[s])) - kOne;
  for (uint32_t i = 0; i < kHeatKernelTimes; ++i) *out++ = channel(logs[kTimeStride * i]);
  for (uint32_t e = 0; e < kWaveKernelEnergies; ++e) {
    const uint64_t value = wave[e] > 0 ? static_cast<uint64_t>(wave[e]) : 1;
    *out++ = count_ == 0 ? int16_t{0} : channel(static_cast<int64_t>(log2_q16(value)) - kOne);
  }
  for (uint32_t f = 0; f < kInvariantFrequencies; ++f) {
    int64_t real = 0, imaginary = 0;  // Q30
    for (uint32_t s = 0; s + 1 < kTimeSamples; ++s) {
      const int64_t step = logs[s + 1] - logs[s];
      real += step * kCosines[f * s % 32];
      imaginary += step * kCosines[(f * s + 24) % 32];  // sine
    }
    real >>= 14;
    imaginary >>= 14;
    const uint64_t square = static_cast<uint64_t>(real * real + imaginary * imaginary) + uint64_t{kFloor} * kFloor;
    *out++ = channel(log2_q16(square) / 2 - (16 << 16));
  }
}

}  // namespace sinew
