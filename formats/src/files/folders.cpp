// SPDX-License-Identifier: MIT
// Folders of files: everything below one, and names that tell its characters apart.
#include "files/folders.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "sinew_formats/error.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"

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

}  // namespace

std::vector<std::string> files_below(const std::string& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw Error(folder + ": expected a folder of characters, found no such folder");
  std::set<fs::path> entered;
  std::vector<std::string> files;
  collect(folder, &entered, &files);
  return files;
}

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
