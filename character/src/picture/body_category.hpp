// SPDX-License-Identifier: MIT
#ifndef SINEW_CHARACTER_PICTURE_BODY_CATEGORY_HPP
#define SINEW_CHARACTER_PICTURE_BODY_CATEGORY_HPP

#include "sinew/sinew.h"
#include "sinew_character/picture/body_class.hpp"

namespace sinew {

// The engine's sinew_category of a class, and back. Categories are in the order of classes, behind SINEW_CATEGORY_ANY.
inline uint32_t category_of(BodyClass body) { return static_cast<uint32_t>(body) + SINEW_CATEGORY_BIPED; }
inline BodyClass body_of_category(uint32_t category) { return static_cast<BodyClass>(category - SINEW_CATEGORY_BIPED); }

}  // namespace sinew
#endif
