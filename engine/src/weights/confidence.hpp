// SPDX-License-Identifier: MIT
// The strongest joint's share of a prediction to a measured chance that it is the right joint (stage 9).
#ifndef SINEW_WEIGHTS_CONFIDENCE_HPP
#define SINEW_WEIGHTS_CONFIDENCE_HPP

#include "model/layout.hpp"
#include "sinew/sinew.h"

namespace sinew {

// share Q16 -> 0..255, linear between the entries of the model's table, level outside of them. Without a model or a
// table the share itself.
inline uint8_t calibrated_confidence(const sinew_model* model, uint32_t share_q16) {
  uint32_t value = share_q16 > 65535 ? 65535 : share_q16;
  if (model != nullptr && model->confidence_count > 0) {
    const uint8_t* entries = model->bytes + model->confidence_offset;
    uint32_t i = 0;
    while (i < model->confidence_count && load_u16(entries + 4 * i) <= value) ++i;
    const uint32_t last = model->confidence_count - 1;
    if (i == 0 || i > last) {
      value = load_u16(entries + 4 * (i == 0 ? 0 : last) + 2);
    } else {
      const uint32_t x0 = load_u16(entries + 4 * (i - 1)), x1 = load_u16(entries + 4 * i);
      const uint32_t y0 = load_u16(entries + 4 * (i - 1) + 2), y1 = load_u16(entries + 4 * i + 2);
      // (y1 - y0) * (value - x0) < 2^32: both factors are below 2^16.
      value = y0 + (y1 - y0) * (value - x0) / (x1 - x0);
    }
  }
  return static_cast<uint8_t>((value * 255u + 32767u) / 65535u);
}

}  // namespace sinew
#endif
