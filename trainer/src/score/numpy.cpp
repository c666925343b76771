// SPDX-License-Identifier: MIT
// SeedSequence, PCG64 and the ziggurat normal as numpy defines them. Two 64-bit halves represent a 128-bit word,
// because not every compiler has one. Rectangular assignment by shortest augmenting paths.
#include "score/numpy.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace sinew {
namespace {

// Where the base strip of the 256-layer ziggurat ends and the tail begins.
constexpr long double kTailStart = 3.6541528853610087963519472518L;

// Layer i reaches from the axis to x_i, where x_255 = kTailStart, every layer has the same area, and layer 0 is the
// base strip with the tail. A draw is 52 bits times `width`; below `inside` it needs no second look.
struct Ziggurat {
  std::array<uint64_t, 256> inside;
  std::array<double, 256> width;
  std::array<double, 256> height;

  Ziggurat() {
    constexpr long double two52 = 4503599627370496.0L;
    const auto density = [](long double x) { return std::exp(-x * x / 2); };
    const long double half_pi = 1.5707963267948966192313216916L;
    const long double tail_area = std::sqrt(half_pi) * std::erfc(kTailStart / std::sqrt(2.0L));
    const long double area = kTailStart * density(kTailStart) + tail_area;
    const long double base_width = area / density(kTailStart);
    inside[0] = static_cast<uint64_t>(kTailStart / base_width * two52);
    width[0] = static_cast<double>(base_width / two52);
    height[0] = 1;
    inside[1] = 0;
    long double x = kTailStart;
    for (size_t i = 255; i >= 1; --i) {
      width[i] = static_cast<double>(x / two52);
      height[i] = static_cast<double>(density(x));
      if (i == 1) break;
      const long double next = std::sqrt(-2 * std::log(area / x + density(x)));
      inside[i] = static_cast<uint64_t>(next / x * two52);
      x = next;
    }
  }
};

const Ziggurat& ziggurat() {
  static const Ziggurat tables;
  return tables;
}

// The hash of SeedSequence with its running constant.
struct SeedHash {
  uint32_t constant, multiplier;
  uint32_t operator()(uint32_t value) {
    value ^= constant;
    constant *= multiplier;
    value *= constant;
    return value ^ (value >> 16);
  }
};

uint32_t mix(uint32_t a, uint32_t b) {
  const uint32_t value = 0xca01f9ddu * a - 0x4973f715u * b;
  return value ^ (value >> 16);
}

std::array<uint64_t, 4> seed_words(uint64_t seed) {
  std::array<uint32_t, 4> pool = {static_cast<uint32_t>(seed), static_cast<uint32_t>(seed >> 32), 0, 0};
  SeedHash enter{0x43b0d7e5u, 0x931e8875u};
  for (uint32_t& word : pool) word = enter(word);
  for (size_t from = 0; from < pool.size(); ++from)
    for (size_t to = 0; to < pool.size(); ++to)
      if (from != to) pool[to] = mix(pool[to], enter(pool[from]));
  SeedHash leave{0x8b51f9ddu, 0x58f38dedu};
  std::array<uint64_t, 4> words{};
  for (size_t i = 0; i < 8; ++i) words[i / 2] |= static_cast<uint64_t>(leave(pool[i % 4])) << (32 * (i % 2));
  return words;
}

}  // namespace

NumpyRandom::Word128 NumpyRandom::add(Word128 a, Word128 b) {
  Word128 sum{a.high + b.high, a.low + b.low};
  sum.high += sum.low < a.low ? 1 : 0;
  return sum;
}

NumpyRandom::Word128 NumpyRandom::multiply(Word128 a, Word128 b) {
  const uint64_t a0 = a.low & 0xffffffffu, a1 = a.low >> 32, b0 = b.low & 0xffffffffu, b1 = b.low >> 32;
  const uint64_t middle = a1 * b0 + ((a0 * b0) >> 32);  // at most (2^32 - 1)^2 + 2^32 - 1 < 2^64
  const uint64_t other = a0 * b1 + (middle & 0xffffffffu);
  const uint64_t carry = a1 * b1 + (middle >> 32) + (other >> 32);
  return {carry + a.high * b.low + a.low * b.high, a.low * b.low};
}

void NumpyRandom::step() {
  constexpr Word128 multiplier{0x2360ed051fc65da4u, 0x4385df649fccf645u};
  state_ = add(multiply(state_, multiplier), increment_);
}

NumpyRandom::NumpyRandom(uint64_t seed) {
  const std::array<uint64_t, 4> words = seed_words(seed);
  increment_ = {(words[2] << 1) | (words[3] >> 63), (words[3] << 1) | 1u};
  step();
  state_ = add(state_, {words[0], words[1]});
  step();
}

uint64_t NumpyRandom::next_uint64() {
  step();
  return std::rotr(state_.high ^ state_.low, static_cast<int>(state_.high >> 58));
}

double NumpyRandom::next_double() { return static_cast<double>(next_uint64() >> 11) * (1.0 / 9007199254740992.0); }

double NumpyRandom::uniform(double low, double high) { return low + (high - low) * next_double(); }

double NumpyRandom::normal() {
  const Ziggurat& z = ziggurat();
  constexpr double tail_start = static_cast<double>(kTailStart);
  for (;;) {
    const uint64_t word = next_uint64();
    const size_t layer = word & 0xff;
    const bool negative = (word >> 8) & 1;
    const uint64_t bits = (word >> 9) & 0xfffffffffffffu;
    const double x = static_cast<double>(bits) * z.width[layer];
    if (bits < z.inside[layer]) return negative ? -x : x;
    if (layer == 0) {
      // Marsaglia's tail. numpy takes the tail's sign from another bit than the layers' sign.
      for (;;) {
        const double beyond = -(1 / tail_start) * std::log1p(-next_double());
        const double y = -std::log1p(-next_double());
        if (y + y > beyond * beyond) return (bits >> 8) & 1 ? -(tail_start + beyond) : tail_start + beyond;
      }
    }
    if ((z.height[layer - 1] - z.height[layer]) * next_double() + z.height[layer] < std::exp(-0.5 * x * x))
      return negative ? -x : x;
  }
}

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// At most as many rows as columns. Prices stay such that no reduced cost is negative and those of pairs are 0.
class Pairing {
 public:
  Pairing(const std::vector<double>& cost, size_t rows, size_t columns)
      : cost_(cost),
        row_prices_(rows, 0),
        column_prices_(columns, 0),
        column_of_(rows, -1),
        row_of_(columns, -1),
        before_(columns, -1) {
    for (size_t row = 0; row < rows; ++row) add(row);
  }

  std::vector<int> columns_of_rows() && { return std::move(column_of_); }
  std::vector<int> rows_of_columns() && { return std::move(row_of_); }

 private:
  // Finds the shortest path from the row to a free column, over pairs that it would change, and changes them.
  void add(size_t start) {
    const size_t columns = row_of_.size();
    std::vector<double> distance(columns, kFar);
    std::vector<size_t> reached_rows, reached_columns, open;
    // From the last to the first, and a column that is free before one that is not: the order settles ties.
    for (size_t column = columns; column-- > 0;) open.push_back(column);
    size_t row = start, end = columns;
    double reach = 0;
    while (end == columns) {
      reached_rows.push_back(row);
      size_t next = 0;
      double least = kFar;
      for (size_t k = 0; k < open.size(); ++k) {
        const size_t column = open[k];
        const double through = reach + cost_[row * columns + column] - row_prices_[row] - column_prices_[column];
        if (through < distance[column]) {
          distance[column] = through;
          before_[column] = static_cast<int>(row);
        }
        if (distance[column] < least || (distance[column] == least && row_of_[column] < 0)) {
          least = distance[column];
          next = k;
        }
      }
      reach = least;
      const size_t column = open[next];
      open[next] = open.back();
      open.pop_back();
      reached_columns.push_back(column);
      if (row_of_[column] < 0)
        end = column;
      else
        row = static_cast<size_t>(row_of_[column]);
    }
    for (const size_t reached : reached_rows)
      row_prices_[reached] += reached == start ? reach : reach - distance[static_cast<size_t>(column_of_[reached])];
    for (const size_t reached : reached_columns) column_prices_[reached] -= reach - distance[reached];
    for (int column = static_cast<int>(end); column >= 0;) {
      const int giver = before_[static_cast<size_t>(column)];
      row_of_[static_cast<size_t>(column)] = giver;
      std::swap(column_of_[static_cast<size_t>(giver)], column);
    }
  }

  const std::vector<double>& cost_;
  std::vector<double> row_prices_, column_prices_;
  std::vector<int> column_of_, row_of_;  // the pairs, -1 = none
  std::vector<int> before_;              // row from which the path came to a column
};

}  // namespace

std::vector<int> cheapest_pairs(const std::vector<double>& cost, size_t rows, size_t columns) {
  if (rows <= columns) return Pairing(cost, rows, columns).columns_of_rows();
  std::vector<double> turned(cost.size());
  for (size_t row = 0; row < rows; ++row)
    for (size_t column = 0; column < columns; ++column) turned[column * rows + row] = cost[row * columns + column];
  return Pairing(turned, columns, rows).rows_of_columns();
}

}  // namespace sinew
