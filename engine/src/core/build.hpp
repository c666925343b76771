// SPDX-License-Identifier: MIT
// What a build has beside the bind itself. -DSINEW_SMALL_CODE=ON leaves it out, for microcontrollers: spectral features
// (a model that asks for them is refused as of an unknown version), hints, symmetry and rigid_parts
// (SINEW_ERROR_ARGUMENT). What is left gives the same bytes.
#ifndef SINEW_CORE_BUILD_HPP
#define SINEW_CORE_BUILD_HPP

namespace sinew {

#if defined(SINEW_SMALL_CODE)
constexpr bool kHasExtras = false;
#else
constexpr bool kHasExtras = true;
#endif

}  // namespace sinew
#endif
