// SPDX-License-Identifier: MIT
// What a dropped file holds, and what sinew check finds in the open character.
#ifndef SINEW_WEB_CONTENTS_HPP
#define SINEW_WEB_CONTENTS_HPP

#include <nlohmann/json.hpp>
#include <string>

#include "session.hpp"

namespace sinew::web {

using Json = nlohmann::ordered_json;

// {mesh: whether it has faces, joints, clips: those that have frames}. Throws Error for a file that is neither a mesh nor a motion.
Json contents(const std::string& path);
// [{rule, severity, title, what, cure, joint, place, radius}], as check_rig() orders them.
Json check_json(const Session& s);

}  // namespace sinew::web
#endif
