// SPDX-License-Identifier: MIT
// Integer layers to the bytes of a model file, through engine/src/model/layout.hpp. Checks nothing: the engine's reader
// does.
#ifndef SINEW_QUANT_MODEL_WRITER_HPP
#define SINEW_QUANT_MODEL_WRITER_HPP

#include <cstdint>
#include <vector>

#include "model/layers.hpp"
#include "model/layout.hpp"
#include "model/task.hpp"
#include "sinew_quant/quantize.hpp"

namespace sinew {

// One linear layer in integers; see formats/spec/model.md for the arithmetic.
struct IntegerLinear {
  uint16_t in = 0, out = 0;
  AccumulatorClass accumulator = AccumulatorClass::kNarrow;
  ValueRange range = ValueRange::kPositive;
  uint16_t block = 0;             // columns per int32 block; = in for class N
  std::vector<int64_t> bias;      // [out] holding 1 << (shift - 1)
  std::vector<int16_t> weights;   // [out x in]
  std::vector<int16_t> residual;  // [out] or empty
  std::vector<uint8_t> shifts;    // [out]
};

struct IntegerModel {
  uint32_t task = kTaskBind;          // engine/src/model/task.hpp
  std::vector<uint32_t> input_names;  // input_name() of buffers 0, 1, ...; empty: the file names none
  uint32_t candidate_count = 8, grid_size = 64, feature_set = 0;
  std::vector<Buffer> buffers;
  std::vector<Layer> layers;
  std::vector<IntegerLinear> linears;  // in layer order
};

// The file with a confidence section of these entries behind its first `parameters_end` bytes.
std::vector<uint8_t> write_confidence(const std::vector<uint8_t>& model, size_t parameters_end,
                                      const std::vector<ConfidenceEntry>& entries);
std::vector<uint8_t> write_model(const IntegerModel& model);
// Recomputes the checksum of a file of at least kHeaderBytes after its bytes were changed.
void seal_model(std::vector<uint8_t>* bytes);

// One file of two networks: `second`, a whole file, behind the first one's parameters. Both without a section of their own.
std::vector<uint8_t> with_second_network(std::vector<uint8_t> first, const std::vector<uint8_t>& second);

}  // namespace sinew
#endif
