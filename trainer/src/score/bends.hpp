// SPDX-License-Identifier: MIT
// The bends that the report's pictures show: which joint, about which axis, how far and from which side; and a dressed character
// taken apart, the body and the cloth that lies around it, with the bends under cloth.
#ifndef SINEW_SCORE_BENDS_HPP
#define SINEW_SCORE_BENDS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/vec3d.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// The view of a class of joints.
struct Bend {
  uint32_t joint_class;
  const char* what;  // as "elbow, bent by"
  double degrees;
  bool twist;      // about the bone before it
  bool upwards;    // as arms are raised, in the plane that the front view shows; else to the front
  bool backwards;  // as knees bend
  double aside;    // rotation of the view from the axis to the front, degrees
};
const std::vector<Bend>& report_bends();

// The joint of the bend's class that has most weight and, unless it is twisted, a bone of its own; SIZE_MAX without any.
size_t bent_joint(const Character& character, const LabeledSkeleton& labels, const Bend& bend);

// From a joint to its children, their directions added up; unit length, or zero for a leaf.
Vec3d bone_direction(const Character& character, size_t joint);

// "elbow, bent by 130 degrees"
std::string bend_text(const Bend& bend, double degrees);

// One joint rotated by this many degrees with its descendants, and the view that shows the rotation, `radius` of the
// longest side around the joint: from the front if the rotation is in that plane, else from the joint's side, so that
// the body does not hide it.
struct BentView {
  std::vector<Affine> palette;  // [J]
  RenderOptions view;
};
BentView bent_view(const Character& character, size_t joint, const Bend& bend, double degrees, Axis up, float radius,
                   int side);

struct Dressed {
  Character body, garment;  // both with the joints of the whole; the body with its weights, the garment without
  std::vector<std::pair<const Bend*, size_t>> bends;  // those of report_bends() that lie under cloth, and their joints
};

// A connected part is cloth when at some bend it lies around a part that lies around the bone: rays from the bone, across it, all meet
// both, and it farther away. What is not cloth is the body. nullopt when there is no cloth, no weights, or no joint that names tell.
std::optional<Dressed> take_apart(const Character& character);

}  // namespace sinew
#endif
