// SPDX-License-Identifier: MIT
// The meshes of a folder, or its pictures, and where each one's output goes: the same sub-folders below another folder.
#ifndef SINEW_CLI_FOLDER_FILES_HPP
#define SINEW_CLI_FOLDER_FILES_HPP

#include <string>
#include <vector>

namespace sinew::cli {

struct FolderFile {
  std::string name;  // below the folder
  std::string mesh, output;
};

// output_folder/RELATIVE/NAME + extension for every folder/RELATIVE/NAME.*, by name. Throws UsageError where the outputs
// would be the next run's inputs, and Error where there is no mesh or outputs would replace inputs or each other.
//   or_pictures  a folder without a mesh gives its pictures: beside meshes they are textures
std::vector<FolderFile> folder_files(const std::string& folder, const std::string& output_folder,
                                     const std::string& extension, bool or_pictures = false);

}  // namespace sinew::cli
#endif
