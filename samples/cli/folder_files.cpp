// SPDX-License-Identifier: MIT
// Which mesh of a folder becomes which file.
#include "folder_files.hpp"

#include <filesystem>
#include <map>
#include <set>

#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

std::string real_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(path, ignored).string();
}

// Outputs of one run would be the inputs of the next.
void refuse_folder_inside(const std::string& folder, const std::string& output_folder) {
  const fs::path in = real_path(folder), out = real_path(output_folder);
  const std::string below = out.lexically_relative(in).string();
  if (below == ".") throw UsageError("-o " + output_folder + ": is the folder of the inputs; give another");
  if (!below.empty() && below.rfind("..", 0) != 0)
    throw UsageError("-o " + output_folder + ": lies inside " + folder +
                     ", where the next run would find its files as inputs; give a folder outside");
}

}  // namespace

std::vector<FolderFile> folder_files(const std::string& folder, const std::string& output_folder,
                                     const std::string& extension, bool or_pictures) {
  refuse_folder_inside(folder, output_folder);
  std::vector<std::string> meshes = list_meshes(folder);
  if (meshes.empty() && or_pictures) meshes = list_files(folder, kReadsPicture);
  if (meshes.empty())
    throw Error(folder + ": no mesh " + (or_pictures ? "and no picture " : "") + "in it nor below it; expected " +
                extensions_text(kReadsMesh) + (or_pictures ? ", " + extensions_text(kReadsPicture) : ""));
  std::set<std::string> inputs;
  for (const std::string& mesh : meshes) inputs.insert(real_path(mesh));
  std::map<std::string, std::string> taken;  // output -> mesh
  std::vector<FolderFile> files;
  for (const std::string& mesh : meshes) {
    const fs::path name = fs::path(mesh).lexically_relative(folder);
    FolderFile file;
    file.name = name.string();
    file.mesh = mesh;
    file.output = (fs::path(output_folder) / name.parent_path() / (stem_of(mesh) + extension)).string();
    const auto [first, fresh] = taken.emplace(file.output, mesh);
    if (!fresh) throw Error(first->second + " and " + mesh + " would both become " + file.output + "; rename one");
    if (inputs.count(real_path(file.output)) != 0)
      throw Error(file.output + ": is a link to one of the inputs, which are not replaced; give another folder");
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace sinew::cli
