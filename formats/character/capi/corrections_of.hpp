// SPDX-License-Identifier: MIT
// A caller's choice of how posed meshes follow, as the engine's options.
#ifndef SINEW_CHARACTER_CAPI_CORRECTIONS_OF_HPP
#define SINEW_CHARACTER_CAPI_CORRECTIONS_OF_HPP

#include <optional>

#include "handle.hpp"

namespace sinew {

// nullopt for plain skinning. Throws Failure for settings that the method has no use for.
inline std::optional<sinew_deform_options> corrections_of(uint32_t deform, uint32_t cells, uint32_t rounds,
                                                          uint32_t body_contact) {
  check_at_most("deform", deform, SINEW_POSE_DELTA_MUSH);
  if (cells != 0 && (cells < 8 || cells > SINEW_MAX_DEFORM_CELLS))
    throw Failure(SINEW_ERROR_ARGUMENT, "cells: expected 8 to " + std::to_string(SINEW_MAX_DEFORM_CELLS));
  check_at_most("rounds", rounds, SINEW_MAX_DEFORM_ROUNDS);
  if (body_contact != 0 && deform != SINEW_POSE_VOLUME && deform != SINEW_POSE_XPBD)
    throw Failure(SINEW_ERROR_ARGUMENT, "body_contact: is for SINEW_POSE_VOLUME and SINEW_POSE_XPBD");
  if (deform < SINEW_POSE_VOLUME) {
    if (cells != 0 || rounds != 0)
      throw Failure(SINEW_ERROR_ARGUMENT, "cells and rounds: are for poses that are corrected");
    return std::nullopt;
  }
  sinew_deform_options options = sinew_deform_options_init();
  options.cell_count = cells;
  options.round_count = rounds;
  options.body_contact = body_contact != 0 ? 1 : 0;
  if (deform == SINEW_POSE_XPBD) options.method = SINEW_DEFORM_XPBD;
  if (deform == SINEW_POSE_DELTA_MUSH) options.method = SINEW_DEFORM_DELTA_MUSH;
  return options;
}

// Progress over steps; each step may end the work.
inline auto steps_of(ProgressOfCaller* progress) {
  return [progress](size_t total) {
    return [progress, total, done = size_t{0}]() mutable { return progress->step(++done, total); };
  };
}

inline std::string text_or_empty(const char* text) { return text == nullptr ? "" : text; }
inline std::string file_of(const sinew_character& character) {
  return character.path.empty() ? character.character.name : character.path;
}

}  // namespace sinew
#endif
