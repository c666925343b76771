// SPDX-License-Identifier: MIT
// Spectral stage of a bind: heat-kernel, wave-kernel and scale-invariant heat-kernel signatures per welded vertex, in
// integers. README.md beside this file is the exact definition.
#ifndef SINEW_SPECTRAL_SPECTRAL_HPP
#define SINEW_SPECTRAL_SPECTRAL_HPP

#include "features/channels.hpp"
#include "mesh/mesh.hpp"

namespace sinew {

constexpr uint32_t kHeatKernelTimes = 6;
constexpr uint32_t kWaveKernelEnergies = 6;
constexpr uint32_t kInvariantFrequencies = 6;
static_assert(kHeatKernelTimes + kWaveKernelEnergies + kInvariantFrequencies == kSpectralChannels,
              "features/channels.hpp has another number");
constexpr int kSignatureBits = 10;  // channels are logarithms to base 2

// Fills one row per welded vertex: log2 of the heat-kernel signature at 6 times, of the wave-kernel signature at 6
// energies, of the first 6 frequencies of the scale-invariant one; Q10, clamped to [-16384, 16383].
//   out       [U x stride] int16; kSpectralChannels of each row are written
//   progress  reported from 0 to 1000
//   arena     scratch, all of it released
// Every part has its own eigenpairs and is normalized by its own area. A vertex without faces has 0, 0 and -8, and
// so has a tangle of faces whose factor would not fit. The same bytes on every platform. Returns SINEW_OK,
// SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status compute_spectral(const Mesh& mesh, const Counts& counts, const Progress& progress, Arena& arena,
                              int16_t* out, size_t stride);

}  // namespace sinew
#endif
