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

// Integer steps per unit: of the engine's rows of features (Q13), of a network's output (Q10), and of bind's, which are
// log2 units of what float has in natural ones.
constexpr double kFeatureScale = 8192;
constexpr double kOutputScale = 1024;
constexpr double kLogitScale = 1024 * 1.4426950408889634074;

// One linear layer: weights [out x in] row-major, bias [out].
struct LinearParameters {
  uint32_t in = 0, out = 0;
  std::vector<float> weights;
  std::vector<float> bias;
};

// Inputs are the engine's int16 rows / kFeatureScale. The names of a network that says nothing else are bind's.
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

// The network of a model file (.sinew) with its own layers, in float: what the model computes but for its rounding.
// Architecture, task, features and inputs are those of `like`. Throws Error when the file cannot be read, the engine refuses it,
// or its task or features are others.
FloatNetwork read_model_network(const std::string& path, const FloatNetwork& like);

// Fills the parameters of a network of known layers from a model file (.sinew), as float: what the model computes but for
// its rounding. Throws Error when the file cannot be read, the engine refuses it, or its task, features or layers are not
// the network's; then *network is as it was.
void read_model_weights(const std::string& path, FloatNetwork* network);

// What the quantizer must know of a float network beside its checkpoint: the trainer measures it.
struct Calibration {
  std::vector<float> layer_max;  // [layers] largest absolute value in each layer's output region
};

}  // namespace sinew
#endif
