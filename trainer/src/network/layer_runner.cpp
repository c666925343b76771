// SPDX-License-Identifier: MIT
// Runs the layer list over a sample: checks that they fit together, copies parameters, walks the layers.
#include "network/layer_runner.hpp"

#include <algorithm>
#include <string>

#include "network/float_layers.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

template <class S>
std::vector<LinearBlock<S>> zero_blocks(const FloatNetwork& network) {
  std::vector<LinearBlock<S>> blocks(network.parameters.size());
  for (size_t i = 0; i < blocks.size(); ++i) {
    blocks[i].weights.assign(network.parameters[i].weights.size(), S(0));
    blocks[i].bias.assign(network.parameters[i].bias.size(), S(0));
  }
  return blocks;
}
template <class S>
std::vector<LinearBlock<S>> copy_blocks(const FloatNetwork& network) {
  std::vector<LinearBlock<S>> blocks(network.parameters.size());
  for (size_t i = 0; i < blocks.size(); ++i) {
    blocks[i].weights.assign(network.parameters[i].weights.begin(), network.parameters[i].weights.end());
    blocks[i].bias.assign(network.parameters[i].bias.begin(), network.parameters[i].bias.end());
  }
  return blocks;
}
template std::vector<LinearBlock<float>> zero_blocks<float>(const FloatNetwork&);
template std::vector<LinearBlock<double>> zero_blocks<double>(const FloatNetwork&);
template std::vector<LinearBlock<float>> copy_blocks<float>(const FloatNetwork&);
template std::vector<LinearBlock<double>> copy_blocks<double>(const FloatNetwork&);

namespace {

void check_inputs(const FloatNetwork& shape, const NetworkSample& sample) {
  const auto list = [](size_t count, auto&& channels) {
    std::string text;
    for (size_t i = 0; i < count; ++i) text += (i == 0 ? "" : " + ") + std::to_string(channels(i));
    return text;
  };
  const size_t inputs = shape.input_names.size();
  bool same = sample.inputs.size() == inputs && shape.candidate_count == sample.candidates;
  for (size_t i = 0; i < inputs && same; ++i) same = shape.buffers[i].channels == sample.inputs[i].channels;
  if (!same) {
    throw Error(sample.name + ": the network wants " +
                list(inputs, [&](size_t i) { return shape.buffers[i].channels; }) + " features and " +
                std::to_string(shape.candidate_count) + " candidates, the sample has " +
                list(sample.inputs.size(), [&](size_t i) { return sample.inputs[i].channels; }) + " and " +
                std::to_string(sample.candidates));
  }
  for (size_t i = 0; i < inputs; ++i) {
    const size_t rows = size_t{sample.vertices} * (has_slots(shape.buffers[i].domain) ? sample.candidates : 1);
    if (sample.inputs[i].rows.size() != rows * sample.inputs[i].channels)
      throw Error(sample.name + ": the sample's arrays do not fit its counts; its cache is damaged, delete it");
  }
  for (const Layer& layer : shape.layers) {
    if ((layer.kind == LayerKind::kRingMean || layer.kind == LayerKind::kRingMax) && (layer.flags & kLayerFar) != 0 &&
        sample.far_offsets.size() != size_t{sample.vertices} + 1)
      throw Error(sample.name + ": the network reads far neighbors, which the sample lacks; delete its cache");
  }
}

}  // namespace

template <class S>
LayerRunner<S>::LayerRunner() : state_(std::make_unique<FloatLayers<S>>()) {}
template <class S>
LayerRunner<S>::~LayerRunner() = default;
template <class S>
void LayerRunner<S>::set_team(Team* team) {
  state_->team = team;
}

template <class S>
const std::vector<S>& LayerRunner<S>::forward(const FloatNetwork& shape, const std::vector<LinearBlock<S>>& parameters,
                                              const NetworkSample& sample, const DropoutOptions& dropout) {
  FloatLayers<S>& s = *state_;
  check_inputs(shape, sample);
  s.sample = &sample;
  s.index.build(sample);
  s.relu_scale = static_cast<S>(1.0 / (1.0 - static_cast<double>(dropout.activations)));
  s.values.resize(shape.buffers.size());
  s.arguments.resize(shape.layers.size());
  for (uint16_t b = 0; b < shape.buffers.size(); ++b) {
    s.values[b].resize(size_t{s.rows(shape, b)} * shape.buffers[b].channels);
  }
  s.weights.resize(parameters.size());
  s.bias.resize(parameters.size());
  for (size_t i = 0; i < parameters.size(); ++i) {
    s.weights[i].resize(parameters[i].weights.size());
    std::copy(parameters[i].weights.begin(), parameters[i].weights.end(), s.weights[i].data());
    s.bias[i].resize(parameters[i].bias.size());
    std::copy(parameters[i].bias.begin(), parameters[i].bias.end(), s.bias[i].data());
  }
  s.load_inputs(shape, dropout);

  for (size_t i = 0; i < shape.layers.size(); ++i) s.forward(shape, i, dropout);
  const View<S> output = s.view(shape, s.values, shape.layers.back().out);
  s.outputs.assign(s.output_rows(shape) * output.channels, S(0));
  for (uint32_t r = 0; r < output.rows; ++r)
    std::copy_n(output.row(r), output.channels, s.outputs.data() + s.output_row(shape, r) * output.channels);
  return s.outputs;
}

template <class S>
void LayerRunner<S>::backward(const FloatNetwork& shape, const std::vector<LinearBlock<S>>& parameters,
                              const std::vector<S>& d_outputs, std::vector<LinearBlock<S>>* gradients) {
  FloatLayers<S>& s = *state_;
  s.gradients.resize(shape.buffers.size());
  const uint16_t inputs = static_cast<uint16_t>(shape.input_names.size());
  for (uint16_t b = inputs; b < shape.buffers.size(); ++b) {
    s.gradients[b].resize(s.values[b].size());
    s.gradients[b].zero();
  }
  s.d_weights.resize(parameters.size());
  s.d_bias.resize(parameters.size());
  for (size_t i = 0; i < parameters.size(); ++i) {
    s.d_weights[i].resize(parameters[i].weights.size());
    s.d_weights[i].zero();
    s.d_bias[i].resize(parameters[i].bias.size());
    s.d_bias[i].zero();
  }
  const View<S> output = s.view(shape, s.gradients, shape.layers.back().out);
  for (uint32_t r = 0; r < output.rows; ++r)
    std::copy_n(d_outputs.data() + s.output_row(shape, r) * output.channels, output.channels, output.row(r));

  for (size_t i = shape.layers.size(); i-- > 0;) s.backward(shape, i);

  for (size_t i = 0; i < parameters.size(); ++i) {
    add_to((*gradients)[i].weights.data(), s.d_weights[i].data(), static_cast<uint32_t>(s.d_weights[i].size()));
    add_to((*gradients)[i].bias.data(), s.d_bias[i].data(), static_cast<uint32_t>(s.d_bias[i].size()));
  }
}

template <class S>
void LayerRunner<S>::copy_buffer(const FloatNetwork& shape, uint16_t index, std::vector<S>* out) const {
  const FloatLayers<S>& s = *state_;
  const uint32_t channels = shape.buffers[index].channels;
  const S* in = s.values[index].data();
  if (!has_slots(shape.buffers[index].domain)) {
    out->assign(in, in + size_t{s.index.vertices} * channels);
    return;
  }
  out->assign(size_t{s.index.vertices} * s.index.slots * channels, S(0));
  for (uint32_t p = 0; p < s.index.pairs; ++p) {
    std::copy_n(in + size_t{p} * channels, channels, out->data() + size_t{s.index.pair_slot[p]} * channels);
  }
}

template class LayerRunner<float>;
template class LayerRunner<double>;

}  // namespace sinew
