// SPDX-License-Identifier: MIT
// Weights go back to the decimals of their files, rows are added in numpy's order.
#include "data/dense_rows.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// Files hold round decimals, so errors of exactly 0.5 and weights of exactly 1e-4 are common, and the last bit decides
// on which side of a threshold they fall. To fall where the yardstick's do, weights go back to the decimal that the
// float was read from, and rows are added in numpy's order. (Without this `bad` was off by up to 6e-4 on single
// characters.)
double decimal_value(float weight) {
  std::array<char, 32> text;
  const auto printed = std::to_chars(text.data(), text.data() + text.size(), weight);
  double value = 0;
  std::from_chars(text.data(), printed.ptr, value);
  return value;
}

}  // namespace

double numpy_sum(const double* values, size_t count) {
  double sum = 0;
  if (count < 8) {
    for (size_t i = 0; i < count; ++i) sum += values[i];
    return sum;
  }
  if (count > 128) {
    const size_t half = count / 2 - count / 2 % 8;
    return numpy_sum(values, half) + numpy_sum(values + half, count - half);
  }
  std::array<double, 8> lanes;
  std::copy_n(values, 8, lanes.begin());
  size_t i = 8;
  for (; i + 8 <= count; i += 8)
    for (size_t k = 0; k < 8; ++k) lanes[k] += values[i + k];
  sum = ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
  for (; i < count; ++i) sum += values[i];
  return sum;
}

DenseRows normalised_rows(const std::vector<std::vector<Influence>>& influences, size_t joint_count,
                          const std::string& name) {
  DenseRows rows(influences.size(), std::vector<double>(joint_count, 0.0));
  for (size_t v = 0; v < rows.size(); ++v) {
    for (const Influence& influence : influences[v]) {
      if (influence.joint >= joint_count) {
        throw Error(name + ": vertex " + std::to_string(v) + " has weight for joint " +
                    std::to_string(influence.joint) + ", but there are " + std::to_string(joint_count) + " joints");
      }
      if (!(influence.weight > 0)) continue;
      rows[v][influence.joint] += decimal_value(influence.weight);
    }
    const double sum = numpy_sum(rows[v].data(), joint_count);
    for (double& w : rows[v]) w = sum > 1e-12 ? w / sum : 0;
  }
  return rows;
}

}  // namespace sinew
