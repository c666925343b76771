// SPDX-License-Identifier: MIT
// Float checkpoint to integer layers: activation scales from calibration, per-channel weight scales and shifts under
// the accumulator proof. Between trainer and model file.
#include "sinew_quant/quantize.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/reader.hpp"
#include "model/regions.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_quant/model_writer.hpp"

namespace sinew {
namespace {

constexpr int32_t kMaxWeight = 32767;
// A channel whose largest weight has fewer bits than this (sign included) in class N moves its layer to class W.
constexpr int kLeastWeightBits = 11;
// Activations that calibration never saw above this get a scale as if they had reached it: 2^14 steps of it are fine
// enough for anything, and a channel that was always 0 needs some scale.
constexpr double kLeastMaximum = 1.0 / 1024;

std::string layer_name(size_t index) { return "quantize: layer " + std::to_string(index); }

// One output channel in units of out-steps: y_int = sum_k a_int[k] * weights[k] + r_int * residual + bias.
struct RealChannel {
  std::vector<double> weights;
  double residual = 0, bias = 0;
};
struct IntegerChannel {
  std::vector<int16_t> weights;
  int16_t residual = 0;
  int64_t bias = 0;
  uint8_t shift = 0;
  int64_t bound = 0;  // proven largest |accumulator|
  int largest = 0;    // largest |weight|, residual factor included
};

// Everything the proof of one layer's channels needs.
struct LayerRanges {
  std::vector<ValueRange> columns;  // [in]
  ValueRange residual = ValueRange::kPositive;
  uint32_t block = 0;
};

// The channel at one shift, or nothing when a weight or a sum does not fit.
std::optional<IntegerChannel> try_shift(const RealChannel& real, const LayerRanges& ranges, bool wide, int shift) {
  const double factor = std::ldexp(1.0, shift);
  IntegerChannel channel;
  channel.shift = static_cast<uint8_t>(shift);
  const auto rounded = [&](double weight) -> std::optional<int16_t> {
    const double value = std::floor(weight * factor + 0.5);
    if (!(std::abs(value) <= kMaxWeight)) return std::nullopt;
    channel.largest = std::max(channel.largest, static_cast<int>(std::abs(value)));
    return static_cast<int16_t>(value);
  };
  const double bias = std::floor(real.bias * factor + 0.5);
  if (!(std::abs(bias) < static_cast<double>(wide ? kWideLimit / 2 : kNarrowLimit))) return std::nullopt;
  channel.bias = static_cast<int64_t>(bias) + (int64_t{1} << (shift - 1));

  SumBound total, block;
  for (size_t k = 0; k < real.weights.size(); ++k) {
    const std::optional<int16_t> weight = rounded(real.weights[k]);
    if (!weight) return std::nullopt;
    channel.weights.push_back(*weight);
    block.add(*weight, ranges.columns[k]);
    if ((k + 1) % ranges.block == 0 || k + 1 == real.weights.size()) {
      if (wide && !block.below(kNarrowLimit)) return std::nullopt;
      total.add(block);
      block = SumBound();
    }
  }
  const std::optional<int16_t> residual = rounded(real.residual);
  if (!residual) return std::nullopt;
  channel.residual = *residual;
  total.add(*residual, ranges.residual);
  total.low += channel.bias;
  total.high += channel.bias;
  if (!total.below(wide ? kWideLimit : kNarrowLimit)) return std::nullopt;
  channel.bound = total.largest();
  return channel;
}

// The largest legal shift, that is the finest weights.
std::optional<IntegerChannel> best_shift(const RealChannel& real, const LayerRanges& ranges, bool wide) {
  for (int shift = static_cast<int>(wide ? kMaxShiftWide : kMaxShiftNarrow); shift >= 1; --shift) {
    if (std::optional<IntegerChannel> channel = try_shift(real, ranges, wide, shift)) return channel;
  }
  return std::nullopt;
}

// Rounds weights to `bits` bits of the channel's largest one.
void coarsen(std::vector<double>* weights, int bits) {
  double largest = 0;
  for (double w : *weights) largest = std::max(largest, std::abs(w));
  const double step = largest / (std::ldexp(1.0, bits - 1) - 1);
  if (bits >= 16 || step == 0) return;
  for (double& w : *weights) w = std::floor(w / step + 0.5) * step;
}

class ModelQuantizer {
 public:
  ModelQuantizer(const FloatNetwork& network, const Calibration& calibration, const QuantizeOptions& options)
      : network_(network), calibration_(calibration), options_(options) {
    check_arguments();
    inputs_ = static_cast<uint32_t>(network.input_names.size());
    for (const Buffer& buffer : network.buffers)
      scales_.emplace_back(buffer.channels, scales_.size() < inputs_ ? kFeatureScale : 0.0);
    ranges_.resize(network.layers.size(), ValueRange::kSigned);
    mark_output_layers();
  }

  QuantizedModel run() {
    IntegerModel model;
    model.task = network_.task;
    if (network_.task != kTaskBind) {  // bind's files stay as the first ones were
      const ModelTask task = model_task(network_);
      for (uint32_t i = 0; i < task.input_count; ++i) model.input_names.push_back(task.inputs[i].name);
    }
    model.candidate_count = network_.candidate_count;
    model.grid_size = network_.grid_size;
    model.feature_set = network_.feature_set;
    model.buffers = network_.buffers;
    model.layers = network_.layers;
    QuantizedModel result;
    for (size_t i = 0; i < network_.layers.size(); ++i) {
      Layer& layer = model.layers[i];
      if (!(layer.flags & kLayerResidual)) layer.residual = Region();
      if (has_weights(layer.kind)) {
        layer.parameters = static_cast<uint32_t>(model.linears.size());
        model.linears.push_back(linear(i, &result.layers));
      } else {
        layer.parameters = 0;
        hand_on_scales(i);
      }
    }
    result.bytes = write_model(model);
    return result;
  }

 private:
  void check_arguments() const {
    check_network(network_, "quantize");
    if (calibration_.layer_max.size() != network_.layers.size()) {
      throw Error("quantize: calibration has " + std::to_string(calibration_.layer_max.size()) +
                  " layers, the network " + std::to_string(network_.layers.size()));
    }
    if (!(options_.margin >= 1) || options_.weight_bits < 4 || options_.weight_bits > 16 ||
        options_.activation_bits < 4 || options_.activation_bits > 14) {
      throw Error("quantize: margin must be >= 1, weight_bits 4..16, activation_bits 4..14");
    }
    const auto finite = [](float v) { return std::isfinite(v); };
    for (size_t i = 0; i < network_.layers.size(); ++i) {
      const Layer& layer = network_.layers[i];
      if (!has_weights(layer.kind)) continue;
      const LinearParameters& p = network_.parameters[layer.parameters];
      if (!std::all_of(p.weights.begin(), p.weights.end(), finite) ||
          !std::all_of(p.bias.begin(), p.bias.end(), finite) || !finite(calibration_.layer_max[i])) {
        throw Error(layer_name(i) + ": a weight, bias or calibrated maximum is not finite");
      }
    }
  }

  // Layers with weights that write the network's output: the last one, or those whose values the last one hands on.
  void mark_output_layers() {
    outputs_.assign(network_.layers.size(), false);
    const size_t last = network_.layers.size() - 1;
    const Layer& output = network_.layers[last];
    if (has_weights(output.kind)) {
      outputs_[last] = true;
      return;
    }
    if (!traits_of(output.kind).ends_network)
      throw Error(layer_name(last) + ": the last layer of a network cannot be of kind " + traits_of(output.kind).name);
    for (uint32_t channel = output.in.offset; channel < region_end(output.in);) {
      const Segment segment =
          segment_at(network_.layers.data(), inputs_, static_cast<uint32_t>(last), output.in, channel);
      if (segment.producer < 0 || !has_weights(network_.layers[segment.producer].kind)) {
        throw Error(layer_name(last) + ": the output must come straight from a linear layer");
      }
      outputs_[segment.producer] = true;
      channel += segment.count;
    }
  }

  // Layers without weights keep values, so scales go through channel by channel.
  void hand_on_scales(size_t index) {
    const Layer& layer = network_.layers[index];
    ranges_[index] =
        region_range(network_.layers.data(), inputs_, static_cast<uint32_t>(index), ranges_.data(), layer.in);
    const std::vector<double>& in = scales_[layer.in.buffer];
    for (uint32_t c = 0; c < layer.out.channels; ++c) {
      if (traits_of(layer.kind).shape == LayerShape::kSplitSlots) {
        for (uint32_t slot = 1; slot < network_.candidate_count; ++slot) {
          if (in[layer.in.offset + slot * layer.out.channels + c] != in[layer.in.offset + c]) {
            throw Error(layer_name(index) + ": slots of different scales cannot share a channel");
          }
        }
      }
      // Pair-to-vertex repeats its channels once per slot; elsewhere c is always below in.channels.
      scales_[layer.out.buffer][layer.out.offset + c] = in[layer.in.offset + c % layer.in.channels];
    }
  }

  double output_scale(size_t index) const {
    if (outputs_[index]) return network_.task == kTaskBind ? kLogitScale : kOutputScale;
    const double largest = std::max<double>(std::abs(calibration_.layer_max[index]), kLeastMaximum);
    return (std::ldexp(1.0, options_.activation_bits) - 1) / (largest * options_.margin);
  }

  ValueRange segment_range(const Segment& segment) const {
    return segment.producer >= 0 ? ranges_[segment.producer] : ValueRange::kSigned;
  }

  LayerRanges input_ranges(size_t index) const {
    const Layer& layer = network_.layers[index];
    LayerRanges ranges;
    for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
      const Segment segment =
          segment_at(network_.layers.data(), inputs_, static_cast<uint32_t>(index), layer.in, channel);
      ranges.columns.insert(ranges.columns.end(), segment.count, segment_range(segment));
      channel += segment.count;
    }
    if (layer.flags & kLayerResidual) {
      ranges.residual =
          region_range(network_.layers.data(), inputs_, static_cast<uint32_t>(index), ranges_.data(), layer.residual);
    }
    return ranges;
  }

  std::vector<RealChannel> real_channels(size_t index, double out_scale) const {
    const Layer& layer = network_.layers[index];
    const LinearParameters& p = network_.parameters[layer.parameters];
    std::vector<RealChannel> channels(p.out);
    for (uint32_t n = 0; n < p.out; ++n) {
      RealChannel& channel = channels[n];
      for (uint32_t k = 0; k < p.in; ++k) {
        const double in_scale = scales_[layer.in.buffer][layer.in.offset + k];
        if (in_scale == 0) throw Error(layer_name(index) + ": reads a channel that no layer has written");
        channel.weights.push_back(p.weights[size_t{n} * p.in + k] * out_scale / in_scale);
      }
      coarsen(&channel.weights, options_.weight_bits);
      channel.bias = p.bias[n] * out_scale;
      if (layer.flags & kLayerResidual) {
        const double in_scale = scales_[layer.residual.buffer][layer.residual.offset + n];
        if (in_scale == 0) throw Error(layer_name(index) + ": its residual is a channel that no layer has written");
        channel.residual = out_scale / in_scale;
      }
    }
    return channels;
  }

  // All channels in one class, or nothing when one does not fit.
  static std::optional<std::vector<IntegerChannel>> fit(const std::vector<RealChannel>& real, const LayerRanges& ranges,
                                                        bool wide) {
    std::vector<IntegerChannel> channels;
    for (const RealChannel& channel : real) {
      std::optional<IntegerChannel> fitted = best_shift(channel, ranges, wide);
      if (!fitted) return std::nullopt;
      channels.push_back(std::move(*fitted));
    }
    return channels;
  }

  // True when class N costs no weight bits that matter: every channel's largest weight has enough of them, or no more
  // even with int64 sums (then it is the channel's bias or its zeros that limit it, not the accumulator).
  static bool enough_bits(const std::vector<IntegerChannel>& narrow, const std::vector<RealChannel>& real,
                          const LayerRanges& ranges) {
    for (size_t n = 0; n < narrow.size(); ++n) {
      if (narrow[n].largest >= 1 << (kLeastWeightBits - 2)) continue;
      const std::optional<IntegerChannel> wide = best_shift(real[n], ranges, true);
      if (wide && wide->largest > 2 * narrow[n].largest && wide->largest > 1) return false;
    }
    return true;
  }

  IntegerLinear linear(size_t index, std::vector<QuantizeLayerReport>* report) {
    const Layer& layer = network_.layers[index];
    const bool relu = (layer.flags & kLayerRelu) != 0;
    if (outputs_[index] && relu)
      throw Error(layer_name(index) + ": the layer that writes the output must not have a ReLU");
    const double out_scale = output_scale(index);
    ranges_[index] = outputs_[index] ? ValueRange::kLogits : relu ? ValueRange::kPositive : ValueRange::kSigned;
    std::fill_n(scales_[layer.out.buffer].begin() + layer.out.offset, layer.out.channels, out_scale);

    const std::vector<RealChannel> real = real_channels(index, out_scale);
    LayerRanges ranges = input_ranges(index);
    ranges.block = layer.in.channels;
    bool wide = false;
    std::optional<std::vector<IntegerChannel>> channels = fit(real, ranges, false);
    if (!channels || !enough_bits(*channels, real, blocks_of_two(ranges))) {
      wide = true;
      // The longest block that costs no bits against blocks of two, which always fit: 2 * 32767 * 32767 < 2^31.
      channels = fit(real, blocks_of_two(ranges), true);
      if (!channels) {
        throw Error(layer_name(index) +
                    ": weights or biases are too large for int16 at any shift; train with weight decay");
      }
      ranges.block = longest_block(*channels, real, ranges);
      channels = fit(real, ranges, true);
    }
    return assemble(layer, ranges_[index], wide, static_cast<uint16_t>(ranges.block), *channels, report);
  }

  static LayerRanges blocks_of_two(LayerRanges ranges) {
    ranges.block = std::min<uint32_t>(2, static_cast<uint32_t>(ranges.columns.size()));
    return ranges;
  }

  static uint32_t longest_block(const std::vector<IntegerChannel>& best, const std::vector<RealChannel>& real,
                                LayerRanges ranges) {
    const uint32_t shortest = blocks_of_two(ranges).block;
    for (; ranges.block > shortest; ranges.block = std::max(shortest, ranges.block / 2)) {
      bool same = true;
      for (size_t n = 0; n < best.size() && same; ++n)
        same = try_shift(real[n], ranges, true, best[n].shift).has_value();
      if (same) break;
    }
    return ranges.block;
  }

  static IntegerLinear assemble(const Layer& layer, ValueRange range, bool wide, uint16_t block,
                                const std::vector<IntegerChannel>& channels, std::vector<QuantizeLayerReport>* report) {
    IntegerLinear linear;
    linear.in = layer.in.channels;
    linear.out = layer.out.channels;
    linear.accumulator = wide ? AccumulatorClass::kWide : AccumulatorClass::kNarrow;
    linear.range = range;
    linear.block = block;
    QuantizeLayerReport line;
    line.what = "linear " + std::to_string(linear.in) + " -> " + std::to_string(linear.out);
    line.wide = wide;
    line.min_shift = 255;
    for (const IntegerChannel& channel : channels) {
      linear.bias.push_back(channel.bias);
      linear.weights.insert(linear.weights.end(), channel.weights.begin(), channel.weights.end());
      linear.shifts.push_back(channel.shift);
      if (layer.flags & kLayerResidual) linear.residual.push_back(channel.residual);
      line.bound = std::max(line.bound, channel.bound);
      line.min_shift = std::min<int>(line.min_shift, channel.shift);
      line.max_shift = std::max<int>(line.max_shift, channel.shift);
    }
    report->push_back(line);
    return linear;
  }

  const FloatNetwork& network_;
  const Calibration& calibration_;
  const QuantizeOptions& options_;
  uint32_t inputs_ = 0;                      // buffers [0, inputs_)
  std::vector<std::vector<double>> scales_;  // [buffers][channels] integer steps per real unit; 0 = not written yet
  std::vector<ValueRange> ranges_;           // [layers]
  std::vector<bool> outputs_;                // [layers]
};

[[noreturn]] void refuse(sinew_status status) {
  throw Error("quantize: the engine refuses the model (" + std::string(sinew_status_text(status)) +
              "); check that the checkpoint has this version's feature set and layer rules");
}

// The engine wants 8-byte aligned bytes; a vector's are, as operator new aligns for every fundamental type.
sinew_model open_bind_model(const std::vector<uint8_t>& bytes) {
  sinew_model model;
  const sinew_status status = sinew_model_open(bytes.data(), bytes.size(), &model);
  if (status != SINEW_OK) refuse(status);
  return model;
}

void reopen(const FloatNetwork& network, const std::vector<uint8_t>& bytes) {
  if (network.task == kTaskBind) {
    (void)open_bind_model(bytes);
    return;
  }
  ModelHeader header;
  sinew_model model;
  sinew_status status = read_header(bytes.data(), bytes.size(), &header);
  if (status == SINEW_OK) status = open_model(bytes.data(), bytes.size(), model_task(network), &model);
  if (status != SINEW_OK) refuse(status);
}

}  // namespace

QuantizedModel quantize(const FloatNetwork& network, const Calibration& calibration, const QuantizeOptions& options) {
  QuantizedModel result = ModelQuantizer(network, calibration, options).run();
  reopen(network, result.bytes);
  return result;
}

std::vector<uint8_t> with_confidence(const std::vector<uint8_t>& model, const std::vector<ConfidenceEntry>& entries) {
  const sinew_model opened = open_bind_model(model);
  const size_t end = opened.confidence_count > 0 ? opened.confidence_offset - kConfidenceHeader : model.size();
  std::vector<uint8_t> bytes = write_confidence(model, end, entries);
  sinew_model checked;
  if (sinew_model_open(bytes.data(), bytes.size(), &checked) != SINEW_OK) {
    throw Error(
        "confidence: the engine refuses the table; expected 2 to 64 entries with ascending shares and hits that do not "
        "decrease, found " +
        std::to_string(entries.size()));
  }
  return bytes;
}

}  // namespace sinew
