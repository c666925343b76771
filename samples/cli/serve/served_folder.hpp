// SPDX-License-Identifier: MIT
// The one folder whose files a server reads and writes.
#ifndef SINEW_CLI_SERVED_FOLDER_HPP
#define SINEW_CLI_SERVED_FOLDER_HPP

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sinew::cli {

class ServedFolder {
 public:
  //   most_bytes  of a file that is read
  // Throws Error where `path` is no folder.
  ServedFolder(const std::string& path, uint64_t most_bytes);

  const std::filesystem::path& root() const { return root_; }

  // A name below the folder as a command line takes it, "./hero.glb". Throws Error for names that lead out of it, by .., by a link or
  // by being absolute, that no file can have, and
  std::string input(const std::string& name) const;   // where there is no such file, or a longer one than is read
  std::string output(const std::string& name) const;  // where its folder is not there

  struct File {
    std::string name;  // below the folder, with /
    uint64_t bytes = 0;
  };
  // By name; hidden ones and links aside, no more than a thousand.
  std::vector<File> files() const;
  // The whole of a file that input() takes.
  std::string read(const std::string& name) const;

 private:
  std::filesystem::path below(const std::string& name) const;

  std::filesystem::path root_;
  uint64_t most_bytes_;
};

}  // namespace sinew::cli
#endif
