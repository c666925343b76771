// SPDX-License-Identifier: MIT
// Binding of files, without the command line: reads, binds, writes and summarizes one file, or every mesh of a
// folder.
#ifndef SINEW_CLI_BIND_FILES_HPP
#define SINEW_CLI_BIND_FILES_HPP

#include <string>
#include <vector>

#include "bind_summary.hpp"
#include "option_groups.hpp"
#include "sinew_character/jobs/bind_job.hpp"
#include "sinew_character/pose/character_transform.hpp"
#include "sinew_formats/character.hpp"

namespace sinew::cli {

// Job of one file. Empty paths: none.
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
  bool cut = false;                  // what has fused is opened
  std::string to_pose;               // rest pose of what is written; empty: as the mesh stands
  bool pose_preferred = false;       // it is the profile's
  CharacterTransform transform;      // where the mesh with its joints is put first
  ProfileSettings profile;           // what it is written for
  unsigned questions = 0;            // parts to list or, with `ask`, to ask about on the terminal
  bool ask = false;                  // reads answers from standard input
  std::vector<std::string> answers;  // PART=ANSWER
  std::string studio_style;          // a style file that answers what it knows
  std::string save_style;            // where the answers go, with those of studio_style
  bool compare = false;              // with the weights that the file, or the skeleton's file, has
};

// Files that a bind leaves beside its output.
struct BoundFile {
  Character character;  // with the new weights
  BindSummary summary;
};

// Reads, binds, writes `settings.output` and the pictures. Throws Error; nothing is written then. With `progress` one
// line on stderr counts to 100 %. Calls at the same time are allowed when their outputs differ.
BoundFile bind_one(const BindSettings& settings, const Binder& binder, bool progress);

struct FolderSettings {
  BindSettings
      each;  // of every file; mesh and output are the file's own, an OBJ without a skeleton takes the rig beside
  std::string folder, output_folder;
  std::string extension = ".glb";  // of what is written
  std::string report;              // page; empty: none
  unsigned jobs = 1;               // files at the same time
  bool json = false;               // JSON Lines instead of text
};

// Writes output_folder/RELATIVE/NAME.glb for folder/RELATIVE/NAME.*, and reports every file in the order of names. A
// failed file is reported on stderr and does not stop the others; throws Error at the end. Throws Error before any
// work when outputs would replace inputs or each other.
void bind_folder(const FolderSettings& settings, const Binder& binder);

}  // namespace sinew::cli
#endif
