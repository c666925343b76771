// SPDX-License-Identifier: MIT
// The check of a float network: the engine's rules of a layer list, and parameters of the right shapes.
#include "sinew_formats/float_network.hpp"

#include <algorithm>

#include "model/layer_list.hpp"
#include "sinew/sinew.h"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

const char* fault_text(LayerFault fault) {
  switch (fault) {
    case LayerFault::kRegion:
      return "reaches outside its buffers";
    case LayerFault::kShape:
      return "has an unknown kind, or regions that do not fit its kind";
    case LayerFault::kFlags:
      return "has flags that its kind does not use";
    case LayerFault::kOverwrite:
      return "writes over an input or over an earlier layer";
    case LayerFault::kUnwritten:
      return "reads a buffer that no earlier layer writes";
    case LayerFault::kResidual:
      return "has a residual of another shape, or one that no earlier layer writes";
    case LayerFault::kNone:
      break;
  }
  return "has no error";
}

}  // namespace

ModelTask model_task(const FloatNetwork& network) {
  ModelTask task;
  task.id = network.task;
  task.input_count = static_cast<uint32_t>(network.input_names.size());
  for (uint32_t i = 0; i < task.input_count; ++i) {
    const std::string& name = network.input_names[i];
    const char letters[5] = {name[0], name[1], name[2], name[3], 0};
    task.inputs[i] = {input_name(letters), network.buffers[i]};
  }
  const Region& out = network.layers.back().out;
  task.output = {network.buffers[out.buffer].domain, out.channels};
  task.far_neighbors = network.task != kTaskBind;
  return task;
}

void check_network(const FloatNetwork& network, const std::string& source) {
  const auto fail = [&](const std::string& what) { throw Error(source + ": damaged: " + what); };
  const size_t inputs = network.input_names.size();
  if (inputs < 1 || inputs > kMaxInputs)
    fail(std::to_string(inputs) + " inputs, expected 1 to " + std::to_string(kMaxInputs));
  for (const std::string& name : network.input_names)
    if (name.size() != 4) fail("an input is called '" + name + "', expected four letters");
  if (network.buffers.size() <= inputs || network.buffers.size() > kMaxBuffers)
    fail(std::to_string(network.buffers.size()) + " buffers, expected " + std::to_string(inputs + 1) + " to " +
         std::to_string(kMaxBuffers));
  if (network.layers.empty() || network.layers.size() > kMaxLayers)
    fail(std::to_string(network.layers.size()) + " layers, expected 1 to " + std::to_string(kMaxLayers));
  if (network.candidate_count < 1 || network.candidate_count > SINEW_MAX_CANDIDATES)
    fail(std::to_string(network.candidate_count) + " candidates, expected 1 to " +
         std::to_string(SINEW_MAX_CANDIDATES));
  for (size_t i = 0; i < network.buffers.size(); ++i) {
    const Buffer& buffer = network.buffers[i];
    const std::string name = "buffer " + std::to_string(i);
    if (static_cast<uint8_t>(buffer.domain) >= kDomains) fail(name + " has an unknown domain");
    if (without_slots(buffer.domain) != without_slots(network.buffers[0].domain))
      fail(name + " mixes joints and vertices");
    if (buffer.channels < 1 || buffer.channels > kMaxChannels)
      fail(name + " has " + std::to_string(buffer.channels) + " channels, expected 1 to " +
           std::to_string(kMaxChannels));
  }
  LayerList list;
  list.buffers = network.buffers.data();
  list.layers = network.layers.data();
  list.buffer_count = static_cast<uint32_t>(network.buffers.size());
  list.input_count = static_cast<uint32_t>(inputs);
  list.candidates = network.candidate_count;
  list.far_neighbors = network.task != kTaskBind;
  for (uint32_t i = 0; i < network.layers.size(); ++i) {
    const Layer& layer = network.layers[i];
    const std::string name = "layer " + std::to_string(i) + " (" +
                             (is_layer_kind(layer.kind) ? traits_of(layer.kind).name
                                                        : "kind " + std::to_string(static_cast<int>(layer.kind))) +
                             ") ";
    const LayerFault fault = find_layer_fault(list, i);
    if (fault != LayerFault::kNone) fail(name + fault_text(fault));
    if (!has_weights(layer.kind)) continue;
    if (layer.parameters >= network.parameters.size()) fail(name + "has no weights");
    const LinearParameters& block = network.parameters[layer.parameters];
    if (block.in != layer.in.channels || block.out != layer.out.channels)
      fail(name + "has weights for " + std::to_string(block.out) + " x " + std::to_string(block.in) + ", expected " +
           std::to_string(layer.out.channels) + " x " + std::to_string(layer.in.channels));
  }
  for (size_t i = 0; i < network.parameters.size(); ++i) {
    const LinearParameters& block = network.parameters[i];
    if (block.weights.size() != size_t{block.in} * block.out || block.bias.size() != block.out)
      fail("weight block " + std::to_string(i) + " is not " + std::to_string(block.out) + " x " +
           std::to_string(block.in));
  }
}

}  // namespace sinew
