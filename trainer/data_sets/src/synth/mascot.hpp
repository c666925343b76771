// SPDX-License-Identifier: MIT
// Mascots, chibi and plush: a head of about half the height on stubby limbs, and what is no limb but looks like one.
#ifndef SINEW_DATA_SETS_SYNTH_MASCOT_HPP
#define SINEW_DATA_SETS_SYNTH_MASCOT_HPP

#include "synth/sketch.hpp"

namespace sinew::synth {

// Upright, with one or more of pigtails, long ears, wings and a big tail. Positions as in make_creature().
Body mascot(Sketch* s);

}  // namespace sinew::synth
#endif
