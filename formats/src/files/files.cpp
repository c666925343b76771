// SPDX-License-Identifier: MIT
// Whole files in and out, and the folders of a data set. Everything that any reader or writer touches on disk goes
// through here.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "sinew_formats/base/lower_case.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"

namespace fs = std::filesystem;

namespace sinew {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string system_error() { return std::strerror(errno); }

void write_all(const std::string& path, std::FILE* file, const void* bytes, size_t size) {
  if ((size != 0 && std::fwrite(bytes, 1, size, file) != size) || std::fflush(file) != 0)
    throw Error(path + ": cannot write " + std::to_string(size) + " bytes: " + system_error());
}

// Bytes in a temporary file beside their target. replace() renames it to the target; without that, it is removed.
class PendingFile {
 public:
  PendingFile(const std::string& path, const void* bytes, size_t size) : path_(path), target_(path) {
    std::error_code ignored;
    if (fs::is_symlink(target_, ignored)) {  // the link stays, what it points to is replaced
      const fs::path pointed = fs::weakly_canonical(target_, ignored);
      if (!pointed.empty()) target_ = pointed;
    }
    const fs::file_status status = fs::status(target_, ignored);
    if (fs::is_directory(status)) throw Error(path + ": cannot write, it is a directory; give a file name");
    if (fs::exists(status) && !fs::is_regular_file(status)) {  // a pipe or a device cannot be renamed over
      const File file(std::fopen(target_.c_str(), "wb"));
      if (!file) throw Error(path + ": cannot write: " + system_error());
      write_all(path, file.get(), bytes, size);
      return;
    }
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored))
      throw Error(path + ": cannot write, the folder " + folder.string() + " does not exist; create it first");

    static std::atomic<unsigned> counter{0};  // several threads may write files of one folder
    temporary_ = target_.string() + ".tmp" + std::to_string(::getpid()) + "." + std::to_string(counter++);
    try {
      File file(std::fopen(temporary_.c_str(), "wbx"));
      if (!file) throw Error(path + ": cannot write in " + folder.string() + ": " + system_error());
      write_all(path, file.get(), bytes, size);
      if (std::fclose(file.release()) != 0) throw Error(path + ": cannot write: " + system_error());
    } catch (...) {
      std::remove(temporary_.c_str());
      throw;
    }
    if (fs::exists(status)) fs::permissions(temporary_, status.permissions(), ignored);
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile() {
    if (!temporary_.empty()) std::remove(temporary_.c_str());
  }

  void replace() {
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
      throw Error(path_ + ": cannot replace: " + system_error());
    temporary_.clear();
  }

 private:
  std::string path_, temporary_;
  fs::path target_;
};

bool write_to_memory(const std::string& path, const void* bytes, size_t size) {
  std::vector<NamedBytes>* outputs = memory_outputs();
  if (outputs == nullptr) return false;
  const uint8_t* first = static_cast<const uint8_t*>(bytes);
  outputs->push_back({path, {first, first + size}});
  return true;
}

void write_bytes(const std::string& path, const void* bytes, size_t size) {
  if (write_to_memory(path, bytes, size)) return;
  if (path == "-") return write_all("standard output", stdout, bytes, size);
  PendingFile(path, bytes, size).replace();
}

}  // namespace

bool has_extension(const std::string& path, const char* extension) {
  const std::string text = lower_case(path), end = extension;
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string stem_of(const std::string& path) {
  if (path == "-") return "stdin";
  std::string name = fs::path(path).filename().string();
  if (const FileKind* kind = file_kind(name)) return name.substr(0, name.size() - std::strlen(kind->extension));
  return fs::path(name).stem().string();
}

std::vector<uint8_t> read_file(const std::string& path) {
  if (const FileBytes* files = memory_inputs()) {
    const auto file = files->find(fs::path(path).lexically_normal().generic_string());
    if (file == files->end()) throw Error(path + ": no such file");
    return file->second;
  }
  const bool standard_input = path == "-";
  const std::string name = standard_input ? "standard input" : path;
  File opened;
  std::FILE* file = stdin;
  if (!standard_input) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (status.type() == fs::file_type::not_found) throw Error(path + ": no such file");
    if (fs::is_directory(status)) throw Error(path + ": expected a file, found a directory");
    opened.reset(std::fopen(path.c_str(), "rb"));
    if (!opened) throw Error(path + ": cannot read: " + system_error());
    file = opened.get();
  }
  std::vector<uint8_t> bytes;
  size_t filled = 0;
  for (;;) {
    bytes.resize(std::max<size_t>(size_t{1} << 16, filled * 2));
    const size_t got = std::fread(bytes.data() + filled, 1, bytes.size() - filled, file);
    filled += got;
    if (got == 0) break;
  }
  if (std::ferror(file)) throw Error(name + ": cannot read: " + system_error());
  bytes.resize(filled);
  return bytes;
}

std::string read_text_file(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return std::string(bytes.begin(), bytes.end());
}

void write_file(const std::string& path, const std::vector<uint8_t>& bytes) {
  write_bytes(path, bytes.data(), bytes.size());
}

void write_files(const std::vector<NamedBytes>& files) {
  std::vector<std::unique_ptr<PendingFile>> pending;
  for (const NamedBytes& file : files)
    if (!write_to_memory(file.path, file.bytes.data(), file.bytes.size()))
      pending.push_back(std::make_unique<PendingFile>(file.path, file.bytes.data(), file.bytes.size()));
  for (const auto& file : pending) file->replace();
}

void write_text_file(const std::string& path, const std::string& text) { write_bytes(path, text.data(), text.size()); }

std::string rig_path_beside(const std::string& mesh_path) {
  const fs::path path = mesh_path;
  return (path.parent_path() / (stem_of(mesh_path) + ".rig.txt")).string();
}

}  // namespace sinew
