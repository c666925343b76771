// SPDX-License-Identifier: MIT
// SeedSequence, PCG64 and the ziggurat normal as numpy defines them. Two 64-bit halves stand for a 128-bit word,
// because not every compiler has one.
#include "score/numpy_random.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

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

}  // namespace sinew
