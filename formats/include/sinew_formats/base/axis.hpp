// SPDX-License-Identifier: MIT
// An axis of the world. A mesh has y or z up; callers' other codes for it are converted in the C API, the command and the page.
#ifndef SINEW_FORMATS_BASE_AXIS_HPP
#define SINEW_FORMATS_BASE_AXIS_HPP

#include <cstdint>
#include <optional>

namespace sinew {

enum class Axis : uint8_t { kX, kY, kZ };

// An axis that may not be known.
using MaybeAxis = std::optional<Axis>;

// 0, 1, 2: the axis's index in x, y, z.
constexpr uint32_t axis_index(Axis axis) { return static_cast<uint32_t>(axis); }

}  // namespace sinew
#endif
