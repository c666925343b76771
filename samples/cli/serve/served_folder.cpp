// SPDX-License-Identifier: MIT
#include "serve/served_folder.hpp"

#include <algorithm>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {

namespace fs = std::filesystem;

namespace {

constexpr size_t kMostFiles = 1000, kLongestName = 1000;

bool is_hidden(const fs::path& path) { return path.filename().string().front() == '.'; }

}  // namespace

ServedFolder::ServedFolder(const std::string& path, uint64_t most_bytes) : most_bytes_(most_bytes) {
  std::error_code error;
  root_ = fs::canonical(path, error);
  if (error || !fs::is_directory(root_)) throw Error(path + ": expected a folder to serve");
}

fs::path ServedFolder::below(const std::string& name) const {
  const fs::path path(name);
  const auto refuse = [&](const std::string& why) -> void { throw Error("'" + printable(name) + "': " + why); };
  if (name.empty() || name.size() > kLongestName) refuse("expected a file name below the served folder");
  if (std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }))
    refuse("expected a file name without control characters");
  if (path.is_absolute() || path.has_root_name())
    refuse("expected a name below the served folder, found an absolute path");
  for (const fs::path& part : path)
    if (part == "..") refuse("expected a name below the served folder, found '..'");
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(root_ / path, error);
  const fs::path relative = whole.lexically_relative(root_);
  if (error || relative.empty() || *relative.begin() == "..") refuse("a link leads out of the served folder");
  return relative;
}

std::string ServedFolder::input(const std::string& name) const {
  const fs::path path = below(name);
  std::error_code error;
  if (!fs::is_regular_file(root_ / path, error))
    throw Error("'" + printable(name) + "': no such file in the served folder");
  const uint64_t bytes = fs::file_size(root_ / path, error);
  if (error || bytes > most_bytes_)
    throw Error("'" + printable(name) + "': " + std::to_string(bytes) + " bytes, expected at most " +
                std::to_string(most_bytes_) + " (--most-bytes)");
  return "./" + path.generic_string();
}

std::string ServedFolder::output(const std::string& name) const {
  const fs::path path = below(name);
  std::error_code error;
  if (!fs::is_directory((root_ / path).parent_path(), error))
    throw Error("'" + printable(name) + "': no such folder to write to");
  if (fs::is_directory(root_ / path, error))
    throw Error("'" + printable(name) + "': expected a file to write, found a folder");
  return "./" + path.generic_string();
}

std::vector<ServedFolder::File> ServedFolder::files() const {
  std::vector<File> files;
  std::error_code error;
  fs::recursive_directory_iterator at(root_, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && at != end && files.size() < kMostFiles; at.increment(error)) {
    if (is_hidden(at->path())) {
      if (at->is_directory(error)) at.disable_recursion_pending();
      continue;
    }
    if (at->is_symlink(error) || !at->is_regular_file(error)) continue;
    files.push_back({at->path().lexically_relative(root_).generic_string(), at->file_size(error)});
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.name < b.name; });
  return files;
}

std::string ServedFolder::read(const std::string& name) const {
  const std::string path = input(name);
  return read_text_file((root_ / path).string());
}

}  // namespace sinew::cli
