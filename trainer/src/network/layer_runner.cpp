// SPDX-License-Identifier: MIT
// Float execution of the layer list: every layer's forward pass and its gradient. Rows of absent slots do not exist
// here.
#include "network/layer_runner.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

#include "core/random.hpp"
#include "core/team.hpp"
#include "data/sample_index.hpp"
#include "features/features.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// Memory that grows and is never given back, on 64-byte boundaries: Eigen's reductions may peel by alignment, and a
// resumed run has to give the same bytes.
template <class T>
class Block {
 public:
  Block() = default;
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  Block(Block&& other) noexcept : data_(other.data_), size_(other.size_), capacity_(other.capacity_) {
    other.data_ = nullptr;
    other.size_ = other.capacity_ = 0;
  }
  ~Block() { std::free(data_); }
  void resize(size_t size) {  // contents are lost
    if (size > capacity_) {
      std::free(data_);
      capacity_ = size + size / 8;
      data_ = static_cast<T*>(std::aligned_alloc(64, (capacity_ * sizeof(T) + 63) / 64 * 64));
      if (data_ == nullptr) throw std::bad_alloc();
    }
    size_ = size;
  }
  void zero() {
    if (size_ != 0) std::memset(static_cast<void*>(data_), 0, size_ * sizeof(T));
  }
  T* data() { return data_; }
  const T* data() const { return data_; }
  size_t size() const { return size_; }

 private:
  T* data_ = nullptr;
  size_t size_ = 0, capacity_ = 0;
};

// Channels of some rows of a buffer.
template <class S>
struct View {
  S* data = nullptr;
  size_t stride = 0;
  uint32_t rows = 0, channels = 0;
  S* row(size_t r) const { return data + r * stride; }
};

template <class S>
void add_to(S* out, const S* in, uint32_t n) {
  for (uint32_t c = 0; c < n; ++c) out[c] += in[c];
}
template <class S>
void add_scaled(S* out, const S* in, S scale, uint32_t n) {
  for (uint32_t c = 0; c < n; ++c) out[c] += scale * in[c];
}

template <class S>
using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
template <class S>
using MatrixMap = Eigen::Map<Matrix<S>, Eigen::Unaligned, Eigen::OuterStride<>>;
template <class S>
using ConstMatrixMap = Eigen::Map<const Matrix<S>, Eigen::Unaligned, Eigen::OuterStride<>>;

// Rows per tile of a linear layer: 256 rows of 192 floats stay in the second-level cache between the product, the
// activation and, backward, the two products.
constexpr uint32_t kTileRows = 256;

// Rows that one thread of a team takes at a time. Sums over blocks are added in the order of the blocks, with a team or
// without, so it is part of what a run computes.
constexpr uint32_t kBlockRows = 16 * kTileRows;

}  // namespace

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
      throw Error(sample.name + ": the network reads far neighbours, which the sample does not have");
  }
}

}  // namespace

template <class S>
struct LayerRunner<S>::State {
  SampleIndex index;
  std::vector<Block<S>> values, gradients;  // per buffer [rows x channels]
  std::vector<Block<uint32_t>> arguments;   // per layer: the row that a maximum came from, UINT32_MAX = none
  std::vector<Block<S>> weights, d_weights, bias, d_bias;
  Block<S> sums;
  std::vector<S> outputs;
  S relu_scale = 1;  // of the last forward: 1 / (1 - dropout)
  const NetworkSample* sample = nullptr;
  Team* team = nullptr;
  Block<S> partial;  // per block of a linear layer: its part of the gradient

  // Calls work(first row, end row, block); blocks may run side by side.
  template <class Work>
  void row_blocks(uint32_t row_count, Work&& work) {
    const auto block = [&](size_t b) {
      const uint32_t first = static_cast<uint32_t>(b) * kBlockRows;
      work(first, std::min(first + kBlockRows, row_count), b);
    };
    const size_t count = block_count(row_count);
    if (team != nullptr && count > 1) return team->blocks(count, block);
    for (size_t b = 0; b < count; ++b) block(b);
  }
  static size_t block_count(uint32_t row_count) { return (row_count + kBlockRows - 1) / kBlockRows; }

  uint32_t rows(const FloatNetwork& shape, uint16_t buffer) const {
    return has_slots(shape.buffers[buffer].domain) ? index.pairs : index.vertices;
  }
  // Rows of the output with absent slots, and where row r without them goes among those.
  size_t output_rows(const FloatNetwork& shape) const {
    return size_t{index.vertices} * (has_slots(output_domain(shape)) ? index.slots : 1);
  }
  size_t output_row(const FloatNetwork& shape, uint32_t r) const {
    return has_slots(output_domain(shape)) ? index.pair_slot[r] : r;
  }
  static Domain output_domain(const FloatNetwork& shape) {
    return shape.buffers[shape.layers.back().out.buffer].domain;
  }
  View<S> view(const FloatNetwork& shape, std::vector<Block<S>>& blocks, const Region& region) const {
    return {blocks[region.buffer].data() + region.offset, shape.buffers[region.buffer].channels,
            rows(shape, region.buffer), region.channels};
  }

  void load_inputs(const FloatNetwork& shape, const DropoutOptions& dropout);
  void linear(const Layer& layer, View<S> in, View<S> out, View<S> residual, float dropout, uint64_t seed);
  void linear_backward(const Layer& layer, View<S> in, View<S> out, View<S> d_in, View<S> d_out, View<S> d_residual);
  // CSR of the rows that a layer of neighbours reads.
  std::pair<const uint32_t*, const uint32_t*> neighbours(const Layer& layer, bool pair) const {
    if (pair) return {index.ring_begin.data(), index.ring_pairs.data()};
    if ((layer.flags & kLayerFar) != 0) return {sample->far_offsets.data(), sample->far_indices.data()};
    return {sample->row_offsets.data(), sample->col_indices.data()};
  }
  void ring(const Layer& layer, Block<uint32_t>* argument, bool pair, View<S> in, View<S> out);
  void ring_backward(const Layer& layer, const Block<uint32_t>& argument, bool pair, View<S> d_in, View<S> d_out);
  void part_mean(bool pair, View<S> in, View<S> out);  // linear and symmetric: its own transpose, adds to out
  void global(const Layer& layer, Block<uint32_t>* argument, View<S> in, View<S> out);
  void global_backward(const Layer& layer, const Block<uint32_t>& argument, View<S> d_in, View<S> d_out);
  void candidate_max(Block<uint32_t>* argument, View<S> in, View<S> out);
  void candidate_max_backward(const Block<uint32_t>& argument, View<S> d_in, View<S> d_out);
};

template <class S>
void LayerRunner<S>::State::load_inputs(const FloatNetwork& shape, const DropoutOptions& dropout) {
  Random random(mix_seeds(dropout.seed, 1));
  constexpr S scale = S(1) / S(1 << kFeatureBits);
  const auto of_input = [](const std::vector<std::vector<uint32_t>>& lists, size_t input) {
    return input < lists.size() ? lists[input] : std::vector<uint32_t>();
  };
  std::vector<std::vector<S>> scales;  // drawn for all inputs before any is read
  for (size_t i = 0; i < shape.input_names.size(); ++i) {
    const std::vector<uint32_t> kept = of_input(dropout.kept, i);
    std::vector<S>& of_channels = scales.emplace_back(shape.buffers[i].channels, scale);
    for (uint32_t c = 0; c < of_channels.size() && dropout.features > 0; ++c) {
      const bool drop = random.uniform() < static_cast<double>(dropout.features);
      if (drop && std::find(kept.begin(), kept.end(), c) == kept.end()) of_channels[c] = 0;
    }
    for (const uint32_t c : of_input(dropout.absent, i)) of_channels[c] = 0;
  }
  const bool noisy = dropout.noise > 0 && random.uniform() < 0.5;
  for (size_t i = 0; i < scales.size(); ++i) {
    const bool pair = has_slots(shape.buffers[i].domain);
    const uint32_t channels = shape.buffers[i].channels;
    std::vector<S> moved(channels, S(0));
    for (uint32_t c = 0; c < channels && noisy; ++c)
      moved[c] = static_cast<S>(static_cast<double>(dropout.noise) * random.normal());
    S* const out = values[i].data();
    for (uint32_t r = 0; r < (pair ? index.pairs : index.vertices); ++r) {
      const int16_t* in = sample->inputs[i].rows.data() + size_t{pair ? index.pair_slot[r] : r} * channels;
      for (uint32_t c = 0; c < channels; ++c)
        out[size_t{r} * channels + c] = static_cast<S>(in[c]) * scales[i][c] + moved[c];
    }
  }
}

template <class S>
void LayerRunner<S>::State::linear(const Layer& layer, View<S> in, View<S> out, View<S> residual, float dropout,
                                   uint64_t seed) {
  const S* b = bias[layer.parameters].data();
  const bool relu = layer.flags & kLayerRelu, has_residual = layer.flags & kLayerResidual;
  const bool drop = relu && dropout > 0;
  const uint64_t drop_below = static_cast<uint64_t>(dropout * 65536.0f);  // 16 random bits per value are fine enough
  const ConstMatrixMap<S> w(weights[layer.parameters].data(), out.channels, in.channels,
                            Eigen::OuterStride<>(in.channels));
  row_blocks(in.rows, [&](uint32_t first, uint32_t end, size_t block) {
    Random random(mix_seeds(seed, block));
    for (uint32_t begin = first; begin < end; begin += kTileRows) {
      const uint32_t n = std::min(kTileRows, end - begin);
      MatrixMap<S> y(out.row(begin), n, out.channels, Eigen::OuterStride<>(static_cast<Eigen::Index>(out.stride)));
      const ConstMatrixMap<S> x(in.row(begin), n, in.channels,
                                Eigen::OuterStride<>(static_cast<Eigen::Index>(in.stride)));
      y.noalias() = x * w.transpose();
      for (uint32_t r = begin; r < begin + n; ++r) {
        S* row = out.row(r);
        for (uint32_t c = 0; c < out.channels; ++c) row[c] += b[c];
        if (has_residual) add_to(row, residual.row(r), out.channels);
        if (relu) {
          for (uint32_t c = 0; c < out.channels; ++c) row[c] = std::max(row[c], S(0));
        }
        if (drop) {
          for (uint32_t c = 0; c < out.channels; c += 4) {
            uint64_t bits = random.next();
            for (uint32_t i = c; i < std::min(c + 4, out.channels); ++i, bits >>= 16) {
              row[i] *= (bits & 0xFFFF) < drop_below ? S(0) : relu_scale;
            }
          }
        }
      }
    }
  });
}

template <class S>
void LayerRunner<S>::State::linear_backward(const Layer& layer, View<S> in, View<S> out, View<S> d_in, View<S> d_out,
                                            View<S> d_residual) {
  const bool relu = layer.flags & kLayerRelu;
  const size_t weight_count = size_t{out.channels} * in.channels;
  const size_t stride = (weight_count + out.channels + 15) / 16 * 16;  // 64-byte boundaries, as everywhere
  partial.resize(stride * block_count(in.rows));
  partial.zero();
  const ConstMatrixMap<S> w(weights[layer.parameters].data(), out.channels, in.channels,
                            Eigen::OuterStride<>(in.channels));
  row_blocks(in.rows, [&](uint32_t first, uint32_t end, size_t block) {
    MatrixMap<S> dw(partial.data() + stride * block, out.channels, in.channels, Eigen::OuterStride<>(in.channels));
    S* db = dw.data() + weight_count;
    for (uint32_t begin = first; begin < end; begin += kTileRows) {
      const uint32_t n = std::min(kTileRows, end - begin);
      for (uint32_t r = begin; r < begin + n; ++r) {
        S* g = d_out.row(r);
        if (relu) {  // a dropped value is 0 like an inactive one, so the output alone tells where the gradient flows
          const S* y = out.row(r);
          for (uint32_t c = 0; c < out.channels; ++c) g[c] = y[c] > S(0) ? g[c] * relu_scale : S(0);
        }
        add_to(db, g, out.channels);
        if (d_residual.data != nullptr) add_to(d_residual.row(r), g, out.channels);
      }
      const ConstMatrixMap<S> g(d_out.row(begin), n, out.channels,
                                Eigen::OuterStride<>(static_cast<Eigen::Index>(d_out.stride)));
      const ConstMatrixMap<S> x(in.row(begin), n, in.channels,
                                Eigen::OuterStride<>(static_cast<Eigen::Index>(in.stride)));
      dw.noalias() += g.transpose() * x;
      if (d_in.data != nullptr) {
        MatrixMap<S> dx(d_in.row(begin), n, in.channels, Eigen::OuterStride<>(static_cast<Eigen::Index>(d_in.stride)));
        dx.noalias() += g * w;
      }
    }
  });
  for (size_t block = 0; block < block_count(in.rows); ++block) {
    const S* part = partial.data() + stride * block;
    add_to(d_weights[layer.parameters].data(), part, static_cast<uint32_t>(weight_count));
    add_to(d_bias[layer.parameters].data(), part + weight_count, out.channels);
  }
}

template <class S>
void LayerRunner<S>::State::ring(const Layer& layer, Block<uint32_t>* argument, bool pair, View<S> in, View<S> out) {
  const auto [begin, cols] = neighbours(layer, pair);
  const uint32_t channels = in.channels;
  if (layer.kind == LayerKind::kRingMean) {
    row_blocks(in.rows, [&](uint32_t first, uint32_t end, size_t) {
      for (uint32_t r = first; r < end; ++r) {
        S* o = out.row(r);
        std::fill_n(o, channels, S(0));
        for (uint32_t e = begin[r]; e < begin[r + 1]; ++e) add_to(o, in.row(cols[e]), channels);
        if (begin[r + 1] - begin[r] > 1) {
          const S scale = S(1) / static_cast<S>(begin[r + 1] - begin[r]);
          for (uint32_t c = 0; c < channels; ++c) o[c] *= scale;
        }
      }
    });
    return;
  }
  argument->resize(size_t{in.rows} * channels);
  for (uint32_t r = 0; r < in.rows; ++r) {
    S* o = out.row(r);
    uint32_t* arg = argument->data() + size_t{r} * channels;
    std::fill_n(arg, channels, UINT32_MAX);
    std::fill_n(o, channels, S(0));
    for (uint32_t e = begin[r]; e < begin[r + 1]; ++e) {
      const S* i = in.row(cols[e]);
      for (uint32_t c = 0; c < channels; ++c) {
        if (e == begin[r] || i[c] > o[c]) {
          o[c] = i[c];
          arg[c] = cols[e];
        }
      }
    }
  }
}

template <class S>
void LayerRunner<S>::State::ring_backward(const Layer& layer, const Block<uint32_t>& argument, bool pair, View<S> d_in,
                                          View<S> d_out) {
  const auto [begin, cols] = neighbours(layer, pair);
  const uint32_t channels = d_in.channels;
  for (uint32_t r = 0; r < d_in.rows; ++r) {
    const S* g = d_out.row(r);
    if (layer.kind == LayerKind::kRingMean) {
      if (begin[r] == begin[r + 1]) continue;
      const S scale = S(1) / static_cast<S>(begin[r + 1] - begin[r]);
      for (uint32_t e = begin[r]; e < begin[r + 1]; ++e) add_scaled(d_in.row(cols[e]), g, scale, channels);
    } else {
      const uint32_t* arg = argument.data() + size_t{r} * channels;
      for (uint32_t c = 0; c < channels; ++c) {
        if (arg[c] != UINT32_MAX) d_in.row(arg[c])[c] += g[c];
      }
    }
  }
}

template <class S>
void LayerRunner<S>::State::part_mean(bool pair, View<S> in, View<S> out) {
  const uint32_t channels = in.channels;
  const size_t groups = pair ? index.group_scale.size() : sample->part_count;
  const uint32_t* group = pair ? index.group.data() : sample->part.data();
  sums.resize(groups * channels);
  sums.zero();
  for (uint32_t r = 0; r < in.rows; ++r) add_to(sums.data() + size_t{group[r]} * channels, in.row(r), channels);
  for (size_t g = 0; g < groups; ++g) {
    const S scale = pair ? static_cast<S>(index.group_scale[g])
                         : S(1) / static_cast<S>(sample->part_offsets[g + 1] - sample->part_offsets[g]);
    for (uint32_t c = 0; c < channels; ++c) sums.data()[g * channels + c] *= scale;
  }
  for (uint32_t r = 0; r < in.rows; ++r) add_to(out.row(r), sums.data() + size_t{group[r]} * channels, channels);
}

template <class S>
void LayerRunner<S>::State::global(const Layer& layer, Block<uint32_t>* argument, View<S> in, View<S> out) {
  const uint32_t channels = in.channels;
  sums.resize(channels);
  sums.zero();
  S* total = sums.data();
  if (layer.kind == LayerKind::kGlobalMean) {
    // In two levels: a straight float sum over 100k rows would lose the small values.
    std::vector<double> all(channels, 0.0);
    for (uint32_t begin = 0; begin < in.rows; begin += kTileRows) {
      sums.zero();
      for (uint32_t r = begin; r < std::min(begin + kTileRows, in.rows); ++r) add_to(total, in.row(r), channels);
      for (uint32_t c = 0; c < channels; ++c) all[c] += static_cast<double>(total[c]);
    }
    for (uint32_t c = 0; c < channels; ++c) total[c] = static_cast<S>(all[c] / std::max(in.rows, 1u));
  } else {
    argument->resize(channels);
    std::fill_n(argument->data(), channels, UINT32_MAX);
    for (uint32_t r = 0; r < in.rows; ++r) {
      const S* i = in.row(r);
      for (uint32_t c = 0; c < channels; ++c) {
        if (r == 0 || i[c] > total[c]) {
          total[c] = i[c];
          argument->data()[c] = r;
        }
      }
    }
  }
  for (uint32_t r = 0; r < in.rows; ++r) std::copy_n(total, channels, out.row(r));
}

template <class S>
void LayerRunner<S>::State::global_backward(const Layer& layer, const Block<uint32_t>& argument, View<S> d_in,
                                            View<S> d_out) {
  const uint32_t channels = d_in.channels;
  if (d_in.rows == 0) return;
  sums.resize(channels);
  sums.zero();
  for (uint32_t r = 0; r < d_in.rows; ++r) add_to(sums.data(), d_out.row(r), channels);
  if (layer.kind == LayerKind::kGlobalMean) {
    const S scale = S(1) / static_cast<S>(d_in.rows);
    for (uint32_t r = 0; r < d_in.rows; ++r) add_scaled(d_in.row(r), sums.data(), scale, channels);
  } else {
    for (uint32_t c = 0; c < channels; ++c) d_in.row(argument.data()[c])[c] += sums.data()[c];
  }
}

template <class S>
void LayerRunner<S>::State::candidate_max(Block<uint32_t>* argument, View<S> in, View<S> out) {
  const uint32_t channels = in.channels;
  argument->resize(size_t{index.vertices} * channels);
  row_blocks(index.vertices, [&](uint32_t first_vertex, uint32_t end_vertex, size_t) {
    std::vector<S> best_of(channels);
    S* best = best_of.data();
    for (uint32_t v = first_vertex; v < end_vertex; ++v) {
      const uint32_t first = index.pair_begin[v], last = index.pair_begin[v + 1];
      if (first == last) continue;
      uint32_t* arg = argument->data() + size_t{v} * channels;
      std::copy_n(in.row(first), channels, best);
      std::fill_n(arg, channels, first);
      for (uint32_t p = first + 1; p < last; ++p) {
        const S* i = in.row(p);
        for (uint32_t c = 0; c < channels; ++c) {
          arg[c] = i[c] > best[c] ? p : arg[c];
          best[c] = i[c] > best[c] ? i[c] : best[c];
        }
      }
      for (uint32_t p = first; p < last; ++p) std::copy_n(best, channels, out.row(p));
    }
  });
}

template <class S>
void LayerRunner<S>::State::candidate_max_backward(const Block<uint32_t>& argument, View<S> d_in, View<S> d_out) {
  const uint32_t channels = d_in.channels;
  row_blocks(index.vertices, [&](uint32_t first, uint32_t end, size_t) {
    std::vector<S> sum(channels);
    for (uint32_t v = first; v < end; ++v) {
      std::fill(sum.begin(), sum.end(), S(0));
      for (uint32_t p = index.pair_begin[v]; p < index.pair_begin[v + 1]; ++p)
        add_to(sum.data(), d_out.row(p), channels);
      if (index.pair_begin[v] == index.pair_begin[v + 1]) continue;
      const uint32_t* arg = argument.data() + size_t{v} * channels;
      for (uint32_t c = 0; c < channels; ++c) d_in.row(arg[c])[c] += sum[c];
    }
  });
}

template <class S>
LayerRunner<S>::LayerRunner() : state_(std::make_unique<State>()) {}
template <class S>
LayerRunner<S>::~LayerRunner() = default;
template <class S>
void LayerRunner<S>::set_team(Team* team) {
  state_->team = team;
}

template <class S>
const std::vector<S>& LayerRunner<S>::forward(const FloatNetwork& shape, const std::vector<LinearBlock<S>>& parameters,
                                              const NetworkSample& sample, const DropoutOptions& dropout) {
  State& s = *state_;
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

  for (size_t i = 0; i < shape.layers.size(); ++i) {
    const Layer& layer = shape.layers[i];
    const View<S> in = s.view(shape, s.values, layer.in), out = s.view(shape, s.values, layer.out);
    const bool pair = has_slots(shape.buffers[layer.in.buffer].domain);
    switch (layer.kind) {
      case LayerKind::kLinear: {
        View<S> residual;
        if (layer.flags & kLayerResidual) residual = s.view(shape, s.values, layer.residual);
        s.linear(layer, in, out, residual, dropout.activations, mix_seeds(dropout.seed, 2, i));
        break;
      }
      case LayerKind::kRingMean:
      case LayerKind::kRingMax:
        s.ring(layer, &s.arguments[i], pair, in, out);
        break;
      case LayerKind::kPartMean:
        for (uint32_t r = 0; r < out.rows; ++r) std::fill_n(out.row(r), out.channels, S(0));
        s.part_mean(pair, in, out);
        break;
      case LayerKind::kGlobalMean:
      case LayerKind::kGlobalMax:
        s.global(layer, &s.arguments[i], in, out);
        break;
      case LayerKind::kCandidateMax:
        s.candidate_max(&s.arguments[i], in, out);
        break;
      case LayerKind::kVertexToPair:
        s.row_blocks(s.index.vertices, [&](uint32_t first, uint32_t end, size_t) {
          for (uint32_t v = first; v < end; ++v) {
            for (uint32_t p = s.index.pair_begin[v]; p < s.index.pair_begin[v + 1]; ++p) {
              std::copy_n(in.row(v), in.channels, out.row(p));
            }
          }
        });
        break;
      case LayerKind::kPairToVertex:
        for (uint32_t v = 0; v < s.index.vertices; ++v) {
          std::fill_n(out.row(v), out.channels, S(0));
          for (uint32_t p = s.index.pair_begin[v]; p < s.index.pair_begin[v + 1]; ++p) {
            std::copy_n(in.row(p), in.channels, out.row(v) + (s.index.pair_slot[p] - v * s.index.slots) * in.channels);
          }
        }
        break;
      case LayerKind::kVertexToSlots:
        for (uint32_t v = 0; v < s.index.vertices; ++v) {
          for (uint32_t p = s.index.pair_begin[v]; p < s.index.pair_begin[v + 1]; ++p) {
            std::copy_n(in.row(v) + (s.index.pair_slot[p] - v * s.index.slots) * out.channels, out.channels,
                        out.row(p));
          }
        }
        break;
      case LayerKind::kCopy:
        for (uint32_t r = 0; r < in.rows; ++r) std::copy_n(in.row(r), in.channels, out.row(r));
        break;
    }
  }
  const View<S> output = s.view(shape, s.values, shape.layers.back().out);
  s.outputs.assign(s.output_rows(shape) * output.channels, S(0));
  for (uint32_t r = 0; r < output.rows; ++r)
    std::copy_n(output.row(r), output.channels, s.outputs.data() + s.output_row(shape, r) * output.channels);
  return s.outputs;
}

template <class S>
void LayerRunner<S>::backward(const FloatNetwork& shape, const std::vector<LinearBlock<S>>& parameters,
                              const std::vector<S>& d_outputs, std::vector<LinearBlock<S>>* gradients) {
  State& s = *state_;
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

  for (size_t i = shape.layers.size(); i-- > 0;) {
    const Layer& layer = shape.layers[i];
    const bool is_input = layer.in.buffer < inputs;
    if (is_input && layer.kind != LayerKind::kLinear) continue;
    const bool pair = has_slots(shape.buffers[layer.in.buffer].domain);
    const View<S> d_out = s.view(shape, s.gradients, layer.out);
    View<S> d_in;
    if (!is_input) d_in = s.view(shape, s.gradients, layer.in);
    switch (layer.kind) {
      case LayerKind::kLinear: {
        View<S> d_residual;
        if ((layer.flags & kLayerResidual) && layer.residual.buffer >= inputs) {
          d_residual = s.view(shape, s.gradients, layer.residual);
        }
        s.linear_backward(layer, s.view(shape, s.values, layer.in), s.view(shape, s.values, layer.out), d_in, d_out,
                          d_residual);
        break;
      }
      case LayerKind::kRingMean:
      case LayerKind::kRingMax:
        s.ring_backward(layer, s.arguments[i], pair, d_in, d_out);
        break;
      case LayerKind::kPartMean:
        s.part_mean(pair, d_out, d_in);
        break;
      case LayerKind::kGlobalMean:
      case LayerKind::kGlobalMax:
        s.global_backward(layer, s.arguments[i], d_in, d_out);
        break;
      case LayerKind::kCandidateMax:
        s.candidate_max_backward(s.arguments[i], d_in, d_out);
        break;
      case LayerKind::kVertexToPair:
        s.row_blocks(s.index.vertices, [&](uint32_t first, uint32_t end, size_t) {
          for (uint32_t v = first; v < end; ++v) {
            for (uint32_t p = s.index.pair_begin[v]; p < s.index.pair_begin[v + 1]; ++p) {
              add_to(d_in.row(v), d_out.row(p), d_in.channels);
            }
          }
        });
        break;
      case LayerKind::kPairToVertex:
        for (uint32_t v = 0; v < s.index.vertices; ++v) {
          for (uint32_t p = s.index.pair_begin[v]; p < s.index.pair_begin[v + 1]; ++p) {
            add_to(d_in.row(p), d_out.row(v) + (s.index.pair_slot[p] - v * s.index.slots) * d_in.channels,
                   d_in.channels);
          }
        }
        break;
      case LayerKind::kVertexToSlots:
        for (uint32_t v = 0; v < s.index.vertices; ++v) {
          for (uint32_t p = s.index.pair_begin[v]; p < s.index.pair_begin[v + 1]; ++p) {
            add_to(d_in.row(v) + (s.index.pair_slot[p] - v * s.index.slots) * d_out.channels, d_out.row(p),
                   d_out.channels);
          }
        }
        break;
      case LayerKind::kCopy:
        for (uint32_t r = 0; r < d_in.rows; ++r) add_to(d_in.row(r), d_out.row(r), d_in.channels);
        break;
    }
  }
  for (size_t i = 0; i < parameters.size(); ++i) {
    add_to((*gradients)[i].weights.data(), s.d_weights[i].data(), static_cast<uint32_t>(s.d_weights[i].size()));
    add_to((*gradients)[i].bias.data(), s.d_bias[i].data(), static_cast<uint32_t>(s.d_bias[i].size()));
  }
}

template <class S>
void LayerRunner<S>::copy_buffer(const FloatNetwork& shape, uint16_t index, std::vector<S>* out) const {
  const State& s = *state_;
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
