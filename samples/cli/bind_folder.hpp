// SPDX-License-Identifier: MIT
// sinew bind DIR: every mesh of a folder, several at once, a line each.
#ifndef SINEW_CLI_BIND_FOLDER_HPP
#define SINEW_CLI_BIND_FOLDER_HPP

#include <string>

#include "bind_one.hpp"

namespace sinew::cli {

struct FolderSettings {
  BindSettings
      each;  // of every file; mesh and output are the file's own, an OBJ without a skeleton takes the rig beside
  std::string folder, output_folder;
  std::string extension = ".glb";  // of what is written
  std::string report;              // page; empty: none
  unsigned jobs = 1;               // files at the same time
  bool json = false;               // JSON Lines instead of text
};

// Writes output_folder/RELATIVE/NAME.glb for folder/RELATIVE/NAME.*, and tells of every file in the order of their
// names. A file that fails is told on stderr and does not stop the others; then throws Error at the end. Throws Error
// before any work when outputs would replace inputs or each other.
void bind_folder(const FolderSettings& settings, const Binder& binder);

}  // namespace sinew::cli
#endif
