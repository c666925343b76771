// SPDX-License-Identifier: MIT
#include "gltf/spring_limits.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_formats/base/affine.hpp"

namespace sinew {
namespace {

using Json = nlohmann::json;

constexpr double kDegrees = 57.29577951308232;  // in a radian
constexpr double kLargest = 180;

// The axes of a limit before its own rotation: y along the bone, by the shortest arc. Its x and z in the node's axes.
struct LimitAxes {
  Point3 x, z;
};
LimitAxes axes_along(const Point3& bone) {
  const Point3 y = unit(bone);
  if (y[1] < -1 + 1e-9) return {{-1, 0, 0}, {0, 0, 1}};  // 180 degrees about z
  // The arc from +y is about (z, 0, -x).
  const double scale = 1 / (1 + y[1]);
  return {{1 - scale * y[0] * y[0], -y[0], -scale * y[0] * y[2]},
          {-scale * y[0] * y[2], -y[2], 1 - scale * y[2] * y[2]}};
}

}  // namespace

Json spring_limit_json(double limit, const Point3& hinge, const Point3& bone) {
  const Point3 y = unit(bone), axis = unit(hinge - dot(hinge, y) * y);
  const bool hinged = length(axis) > 0;
  if (!hinged && !(limit > 0)) return nullptr;
  Json shape = {{"angle", (limit > 0 ? limit : kLargest) / kDegrees}};
  if (hinged) {  // about its y until its x is the axis
    const LimitAxes axes = axes_along(bone);
    const double half = 0.5 * std::atan2(-dot(axis, axes.z), dot(axis, axes.x));
    shape["rotation"] = {0, std::sin(half), 0, std::cos(half)};
  }
  return {{"specVersion", "1.0-draft"}, {"limit", {{hinged ? "hinge" : "cone", shape}}}};
}

SpringLimit read_spring_limit(const Json& extension, const Point3& bone) {
  SpringLimit out;
  const Json& limit = extension.at("limit");
  const bool hinged = limit.contains("hinge");
  if (!hinged && !limit.contains("cone")) {
    out.known = false;
    return out;
  }
  const Json& shape = limit.at(hinged ? "hinge" : "cone");
  out.limit = std::clamp(shape.value("angle", 0.0) * kDegrees, 0.0, kLargest);
  if (hinged && out.limit == kLargest) out.limit = 0;
  if (!hinged) return out;
  const std::array<double, 4> q = shape.value("rotation", std::array<double, 4>{0, 0, 0, 1});
  const LimitAxes axes = axes_along(bone);
  const Point3 y = unit(bone);
  // The first column of the rotation, in the limit's axes.
  const Point3 x = {1 - 2 * (q[1] * q[1] + q[2] * q[2]), 2 * (q[0] * q[1] + q[2] * q[3]),
                    2 * (q[0] * q[2] - q[1] * q[3])};
  out.hinge = x[0] * axes.x + x[1] * y + x[2] * axes.z;
  return out;
}

}  // namespace sinew
