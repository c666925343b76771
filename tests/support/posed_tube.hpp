// SPDX-License-Identifier: MIT
// A bent tube in poses: corrected, skinned, and how far its edges and vertices go.
#ifndef SINEW_TESTS_SUPPORT_POSED_TUBE_HPP
#define SINEW_TESTS_SUPPORT_POSED_TUBE_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bent_tube.hpp"

namespace sinew_test {

struct Posed {
  std::vector<float> positions;
  sinew_deform_outputs outputs = {};
};

inline Posed pose(sinew::Deformer* deformer, const std::vector<float>& palette) {
  Posed posed;
  posed.positions.assign(size_t{3} * deformer->get().vertex_count, -77);
  posed.outputs = SINEW_INIT(sinew_deform_outputs);
  posed.outputs.positions = posed.positions.data();
  EXPECT_EQ(deformer->pose(palette.data(), &posed.outputs), SINEW_OK);
  return posed;
}
inline Posed pose(const BentTube& tube, const sinew_deform_options& options, const std::vector<float>& palette) {
  sinew::Deformer deformer;
  EXPECT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), options), SINEW_OK);
  return pose(&deformer, palette);
}
inline std::vector<float> skinned(const BentTube& tube, const std::vector<float>& palette, bool dual) {
  std::vector<float> out(tube.positions.size());
  const sinew_skin skin = tube.skin();
  EXPECT_EQ((dual ? sinew_skin_dual_quaternion : sinew_skin_linear)(
                tube.positions.data(), tube.vertex_count(), &skin, palette.data(),
                static_cast<uint32_t>(tube.parents.size()), out.data()),
            SINEW_OK);
  return out;
}
inline float farthest(const std::vector<float>& a, const std::vector<float>& b) {
  float most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

// Root mean square of how much longer or shorter edges are than at rest.
inline double stretch(const BentTube& tube, const std::vector<float>& at) {
  double sum = 0;
  const auto length = [&](const std::vector<float>& of, size_t a, size_t b) {
    return std::hypot(double{of[3 * a]} - of[3 * b], double{of[3 * a + 1]} - of[3 * b + 1],
                      double{of[3 * a + 2]} - of[3 * b + 2]);
  };
  for (size_t t = 0; t < tube.corners.size(); t += 3) {
    const size_t a = tube.corners[t], b = tube.corners[t + 1];
    const double off = length(at, a, b) / length(tube.positions, a, b) - 1;
    sum += off * off;
  }
  return std::sqrt(sum / (static_cast<double>(tube.corners.size()) / 3));
}

}  // namespace sinew_test
#endif
