// SPDX-License-Identifier: MIT
// Every kind of layer in float, forward and backward.
#include "network/float_layers.hpp"

#include <Eigen/Core>

#include "core/random.hpp"
#include "features/features.hpp"

namespace sinew {
namespace {

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

}  // namespace

template <class S>
void FloatLayers<S>::load_inputs(const FloatNetwork& shape, const DropoutOptions& dropout) {
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
void FloatLayers<S>::linear(const Layer& layer, View<S> in, View<S> out, View<S> residual, float dropout,
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
void FloatLayers<S>::linear_backward(const Layer& layer, View<S> in, View<S> out, View<S> d_in, View<S> d_out,
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
void FloatLayers<S>::ring(const Layer& layer, Block<uint32_t>* argument, bool pair, View<S> in, View<S> out) {
  const auto [begin, cols] = neighbors(layer, pair);
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
void FloatLayers<S>::ring_backward(const Layer& layer, const Block<uint32_t>& argument, bool pair, View<S> d_in,
                                   View<S> d_out) {
  const auto [begin, cols] = neighbors(layer, pair);
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
void FloatLayers<S>::part_mean(bool pair, View<S> in, View<S> out) {
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
void FloatLayers<S>::global(const Layer& layer, Block<uint32_t>* argument, View<S> in, View<S> out) {
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
void FloatLayers<S>::global_backward(const Layer& layer, const Block<uint32_t>& argument, View<S> d_in, View<S> d_out) {
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
void FloatLayers<S>::candidate_max(Block<uint32_t>* argument, View<S> in, View<S> out) {
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
void FloatLayers<S>::candidate_max_backward(const Block<uint32_t>& argument, View<S> d_in, View<S> d_out) {
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
void FloatLayers<S>::forward(const FloatNetwork& shape, size_t i, const DropoutOptions& dropout) {
  const Layer& layer = shape.layers[i];
  const View<S> in = view(shape, values, layer.in), out = view(shape, values, layer.out);
  const bool pair = has_slots(shape.buffers[layer.in.buffer].domain);
  switch (layer.kind) {
    case LayerKind::kLinear: {
      View<S> residual;
      if (layer.flags & kLayerResidual) residual = view(shape, values, layer.residual);
      linear(layer, in, out, residual, dropout.activations, mix_seeds(dropout.seed, 2, i));
      break;
    }
    case LayerKind::kRingMean:
    case LayerKind::kRingMax:
      ring(layer, &arguments[i], pair, in, out);
      break;
    case LayerKind::kPartMean:
      for (uint32_t r = 0; r < out.rows; ++r) std::fill_n(out.row(r), out.channels, S(0));
      part_mean(pair, in, out);
      break;
    case LayerKind::kGlobalMean:
    case LayerKind::kGlobalMax:
      global(layer, &arguments[i], in, out);
      break;
    case LayerKind::kCandidateMax:
      candidate_max(&arguments[i], in, out);
      break;
    case LayerKind::kVertexToPair:
      row_blocks(index.vertices, [&](uint32_t first, uint32_t end, size_t) {
        for (uint32_t v = first; v < end; ++v) {
          for (uint32_t p = index.pair_begin[v]; p < index.pair_begin[v + 1]; ++p) {
            std::copy_n(in.row(v), in.channels, out.row(p));
          }
        }
      });
      break;
    case LayerKind::kPairToVertex:
      for (uint32_t v = 0; v < index.vertices; ++v) {
        std::fill_n(out.row(v), out.channels, S(0));
        for (uint32_t p = index.pair_begin[v]; p < index.pair_begin[v + 1]; ++p) {
          std::copy_n(in.row(p), in.channels, out.row(v) + (index.pair_slot[p] - v * index.slots) * in.channels);
        }
      }
      break;
    case LayerKind::kVertexToSlots:
      for (uint32_t v = 0; v < index.vertices; ++v) {
        for (uint32_t p = index.pair_begin[v]; p < index.pair_begin[v + 1]; ++p) {
          std::copy_n(in.row(v) + (index.pair_slot[p] - v * index.slots) * out.channels, out.channels, out.row(p));
        }
      }
      break;
    case LayerKind::kCopy:
      for (uint32_t r = 0; r < in.rows; ++r) std::copy_n(in.row(r), in.channels, out.row(r));
      break;
  }
}

template <class S>
void FloatLayers<S>::backward(const FloatNetwork& shape, size_t i) {
  const Layer& layer = shape.layers[i];
  const bool is_input = layer.in.buffer < shape.input_names.size();
  if (is_input && !has_weights(layer.kind)) return;
  const bool pair = has_slots(shape.buffers[layer.in.buffer].domain);
  const View<S> d_out = view(shape, gradients, layer.out);
  View<S> d_in;
  if (!is_input) d_in = view(shape, gradients, layer.in);
  switch (layer.kind) {
    case LayerKind::kLinear: {
      View<S> d_residual;
      if ((layer.flags & kLayerResidual) && layer.residual.buffer >= shape.input_names.size()) {
        d_residual = view(shape, gradients, layer.residual);
      }
      linear_backward(layer, view(shape, values, layer.in), view(shape, values, layer.out), d_in, d_out, d_residual);
      break;
    }
    case LayerKind::kRingMean:
    case LayerKind::kRingMax:
      ring_backward(layer, arguments[i], pair, d_in, d_out);
      break;
    case LayerKind::kPartMean:
      part_mean(pair, d_out, d_in);
      break;
    case LayerKind::kGlobalMean:
    case LayerKind::kGlobalMax:
      global_backward(layer, arguments[i], d_in, d_out);
      break;
    case LayerKind::kCandidateMax:
      candidate_max_backward(arguments[i], d_in, d_out);
      break;
    case LayerKind::kVertexToPair:
      row_blocks(index.vertices, [&](uint32_t first, uint32_t end, size_t) {
        for (uint32_t v = first; v < end; ++v) {
          for (uint32_t p = index.pair_begin[v]; p < index.pair_begin[v + 1]; ++p) {
            add_to(d_in.row(v), d_out.row(p), d_in.channels);
          }
        }
      });
      break;
    case LayerKind::kPairToVertex:
      for (uint32_t v = 0; v < index.vertices; ++v) {
        for (uint32_t p = index.pair_begin[v]; p < index.pair_begin[v + 1]; ++p) {
          add_to(d_in.row(p), d_out.row(v) + (index.pair_slot[p] - v * index.slots) * d_in.channels, d_in.channels);
        }
      }
      break;
    case LayerKind::kVertexToSlots:
      for (uint32_t v = 0; v < index.vertices; ++v) {
        for (uint32_t p = index.pair_begin[v]; p < index.pair_begin[v + 1]; ++p) {
          add_to(d_in.row(v) + (index.pair_slot[p] - v * index.slots) * d_out.channels, d_out.row(p), d_out.channels);
        }
      }
      break;
    case LayerKind::kCopy:
      for (uint32_t r = 0; r < d_in.rows; ++r) add_to(d_in.row(r), d_out.row(r), d_in.channels);
      break;
  }
}

template struct FloatLayers<float>;
template struct FloatLayers<double>;

}  // namespace sinew
