// SPDX-License-Identifier: MIT
// Common declarations of `sinew inspect`: one kind of content each, as text on standard output or as JSON.
#ifndef SINEW_CLI_INSPECT_PARTS_HPP
#define SINEW_CLI_INSPECT_PARTS_HPP

#include <nlohmann/json.hpp>
#include <string>

#include "sinew_formats/character.hpp"
#include "sinew_formats/gltf_summary.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew::cli {

std::string character_kind(const Character& character);  // character, mesh and skeleton, mesh, skeleton
void print_character(const Character& character);
nlohmann::ordered_json character_json(const Character& character);

// Clips, rest pose and up axis; joints stand in the character's part.
void print_motion(const Motion& motion);
nlohmann::ordered_json motion_json(const Motion& motion);

void print_gltf(const GltfSummary& summary);
nlohmann::ordered_json gltf_json(const GltfSummary& summary);

}  // namespace sinew::cli
#endif
