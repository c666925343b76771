// SPDX-License-Identifier: MIT
// Orientation of a mesh in the caller's axes, and its rotation to y up and front +z.
#ifndef SINEW_FRONT_TURN_HPP
#define SINEW_FRONT_TURN_HPP

#include "grid/caller_units.hpp"

namespace sinew::rigging {

// Where the front is, with y up: (sine, 0, cosine). Products and sums are doubles of one order, so the same everywhere.
struct Turn {
  uint32_t up_axis = 0;  // of the caller: 0 = y, 1 = z
  float sine = 0, cosine = 1;

  bool nothing() const { return sine == 0 && cosine > 0; }  // the front is +z
  // The rotation for a front in the caller's axes.
  static Turn of(const float* front, uint32_t up_axis);
  // From the caller's axes to y up and front +z, and back.
  void to(const float* from, double* out) const;
  void from(const double* from, float* out) const;
  void direction(float* out) const;  // of the front, the caller's axes
};

// A mesh with every position rotated; other arrays are the caller's.
//   positions  out  [V x 3]
sinew_mesh turn_mesh(const sinew_mesh& mesh, const Turn& turn, float* positions);

}  // namespace sinew::rigging
#endif
