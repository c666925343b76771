// SPDX-License-Identifier: MIT
// The calls of sinew/deform.h behind their argument checks.
#ifndef SINEW_DEFORM_DEFORMER_HPP
#define SINEW_DEFORM_DEFORMER_HPP

#include "deform/rest.hpp"

namespace sinew::deform {

// As in sinew/deform.h; pointers were checked for null. With a measuring arena the deformer is not written.
sinew_status create_deformer(const RestInput& input, Arena& arena, sinew_deformer* deformer);
sinew_status pose_deformer(const DeformRest& rest, const float* palette, Arena& arena, sinew_deform_outputs* outputs);

}  // namespace sinew::deform
#endif
