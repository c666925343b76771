// SPDX-License-Identifier: MIT
// Files in memory for readers and writers, for programs without a disk or with their own storage.
#ifndef SINEW_FORMATS_MEMORY_FILES_HPP
#define SINEW_FORMATS_MEMORY_FILES_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sinew_formats/io.hpp"

namespace sinew {

using FileBytes = std::map<std::string, std::vector<uint8_t>>;  // by name; a/../b is b

// During the lifetime of an object, all files that this thread reads or writes through formats are here instead of on
// disk. The latest object counts.
class MemoryFiles {
 public:
  //   inputs   files to read; null: those on disk
  //   outputs  receives the written files, in order; null: they are written to disk
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

// The object of this thread; null: the disk.
const FileBytes* memory_inputs();
std::vector<NamedBytes>* memory_outputs();

// Returns whether a file exists on disk or in memory. A directory or a device is not a file.
bool is_file(const std::string& path);

}  // namespace sinew
#endif
