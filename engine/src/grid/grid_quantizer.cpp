// SPDX-License-Identifier: MIT
// Exact float-to-grid conversion: a 64-bit quotient with an error bound decides nearly always, a 320-bit division the
// rest.
#include "grid/grid_quantizer.hpp"

#include <string.h>

#include "core/build.hpp"
#include "core/vector_math.hpp"

namespace sinew {
namespace {

constexpr int kLimbs = 5;
constexpr uint32_t kSignBit = 0x80000000u;
constexpr uint32_t kExponentMask = 0x7F800000u;
constexpr int kShortSideBits = 36;
constexpr int kClampBits = 22;

uint32_t word_of(const float* value) {
  uint32_t word;
  memcpy(&word, value, sizeof(word));
  return word;
}

// Orders finite floats like their values; -0 equals 0.
int32_t order_key(uint32_t word) {
  const int32_t magnitude = static_cast<int32_t>(word & ~kSignBit);
  return (word & kSignBit) != 0 ? -magnitude : magnitude;
}
uint32_t word_of_key(int32_t key) {
  return key < 0 ? kSignBit | static_cast<uint32_t>(-key) : static_cast<uint32_t>(key);
}

// value = mantissa * 2^(exponent - 149), exponent 0..253, |mantissa| < 2^24.
void decode(uint32_t word, int64_t* mantissa, int* exponent) {
  const int field = static_cast<int>((word & kExponentMask) >> 23);
  const int64_t fraction = static_cast<int64_t>(word & 0x007FFFFFu) | (field != 0 ? 0x00800000 : 0);
  *mantissa = (word & kSignBit) != 0 ? -fraction : fraction;
  *exponent = field != 0 ? field - 1 : 0;
}

WideInt wide_zero() { return {{0, 0, 0, 0, 0}}; }
bool is_negative(const WideInt& a) { return (a.limb[kLimbs - 1] >> 63) != 0; }

WideInt add(const WideInt& a, const WideInt& b) {
  WideInt out;
  uint64_t carry = 0;
  for (int i = 0; i < kLimbs; ++i) {
    const uint64_t partial = a.limb[i] + carry;
    const uint64_t overflow = partial < carry ? 1u : 0u;
    out.limb[i] = partial + b.limb[i];
    carry = overflow + (out.limb[i] < partial ? 1u : 0u);
  }
  return out;
}

WideInt subtract(const WideInt& a, const WideInt& b) {
  WideInt out;
  uint64_t borrow = 0;
  for (int i = 0; i < kLimbs; ++i) {
    const uint64_t partial = a.limb[i] - b.limb[i];
    const uint64_t under = a.limb[i] < b.limb[i] ? 1u : 0u;
    out.limb[i] = partial - borrow;
    borrow = under + (partial < borrow ? 1u : 0u);
  }
  return out;
}

WideInt shift_left(const WideInt& a, int bits) {
  WideInt out = wide_zero();
  const int limbs = bits / 64, rest = bits % 64;
  for (int i = kLimbs - 1; i >= limbs; --i) {
    out.limb[i] = a.limb[i - limbs] << rest;
    if (rest != 0 && i > limbs) out.limb[i] |= a.limb[i - limbs - 1] >> (64 - rest);
  }
  return out;
}

WideInt half(const WideInt& a) {  // a >= 0
  WideInt out;
  for (int i = 0; i < kLimbs; ++i) out.limb[i] = (a.limb[i] >> 1) | (i + 1 < kLimbs ? a.limb[i + 1] << 63 : 0);
  return out;
}

int bit_length(const WideInt& a) {  // a >= 0
  for (int i = kLimbs - 1; i >= 0; --i) {
    if (a.limb[i] == 0) continue;
    int bits = 0;
    for (uint64_t t = a.limb[i]; t != 0; t >>= 1) ++bits;
    return 64 * i + bits;
  }
  return 0;
}

WideInt wide_of(uint32_t word) {
  int64_t mantissa;
  int exponent;
  decode(word, &mantissa, &exponent);
  WideInt magnitude = wide_zero();
  magnitude.limb[0] = static_cast<uint64_t>(abs64(mantissa));
  magnitude = shift_left(magnitude, exponent);
  return mantissa < 0 ? subtract(wide_zero(), magnitude) : magnitude;
}

// floor(value / 2^(unit - 149)). False when it needs more than 60 bits. **exact becomes false when bits were cut off.
bool short_of(uint32_t word, int unit, int64_t* out, bool* exact) {
  int64_t mantissa;
  int exponent;
  decode(word, &mantissa, &exponent);
  const int shift = exponent - unit;
  if (shift > 36) {
    *out = 0;
    return mantissa == 0;
  }
  if (shift >= 0) {
    *out = mantissa * (static_cast<int64_t>(1) << shift);
    return true;
  }
  const int cut = -shift < 32 ? -shift : 32;
  *out = mantissa >> cut;
  if ((*out * (static_cast<int64_t>(1) << cut)) != mantissa) *exact = false;
  return true;
}

// The definition, in 320 bits: restoring division, one quotient bit a step.
int32_t quantize_long(const GridQuantizer& quantizer, uint32_t word, int axis) {
  const WideInt twice_value = shift_left(wide_of(word), 1);
  const WideInt centered = shift_left(subtract(twice_value, quantizer.sum[axis]), kGridBits);
  // + side is the half of the rounding; + 2^22 * (2 side) makes every value inside the clamp non-negative.
  WideInt rest = add(add(centered, quantizer.side), shift_left(quantizer.side, kClampBits + 1));
  if (is_negative(rest)) return -(1 << kClampBits);
  WideInt divisor = shift_left(quantizer.side, kClampBits + 2);
  if (!is_negative(subtract(rest, divisor))) return 1 << kClampBits;
  int32_t quotient = 0;
  for (int bit = kClampBits; bit >= 0; --bit) {
    divisor = half(divisor);
    const WideInt next = subtract(rest, divisor);
    if (is_negative(next)) continue;
    rest = next;
    quotient |= 1 << bit;
  }
  return quotient - (1 << kClampBits);
}

int32_t quantize_value(const GridQuantizer& quantizer, uint32_t word, int axis) {
  int64_t value = 0;
  bool exact = !kSmallCode && quantizer.short_exact[axis];  // not filled for small code
  if (!kSmallCode && quantizer.short_ok[axis] && short_of(word, quantizer.unit, &value, &exact)) {
    const int64_t centered = 2 * value - quantizer.short_sum[axis];  // below 2^62 + 2^61
    if (abs64(centered) <= static_cast<int64_t>(1) << 39) {
      // Flooring moved the numerator by less than 2^21 + 1 and, through the side, by less than 2 |quotient| <= 2^25
      // (|quotient| < 2^24). A remainder farther than 2^26 from both ends therefore proves the quotient.
      const int64_t numerator = centered * (1 << kGridBits) + quantizer.short_side;
      const int64_t divisor = 2 * quantizer.short_side;
      const int64_t quotient = floor_div(numerator, divisor);
      const int64_t rest = numerator - quotient * divisor;
      const int64_t margin = static_cast<int64_t>(1) << 26;
      if (exact || (rest >= margin && rest < divisor - margin)) {
        return clamp32(quotient, -(1 << kClampBits), 1 << kClampBits);
      }
    }
  }
  return quantize_long(quantizer, word, axis);
}

void turn_up(const float* position, uint32_t up_axis, uint32_t* words) {
  words[0] = word_of(position);
  if (up_axis == 0) {
    words[1] = word_of(position + 1);
    words[2] = word_of(position + 2);
  } else {
    words[1] = word_of(position + 2);
    words[2] = word_of(position + 1) ^ kSignBit;
  }
}

}  // namespace

bool is_finite_point(const float* position) {
  for (int axis = 0; axis < 3; ++axis) {
    if ((word_of(position + axis) & kExponentMask) == kExponentMask) return false;
  }
  return true;
}

sinew_status make_grid_quantizer(const float* positions, size_t count, uint32_t up_axis, GridQuantizer* quantizer) {
  int32_t low[3] = {INT32_MAX, INT32_MAX, INT32_MAX};
  int32_t high[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
  for (size_t i = 0; i < count; ++i) {
    if (!is_finite_point(positions + 3 * i)) return SINEW_ERROR_NOT_FINITE;
    uint32_t words[3];
    turn_up(positions + 3 * i, up_axis, words);
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t key = order_key(words[axis]);
      if (key < low[axis]) low[axis] = key;
      if (key > high[axis]) high[axis] = key;
    }
  }
  GridQuantizer& q = *quantizer;
  q.up_axis = up_axis;
  q.side = wide_zero();
  for (int axis = 0; axis < 3; ++axis) {
    const WideInt low_wide = wide_of(word_of_key(low[axis]));
    const WideInt high_wide = wide_of(word_of_key(high[axis]));
    const WideInt extent = subtract(high_wide, low_wide);
    if (is_negative(subtract(q.side, extent))) q.side = extent;
    q.sum[axis] = add(low_wide, axis == 1 ? low_wide : high_wide);
  }
  int side_bits = bit_length(q.side);
  if (side_bits == 0) {
    q.side = wide_of(0x3F800000u);  // 1.0
    side_bits = bit_length(q.side);
  }
  if (kSmallCode) return SINEW_OK;  // the definition alone: an eighth more instructions a bind, 0.8 KB less
  q.unit = side_bits - kShortSideBits;
  WideInt shortened = q.unit < 0 ? shift_left(q.side, -q.unit) : q.side;
  bool side_exact = true;
  for (int i = 0; i < q.unit; ++i) {
    if ((shortened.limb[0] & 1u) != 0) side_exact = false;
    shortened = half(shortened);
  }
  q.short_side = static_cast<int64_t>(shortened.limb[0]);
  for (int axis = 0; axis < 3; ++axis) {
    int64_t low_short = 0, high_short = 0;
    q.short_exact[axis] = side_exact;
    q.short_ok[axis] = short_of(word_of_key(low[axis]), q.unit, &low_short, &q.short_exact[axis]);
    q.short_ok[axis] =
        short_of(word_of_key(axis == 1 ? low[axis] : high[axis]), q.unit, &high_short, &q.short_exact[axis]) &&
        q.short_ok[axis];
    q.short_sum[axis] = low_short + high_short;
  }
  return SINEW_OK;
}

Vec3i quantize_point(const GridQuantizer& quantizer, const float* position) {
  uint32_t words[3];
  turn_up(position, quantizer.up_axis, words);
  return {quantize_value(quantizer, words[0], 0), quantize_value(quantizer, words[1], 1),
          quantize_value(quantizer, words[2], 2)};
}

}  // namespace sinew
