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

// Integer steps per unit: of the engine's feature rows (Q13), of a network's output (Q10), and of bind's output,
// which is log2 where float has natural logarithms.
constexpr double kFeatureScale = 8192;
constexpr double kOutputScale = 1024;
constexpr double kLogitScale = 1024 * 1.4426950408889634074;

// One linear layer: weights [out x in] row-major, bias [out].
struct LinearParameters {
  uint32_t in = 0, out = 0;
  std::vector<float> weights;
  std::vector<float> bias;
};

// Inputs are the engine's int16 rows / kFeatureScale. Default input names are those of bind.
struct FloatNetwork {
  std::string architecture;      // "field" or "classic" for bind
  uint32_t task = kTaskBind;     // engine/src/model/task.hpp
  uint32_t feature_set = 0;      // feature set of the training: version and flags
  uint32_t candidate_count = 8;  // K
  uint32_t grid_size = 64;
  std::vector<std::string> input_names = {"vert", "pair"};  // four letters each, of buffers 0, 1, ...
  std::vector<Buffer> buffers;                              // the inputs first
  std::vector<Layer> layers;
  std::vector<LinearParameters> parameters;
};

// Inputs and outputs of the network, for opening the model made from it. The network must have passed
// check_network().
ModelTask model_task(const FloatNetwork& network);

// Throws Error unless inputs, buffers, layers and parameters are consistent (engine/src/model/layer_list.hpp has the
// rules).
//   source  start of the message: the file or the origin of the network
void check_network(const FloatNetwork& network, const std::string& source);

// Converts a model file (.sinew) to a float network, which computes the same except for rounding. Architecture, task,
// features and inputs are those of `like`. Throws Error if the file cannot be read, the engine rejects it, or its
// task or features differ.
FloatNetwork read_model_network(const std::string& path, const FloatNetwork& like);

// Fills the parameters of a network with known layers from a model file (.sinew), which computes the same except for
// rounding. Throws Error if the file cannot be read, the engine rejects it, or its task, features or layers differ
// from the network's; *network is then unchanged.
void read_model_weights(const std::string& path, FloatNetwork* network);

// Additional input of the quantizer for a float network, measured by the trainer.
struct Calibration {
  std::vector<float> layer_max;  // [layers] largest absolute value in each layer's output region
};

}  // namespace sinew
#endif
