// SPDX-License-Identifier: MIT
// Bends under cloth with weights that know no body and with those that do, for the report.
#ifndef SINEW_TRAINER_GARMENT_PICTURES_HPP
#define SINEW_TRAINER_GARMENT_PICTURES_HPP

#include <cstddef>

#include "sinew/sinew.h"
#include "sinew_formats/base/box.hpp"
#include "sinew_trainer/report.hpp"

namespace sinew {

// How much there is to see. Cloth is a part of the mesh of its own that lies around another part and the bone.
struct Clothing {
  size_t bends = 0;      // of the report's elbow, knee, hip and shoulder those under cloth; 0 when nothing is dressed
  size_t crossings = 0;  // pairs of triangles of cloth and skin that cross at rest
};
Clothing measure_clothing(const Character& character);

// Four panels a bend: the cloth bound alone, with the weights of the body's nearest points, as a transfer to a garment gives them, and
// these with the volume of body and cloth kept. The body has the weights of `character`. Each caption counts the pairs of triangles of
// cloth and skin that cross and did not at rest. No panels when nothing lies under cloth.
//   model  for the binds; null: by heat
ReportPicture garment_pictures(const Character& character, const sinew_model* model, Axis up = Axis::kY,
                               int side = 300);

}  // namespace sinew
#endif
