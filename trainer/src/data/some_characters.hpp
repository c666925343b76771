// SPDX-License-Identifier: MIT
// Some characters of a folder, spread over its list; what cannot be used is left out.
#ifndef SINEW_TRAINER_DATA_SOME_CHARACTERS_HPP
#define SINEW_TRAINER_DATA_SOME_CHARACTERS_HPP

#include <cstddef>
#include <functional>
#include <string>

#include "sinew_formats/character.hpp"

namespace sinew {

// Calls `use` with characters and their numbers in the order of the list.
//   limit  at most so many; 0 = all
//   use    true: something was made of it. An Error that it throws leaves the character out
// Throws Error, the last one, where nothing was made of any.
void each_of_some_characters(const std::string& folder, size_t limit,
                             const std::function<bool(const Character&, size_t)>& use);

}  // namespace sinew
#endif
