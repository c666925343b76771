// SPDX-License-Identifier: MIT
// Builds a network layer by layer with seeded initial weights.
#ifndef SINEW_TRAINER_NETWORK_NETWORK_BUILDER_HPP
#define SINEW_TRAINER_NETWORK_NETWORK_BUILDER_HPP

#include <cmath>
#include <string>
#include <utility>

#include "core/random.hpp"
#include "model/task.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/float_network.hpp"

namespace sinew {

// The first buffers that are added are the inputs.
class NetworkBuilder {
 public:
  NetworkBuilder(const std::string& architecture, uint64_t seed) : random_(seed) {
    network_.architecture = architecture;
  }

  uint16_t add_buffer(Domain domain, uint32_t channels) {
    if (channels < 1 || channels > kMaxChannels || network_.buffers.size() >= kMaxBuffers) {
      throw Error(network_.architecture + ": a buffer of " + std::to_string(channels) + " channels, or more than " +
                  std::to_string(kMaxBuffers) + " buffers; choose a smaller width or fewer rounds");
    }
    network_.buffers.push_back({domain, static_cast<uint16_t>(channels)});
    return static_cast<uint16_t>(network_.buffers.size() - 1);
  }
  Region all(uint16_t buffer) const { return {buffer, 0, network_.buffers[buffer].channels}; }
  static Region part(uint16_t buffer, uint32_t offset, uint32_t channels) {
    return {buffer, static_cast<uint16_t>(offset), static_cast<uint16_t>(channels)};
  }
  Region fresh(Domain domain, uint32_t channels) { return all(add_buffer(domain, channels)); }

  void apply(LayerKind kind, const Region& in, const Region& out, uint8_t flags = 0) {
    Layer layer;
    layer.kind = kind;
    layer.flags = flags;
    layer.in = in;
    layer.out = out;
    network_.layers.push_back(layer);
  }
  // gain 1 = the variance that keeps ReLU activations at their scale (He et al. 2015). Returns the weights to change
  // them.
  LinearParameters& linear(const Region& in, const Region& out, uint8_t flags, const Region& residual, double gain) {
    Layer layer;
    layer.flags = flags;
    layer.in = in;
    layer.out = out;
    layer.residual = residual;
    layer.parameters = static_cast<uint32_t>(network_.parameters.size());
    network_.layers.push_back(layer);
    LinearParameters block;
    block.in = in.channels;
    block.out = out.channels;
    block.bias.assign(block.out, 0.0f);
    block.weights.resize(size_t{block.in} * block.out);
    const double deviation = gain * std::sqrt(2.0 / block.in);
    for (float& w : block.weights) w = static_cast<float>(deviation * random_.normal());
    network_.parameters.push_back(std::move(block));
    return network_.parameters.back();
  }
  LinearParameters& relu(const Region& in, const Region& out) { return linear(in, out, kLayerRelu, {}, 1.0); }
  FloatNetwork take() { return std::move(network_); }

 protected:
  FloatNetwork network_;

 private:
  Random random_;
};

// A network over points of a surface, of the engine's rig task: one input, no candidates.
class PointNetworkBuilder : public NetworkBuilder {
 public:
  //   grid_size  cells along the longest side of what its features march through; 0: they march through nothing
  PointNetworkBuilder(const std::string& architecture, uint64_t seed, uint32_t feature_set, uint32_t grid_size,
                      const std::string& input)
      : NetworkBuilder(architecture, seed) {
    network_.task = kTaskRig;
    network_.feature_set = feature_set;
    network_.candidate_count = 1;
    network_.grid_size = grid_size;
    network_.input_names = {input};
  }
};

}  // namespace sinew
#endif
