// SPDX-License-Identifier: MIT
// Float checkpoint to int16 model: calibrated ranges, per-channel shifts, accumulator proofs, model writer.
#ifndef SINEW_QUANT_QUANTIZE_HPP
#define SINEW_QUANT_QUANTIZE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/float_network.hpp"

namespace sinew {

struct QuantizeOptions {
  double margin = 1.5;       // a layer's range is its calibrated maximum times this
  int weight_bits = 16;      // 16, 12, 10 or 8: weights are rounded to so many bits
  int activation_bits = 14;  // fewer, to study the error: values are rounded to a coarser grid of the same format
};

struct QuantizeLayerReport {
  std::string what;   // "linear 192 -> 32"
  int64_t bound = 0;  // proven largest |accumulator|
  bool wide = false;  // class W (int64)
  int min_shift = 0, max_shift = 0;
};
struct QuantizedModel {
  std::vector<uint8_t> bytes;  // the model file
  std::vector<QuantizeLayerReport> layers;
};

struct ConfidenceEntry {
  uint16_t share = 0;  // of the strongest joint, 65535 = 1
  uint16_t hits = 0;   // how often it was right there, 65535 = 1
};
// Puts a confidence table into a model file, or another instead of the one it has; no entries take it out. Throws
// Error when the engine refuses the file or the result (2 to 64 entries, share rising, hits not falling).
std::vector<uint8_t> with_confidence(const std::vector<uint8_t>& model, const std::vector<ConfidenceEntry>& entries);

// Writes through engine/src/model's layout, reopens the bytes with sinew_model_open and throws Error if that refuses.
QuantizedModel quantize(const FloatNetwork& network, const Calibration& calibration,
                        const QuantizeOptions& options = {});

}  // namespace sinew
#endif
