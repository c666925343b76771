// SPDX-License-Identifier: MIT
// Files as Assimp asks for them: read by formats, from the disk or from memory.
#ifndef SINEW_FORMATS_GLTF_SCENE_INPUT_HPP
#define SINEW_FORMATS_GLTF_SCENE_INPUT_HPP

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"

namespace sinew {

class SceneFile : public Assimp::IOStream {
 public:
  explicit SceneFile(std::vector<uint8_t> bytes) : bytes_(std::move(bytes)) {}
  size_t Read(void* out, size_t size, size_t count) override {
    if (size == 0) return 0;
    const size_t whole = std::min(count, (bytes_.size() - at_) / size);
    if (whole != 0) std::memcpy(out, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    if (offset > bytes_.size() || from > bytes_.size() - offset) return aiReturn_FAILURE;
    at_ = from + offset;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return at_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::vector<uint8_t> bytes_;
  size_t at_ = 0;
};

class SceneFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char* path) const override { return is_file(path); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (std::strchr(mode, 'r') == nullptr || !is_file(path)) return nullptr;
    try {
      return new SceneFile(read_file(path));
    } catch (const Error&) {
      return nullptr;
    }
  }
  void Close(Assimp::IOStream* file) override { delete file; }
};

}  // namespace sinew
#endif
