// SPDX-License-Identifier: MIT
// A network in float, as the trainer runs it and the quantizer reads it.
#ifndef SINEW_FORMATS_FLOAT_NETWORK_HPP
#define SINEW_FORMATS_FLOAT_NETWORK_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "model/layers.hpp"
#include "model/task.hpp"

namespace sinew {

// One linear layer: weights [out x in] row-major, bias [out].
struct LinearParameters {
  uint32_t in = 0, out = 0;
  std::vector<float> weights;
  std::vector<float> bias;
};

// Inputs are the engine's int16 rows / 8192. The names of a network that says nothing else are bind's.
struct FloatNetwork {
  std::string architecture;      // "field" or "classic" for bind
  uint32_t task = kTaskBind;     // engine/src/model/task.hpp
  uint32_t feature_set = 0;      // that it was trained with: version and flags
  uint32_t candidate_count = 8;  // K
  uint32_t grid_size = 64;
  std::vector<std::string> input_names = {"vert", "pair"};  // four letters each, of buffers 0, 1, ...
  std::vector<Buffer> buffers;                              // the inputs first
  std::vector<Layer> layers;
  std::vector<LinearParameters> parameters;
};

// What the network reads and writes, for opening the model that is made of it. The network has passed check_network().
ModelTask model_task(const FloatNetwork& network);

// Throws Error unless inputs, buffers, layers and parameters fit together (engine/src/model/layer_list.hpp has the rules).
//   source  begins the message: the file, or who made the network
void check_network(const FloatNetwork& network, const std::string& source);

}  // namespace sinew
#endif
