// SPDX-License-Identifier: MIT
// Random graphs, random networks and a plain interpreter of layer lists: what executor and quantizer are compared with.
// The interpreter keeps every buffer whole and follows engine/src/model/layers.hpp word by word; it shares no code with
// the engine. It runs in double (a float network) and in int64 (a model file).
#ifndef SINEW_TESTS_NETWORK_FIXTURE_HPP
#define SINEW_TESTS_NETWORK_FIXTURE_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "aligned_bytes.hpp"
#include "features/features.hpp"
#include "linear_layer.hpp"
#include "network/network.hpp"
#include "random.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_quant/model_writer.hpp"

namespace sinew::test {

struct Graph {
  uint32_t vertices = 0, k = 0, joint_count = 0, part_count = 0;
  std::vector<int16_t> vertex_features, pair_features;
  std::vector<uint16_t> joints;
  std::vector<uint32_t> row_offsets, col_indices, part, part_offsets, part_vertices;

  NetworkInput input() const {
    NetworkInput in;
    in.vertex_count = vertices;
    in.candidate_count = k;
    in.inputs[kVertexInput] = vertex_features.data();
    in.inputs[kPairInput] = pair_features.data();
    in.joints = joints.data();
    in.row_offsets = row_offsets.data();
    in.col_indices = col_indices.data();
    in.part = part.data();
    in.part_offsets = part_offsets.data();
    in.part_vertices = part_vertices.data();
    in.part_count = part_count;
    in.joint_count = joint_count;
    return in;
  }
  bool present(size_t pair) const { return joints[pair] != kNoJoint; }
};

// `features(random)` gives one Q13 value.
template <class Features>
Graph random_graph(uint32_t seed, uint32_t vertices, uint32_t k, uint32_t joint_count, uint32_t part_count,
                   Features features) {
  Random random(seed);
  Graph g;
  g.vertices = vertices;
  g.k = k;
  g.joint_count = joint_count;
  g.part_count = std::min(part_count, vertices);
  std::vector<std::vector<uint32_t>> members(g.part_count);
  for (uint32_t v = 0; v < vertices; ++v) {
    g.part.push_back(v < g.part_count ? v : random.below(g.part_count));
    members[g.part[v]].push_back(v);
  }
  g.part_offsets.push_back(0);
  for (const auto& list : members) {
    g.part_vertices.insert(g.part_vertices.end(), list.begin(), list.end());
    g.part_offsets.push_back(static_cast<uint32_t>(g.part_vertices.size()));
  }
  std::vector<std::set<uint32_t>> ring(vertices);
  for (uint32_t v = 0; v < vertices; ++v) {
    for (uint32_t i = random.below(5); i > 0; --i) {
      const auto& list = members[g.part[v]];
      const uint32_t u = list[random.below(static_cast<uint32_t>(list.size()))];
      if (u == v) continue;
      ring[v].insert(u);
      ring[u].insert(v);
    }
  }
  g.row_offsets.push_back(0);
  for (const auto& row : ring) {
    g.col_indices.insert(g.col_indices.end(), row.begin(), row.end());
    g.row_offsets.push_back(static_cast<uint32_t>(g.col_indices.size()));
  }
  g.joints.assign(size_t{vertices} * k, kNoJoint);
  g.vertex_features.resize(size_t{vertices} * kVertexFeatures);
  g.pair_features.assign(size_t{vertices} * k * kPairFeatures, 0);
  for (int16_t& value : g.vertex_features) value = features(random);
  for (uint32_t v = 0; v < vertices; ++v) {
    const uint32_t used = 1 + random.below(std::min(k, joint_count));
    std::set<uint16_t> taken;
    while (taken.size() < used) {
      const uint16_t joint = static_cast<uint16_t>(random.below(joint_count));
      const size_t pair = size_t{v} * k + taken.size();
      if (!taken.insert(joint).second) continue;
      g.joints[pair] = joint;
      for (uint32_t c = 0; c < kPairFeatures; ++c) g.pair_features[pair * kPairFeatures + c] = features(random);
    }
  }
  return g;
}
inline int16_t any_feature(Random& random) { return static_cast<int16_t>(random.between(-16384, 16383)); }
inline int16_t usual_feature(Random& random) {
  return static_cast<int16_t>(std::clamp(random.normal() * 4096, -16384.0, 16383.0));
}

template <class Value>
using Buffers = std::vector<std::vector<Value>>;

template <class Value>
Buffers<Value> make_buffers(const std::vector<Buffer>& shapes, const Graph& g, double scale) {
  Buffers<Value> buffers;
  for (const Buffer& b : shapes) {
    buffers.emplace_back(size_t{g.vertices} * (b.domain == Domain::kPair ? g.k : 1) * b.channels, Value(0));
  }
  for (size_t i = 0; i < buffers[0].size(); ++i) buffers[0][i] = static_cast<Value>(g.vertex_features[i] * scale);
  for (size_t i = 0; i < buffers[1].size(); ++i) buffers[1][i] = static_cast<Value>(g.pair_features[i] * scale);
  return buffers;
}

// Runs one layer. linear(layer, in_row, residual_row or null, out_row); mean(sum, n).
template <class Value, class Linear, class Mean>
void interpret_layer(const Layer& layer, const std::vector<Buffer>& shapes, const Graph& g, Buffers<Value>* buffers,
                     Linear linear, Mean mean) {
  const bool pair_in = shapes[layer.in.buffer].domain == Domain::kPair;
  const bool pair_out = shapes[layer.out.buffer].domain == Domain::kPair;
  const uint32_t k = g.k;
  const size_t rows_in = size_t{g.vertices} * (pair_in ? k : 1), rows_out = size_t{g.vertices} * (pair_out ? k : 1);
  const auto in = [&](size_t row) {
    return (*buffers)[layer.in.buffer].data() + row * shapes[layer.in.buffer].channels + layer.in.offset;
  };
  const auto out = [&](size_t row) {
    return (*buffers)[layer.out.buffer].data() + row * shapes[layer.out.buffer].channels + layer.out.offset;
  };
  // Reduces the present rows that `wanted` accepts into one row. Divides by `divisor`, or by how many there were when
  // it is 0.
  const auto reduce = [&](bool is_mean, uint32_t divisor, Value* to, auto wanted) {
    std::vector<size_t> rows;
    for (size_t row = 0; row < rows_in; ++row) {
      if ((!pair_in || g.present(row)) && wanted(row)) rows.push_back(row);
    }
    for (uint32_t c = 0; c < layer.out.channels; ++c) {
      Value sum = 0, largest = rows.empty() ? Value(0) : in(rows[0])[c];
      for (const size_t row : rows) {
        sum += in(row)[c];
        largest = std::max(largest, in(row)[c]);
      }
      const uint32_t n = divisor == 0 ? static_cast<uint32_t>(rows.size()) : divisor;
      to[c] = rows.empty() ? Value(0) : is_mean ? mean(sum, n) : largest;
    }
  };
  for (size_t row = 0; row < rows_out; ++row) {
    if (pair_out && !g.present(row)) continue;
    const uint32_t v = static_cast<uint32_t>(pair_out ? row / k : row);
    const auto same_joint = [&](size_t other) { return !pair_in || g.joints[other] == g.joints[row]; };
    const auto vertex_of = [&](size_t other) { return static_cast<uint32_t>(pair_in ? other / k : other); };
    const auto is_neighbor = [&](uint32_t u) {
      return std::binary_search(g.col_indices.begin() + g.row_offsets[v], g.col_indices.begin() + g.row_offsets[v + 1],
                                u);
    };
    switch (layer.kind) {
      case LayerKind::kLinear: {
        const Value* residual = (layer.flags & kLayerResidual)
                                    ? (*buffers)[layer.residual.buffer].data() +
                                          row * shapes[layer.residual.buffer].channels + layer.residual.offset
                                    : nullptr;
        linear(layer, in(row), residual, out(row));
        break;
      }
      case LayerKind::kRingMean:
      case LayerKind::kRingMax:
        reduce(layer.kind == LayerKind::kRingMean, 0, out(row),
               [&](size_t o) { return same_joint(o) && is_neighbor(vertex_of(o)); });
        break;
      case LayerKind::kPartMean: {
        const uint32_t part = g.part[v], size = g.part_offsets[part + 1] - g.part_offsets[part];
        reduce(true, size, out(row), [&](size_t o) { return g.part[vertex_of(o)] == part && same_joint(o); });
        break;
      }
      case LayerKind::kGlobalMean:
      case LayerKind::kGlobalMax: {
        // Every row gets the same: computed once, at the first present row, then copied from it.
        size_t first = 0;
        while (pair_out && !g.present(first)) ++first;
        if (row == first) {
          reduce(layer.kind == LayerKind::kGlobalMean, 0, out(row), [](size_t) { return true; });
        } else {
          std::copy_n(out(first), layer.out.channels, out(row));
        }
        break;
      }
      case LayerKind::kCandidateMax:
        for (uint32_t c = 0; c < layer.out.channels; ++c) {
          Value best = in(row)[c];
          for (uint32_t slot = 0; slot < k; ++slot) {
            if (g.present(size_t{v} * k + slot)) best = std::max(best, in(size_t{v} * k + slot)[c]);
          }
          out(row)[c] = best;
        }
        break;
      case LayerKind::kVertexToPair:
        std::copy_n(in(v), layer.out.channels, out(row));
        break;
      case LayerKind::kPairToVertex:
        for (uint32_t slot = 0; slot < k; ++slot) {
          std::copy_n(in(size_t{v} * k + slot), layer.in.channels, out(row) + slot * layer.in.channels);
        }
        break;
      case LayerKind::kVertexToSlots:
        std::copy_n(in(v) + (row % k) * layer.out.channels, layer.out.channels, out(row));
        break;
      case LayerKind::kCopy:
        std::copy_n(in(row), layer.out.channels, out(row));
        break;
    }
  }
}

struct FloatRun {
  std::vector<double> logits;    // [U x K]
  std::vector<float> layer_max;  // [layers] calibration
};
inline FloatRun run_float(const FloatNetwork& network, const Graph& g) {
  Buffers<double> buffers = make_buffers<double>(network.buffers, g, 1.0 / 8192);
  FloatRun run;
  const auto linear = [&](const Layer& layer, const double* in, const double* residual, double* out) {
    const LinearParameters& p = network.parameters[layer.parameters];
    for (uint32_t n = 0; n < p.out; ++n) {
      double sum = p.bias[n] + (residual ? residual[n] : 0.0);
      for (uint32_t c = 0; c < p.in; ++c) sum += in[c] * p.weights[size_t{n} * p.in + c];
      out[n] = (layer.flags & kLayerRelu) ? std::max(sum, 0.0) : sum;
    }
  };
  for (const Layer& layer : network.layers) {
    interpret_layer(layer, network.buffers, g, &buffers, linear, [](double sum, uint32_t n) { return sum / n; });
    const std::vector<double>& out = buffers[layer.out.buffer];
    const size_t width = network.buffers[layer.out.buffer].channels;
    double largest = 0;
    for (size_t i = 0; i < out.size(); ++i) {
      const size_t c = i % width;
      if (c >= layer.out.offset && c < size_t{layer.out.offset} + layer.out.channels)
        largest = std::max(largest, std::abs(out[i]));
    }
    run.layer_max.push_back(static_cast<float>(largest));
  }
  const Layer& last = network.layers.back();
  for (size_t i = 0; i < size_t{g.vertices} * g.k; ++i) {
    run.logits.push_back(buffers[last.out.buffer][i * network.buffers[last.out.buffer].channels + last.out.offset]);
  }
  return run;
}

inline std::vector<int16_t> run_integer(const IntegerModel& model, const Graph& g) {
  Buffers<int64_t> buffers = make_buffers<int64_t>(model.buffers, g, 1.0);
  const auto linear = [&](const Layer& layer, const int64_t* in, const int64_t* residual, int64_t* out) {
    const IntegerLinear& p = model.linears[layer.parameters];
    const int64_t low = p.range == ValueRange::kPositive ? 0 : p.range == ValueRange::kSigned ? -16384 : -32767;
    const int64_t high = p.range == ValueRange::kLogits ? 32767 : 16383;
    for (uint32_t n = 0; n < p.out; ++n) {
      int64_t sum = p.bias[n] + (residual ? residual[n] * p.residual[n] : 0);
      for (uint32_t c = 0; c < p.in; ++c) sum += in[c] * p.weights[size_t{n} * p.in + c];
      out[n] = std::clamp(floor_divide(sum, int64_t{1} << p.shifts[n]), low, high);
    }
  };
  for (const Layer& layer : model.layers) {
    interpret_layer(layer, model.buffers, g, &buffers, linear,
                    [](int64_t sum, uint32_t n) { return floor_divide(2 * sum + n, 2 * int64_t{n}); });
  }
  const Layer& last = model.layers.back();
  std::vector<int16_t> logits;
  for (size_t i = 0; i < size_t{g.vertices} * g.k; ++i) {
    logits.push_back(
        static_cast<int16_t>(buffers[last.out.buffer][i * model.buffers[last.out.buffer].channels + last.out.offset]));
  }
  return logits;
}

// Back from bytes, so that a quantized network can be interpreted.
inline IntegerModel parse_model(const std::vector<uint8_t>& bytes) {
  const ModelTables tables(bytes.data());
  IntegerModel model;
  model.candidate_count = load_u32(bytes.data() + kHeaderCandidates);
  model.grid_size = load_u32(bytes.data() + kHeaderGrid);
  model.feature_set = load_u32(bytes.data() + kHeaderFeatureSet);
  for (uint32_t i = 0; i < tables.buffer_count(); ++i) model.buffers.push_back(tables.buffer(i));
  for (uint32_t i = 0; i < tables.layer_count(); ++i) model.layers.push_back(tables.layer(i));
  for (uint32_t i = 0; i < tables.linear_count(); ++i) {
    const LinearRecord r = tables.linear(i);
    IntegerLinear linear;
    linear.in = r.in;
    linear.out = r.out;
    linear.accumulator = r.accumulator;
    linear.range = r.range;
    linear.block = r.block;
    for (uint32_t n = 0; n < r.out; ++n) {
      linear.bias.push_back(load_i64(bytes.data() + r.bias + 8 * n));
      linear.shifts.push_back(bytes[r.shifts + n]);
      if (r.residual != 0) linear.residual.push_back(static_cast<int16_t>(load_u16(bytes.data() + r.residual + 2 * n)));
    }
    for (uint32_t n = 0; n < uint32_t{r.in} * r.out; ++n) {
      linear.weights.push_back(static_cast<int16_t>(load_u16(bytes.data() + r.weights + 2 * n)));
    }
    model.linears.push_back(linear);
  }
  return model;
}

// Float networks layer by layer, weights drawn like a trained network's start (He).
class NetworkBuilder {
 public:
  NetworkBuilder(uint32_t seed, uint32_t k) : random_(seed) {
    network_.architecture = "test";
    network_.feature_set = kFeatureSet;
    network_.candidate_count = k;
    add(Domain::kVertex, kVertexFeatures);
    add(Domain::kPair, kPairFeatures);
  }
  uint16_t add(Domain domain, uint32_t channels) {
    network_.buffers.resize(network_.buffers.size() + 1);
    network_.buffers.back().domain = domain;
    network_.buffers.back().channels = static_cast<uint16_t>(channels);
    return static_cast<uint16_t>(network_.buffers.size() - 1);
  }
  static Region region(uint16_t buffer, uint32_t offset, uint32_t channels) {
    return {buffer, static_cast<uint16_t>(offset), static_cast<uint16_t>(channels)};
  }
  Region whole(uint16_t buffer) const { return region(buffer, 0, network_.buffers[buffer].channels); }
  void layer(LayerKind kind, Region in, Region out) {
    Layer l;
    l.kind = kind;
    l.in = in;
    l.out = out;
    network_.layers.push_back(l);
  }
  void linear(Region in, Region out, bool relu, const Region* residual = nullptr) {
    layer(LayerKind::kLinear, in, out);
    Layer& l = network_.layers.back();
    l.flags = static_cast<uint8_t>((relu ? kLayerRelu : 0) | (residual ? kLayerResidual : 0));
    if (residual) l.residual = *residual;
    l.parameters = static_cast<uint32_t>(network_.parameters.size());
    LinearParameters p;
    p.in = in.channels;
    p.out = out.channels;
    const double size = std::sqrt((residual ? 0.3 : 1.0) * 2.0 / p.in);
    for (uint32_t i = 0; i < p.in * p.out; ++i) p.weights.push_back(static_cast<float>(random_.normal() * size));
    for (uint32_t i = 0; i < p.out; ++i) p.bias.push_back(static_cast<float>(random_.normal() * 0.1));
    network_.parameters.push_back(p);
  }
  FloatNetwork take() { return network_; }

 private:
  Random random_;
  FloatNetwork network_;
};

// The shape of the default network: vertex embedding, pair state, rounds of message passing, logit beside the features.
inline FloatNetwork field_like(uint32_t seed, uint32_t k, uint32_t width, uint32_t rounds) {
  NetworkBuilder b(seed, k);
  const uint32_t embed = width / 2;
  const uint16_t vertex = b.add(Domain::kVertex, embed);
  b.linear(b.whole(kVertexInput), b.whole(vertex), true);
  const uint16_t start = b.add(Domain::kPair, kPairFeatures + embed);
  b.layer(LayerKind::kCopy, b.whole(kPairInput), b.region(start, 0, kPairFeatures));
  b.layer(LayerKind::kVertexToPair, b.whole(vertex), b.region(start, kPairFeatures, embed));
  uint16_t before = start;
  for (uint32_t r = 0; r <= rounds; ++r) {
    const bool last = r == rounds;
    const uint16_t state = b.add(Domain::kPair, last ? width + kPairFeatures : 6 * width);
    const Region self = b.region(state, 0, width);
    if (r == 0) {
      b.linear(b.whole(before), self, true);
    } else {
      const Region residual = b.region(before, 0, width);
      b.linear(b.whole(before), self, true, &residual);
    }
    if (last) {
      b.layer(LayerKind::kCopy, b.whole(kPairInput), b.region(state, width, kPairFeatures));
    } else {
      b.layer(LayerKind::kRingMean, self, b.region(state, width, width));
      b.layer(LayerKind::kCandidateMax, self, b.region(state, 2 * width, width));
      b.layer(LayerKind::kPartMean, self, b.region(state, 3 * width, width));
      b.layer(LayerKind::kCandidateMax, b.region(state, 3 * width, width), b.region(state, 4 * width, width));
      b.layer(LayerKind::kGlobalMean, self, b.region(state, 5 * width, width));
    }
    before = state;
  }
  const uint16_t logits = b.add(Domain::kPair, 1);
  b.linear(b.whole(before), b.whole(logits), false);
  return b.take();
}

// The shape of the patent's network: vertex branches, ring pooling, a global feature, slots of logits.
inline FloatNetwork classic_like(uint32_t seed, uint32_t k, uint32_t width) {
  NetworkBuilder b(seed, k);
  const uint32_t features = kVertexFeatures + k;
  const uint16_t start = b.add(Domain::kVertex, features), joined = b.add(Domain::kVertex, 3 * width);
  b.layer(LayerKind::kCopy, b.whole(kVertexInput), b.region(start, 0, kVertexFeatures));
  b.layer(LayerKind::kPairToVertex, b.region(kPairInput, 3, 1), b.region(start, kVertexFeatures, k));
  const Region first = b.region(joined, 0, width), sub = b.region(joined, width, width),
               pooled = b.region(joined, 2 * width, width);
  b.linear(b.whole(start), first, true);
  const uint16_t ring = b.add(Domain::kVertex, width);
  b.layer(LayerKind::kRingMean, first, b.whole(ring));
  b.linear(b.whole(ring), sub, false);
  b.layer(LayerKind::kRingMax, sub, pooled);
  const uint16_t second = b.add(Domain::kVertex, width), tail = b.add(Domain::kVertex, 3 * width);
  b.linear(b.whole(joined), b.whole(second), true);
  b.layer(LayerKind::kGlobalMax, b.whole(second), b.region(tail, 0, width));
  b.layer(LayerKind::kPartMean, b.whole(joined).channels > width ? b.region(joined, 0, width) : first,
          b.region(tail, width, width));
  const uint16_t local = b.add(Domain::kVertex, width);
  b.layer(LayerKind::kRingMean, b.whole(second), b.whole(local));
  b.linear(b.whole(local), b.region(tail, 2 * width, width), true);
  const uint16_t target = b.add(Domain::kVertex, k), logits = b.add(Domain::kPair, 1);
  b.linear(b.whole(tail), b.whole(target), false);
  b.layer(LayerKind::kVertexToSlots, b.whole(target), b.whole(logits));
  return b.take();
}

// A random legal list over a few wide buffers: regions of several writers, every kind, random integers in both classes.
inline IntegerModel random_model(uint32_t seed, uint32_t k, uint32_t vertex_channels = kVertexFeatures) {
  Random random(seed);
  IntegerModel model;
  model.candidate_count = k;
  model.feature_set = kFeatureSet;
  model.buffers = {{Domain::kVertex, static_cast<uint16_t>(vertex_channels)},
                   {Domain::kPair, static_cast<uint16_t>(kPairFeatures)}};
  std::vector<uint32_t> filled = {vertex_channels, kPairFeatures};
  const auto place = [&](Domain domain, uint32_t channels) {  // next free channels of a buffer of the domain
    for (size_t b = 2; b < model.buffers.size(); ++b) {
      if (model.buffers[b].domain == domain && filled[b] + channels <= model.buffers[b].channels &&
          random.below(3) != 0) {
        filled[b] += channels;
        return NetworkBuilder::region(static_cast<uint16_t>(b), filled[b] - channels, channels);
      }
    }
    model.buffers.push_back({domain, static_cast<uint16_t>(channels + random.below(90))});
    filled.push_back(channels);
    return NetworkBuilder::region(static_cast<uint16_t>(filled.size() - 1), 0, channels);
  };
  const auto pick = [&](Domain domain, uint32_t channels) {  // written channels, often of several writers
    while (true) {
      const uint32_t b = random.below(static_cast<uint32_t>(model.buffers.size()));
      if (model.buffers[b].domain != domain || filled[b] < channels) continue;
      return NetworkBuilder::region(static_cast<uint16_t>(b), random.below(filled[b] - channels + 1), channels);
    }
  };
  const auto add_linear = [&](Layer layer, ValueRange range) {
    IntegerLinear p;
    p.in = layer.in.channels;
    p.out = layer.out.channels;
    p.range = range;
    p.block = p.in;
    layer.parameters = static_cast<uint32_t>(model.linears.size());
    const bool wide = random.below(3) == 0;
    const int32_t largest = wide ? 32767 : std::min<int32_t>(32767, static_cast<int32_t>(60000 / (p.in + 2)));
    for (uint32_t n = 0; n < p.out; ++n) {
      const int shift = wide ? random.between(1, 20) : random.between(1, 14);
      p.shifts.push_back(static_cast<uint8_t>(shift));
      p.bias.push_back((int64_t{random.between(-5000, 5000)} << (shift / 2)) + (int64_t{1} << (shift - 1)));
      for (uint32_t c = 0; c < p.in; ++c) p.weights.push_back(static_cast<int16_t>(random.between(-largest, largest)));
      if (layer.flags & kLayerResidual) p.residual.push_back(static_cast<int16_t>(random.between(-largest, largest)));
    }
    if (wide) {
      p.accumulator = AccumulatorClass::kWide;
      p.block = static_cast<uint16_t>(
          std::min<uint32_t>(p.in, 1 + random.below(2)));  // two products of the largest values stay below 2^31
    }
    model.linears.push_back(p);
    model.layers.push_back(layer);
  };
  const uint32_t count = 4 + random.below(28);
  for (uint32_t i = 0; i < count; ++i) {
    Layer layer;
    layer.kind = static_cast<LayerKind>(1 + random.below(kLayerKindCount));
    const Domain domain = random.below(3) == 0 ? Domain::kVertex : Domain::kPair;
    const uint32_t channels = 1 + random.below(random.below(4) == 0 ? 80 : 12);
    const auto fit = [&](Domain d) {  // not more channels than some buffer of the domain holds
      uint32_t most = 0;
      for (size_t b = 0; b < filled.size(); ++b) most = model.buffers[b].domain == d ? std::max(most, filled[b]) : most;
      return std::min(channels, most);
    };
    switch (traits_of(layer.kind).shape) {
      case LayerShape::kWeights:
        layer.in = pick(domain, fit(domain));
        layer.flags = static_cast<uint8_t>(random.below(4));
        if (layer.flags & kLayerResidual) layer.residual = pick(domain, 1 + random.below(6));
        layer.out = place(domain, (layer.flags & kLayerResidual) ? layer.residual.channels : 1 + random.below(20));
        add_linear(layer, (layer.flags & kLayerRelu) ? ValueRange::kPositive : ValueRange::kSigned);
        continue;
      case LayerShape::kSameSlots:
        layer.in = pick(Domain::kPair, fit(Domain::kPair));
        layer.out = place(Domain::kPair, layer.in.channels);
        break;
      case LayerShape::kToSlots:
        layer.in = pick(Domain::kVertex, fit(Domain::kVertex));
        layer.out = place(Domain::kPair, layer.in.channels);
        break;
      case LayerShape::kJoinSlots:
        layer.in = pick(Domain::kPair, std::min<uint32_t>(fit(Domain::kPair), 3));
        layer.out = place(Domain::kVertex, layer.in.channels * k);
        break;
      case LayerShape::kSplitSlots: {
        if (fit(Domain::kVertex) < k) continue;
        layer.in = pick(Domain::kVertex, k);
        layer.out = place(Domain::kPair, 1);
        break;
      }
      case LayerShape::kSame:
        layer.in = pick(domain, fit(domain));
        layer.out = place(domain, layer.in.channels);
        break;
    }
    model.layers.push_back(layer);
  }
  Layer last;
  last.in = pick(Domain::kPair, 1);
  for (size_t b = 0; b < filled.size(); ++b) {  // the fullest pair buffer, so that much of the list matters
    if (model.buffers[b].domain == Domain::kPair && filled[b] > last.in.channels) {
      last.in = NetworkBuilder::region(static_cast<uint16_t>(b), 0, filled[b]);
    }
  }
  model.buffers.push_back({Domain::kPair, 1});
  filled.push_back(1);
  last.out = NetworkBuilder::region(static_cast<uint16_t>(filled.size() - 1), 0, 1);
  add_linear(last, ValueRange::kLogits);
  return model;
}

}  // namespace sinew::test
#endif
