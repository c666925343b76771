// SPDX-License-Identifier: MIT
// Which files this thread sees.
#include "sinew_formats/memory_files.hpp"

#include <filesystem>

namespace fs = std::filesystem;

namespace sinew {
namespace {

thread_local MemoryFiles* latest = nullptr;

}  // namespace

MemoryFiles::MemoryFiles(const FileBytes* inputs, std::vector<NamedBytes>* outputs)
    : inputs_(inputs), outputs_(outputs), before_(latest) {
  latest = this;
}

MemoryFiles::~MemoryFiles() { latest = before_; }

const FileBytes* memory_inputs() { return latest == nullptr ? nullptr : latest->inputs_; }
std::vector<NamedBytes>* memory_outputs() { return latest == nullptr ? nullptr : latest->outputs_; }

bool is_file(const std::string& path) {
  if (const FileBytes* files = memory_inputs())
    return files->count(fs::path(path).lexically_normal().generic_string()) != 0;
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace sinew
