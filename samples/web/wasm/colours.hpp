// SPDX-License-Identifier: MIT
// Colours of the shown mesh: all joints, a joint's field, doubt, the file's weights and how far they are from ours.
#ifndef SINEW_WEB_COLOURS_HPP
#define SINEW_WEB_COLOURS_HPP

#include "session.hpp"

namespace sinew::web {

enum class ColourMode : uint32_t {
  kJoints = 0,   // joints' colours by weight
  kField,        // of one joint
  kDoubt,        // red: unsure
  kArtist,       // as kJoints, by the file's weights
  kArtistField,  // as kField, the same
  kDifference    // between the two
};

// Returns the mean of what is shown: of kDifference twice it is the L1 of the READMEs.
double colour(Session& s, ColourMode mode, uint32_t joint);

}  // namespace sinew::web
#endif
