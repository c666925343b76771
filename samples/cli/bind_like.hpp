// SPDX-License-Identifier: MIT
// sinew bind --like: a finished character shows how weights are wanted.
#ifndef SINEW_CLI_BIND_LIKE_HPP
#define SINEW_CLI_BIND_LIKE_HPP

#include <cstdint>
#include <vector>

#include "bind_one.hpp"

namespace sinew::cli {

// Carries the weights of settings.like over and makes hints of them where they fit: in parts that sinew_transfer() rather carries
// over than binds anew, vertices that it is sure of. Hints and locked vertices that are there stay. Says in the character's notes how many there are.
//   hints  [V] or empty; set where rows of the character's influences are to be kept and to steer the others
void add_hints_like(const BindSettings& settings, const Binder& binder, const std::vector<uint8_t>& locked,
                    Character* character, std::vector<uint8_t>* hints);

}  // namespace sinew::cli
#endif
