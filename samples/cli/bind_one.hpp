// SPDX-License-Identifier: MIT
// One file bound, apart from the command line: read, bind, write, told in numbers.
#ifndef SINEW_CLI_BIND_ONE_HPP
#define SINEW_CLI_BIND_ONE_HPP

#include <string>
#include <vector>

#include "bind_summary.hpp"
#include "profile_options.hpp"
#include "sinew_character/jobs/bind_job.hpp"
#include "sinew_character/pose/character_transform.hpp"
#include "sinew_formats/character.hpp"
#include "style_options.hpp"

namespace sinew::cli {

// What to do with one file. Empty paths: none.
struct BindSettings {
  std::string mesh, skeleton;
  std::string output;                      // see write_character()
  std::string deform, never, lock, hints;  // files, see the options of sinew bind
  std::string like;                        // a bound character whose weights show how they are wanted
  std::string png, png_confidence;
  std::string up = "y";
  std::string joints;  // own, names, all; empty: own for a mesh with weights of its own skeleton, else names
  unsigned influences = 4, threads = 1;
  StyleOptions style;
  bool keep_tips = false, bind_props = false, fit = false;
  bool symmetric = false, confidence = false, no_seams = false;
  bool cut = false;                  // what has grown together is opened
  std::string to_pose;               // rest pose of what is written; empty: as the mesh stands
  CharacterTransform transform;      // where the mesh with its joints is put first
  ProfileSettings profile;           // what it is written for
  unsigned questions = 0;            // parts to list or, with `ask`, to ask about on the terminal
  bool ask = false;                  // reads answers from standard input
  std::vector<std::string> answers;  // PART=ANSWER
  std::string studio_style;          // a style file that answers what it knows
  std::string save_style;            // where the answers go, with those of studio_style
  bool compare = false;              // with the weights that the file, or the skeleton's file, has
};

// What a bind leaves beside the file it wrote.
struct BoundFile {
  Character character;  // with the new weights
  BindSummary summary;
};

// Reads, binds, writes `settings.output` and the pictures. Throws Error; nothing is written then. With `progress` one
// line on stderr counts to 100 %. Calls at the same time are allowed when their outputs differ.
BoundFile bind_one(const BindSettings& settings, const Binder& binder, bool progress);

}  // namespace sinew::cli
#endif
