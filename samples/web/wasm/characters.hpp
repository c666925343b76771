// SPDX-License-Identifier: MIT
// Characters into the session, and their skeletons: the file's, new ones, edited ones.
#ifndef SINEW_WEB_CHARACTERS_HPP
#define SINEW_WEB_CHARACTERS_HPP

#include <nlohmann/json.hpp>
#include <string>

#include "session.hpp"

namespace sinew::web {

using Json = nlohmann::json;

// As web_load() of web.cpp: what is asked of each is said there.
Json load(Session& s, const std::string& mesh, const std::string& skeleton, uint32_t number, const Json& place);
Json load_picture(Session& s, const std::string& path, const Json& wishes, uint32_t number);
// What was found in the picture, and how its character would move by itself.
Json picture_json(const PictureCharacter& picture);
Json predict(Session& s, const Json& wishes);
Json edit(Session& s, const Json& edits, bool mirror, bool continues);
// Whether joints have the same parents, so that weights and clips of some are good for the others.
bool are_alike(const std::vector<Joint>& some, const std::vector<Joint>& others);
// The character has the present rig. Weights stay where joints were moved or renamed, until the next bind.
Json show_rig(Session& s);
// What the command says of its options the page has as boxes, or not at all.
std::string without_option(std::string line);

}  // namespace sinew::web
#endif
