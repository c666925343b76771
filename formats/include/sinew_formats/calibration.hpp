// SPDX-License-Identifier: MIT
// What the quantizer must know of a float network beside its checkpoint: the trainer measures it, quant reads it.
#ifndef SINEW_FORMATS_CALIBRATION_HPP
#define SINEW_FORMATS_CALIBRATION_HPP

#include <vector>

namespace sinew {

struct Calibration {
  std::vector<float> layer_max;  // [layers] largest absolute value in each layer's output region
};

}  // namespace sinew
#endif
