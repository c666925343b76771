// SPDX-License-Identifier: MIT
// The rules of a layer list, for the reader of model files and for the float networks that become such files.
#ifndef SINEW_MODEL_LAYER_LIST_HPP
#define SINEW_MODEL_LAYER_LIST_HPP

#include "model/layers.hpp"

namespace sinew {

// A borrowed layer list. Its counts are within kMaxInputs, kMaxBuffers and kMaxLayers, its inputs come first.
struct LayerList {
  const Buffer* buffers = nullptr;
  const Layer* layers = nullptr;
  uint32_t buffer_count = 0, input_count = 0;
  uint32_t candidates = 0;     // K
  bool far_neighbors = false;  // the task has them
};

enum class LayerFault : uint8_t {
  kNone = 0,
  kRegion,     // a region lies outside its buffer or has no channels
  kShape,      // a layer of this kind does not take such domains or channels
  kFlags,      // an unknown flag, or a flag of another kind of layer
  kOverwrite,  // it writes to an input, or where an earlier layer wrote
  kUnwritten,  // it reads channels that no earlier layer writes
  kResidual    // the residual lies outside its buffer, has another shape than the output, or is not written before
};

// First fault of layer `index`; the layers before it have none.
LayerFault find_layer_fault(const LayerList& list, uint32_t index);
// Whether a layer's region gives one row of `output` per row of that domain.
bool writes_output(const LayerList& list, uint32_t index, const Buffer& output);

}  // namespace sinew
#endif
