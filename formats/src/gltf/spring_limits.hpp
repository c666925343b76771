// SPDX-License-Identifier: MIT
// VRMC_springBone_limit 1.0-draft (vrm-specification, pull request 496): cones and hinges of joints that swing.
#ifndef SINEW_FORMATS_GLTF_SPRING_LIMITS_HPP
#define SINEW_FORMATS_GLTF_SPRING_LIMITS_HPP

#include <nlohmann/json.hpp>

#include "sinew_formats/springs.hpp"

namespace sinew {

constexpr const char* kSpringLimit = "VRMC_springBone_limit";

// The extension's object for a joint with a limit or a hinge; null for one that has neither.
//   bone   from the joint to its tail, in the node's axes
//   hinge  in the node's axes
nlohmann::json spring_limit_json(double limit, const Point3& hinge, const Point3& bone);

struct SpringLimit {
  double limit = 0;   // degrees; 0: none
  Point3 hinge = {};  // in the node's axes
  bool known = true;  // false: a limit that is neither a cone nor a hinge
};
// Reads the extension's object. Throws nlohmann::json::exception where it is broken.
SpringLimit read_spring_limit(const nlohmann::json& extension, const Point3& bone);

}  // namespace sinew
#endif
