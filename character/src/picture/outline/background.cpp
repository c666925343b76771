// SPDX-License-Identifier: MIT
// Models the background of a picture: a smooth color with ruled lines, or a few flat colors.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "picture/outline/foreground.hpp"

namespace sinew::picture {
namespace {

using Basis = std::array<double, 6>;

Basis basis_at(double x, double y) { return {1, x, y, x * x, x * y, y * y}; }

// Gaussian elimination with the largest pivot; a direction that the samples do not show stays 0.
Basis solved(std::array<std::array<double, 7>, 6> m) {
  for (size_t c = 0; c < 6; ++c) {
    size_t best = c;
    for (size_t r = c + 1; r < 6; ++r)
      if (std::abs(m[r][c]) > std::abs(m[best][c])) best = r;
    std::swap(m[c], m[best]);
    if (std::abs(m[c][c]) < 1e-9) continue;
    for (size_t r = 0; r < 6; ++r) {
      if (r == c) continue;
      const double f = m[r][c] / m[c][c];
      for (size_t k = c; k < 7; ++k) m[r][k] -= f * m[c][k];
    }
  }
  Basis out{};
  for (size_t c = 0; c < 6; ++c) out[c] = std::abs(m[c][c]) < 1e-9 ? 0 : m[c][6] / m[c][c];
  return out;
}

float middle_of(std::vector<float>* values) {
  const auto at = values->begin() + static_cast<std::ptrdiff_t>(values->size() / 2);
  std::nth_element(values->begin(), at, values->end());
  return *at;
}

// The value that a share of all is not above.
float value_at(std::vector<float> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// A color that leaves no smooth surface by more than this in 4 of 5 samples is one of several.
constexpr float kOneColor = 9;
constexpr float kFlatTolerance = 9;
constexpr float kLeastTolerance = 5, kMostTolerance = 14;

}  // namespace

float length(const Lab& d) { return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]); }

Background::Background(const Grid<Lab>& colors, const std::vector<uint32_t>& samples)
    : width_(colors.width), height_(colors.height), rows_(colors.height), columns_(colors.width) {
  fit_surface(colors, samples);
  fit_lines(colors, samples);
  std::vector<float> off_by, of_light;
  for (size_t k = 0; k < samples.size(); k += std::max<size_t>(1, samples.size() / 50000)) {
    const uint32_t i = samples[k];
    const Lab d = off(i % width_, i / width_, colors.values[i]);
    off_by.push_back(length(d));
    of_light.push_back(std::abs(d[0]));
  }
  noise_ = 1.48f * middle_of(&of_light);
  tolerance_ = std::clamp(2 + 1.3f * value_at(off_by, 0.9), kLeastTolerance, kMostTolerance);
  if (value_at(off_by, 0.8) > kOneColor) fit_flats(colors, samples);
}

// Robust: a sample counts the less the farther off it was the last time (Cauchy's weights).
void Background::fit_surface(const Grid<Lab>& colors, const std::vector<uint32_t>& samples) {
  const size_t stride = std::max<size_t>(1, samples.size() / 20000);
  for (size_t c = 0; c < 3; ++c) {
    std::vector<float> values;
    for (size_t k = 0; k < samples.size(); k += stride) values.push_back(colors.values[samples[k]][c]);
    surface_[c] = {static_cast<double>(middle_of(&values)), 0, 0, 0, 0, 0};
  }
  for (int round = 0; round < 6; ++round) {
    std::array<std::array<std::array<double, 7>, 6>, 3> sums{};
    const double scale = round < 3 ? 6 : 3;
    for (size_t k = 0; k < samples.size(); k += stride) {
      const uint32_t x = samples[k] % width_, y = samples[k] / width_;
      const Lab& color = colors.values[samples[k]];
      const Lab expected = surface_at(x, y);
      const double d =
          static_cast<double>(length({color[0] - expected[0], color[1] - expected[1], color[2] - expected[2]}));
      const double weight = 1 / (1 + d * d / (scale * scale));
      const Basis b = basis_at(double{1} * x / width_, double{1} * y / height_);
      for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < 6; ++i) {
          for (size_t j = 0; j < 6; ++j) sums[c][i][j] += weight * b[i] * b[j];
          sums[c][i][6] += weight * b[i] * static_cast<double>(color[c]);
        }
    }
    for (size_t c = 0; c < 3; ++c) surface_[c] = solved(sums[c]);
  }
}

// A row that is off by the same on both sides of the picture has a line; so has a column.
void Background::fit_lines(const Grid<Lab>& colors, const std::vector<uint32_t>& samples) {
  constexpr size_t kLeastSamples = 4;
  constexpr float kLeastLine = 2.5f;
  for (const bool rows : {true, false}) {
    std::vector<Lab>& lines = rows ? rows_ : columns_;
    const uint32_t across = rows ? width_ : height_;
    std::vector<std::vector<uint32_t>> of(lines.size());
    for (const uint32_t i : samples) of[rows ? i / width_ : i % width_].push_back(i);
    std::vector<Lab> found(lines.size());
    for (size_t line = 0; line < lines.size(); ++line) {
      std::array<Lab, 2> halves{};
      bool both = true;
      for (size_t half = 0; half < 2 && both; ++half) {
        std::array<std::vector<float>, 3> values;
        for (const uint32_t i : of[line]) {
          const uint32_t x = i % width_, y = i / width_;
          if (((rows ? x : y) * 2 >= across) != (half == 1)) continue;
          const Lab d = off(x, y, colors.values[i]);
          for (size_t c = 0; c < 3; ++c) values[c].push_back(d[c]);
        }
        both = values[0].size() >= kLeastSamples;
        for (size_t c = 0; c < 3 && both; ++c) halves[half][c] = middle_of(&values[c]);
      }
      if (!both) continue;
      const Lab mean = {0.5f * (halves[0][0] + halves[1][0]), 0.5f * (halves[0][1] + halves[1][1]),
                        0.5f * (halves[0][2] + halves[1][2])};
      const float apart =
          length({halves[0][0] - halves[1][0], halves[0][1] - halves[1][1], halves[0][2] - halves[1][2]});
      if (length(mean) >= kLeastLine && apart < 0.5f * length(mean)) found[line] = mean;
    }
    lines = std::move(found);
  }
}

// The commonest colors of the samples, in cells of 6 units, each with its neighbors taken away.
void Background::fit_flats(const Grid<Lab>& colors, const std::vector<uint32_t>& samples) {
  constexpr float kCell = 6;
  constexpr size_t kMostFlats = 8;
  struct Cell {
    size_t count = 0;
    std::array<double, 3> sum{};
  };
  std::map<std::array<int, 3>, Cell> cells;
  for (const uint32_t i : samples) {
    const Lab& color = colors.values[i];
    std::array<int, 3> key{};
    for (size_t c = 0; c < 3; ++c) key[c] = static_cast<int>(std::floor(color[c] / kCell));
    Cell& cell = cells[key];
    ++cell.count;
    for (size_t c = 0; c < 3; ++c) cell.sum[c] += static_cast<double>(color[c]);
  }
  while (flats_.size() < kMostFlats) {
    const Cell* best = nullptr;
    for (const auto& [key, cell] : cells)
      if (best == nullptr || cell.count > best->count) best = &cell;
    if (best == nullptr || best->count * 50 < samples.size()) break;
    Lab flat{};
    for (size_t c = 0; c < 3; ++c) flat[c] = static_cast<float>(best->sum[c] / static_cast<double>(best->count));
    flats_.push_back(flat);
    std::erase_if(cells, [&](const auto& entry) {
      for (size_t c = 0; c < 3; ++c)
        if (std::abs(entry.first[c] - static_cast<int>(std::floor(flat[c] / kCell))) > 1) return false;
      return true;
    });
  }
  if (!flats_.empty()) tolerance_ = kFlatTolerance;
}

Lab Background::surface_at(uint32_t x, uint32_t y) const {
  const Basis b = basis_at(double{1} * x / width_, double{1} * y / height_);
  Lab out{};
  for (size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (size_t i = 0; i < 6; ++i) sum += surface_[c][i] * b[i];
    out[c] = static_cast<float>(sum);
  }
  return out;
}

Lab Background::off(uint32_t x, uint32_t y, const Lab& color) const {
  if (flats_.empty()) {
    const Lab from = surface_at(x, y);
    Lab out{};
    for (size_t c = 0; c < 3; ++c) out[c] = color[c] - from[c] - rows_[y][c] - columns_[x][c];
    return out;
  }
  Lab best{};
  float least = 1e30f;
  for (const Lab& flat : flats_) {
    const Lab d = {color[0] - flat[0], color[1] - flat[1], color[2] - flat[2]};
    if (const float l = length(d); l < least) least = l, best = d;
  }
  return best;
}

}  // namespace sinew::picture
