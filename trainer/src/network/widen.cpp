// SPDX-License-Identifier: MIT
// Channels of a narrow network in a wide one, followed from layer to layer.
#include <cstddef>
#include <numeric>
#include <vector>

#include "network/networks.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr uint32_t kAdded = UINT32_MAX;

// The narrow buffer's channel of every channel of every wide buffer, or kAdded.
class ChannelMap {
 public:
  explicit ChannelMap(const FloatNetwork& wide) : inputs_(wide.input_names.size()) {
    for (const Buffer& b : wide.buffers) of_.emplace_back(b.channels, kAdded);
    for (size_t i = 0; i < inputs_; ++i) std::iota(of_[i].begin(), of_[i].end(), 0u);
  }
  // The output of a layer with weights: its first channels are the narrow one's. Other layers copy their input.
  void write(const Layer& wide, const Layer& narrow) {
    for (uint32_t c = 0; c < wide.out.channels; ++c) {
      uint32_t at = has_weights(wide.kind) ? (c < narrow.out.channels ? c : kAdded) : within(wide.in, narrow.in, c);
      if (at != kAdded) at += narrow.out.offset;
      of_[wide.out.buffer][wide.out.offset + c] = at;
    }
  }
  // The channel within the narrow region that channel `c` of the wide one is.
  uint32_t within(const Region& wide, const Region& narrow, uint32_t c) const {
    const uint32_t at = of_[wide.buffer][wide.offset + c];
    return at == kAdded ? kAdded : at - narrow.offset;
  }

 private:
  size_t inputs_;
  std::vector<std::vector<uint32_t>> of_;
};

bool fits(const Region& wide, const Region& narrow) {
  return wide.buffer == narrow.buffer && wide.channels >= narrow.channels;
}

// Also of networks that are no list of layers.
bool same_shape(const FloatNetwork& a, const FloatNetwork& b) {
  bool same = a.architecture == b.architecture && a.parameters.size() == b.parameters.size() &&
              a.layers.size() == b.layers.size();
  for (size_t i = 0; same && i < a.parameters.size(); ++i)
    same = a.parameters[i].in == b.parameters[i].in && a.parameters[i].out == b.parameters[i].out;
  return same;
}

void copy_weights(const Layer& layer, const Layer& from, const ChannelMap& map, const LinearParameters& narrow,
                  LinearParameters* wide) {
  for (uint32_t n = 0; n < narrow.out; ++n) {
    wide->bias[n] = narrow.bias[n];
    float* const row = &wide->weights[size_t{n} * wide->in];
    for (uint32_t k = 0; k < wide->in; ++k) {
      const uint32_t at = map.within(layer.in, from.in, k);
      row[k] = at == kAdded ? 0.0f : narrow.weights[size_t{n} * narrow.in + at];
    }
  }
}

}  // namespace

bool is_wider(const FloatNetwork& wide, const FloatNetwork& narrow) {
  if (same_shape(wide, narrow)) return true;
  if (wide.architecture != narrow.architecture || wide.task != narrow.task || wide.feature_set != narrow.feature_set ||
      wide.candidate_count != narrow.candidate_count || wide.input_names != narrow.input_names ||
      wide.buffers.size() != narrow.buffers.size() || wide.layers.size() != narrow.layers.size() || wide.layers.empty())
    return false;
  for (size_t i = 0; i < wide.input_names.size(); ++i) {
    if (wide.buffers[i].channels != narrow.buffers[i].channels) return false;
  }
  for (size_t i = 0; i < wide.layers.size(); ++i) {
    const Layer &w = wide.layers[i], &n = narrow.layers[i];
    if (w.kind != n.kind || w.flags != n.flags || w.parameters != n.parameters || !fits(w.in, n.in) ||
        !fits(w.out, n.out) || !fits(w.residual, n.residual) ||
        (fixes_candidates(w.kind) && w.in.channels != n.in.channels))  // slots side by side
      return false;
  }
  return wide.layers.back().out.channels == narrow.layers.back().out.channels;
}

void widen(const FloatNetwork& narrow, const std::string& source, FloatNetwork* wide) {
  if (!is_wider(*wide, narrow)) {
    throw Error(source +
                ": cannot start from its weights: the configuration has other layers, or fewer channels; use the "
                "configuration that it was trained with, or one that is wider");
  }
  if (same_shape(*wide, narrow)) {
    wide->parameters = narrow.parameters;
    return;
  }
  ChannelMap map(*wide);
  for (size_t i = 0; i < wide->layers.size(); ++i) {
    const Layer &layer = wide->layers[i], &from = narrow.layers[i];
    if (has_weights(layer.kind))
      copy_weights(layer, from, map, narrow.parameters[from.parameters], &wide->parameters[layer.parameters]);
    map.write(layer, from);
  }
}

}  // namespace sinew
