// SPDX-License-Identifier: MIT
// The rows of one sample at every layer, and the kinds of layers forward and backward. To add a kind of layer, forward()
// and backward() get a case.
#ifndef SINEW_TRAINER_NETWORK_FLOAT_LAYERS_HPP
#define SINEW_TRAINER_NETWORK_FLOAT_LAYERS_HPP

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "core/team.hpp"
#include "data/sample_index.hpp"
#include "network/layer_runner.hpp"

namespace sinew {

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

// Rows per tile of a linear layer: 256 rows of 192 floats stay in the second-level cache between the product, the
// activation and, backward, the two products.
constexpr uint32_t kTileRows = 256;

// Rows that one thread of a team takes at a time. Sums over blocks are added in the order of the blocks, with a team or
// without, so it is part of what a run computes.
constexpr uint32_t kBlockRows = 16 * kTileRows;

// Rows of absent slots do not exist here.
template <class S>
struct FloatLayers {
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
  // Layer i of the list: its rows, and from its rows' gradient that of what it read.
  void forward(const FloatNetwork& shape, size_t i, const DropoutOptions& dropout);
  void backward(const FloatNetwork& shape, size_t i);

 private:
  void linear(const Layer& layer, View<S> in, View<S> out, View<S> residual, float dropout, uint64_t seed);
  void linear_backward(const Layer& layer, View<S> in, View<S> out, View<S> d_in, View<S> d_out, View<S> d_residual);
  // CSR of the rows that a layer of neighbors reads.
  std::pair<const uint32_t*, const uint32_t*> neighbors(const Layer& layer, bool pair) const {
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

extern template struct FloatLayers<float>;
extern template struct FloatLayers<double>;

}  // namespace sinew
#endif
