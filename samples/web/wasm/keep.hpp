// SPDX-License-Identifier: MIT
// States of a character that the page's history goes back to, and rows that a project file holds.
#ifndef SINEW_WEB_KEEP_HPP
#define SINEW_WEB_KEEP_HPP

#include <cstdint>
#include <nlohmann/json.hpp>

#include "session.hpp"

namespace sinew::web {

using Json = nlohmann::json;

// The present character's rig, with what is locked and painted, under a number of the page.
void keep(Session& s, uint32_t number);
// What was kept of the present character; to be bound again. Replies as show_rig(), of a picture's character with `picture`, too, whose mesh is the
// one that the character has by then. Throws Error where nothing was kept under that number.
Json restore(Session& s, uint32_t number);
// Locked and painted rows that the last bind began with: {locked: [vertex], painted: [vertex], rows: [[vertex, joint, weight, joint, weight, ...]]}
Json kept_rows(const Session& s);
// Such rows again, for the next bind. Throws Error for vertices and joints that the character has not.
void put_rows(Session& s, const Json& rows);

}  // namespace sinew::web
#endif
