// SPDX-License-Identifier: MIT
// A bare mesh rigged, for every call that needs a skeleton on the way.
#ifndef SINEW_CHARACTER_CAPI_RIG_OF_HPP
#define SINEW_CHARACTER_CAPI_RIG_OF_HPP

#include "handle.hpp"
#include "sinew_character/jobs/rig_job.hpp"

namespace sinew {

//   picture  out: what the character's picture became; unchanged where it is of none
RiggedCharacter rig_of(const sinew_character& from, const sinew_character_rig_options& options,
                       ProgressOfCaller* progress, std::shared_ptr<const PictureCharacter>* picture);

}  // namespace sinew
#endif
