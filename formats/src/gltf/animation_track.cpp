// SPDX-License-Identifier: MIT
// One sampler of a glTF animation: read, and its value at any time.
#include "gltf/animation_track.hpp"

#include <algorithm>

#include "gltf/gltf_model.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {

std::array<double, 4> Track::sample(double seconds) const {
  const auto above = std::upper_bound(times.begin(), times.end(), seconds,
                                      [](double t, float key) { return t < static_cast<double>(key); });
  const size_t next = static_cast<size_t>(above - times.begin());
  if (next == 0) return key(0);
  if (next == times.size() || blend == Blend::kStep) return key(next - 1);
  const size_t k = next - 1;
  const double from = static_cast<double>(times[k]), span = static_cast<double>(times[next]) - from;
  const double t = (seconds - from) / span;
  if (blend == Blend::kLinear && width == 4) return slerp(normalized(key(k)), normalized(key(next)), t);
  std::array<double, 4> out{};
  for (size_t i = 0; i < width; ++i) {
    if (blend == Blend::kLinear) {
      out[i] = at(k, 1, i) + t * (at(next, 1, i) - at(k, 1, i));
      continue;
    }
    const double t2 = t * t, t3 = t2 * t;  // Hermite, as the specification's appendix C has it
    out[i] = (2 * t3 - 3 * t2 + 1) * at(k, 1, i) + span * (t3 - 2 * t2 + t) * at(k, 2, i) +
             (3 * t2 - 2 * t3) * at(next, 1, i) + span * (t3 - t2) * at(next, 0, i);
  }
  return out;
}
std::array<double, 4> Track::key(size_t k) const {
  std::array<double, 4> out{};
  for (size_t i = 0; i < width && i < 4; ++i) out[i] = at(k, 1, i);
  return out;
}

Track read_track(const std::string& where, const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler,
                 size_t width) {
  Track made;
  made.width = width;
  if (sampler.interpolation == "STEP")
    made.blend = Blend::kStep;
  else if (sampler.interpolation == "CUBICSPLINE")
    made.blend = Blend::kCubic;
  else if (!sampler.interpolation.empty() && sampler.interpolation != "LINEAR")
    throw Error(where + ": expected LINEAR, STEP or CUBICSPLINE, found " + in_quotes(sampler.interpolation));
  made.times = accessor_floats(where + ", times", model, sampler.input, 1);
  made.values = accessor_floats(where + ", values", model, sampler.output, static_cast<int>(width));
  const size_t rows = made.times.size() * (made.blend == Blend::kCubic ? 3 : 1);
  if (made.times.empty() || made.values.size() != rows * width)
    throw Error(where + ": expected " + std::to_string(rows) + " values for " + std::to_string(made.times.size()) +
                " keys, found " + std::to_string(made.values.size() / width));
  for (size_t k = 0; k < made.times.size(); ++k)
    if (made.times[k] < 0 || (k > 0 && !(made.times[k] >= made.times[k - 1])))
      throw Error(where + ": expected ascending times from 0, found another order at key " + std::to_string(k));
  return made;
}

}  // namespace sinew
