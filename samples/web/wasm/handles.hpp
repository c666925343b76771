// SPDX-License-Identifier: MIT
// The session's character for the jobs of sinew/character.h, and what the page shows of the clips that they make.
#ifndef SINEW_WEB_HANDLES_HPP
#define SINEW_WEB_HANDLES_HPP

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "session.hpp"
#include "sinew/character.h"

namespace sinew::web {

enum class CopyOf : uint32_t { kShown = 0, kWritten, kFile };

// A copy of the bound character as it is shown, as files of it are (see written()), or with the joints where its own file has them.
//   moving  whose clips it gets where they are of its joints; or null
std::unique_ptr<sinew_character> handle_of(const Session& s, CopyOf what, const sinew_character* moving);
// Moves a character and its clips up or down so that it stands on the floor, as programs for avatars have it; one that stands there within 2 % of its height
// stays. Returns how high it was above the floor, 0 where it stays. Throws Error.
double put_on_floor(sinew_character* handle, Axis up_axis);
// Clips that were added to a handle: [{name, frames, seconds, room}]. room, what joints take up by axes: {is: [[least, most] x 3], around: the same,
// from the joints' middle in each frame}
nlohmann::json clips_json(const sinew_character& moving);
// An added clip's pose at `seconds`. Throws Error where the clip is not of the session's joints.
MotionFrame frame_of(const Session& s, const sinew_character* moving, uint32_t clip, double seconds);
// Pose times inverse bind of all joints in it.
std::vector<Affine> palette_at(const Session& s, const sinew_character* moving, uint32_t clip, double seconds);

}  // namespace sinew::web
#endif
