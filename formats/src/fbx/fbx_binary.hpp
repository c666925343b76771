// SPDX-License-Identifier: MIT
// The tree that a binary FBX is: nodes with properties and nodes below them. Layout as Blender's documentation has it (code.blender.org, "FBX binary
// file format specification"), version 7.5: lengths of 64 bits.
#ifndef SINEW_FORMATS_FBX_FBX_BINARY_HPP
#define SINEW_FORMATS_FBX_FBX_BINARY_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"

namespace sinew {

class FbxNode {
 public:
  explicit FbxNode(std::string name) : name_(std::move(name)) {}

  // Properties, in their order.
  FbxNode& integer(int32_t value);
  FbxNode& id(int64_t value);
  FbxNode& number(double value);
  FbxNode& text(const std::string& value);
  FbxNode& bytes(const uint8_t* values, size_t count);
  FbxNode& integers(const std::vector<int32_t>& values);
  FbxNode& longs(const std::vector<int64_t>& values);
  FbxNode& numbers(const std::vector<double>& values);
  FbxNode& floats(const std::vector<float>& values);
  FbxNode& matrix(const Affine& m);  // 16 numbers, column by column

  // A node below; the reference is good until the next one is added.
  FbxNode& add(const std::string& name);
  FbxNode& add(FbxNode node);

  // Rows of Properties70: P "name", "type", "kind", "flags", value.
  FbxNode& property(const char* name, const char* type, const char* kind, const char* flags);
  FbxNode& property_number(const char* name, double value);
  FbxNode& property_integer(const char* name, int32_t value);
  FbxNode& property_enum(const char* name, int32_t value);
  FbxNode& property_time(const char* name, int64_t value);
  FbxNode& property_text(const char* name, const char* kind, const std::string& value);
  FbxNode& property_vector(const char* name, const char* type, const char* kind, const char* flags,
                           const std::array<double, 3>& value);

  void write(std::vector<uint8_t>* out) const;

 private:
  template <class T>
  FbxNode& array(char type, const std::vector<T>& values);

  std::string name_;
  uint64_t property_count_ = 0;
  std::vector<uint8_t> properties_;
  std::vector<FbxNode> nodes_;
};

// "Name", "Model" as a binary file has it.
std::string fbx_name(const std::string& name, const char* of);

// The whole file. The same nodes are the same bytes: its date is fixed.
std::vector<uint8_t> fbx_file(const std::vector<FbxNode>& nodes);

// Bytes and date that a file's end goes with.
const std::array<uint8_t, 16>& fbx_file_id();
const char* fbx_creation_time();

}  // namespace sinew
#endif
