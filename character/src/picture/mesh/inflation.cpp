// SPDX-License-Identifier: MIT
#include "picture/mesh/inflation.hpp"

#include <algorithm>
#include <cmath>

namespace sinew::picture {

// A ball about q with radius d(q), the distance to the outline, is sqrt(d(q)^2 - |p - q|^2) high at p: the largest of these is one more spread of
// parabolas, of -d^2. A limb of any width has a round cross-section.
Inflation inflate(const Mask& mask) {
  Inflation out = {squared_distance(mask, true), {}};
  out.height = out.depth;
  for (float& v : out.height.values) v = v > 0 ? -v : kFar;
  spread_parabolas(&out.height);
  for (size_t i = 0; i < mask.inside.size(); ++i) {
    const bool in = mask.inside[i] != 0;
    out.height.values[i] = in ? std::sqrt(std::max(0.0f, -out.height.values[i])) : 0;
    out.depth.values[i] = in ? std::sqrt(out.depth.values[i]) : 0;
  }
  return out;
}

}  // namespace sinew::picture
