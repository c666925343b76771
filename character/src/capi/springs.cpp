// SPDX-License-Identifier: MIT
// sinew_character_springs(): the job of `sinew springs`.
#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/jobs/springs_job.hpp"

namespace sinew {
namespace {

std::vector<std::string> texts_of(const char* what, const char* const* given, uint32_t count) {
  need(given != nullptr || count == 0, what);
  std::vector<std::string> out;
  for (uint32_t i = 0; i < count; ++i) {
    need(given[i] != nullptr, what);
    out.emplace_back(given[i]);
  }
  return out;
}

void find(const sinew_character_springs_options& options, sinew_character* character,
          sinew_character_springs_result* result) {
  check_at_most("replace", options.replace, 1);
  check_at_most("make", options.make, 1);
  SpringsOptions job;
  job.replace = options.replace != 0;
  job.keep = texts_of("take", options.take, options.take_count);
  job.drop = texts_of("drop", options.drop, options.drop_count);
  job.presets = texts_of("presets", options.presets, options.preset_count);
  job.values = texts_of("values", options.values, options.value_count);
  std::optional<Character> made;  // with chains in garments that had none
  if (options.make != 0) {
    check_nothing_added(*character);
    made = character->character;
    if (!make_spring_chains(&job, &*made)) made.reset();
  }
  SpringsFound found = springs_of(job, file_of(*character), made ? *made : character->character);
  ResultViews& views = character->results;
  views = {};
  sinew_character_springs_result filled = SINEW_INIT(sinew_character_springs_result);
  filled.proposal_count = count32(found.chains.size());
  filled.chain_count = count32(found.springs.chains.size());
  filled.collider_count = count32(found.springs.colliders.size());
  for (const SpringChain& chain : found.springs.chains) filled.joint_count += count32(chain.turning_joints());
  for (const FoundChain& one : found.chains) {
    filled.own_count += one.own ? 1 : 0;
    views.joint_names += (views.ends.empty() ? "" : "\n") + one.chain.name;
    views.kinds += (views.ends.empty() ? "" : "\n") + std::string(spring_kind_text(one.kind));
    views.ends.push_back(one.kept ? 1 : 0);
    views.confidence.push_back(one.certainty);
  }
  filled.kept = views.ends.data();
  filled.certainties = views.confidence.data();
  filled.names = views.joint_names.c_str();
  filled.kinds = views.kinds.c_str();
  if (made) {
    character->character = std::move(*made);
    changed(character);
  }
  for (const std::string& note : found.notes) character->character.notes.push_back(note);
  character->springs = std::move(found.springs);
  character->spring_player.reset();
  give(filled, result);
}

SpringPlayer& player_of(sinew_character* character) {
  if (character->spring_player == nullptr) {
    const Springs springs = character->springs
                                ? *character->springs
                                : springs_of(SpringsOptions(), file_of(*character), character->character).springs;
    Motion motion = motion_of(character->character.joints);
    motion.name = file_of(*character);
    character->spring_player = std::make_unique<SpringPlayer>(springs, motion);
  }
  return *character->spring_player;
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_springs(sinew_character* character,
                                                const sinew_character_springs_options* given,
                                                sinew_character_springs_result* result) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    check_result(result);
    find(options_of(given), character, result);
  });
}

extern "C" sinew_status sinew_character_springs_frame(sinew_character* character, float seconds, const float* rotations,
                                                      const float* translations, float* out_rotations) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(rotations != nullptr && translations != nullptr && out_rotations != nullptr,
         "rotations, translations, out_rotations");
    if (!(seconds >= 0)) throw Failure(SINEW_ERROR_ARGUMENT, "seconds: expected 0 or more");
    const size_t count = character->character.joints.size();
    MotionFrame pose;
    for (size_t j = 0; j < count; ++j) {
      Quaternion& q = pose.rotations.emplace_back();
      for (size_t c = 0; c < 4; ++c) q[c] = static_cast<double>(rotations[4 * j + c]);
      Point3& p = pose.translations.emplace_back();
      for (size_t c = 0; c < 3; ++c) p[c] = static_cast<double>(translations[3 * j + c]);
    }
    player_of(character).frame(static_cast<double>(seconds), &pose);
    if (out_rotations != rotations) std::copy_n(rotations, 4 * count, out_rotations);
    for (const size_t j : character->spring_player->joints())
      for (size_t c = 0; c < 4; ++c) out_rotations[4 * j + c] = static_cast<float>(pose.rotations[j][c]);
  });
}

extern "C" sinew_status sinew_character_springs_restart(sinew_character* character) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    character->spring_player.reset();
  });
}
