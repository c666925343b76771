// SPDX-License-Identifier: MIT
// What `sinew springs` does with one character: its own springs or found ones, chosen and changed by name, with colliders.
#ifndef SINEW_CHARACTER_SPRINGS_JOB_HPP
#define SINEW_CHARACTER_SPRINGS_JOB_HPP

#include <string>
#include <vector>

#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/springs/find_springs.hpp"

namespace sinew {

// Names are those of chains; NAME* stands for all that begin with NAME.
struct SpringsOptions {
  std::vector<std::string> keep;  // although their certainty is low, or the file has springs of its own
  std::vector<std::string> drop;
  std::vector<std::string> presets;  // NAME=KIND
  // NAME:FIELD=NUMBER for all joints of a chain, or NAME:FIELD=xFACTOR of what each has; see spring_fields_text()
  std::vector<std::string> values;
  bool replace = false;  // the file's own springs do not count
};
// "stiffness, gravity, drag, radius, limit".
std::string spring_fields_text();

struct SpringsFound {
  std::vector<FoundChain> chains;  // all that were proposed
  Springs springs;                 // those that are kept, with colliders
  std::vector<double>
      errors;  // [springs.colliders] how far the skin is from a fitted one, as a share of its radius; -1 for the file's own
  std::vector<std::string> notes;  // remarks for the user
};

// Springs of the character's file where it has some, with what is found beside them proposed but not kept; else those found.
//   path  for messages
// Throws Error for names that no chain has, words that are no kind or field, numbers out of their range, and springs of the file that are broken.
SpringsFound springs_of(const SpringsOptions& options, const std::string& path, const Character& character);

// make_chains() for the character, with a note for each garment, or one that there is none. Its chains are added to those that the options keep.
// Returns whether the character has more joints.
bool make_spring_chains(SpringsOptions* options, Character* character);

// Plays springs_of() behind every clip of an animated character, into it: `sinew animate --springs`. Its notes say what swings. Throws Error
// where nothing does.
//   measure  fills AnimatedClip::swing
void swing_clips(const SpringsOptions& options, const std::string& path, bool measure, AnimatedCharacter* out);
// The same of springs that are there.
void swing_clips(const Springs& springs, bool measure, AnimatedCharacter* out);

}  // namespace sinew
#endif
