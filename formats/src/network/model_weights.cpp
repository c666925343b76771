// SPDX-License-Identifier: MIT
// The weights of an int16 model as float ones, for going on with training where only the model was released.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "model/layout.hpp"
#include "model/reader.hpp"
#include "sinew/sinew.h"
#include "sinew_formats/error.hpp"
#include "sinew_formats/float_network.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

bool same_region(const Region& a, const Region& b) {
  return a.buffer == b.buffer && a.offset == b.offset && a.channels == b.channels;
}

bool same_layer(const Layer& a, const Layer& b) {
  return a.kind == b.kind && a.flags == b.flags && same_region(a.in, b.in) && same_region(a.out, b.out) &&
         (!(a.flags & kLayerResidual) || same_region(a.residual, b.residual));
}

LinearParameters block_of(const Layer& layer) {
  LinearParameters block;
  block.in = layer.in.channels;
  block.out = layer.out.channels;
  block.weights.resize(size_t{block.in} * block.out);
  block.bias.resize(block.out);
  return block;
}

void check_opens(const std::vector<uint8_t>& bytes, const FloatNetwork& network, const std::string& path) {
  ModelHeader header;
  sinew_model model;
  sinew_status status = read_header(bytes.data(), bytes.size(), &header);
  if (status == SINEW_OK && (header.task != network.task || header.feature_set != network.feature_set))
    throw Error(path + ": cannot start from its weights: it has another task or other features");
  if (status == SINEW_OK) {
    status = network.task == kTaskBind ? sinew_model_open(bytes.data(), bytes.size(), &model)
                                       : open_model(bytes.data(), bytes.size(), model_task(network), &model);
  }
  if (status != SINEW_OK) throw Error(path + ": " + sinew_status_text(status));
}

// A model keeps weights times the ratio of the steps of a layer's output and input. What a step of a layer inside is worth
// is lost, and free: ReLUs and largest values keep any factor. It is taken such that the layer's weights have the size
// of fresh ones.
class WeightReader {
 public:
  WeightReader(const ModelTables& tables, FloatNetwork* network) : tables_(tables), network_(*network) {
    for (size_t i = 0; i < network_.buffers.size(); ++i)
      scales_.emplace_back(network_.buffers[i].channels, i < network_.input_names.size() ? kFeatureScale : 0.0);
  }

  void run() {
    mark_outputs();
    for (size_t i = 0; i < network_.layers.size(); ++i) {
      const Layer& layer = network_.layers[i];
      if (has_weights(layer.kind)) {
        linear(i);
        continue;
      }
      for (uint32_t c = 0; c < layer.out.channels; ++c) scale(layer.out, c) = scale(layer.in, c % layer.in.channels);
    }
  }

 private:
  double& scale(const Region& region, uint32_t channel) { return scales_[region.buffer][region.offset + channel]; }

  // Linear layers whose channels the network's last layer is or hands on.
  void mark_outputs() {
    const Layer& last = network_.layers.back();
    const Region& out = has_weights(last.kind) ? last.out : last.in;
    for (const Layer& layer : network_.layers)
      outputs_.push_back(has_weights(layer.kind) && layer.out.buffer == out.buffer);
  }

  void linear(size_t index) {
    const Layer& layer = network_.layers[index];
    const LinearRecord record = tables_.linear(layer.parameters);
    const int16_t* weights = tables_.int16_at(record.weights);
    const uint8_t* shifts = tables_.bytes() + record.shifts;
    LinearParameters& p = network_.parameters[layer.parameters];
    std::vector<double> rows(size_t{p.out} * p.in);
    double squares = 0;
    for (uint32_t n = 0; n < p.out; ++n) {
      for (uint32_t k = 0; k < p.in; ++k) {
        double& w = rows[size_t{n} * p.in + k];
        w = std::ldexp(weights[size_t{n} * p.in + k], -shifts[n]) * scale(layer.in, k);
        squares += w * w;
      }
    }
    double step = std::sqrt(squares / static_cast<double>(rows.size()) * p.in / 2);
    if (outputs_[index]) {
      step = network_.task == kTaskBind ? kLogitScale : kOutputScale;
    } else if (layer.flags & kLayerResidual) {
      const int16_t* residual = tables_.int16_at(record.residual);
      step = 0;
      for (uint32_t n = 0; n < p.out; ++n)
        step += std::ldexp(residual[n], -shifts[n]) * scale(layer.residual, n) / p.out;
    }
    if (!(step > 0)) step = 1;  // a layer of zeros
    for (size_t i = 0; i < rows.size(); ++i) p.weights[i] = static_cast<float>(rows[i] / step);
    for (uint32_t n = 0; n < p.out; ++n) {
      const auto bias = static_cast<int64_t>(load_u64(tables_.bytes() + record.bias + size_t{8} * n));
      const int64_t half = int64_t{1} << (shifts[n] - 1);
      p.bias[n] = static_cast<float>(std::ldexp(static_cast<double>(bias - half), -shifts[n]) / step);
      scale(layer.out, n) = step;
    }
  }

  const ModelTables& tables_;
  FloatNetwork& network_;
  std::vector<std::vector<double>> scales_;  // [buffers][channels] steps per unit
  std::vector<bool> outputs_;                // [layers]
};

}  // namespace

FloatNetwork read_model_network(const std::string& path, const FloatNetwork& like) {
  const std::vector<uint8_t> bytes = read_file(path);
  check_opens(bytes, like, path);
  const ModelTables tables(bytes.data());
  FloatNetwork network = like;
  network.buffers.clear();
  network.layers.clear();
  network.parameters.clear();
  for (uint32_t i = 0; i < tables.buffer_count(); ++i) network.buffers.push_back(tables.buffer(i));
  for (uint32_t i = 0; i < tables.layer_count(); ++i) {
    network.layers.push_back(tables.layer(i));
    if (has_weights(network.layers.back().kind)) network.parameters.push_back(block_of(network.layers.back()));
  }
  WeightReader(tables, &network).run();
  return network;
}

void read_model_weights(const std::string& path, FloatNetwork* network) {
  FloatNetwork read = read_model_network(path, *network);
  bool same = read.buffers.size() == network->buffers.size() && read.layers.size() == network->layers.size();
  for (size_t i = 0; same && i < read.layers.size(); ++i) same = same_layer(read.layers[i], network->layers[i]);
  if (!same) {
    throw Error(path +
                ": cannot start from its weights: its layers have other shapes; use the configuration that trained it "
                "(width, rounds)");
  }
  *network = std::move(read);
}

}  // namespace sinew
