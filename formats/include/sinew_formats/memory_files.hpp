// SPDX-License-Identifier: MIT
// Files in memory for readers and writers: what a program without a disk, or with a file of its own kind, gives them.
#ifndef SINEW_FORMATS_MEMORY_FILES_HPP
#define SINEW_FORMATS_MEMORY_FILES_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sinew_formats/io.hpp"

namespace sinew {

using FileBytes = std::map<std::string, std::vector<uint8_t>>;  // by name; a/../b is b

// While one lives, everything that this thread reads or writes through formats goes here instead of to the disk. The latest counts.
class MemoryFiles {
 public:
  //   inputs   files that there are; null: the disk's
  //   outputs  takes what is written, in its order; null: the disk does
  MemoryFiles(const FileBytes* inputs, std::vector<NamedBytes>* outputs);
  ~MemoryFiles();
  MemoryFiles(const MemoryFiles&) = delete;
  MemoryFiles& operator=(const MemoryFiles&) = delete;

 private:
  friend const FileBytes* memory_inputs();
  friend std::vector<NamedBytes>* memory_outputs();
  const FileBytes* inputs_;
  std::vector<NamedBytes>* outputs_;
  MemoryFiles* before_;
};

// Of this thread; null: the disk.
const FileBytes* memory_inputs();
std::vector<NamedBytes>* memory_outputs();

// On the disk or in memory. A directory or a device is no file.
bool is_file(const std::string& path);

}  // namespace sinew
#endif
