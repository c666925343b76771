// SPDX-License-Identifier: MIT
// A clip of gaits/ performed by a puppet.
#ifndef SINEW_CHARACTER_CLIPS_PERFORMANCE_HPP
#define SINEW_CHARACTER_CLIPS_PERFORMANCE_HPP

#include "clips/gait.hpp"
#include "clips/puppet.hpp"

namespace sinew::clips {

Puppet puppet_of(const Block& kind);

// 30 frames per second; the last frame is the first one, where the body travels one cycle on. Where a foot is out of reach the
// root is lowered in all frames by as much as it takes.
//   kind     what all clips of this body share
//   variant  another manner of the clip, or null
// Throws Error for a joint or a signal that is not there.
Clip perform(Puppet* puppet, const Block& kind, const Block& clip, const Block* variant);

}  // namespace sinew::clips
#endif
