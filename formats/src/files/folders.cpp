// SPDX-License-Identifier: MIT
// Folders of files: those below one by what they are for, and names that tell its characters apart.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"

namespace fs = std::filesystem;

namespace sinew {
namespace {

// A link may lead back up: every folder is entered once, under the first of its names.
void collect(const fs::path& folder, std::set<fs::path>* entered, std::vector<std::string>* files) {
  std::error_code error, ignored;
  if (!entered->insert(fs::canonical(folder, ignored)).second) return;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    entries.push_back(entry->path());
  if (error) throw Error(folder.string() + ": cannot read the folder: " + error.message());
  std::sort(entries.begin(), entries.end());
  for (const fs::path& path : entries) {
    if (path.filename().string()[0] == '.') continue;
    if (fs::is_directory(path, ignored)) {
      collect(path, entered, files);
    } else if (fs::is_regular_file(path, ignored)) {
      files->push_back(path.string());
    }
  }
}

// Every file of a folder and of the folders below it, sorted by name within each. Hidden files and folders (.name) are
// left out, links are followed. Throws Error for what is no folder or cannot be read.
std::vector<std::string> files_below(const std::string& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw Error(folder + ": expected a folder of characters, found no such folder");
  std::set<fs::path> entered;
  std::vector<std::string> files;
  collect(folder, &entered, &files);
  return files;
}

}  // namespace

std::vector<std::string> list_characters(const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> found;  // name, path
  for (const std::string& path : files_below(folder)) {
    const bool pair = has_use(path, kReadsMesh) && !has_use(path, kReadsWhole) && is_file(rig_path_beside(path));
    if (pair || has_use(path, kReadsWhole)) found.emplace_back(stem_of(path), path);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> paths;
  for (auto& [name, path] : found) paths.push_back(std::move(path));
  return paths;
}

std::vector<std::string> list_files(const std::string& folder, uint32_t use) {
  std::vector<std::string> paths;
  for (const std::string& path : files_below(folder))
    if (has_use(path, use)) paths.push_back(path);
  return paths;
}

std::vector<std::string> list_meshes(const std::string& folder) { return list_files(folder, kReadsMesh); }
std::vector<std::string> list_motions(const std::string& folder) { return list_files(folder, kReadsMotion); }

std::vector<std::string> character_names(const std::string& folder, const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) names.push_back(stem_of(path));
  // First by the folders, then by the extension too.
  for (const bool whole : {false, true}) {
    std::map<std::string, size_t> users;
    for (const std::string& name : names) ++users[name];
    for (size_t i = 0; i < paths.size(); ++i) {
      if (users[names[i]] < 2) continue;
      const fs::path below = fs::path(paths[i]).lexically_relative(folder);
      names[i] = (whole ? below : below.parent_path() / stem_of(paths[i])).generic_string();
    }
  }
  return names;
}

std::string family_of(const std::string& character_name) {
  const size_t folder = character_name.rfind('/');
  const std::string name = folder == std::string::npos ? character_name : character_name.substr(folder + 1);
  const size_t at = name.find("__");
  return at == std::string::npos || at == 0 ? "all" : name.substr(0, at);
}

}  // namespace sinew
