// SPDX-License-Identifier: MIT
// Words for kinds of bodies, and the kind that an outline is of, by a small network.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "picture/outline_class_table.hpp"
#include "sinew_character/picture/body_class.hpp"
#include "sinew_formats/base/late_constants.hpp"

namespace sinew {

const std::vector<std::string>& body_class_words() {
  static const std::vector<std::string> words = {"biped", "quadruped", "bird", "fish", "snake", "many-legged", "other"};
  return words;
}

const std::string& body_class_word(BodyClass body) { return body_class_words()[static_cast<size_t>(body)]; }

std::optional<BodyClass> body_class_of(const std::string& word) {
  const auto& words = body_class_words();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<BodyClass>(found - words.begin());
}

namespace {

OutlineCells mirrored(OutlineCells cells) {
  for (auto& row : cells) std::reverse(row.begin(), row.end());
  return cells;
}

// [side x side x channels], rows from the top
struct Layer {
  size_t side = 0, channels = 0;
  std::vector<int32_t> values;
  int32_t at(size_t y, size_t x, size_t c) const { return values[(y * side + x) * channels + c]; }
};

// A kernel of 3 x 3 with zeros around, what is positive of it in Q10, the mean of each four. Sums stay below 9 * 24 * 2^18 * 2^15.
Layer convolved(const Layer& in, size_t channels, const int16_t* weights, const int32_t* biases, int32_t shift) {
  Layer out = {in.side / 2, channels, std::vector<int32_t>(in.side / 2 * (in.side / 2) * channels)};
  for (size_t y = 0; y < in.side; ++y)
    for (size_t x = 0; x < in.side; ++x)
      for (size_t k = 0; k < channels; ++k) {
        int64_t sum = biases[k];
        for (size_t i = 0; i < 9; ++i) {
          const size_t v = y + i / 3, u = x + i % 3;  // one more than the cell's
          if (v == 0 || u == 0 || v > in.side || u > in.side) continue;
          for (size_t c = 0; c < in.channels; ++c)
            sum += int64_t{in.at(v - 1, u - 1, c)} * weights[(i * in.channels + c) * channels + k];
        }
        out.values[((y / 2) * out.side + x / 2) * channels + k] +=
            static_cast<int32_t>(std::max<int64_t>(sum, 0) >> shift);
      }
  for (int32_t& value : out.values) value /= 4;
  return out;
}

// sums [outputs] of inputs by weights [inputs x outputs], with biases.
std::vector<int64_t> dense(const std::vector<int32_t>& in, size_t outputs, const int16_t* weights,
                           const int32_t* biases) {
  std::vector<int64_t> out(biases, biases + outputs);
  for (size_t i = 0; i < in.size(); ++i)
    for (size_t k = 0; k < outputs; ++k) out[k] += int64_t{in[i]} * weights[i * outputs + k];
  return out;
}

// Q10
std::array<int64_t, kOutlineClasses> logits_of(const OutlineCells& cells) {
  const int16_t* weights = late_constants<kOutlineWeights>();
  const int32_t* biases = kOutlineBiases;
  Layer layer = {kOutlineCells, 1, {}};
  for (const auto& row : cells) layer.values.insert(layer.values.end(), row.begin(), row.end());
  int32_t shift = 8;  // of Q18, then of Q22
  for (const int channels : kOutlineChannels) {
    const auto count = static_cast<size_t>(channels);
    const size_t used = 9 * layer.channels * count;
    layer = convolved(layer, count, weights, biases, shift);
    weights += used;
    biases += count;
    shift = 12;
  }
  std::vector<int32_t> hidden;
  for (const int64_t sum : dense(layer.values, kOutlineHidden, weights, biases))
    hidden.push_back(static_cast<int32_t>(std::max<int64_t>(sum, 0) >> 12));
  const std::vector<int64_t> sums =
      dense(hidden, kOutlineClasses, weights + layer.values.size() * kOutlineHidden, biases + kOutlineHidden);
  std::array<int64_t, kOutlineClasses> out{};
  std::transform(sums.begin(), sums.end(), out.begin(), [](int64_t sum) { return sum >> 12; });
  return out;
}

}  // namespace

OutlineCells outline_cells(const Mask& mask) {
  int64_t left = mask.width, right = -1, top = mask.height, bottom = -1;
  for (int64_t y = 0; y < mask.height; ++y) {
    for (int64_t x = 0; x < mask.width; ++x) {
      if (!mask.at(x, y)) continue;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = y;
    }
  }
  OutlineCells out{};
  if (right < 0) return out;
  const int64_t width = right + 1 - left, height = bottom + 1 - top, size = std::max(width, height);
  const int64_t x0 = left - (size - width) / 2, y0 = top - (size - height) / 2;
  for (int64_t r = 0; r < kOutlineCells; ++r) {
    const int64_t low = r * size / kOutlineCells, high = std::max((r + 1) * size / kOutlineCells, low + 1);
    for (int64_t c = 0; c < kOutlineCells; ++c) {
      const int64_t from = c * size / kOutlineCells, to = std::max((c + 1) * size / kOutlineCells, from + 1);
      int64_t inside = 0;
      for (int64_t y = low; y < high; ++y)
        for (int64_t x = from; x < to; ++x) inside += mask.at(x0 + x, y0 + y) ? 1 : 0;
      out[static_cast<size_t>(r)][static_cast<size_t>(c)] =
          static_cast<int32_t>(255 * inside / ((high - low) * (to - from)));
    }
  }
  return out;
}

BodyGuess class_of_outline(const Mask& mask) {
  const OutlineCells cells = outline_cells(mask);
  if (std::all_of(cells.begin(), cells.end(),
                  [](const auto& row) { return row == std::array<int32_t, kOutlineCells>{}; }))
    return {};
  std::array<int64_t, kOutlineClasses> logits = logits_of(cells);
  const std::array<int64_t, kOutlineClasses> other = logits_of(mirrored(cells));
  std::array<size_t, kOutlineClasses> order{};
  std::iota(order.begin(), order.end(), size_t{0});
  for (size_t k = 0; k < kOutlineClasses; ++k) logits[k] += other[k];
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return logits[a] > logits[b]; });
  const auto share = [&](size_t k) { return std::exp(static_cast<double>(logits[k] - logits[order[0]]) / 2048); };
  double sum = 0;
  for (size_t k = 0; k < kOutlineClasses; ++k) sum += share(k);
  return {static_cast<BodyClass>(order[0]), static_cast<float>(1 / sum), static_cast<BodyClass>(order[1]),
          static_cast<float>(share(order[1]) / sum)};
}

}  // namespace sinew
