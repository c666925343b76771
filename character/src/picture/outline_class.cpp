// SPDX-License-Identifier: MIT
// Words for kinds of bodies, and the kind that an outline is of, by a small network.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <utility>

#include "picture/outline_class_table.hpp"
#include "sinew_character/picture/body_class.hpp"

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

constexpr int kPairs = kOutlineCells / 2;
constexpr int32_t kSolid = 64;  // a cell that is covered by more is the figure's

OutlineCells turned_cells(const OutlineCells& cells) {
  OutlineCells out{};
  for (size_t y = 0; y < kOutlineCells; ++y)
    for (size_t x = 0; x < kOutlineCells; ++x) out[x][y] = cells[y][x];
  return out;
}

OutlineCells mirrored(OutlineCells cells) {
  for (auto& row : cells) std::reverse(row.begin(), row.end());
  return cells;
}

// Of one row: how many parts it has, its first and its last solid cell (the middle where there is none).
struct RowShape {
  int32_t parts = 0, first = kPairs, last = kPairs;
};

RowShape shape_of(const std::array<int32_t, kOutlineCells>& row) {
  RowShape out;
  bool before = false;
  for (int32_t x = 0; x < kOutlineCells; ++x) {
    const bool solid = row[static_cast<size_t>(x)] > kSolid;
    if (solid && !before && out.parts++ == 0) out.first = x;
    if (solid) out.last = x;
    before = solid;
  }
  return out;
}

struct LineFeatures {
  std::array<int32_t, kPairs> parts{}, cover{}, first{}, last{};
};

LineFeatures lines_of(const OutlineCells& cells) {
  LineFeatures out;
  for (size_t p = 0; p < kPairs; ++p) {
    const RowShape a = shape_of(cells[2 * p]), b = shape_of(cells[2 * p + 1]);
    out.parts[p] = std::min(std::max(a.parts, b.parts), 4) * 63;
    out.first[p] = std::min(a.first, b.first) * 10;
    out.last[p] = std::max(a.last, b.last) * 10;
    for (size_t x = 0; x < kOutlineCells; ++x) out.cover[p] += cells[2 * p][x] + cells[2 * p + 1][x];
    out.cover[p] /= 2 * kOutlineCells;
  }
  return out;
}

// How many rows have a solid cell, 1 at least.
int32_t solid_rows(const OutlineCells& cells) {
  int32_t rows = 0;
  for (const auto& row : cells) rows += shape_of(row).parts > 0 ? 1 : 0;
  return std::max(rows, 1);
}

std::array<int32_t, 5> shape_features(const OutlineCells& cells) {
  int64_t total = 0, both = 0, either = 0;
  for (const auto& row : cells) {
    for (size_t x = 0; x < kOutlineCells; ++x) {
      const int32_t a = row[x], b = row[kOutlineCells - 1 - x];
      total += a;
      both += std::min(a, b);
      either += std::max(a, b);
    }
  }
  const int32_t wide = solid_rows(turned_cells(cells)), high = solid_rows(cells);
  return {wide * 10, high * 10, static_cast<int32_t>(total / (kOutlineCells * kOutlineCells)),
          static_cast<int32_t>(std::min<int64_t>(255, total / (wide * high))),
          static_cast<int32_t>(255 * both / std::max<int64_t>(either, 1))};
}

// Logits, Q10. Sums stay below 245 * 255 * 2^15.
#if defined(__EMSCRIPTEN__)
// A page loads all of a module's constants with its first part. What code writes comes with the part that has the code: 20 kB later.
constexpr uint64_t four_of_first(size_t from) {
  uint64_t out = 0;
  for (size_t i = 0; i < 4; ++i) out |= uint64_t{static_cast<uint16_t>(kOutlineFirst[from + i])} << (16 * i);
  return out;
}

template <uint64_t kFour>
char write_four(int16_t* to) {
  const uint64_t four = kFour;
  std::memcpy(to, &four, sizeof four);
  return 0;
}

template <size_t... kFour>
[[gnu::noinline]] void write_first(int16_t* to, std::index_sequence<kFour...> /*fours*/) {
  const char done[] = {write_four<four_of_first(4 * kFour)>(to + 4 * kFour)...};
  (void)done;
}

const int16_t* first_layer() {
  static int16_t weights[std::size(kOutlineFirst)];
  static const bool is_written = (write_first(weights, std::make_index_sequence<std::size(weights) / 4>()), true);
  (void)is_written;
  return weights;
}
#else
const int16_t* first_layer() { return kOutlineFirst; }
#endif

std::array<int64_t, kOutlineClasses> logits_of(const OutlineCells& cells) {
  const int16_t* const first = first_layer();
  const std::array<int32_t, kOutlineFeatures> x = outline_features(cells);
  std::array<int64_t, kOutlineClasses> out{};
  for (size_t k = 0; k < kOutlineClasses; ++k) out[k] = kOutlineSecondBias[k];
  for (size_t h = 0; h < kOutlineHidden; ++h) {
    int64_t sum = kOutlineFirstBias[h];
    for (size_t i = 0; i < kOutlineFeatures; ++i) sum += int64_t{x[i]} * first[i * kOutlineHidden + h];
    const int64_t value = std::max<int64_t>(sum, 0) >> 10;
    for (size_t k = 0; k < kOutlineClasses; ++k) out[k] += value * kOutlineSecond[h * kOutlineClasses + k];
  }
  for (int64_t& logit : out) logit >>= 10;
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

std::array<int32_t, kOutlineFeatures> outline_features(const OutlineCells& cells) {
  std::array<int32_t, kOutlineFeatures> out{};
  auto at = out.begin();
  const auto put = [&at](const auto& values) { at = std::copy(values.begin(), values.end(), at); };
  const LineFeatures rows = lines_of(cells), columns = lines_of(turned_cells(cells));
  put(rows.parts);
  put(columns.parts);
  put(rows.cover);
  put(columns.cover);
  put(rows.first);
  put(rows.last);
  put(columns.first);
  put(columns.last);
  put(shape_features(cells));
  for (size_t y = 0; y < kOutlineCells; y += 2)
    for (size_t x = 0; x < kOutlineCells; x += 2)
      *at++ = (cells[y][x] + cells[y][x + 1] + cells[y + 1][x] + cells[y + 1][x + 1]) / 4;
  return out;
}

BodyGuess class_of_outline(const Mask& mask) {
  const OutlineCells cells = outline_cells(mask);
  if (std::all_of(cells.begin(), cells.end(),
                  [](const auto& row) { return row == std::array<int32_t, kOutlineCells>{}; }))
    return {};
  std::array<int64_t, kOutlineClasses> logits = logits_of(cells);
  const std::array<int64_t, kOutlineClasses> other = logits_of(mirrored(cells));
  size_t best = 0;
  for (size_t k = 0; k < kOutlineClasses; ++k) {
    logits[k] += other[k];
    if (logits[k] > logits[best]) best = k;
  }
  double sum = 0;
  for (const int64_t logit : logits) sum += std::exp(static_cast<double>(logit - logits[best]) / 2048);
  return {static_cast<BodyClass>(best), static_cast<float>(1 / sum)};
}

}  // namespace sinew
