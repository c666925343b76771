// SPDX-License-Identifier: MIT
// Creatures of every proportion: joints first, one tapered capsule for every bone.
#ifndef SINEW_DATA_SETS_SYNTH_CREATURE_HPP
#define SINEW_DATA_SETS_SYNTH_CREATURE_HPP

#include "synth/blueprint.hpp"

namespace sinew::synth {

// The plans of kCreaturePlans. Positions as in make_blueprint(); the cell is set from the body's real size.
Blueprint make_creature(BodyPlan plan, int resolution, Random* random);

}  // namespace sinew::synth
#endif
