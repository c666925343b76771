// SPDX-License-Identifier: MIT
// Training samples of things that are no bodies: machines, vehicles, furniture, letters, lone limbs, made of rotated
// solids.
#ifndef SINEW_TRAINER_DATA_THING_SAMPLE_HPP
#define SINEW_TRAINER_DATA_THING_SAMPLE_HPP

#include "data/rig_sample.hpp"

namespace sinew {

// A surface of closed solids, y up, the floor at y = 0. The same seed gives the same surface.
SourcedSurface make_thing(uint64_t seed);

// Points of such a surface, whose bones are anywhere: all that a network can learn of them is that it does not know, and it says so by
// its spreads. Classes are other, which no class is learned from. In the family "thing".
//   cells  0, or fused to a shell of so many (grown_shell.hpp)
RigSample make_thing_sample(uint64_t seed, uint32_t cells);

}  // namespace sinew
#endif
