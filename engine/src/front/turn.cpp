// SPDX-License-Identifier: MIT
// Rotation about the upright axis, point by point.
#include "front/turn.hpp"

namespace sinew::rigging {

Turn Turn::of(const float* front, uint32_t up_axis) {
  Turn turn;
  turn.up_axis = up_axis;
  turn.sine = front[0];
  turn.cosine = up_axis == 0 ? front[2] : -front[1];
  return turn;
}

void Turn::to(const float* from, double* out) const {
  const double x = Units::along(from, up_axis, 0), z = Units::along(from, up_axis, 2);
  const double s = static_cast<double>(sine), c = static_cast<double>(cosine);
  out[0] = c * x - s * z;
  out[1] = Units::along(from, up_axis, 1);
  out[2] = s * x + c * z;
}

void Turn::from(const double* from, float* out) const {
  const double s = static_cast<double>(sine), c = static_cast<double>(cosine);
  const double x = c * from[0] + s * from[2], z = c * from[2] - s * from[0];
  out[0] = to_float(x);
  out[1] = to_float(up_axis == 0 ? from[1] : -z);
  out[2] = to_float(up_axis == 0 ? z : from[1]);
}

void Turn::direction(float* out) const {
  out[0] = sine;
  out[1] = up_axis == 0 ? 0 : -cosine;
  out[2] = up_axis == 0 ? cosine : 0;
}

sinew_mesh turn_mesh(const sinew_mesh& mesh, const Turn& turn, float* positions) {
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    double at[3];
    turn.to(mesh.positions + size_t{3} * v, at);
    for (int axis = 0; axis < 3; ++axis) positions[size_t{3} * v + static_cast<size_t>(axis)] = to_float(at[axis]);
  }
  sinew_mesh turned = mesh;
  turned.positions = positions;
  return turned;
}

}  // namespace sinew::rigging
