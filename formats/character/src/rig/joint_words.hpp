// SPDX-License-Identifier: MIT
// Names of joints as words: every tool writes LeftHandIK, left_hand_ik or Bip01 L Hand IK in its own way.
#ifndef SINEW_CHARACTER_RIG_JOINT_WORDS_HPP
#define SINEW_CHARACTER_RIG_JOINT_WORDS_HPP

#include <string>
#include <vector>

namespace sinew {

// Lower-case words of letters, cut where a capital begins one and where anything but a letter stands. The full-width
// letters of Japanese rigs are letters; other characters beyond ASCII stay in their word as they are.
std::vector<std::string> words_of(const std::string& name);

// The number that a name ends with, but for the numbers that tools append (_021, .001); -1 without one.
int number_at_end(const std::string& name);

}  // namespace sinew
#endif
