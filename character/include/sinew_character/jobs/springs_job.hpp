// SPDX-License-Identifier: MIT
// The job of `sinew springs` for one character: its own springs or found ones, selected and edited by name, with
// colliders.
#ifndef SINEW_CHARACTER_SPRINGS_JOB_HPP
#define SINEW_CHARACTER_SPRINGS_JOB_HPP

#include <string>
#include <vector>

#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/springs/find_springs.hpp"

namespace sinew {

// Names are those of chains; NAME* selects all that begin with NAME.
struct SpringsOptions {
  std::vector<std::string> keep;  // chains to keep despite a low probability, or in addition to the file's own
  std::vector<std::string> drop;
  std::vector<std::string> presets;  // NAME=KIND
  // NAME:FIELD=NUMBER sets a parameter of all joints of a chain, NAME:FIELD=xFACTOR scales it; see
  // spring_fields_text()
  std::vector<std::string> values;
  bool replace = false;  // ignores the file's own springs
};
// "stiffness, gravity, drag, radius, limit".
std::string spring_fields_text();

struct SpringsFound {
  std::vector<FoundChain> chains;  // all proposed chains
  Springs springs;                 // the kept ones, with colliders
  std::vector<double>
      errors;  // [springs.colliders] distance of the skin from a fitted collider, as a share of its radius; -1 for the file's own
  std::vector<std::string> notes;  // notes for the user
};

// Returns the springs of the character's file, with others that were found as proposals only; without any, those
// found.
//   path  for messages
// Throws Error for unknown chains, kinds or fields, numbers out of range, and invalid springs in the file.
SpringsFound springs_of(const SpringsOptions& options, const std::string& path, const Character& character);

// Runs make_chains() for the character, with a note per garment or one that there is none. Adds its chains to those
// that the options keep. Returns whether joints were added.
bool make_spring_chains(SpringsOptions* options, Character* character);

// Simulates springs_of() in each clip of an animated character: `sinew animate --springs`. Notes list the chains that
// swing. Throws Error if there are none.
//   measure  fills AnimatedClip::swing
void swing_clips(const SpringsOptions& options, const std::string& path, bool measure, AnimatedCharacter* out);
// The same for given springs.
void swing_clips(const Springs& springs, bool measure, AnimatedCharacter* out);

}  // namespace sinew
#endif
