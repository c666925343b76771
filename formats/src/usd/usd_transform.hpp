// SPDX-License-Identifier: MIT
// Transforms of prims (UsdGeomXformable), and matrices as USD's text has them.
#ifndef SINEW_FORMATS_USD_USD_TRANSFORM_HPP
#define SINEW_FORMATS_USD_USD_TRANSFORM_HPP

#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "usd/usd_parse.hpp"

namespace sinew {

// The matrix whose 16 numbers begin at `at`: rows of one that multiplies from the right.
Affine usd_affine(const std::vector<double>& numbers, size_t at);

// All matrices of an array. Throws Error naming `where` for another count than `count`, and for numbers that are not finite.
std::vector<Affine> usd_affines(const std::string& where, const UsdValue& value, size_t count);

struct UsdTransform {
  Affine local = kIdentity;
  bool resets = false;    // it does not hang on what is above
  bool animated = false;  // of the first sample then
};

// Throws Error naming `where` for an operation that it does not know, and for numbers that are none of it.
UsdTransform usd_transform(const std::string& where, const UsdPrim& prim);

}  // namespace sinew
#endif
