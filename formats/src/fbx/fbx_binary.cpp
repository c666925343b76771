// SPDX-License-Identifier: MIT
#include "fbx/fbx_binary.hpp"

#include <utility>

namespace sinew {
namespace {

constexpr uint32_t kVersion = 7500;
constexpr size_t kHead = 3 * 8 + 1;  // of a node before its name; so many zeros end a list

// The footer behind the nodes; it depends on the file's id and date.
constexpr std::array<uint8_t, 16> kFoot = {0xfa, 0xbc, 0xab, 0x09, 0xd0, 0xc8, 0xd4, 0x66,
                                           0xb1, 0x76, 0xfb, 0x83, 0x1c, 0xf7, 0x26, 0x7e};
constexpr std::array<uint8_t, 16> kEnd = {0xf8, 0x5a, 0x8c, 0x6a, 0xde, 0xf5, 0xd9, 0x7e,
                                          0xec, 0xe9, 0x0c, 0xe3, 0x75, 0x8f, 0x29, 0x0b};

template <class T>
void put(T value, std::vector<uint8_t>* out) {
  uint64_t bits = 0;
  static_assert(sizeof(T) <= sizeof bits);
  const auto* from = reinterpret_cast<const uint8_t*>(&value);
  if constexpr (std::is_floating_point_v<T>) {
    std::conditional_t<sizeof(T) == 8, uint64_t, uint32_t> whole = 0;
    for (size_t i = 0; i < sizeof(T); ++i) reinterpret_cast<uint8_t*>(&whole)[i] = from[i];
    bits = whole;
  } else {
    bits = static_cast<uint64_t>(value);
  }
  for (size_t i = 0; i < sizeof(T); ++i) out->push_back(static_cast<uint8_t>(bits >> (8 * i)));
}

void put_text(const std::string& text, std::vector<uint8_t>* out) { out->insert(out->end(), text.begin(), text.end()); }

void overwrite(uint64_t value, size_t at, std::vector<uint8_t>* out) {
  for (size_t i = 0; i < 8; ++i) (*out)[at + i] = static_cast<uint8_t>(value >> (8 * i));
}

}  // namespace

FbxNode& FbxNode::integer(int32_t value) {
  properties_.push_back('I');
  put(value, &properties_);
  ++property_count_;
  return *this;
}

FbxNode& FbxNode::id(int64_t value) {
  properties_.push_back('L');
  put(value, &properties_);
  ++property_count_;
  return *this;
}

FbxNode& FbxNode::number(double value) {
  properties_.push_back('D');
  put(value, &properties_);
  ++property_count_;
  return *this;
}

FbxNode& FbxNode::text(const std::string& value) {
  properties_.push_back('S');
  put(static_cast<uint32_t>(value.size()), &properties_);
  put_text(value, &properties_);
  ++property_count_;
  return *this;
}

FbxNode& FbxNode::bytes(const uint8_t* values, size_t count) {
  properties_.push_back('R');
  put(static_cast<uint32_t>(count), &properties_);
  properties_.insert(properties_.end(), values, values + count);
  ++property_count_;
  return *this;
}

template <class T>
FbxNode& FbxNode::array(char type, const std::vector<T>& values) {
  properties_.push_back(static_cast<uint8_t>(type));
  put(static_cast<uint32_t>(values.size()), &properties_);
  put(uint32_t{0}, &properties_);  // not compressed
  put(static_cast<uint32_t>(values.size() * sizeof(T)), &properties_);
  for (const T value : values) put(value, &properties_);
  ++property_count_;
  return *this;
}

FbxNode& FbxNode::integers(const std::vector<int32_t>& values) { return array('i', values); }
FbxNode& FbxNode::longs(const std::vector<int64_t>& values) { return array('l', values); }
FbxNode& FbxNode::numbers(const std::vector<double>& values) { return array('d', values); }
FbxNode& FbxNode::floats(const std::vector<float>& values) { return array('f', values); }

FbxNode& FbxNode::matrix(const Affine& m) {
  std::vector<double> values;
  for (size_t c = 0; c < 4; ++c)
    for (size_t r = 0; r < 4; ++r) values.push_back(r < 3 ? m[4 * r + c] : (c == 3 ? 1.0 : 0.0));
  return numbers(values);
}

FbxNode& FbxNode::add(const std::string& name) { return add(FbxNode(name)); }
FbxNode& FbxNode::add(FbxNode node) {
  nodes_.push_back(std::move(node));
  return nodes_.back();
}

FbxNode& FbxNode::property(const char* name, const char* type, const char* kind, const char* flags) {
  return add("P").text(name).text(type).text(kind).text(flags);
}
FbxNode& FbxNode::property_number(const char* name, double value) {
  return property(name, "double", "Number", "").number(value);
}
FbxNode& FbxNode::property_integer(const char* name, int32_t value) {
  return property(name, "int", "Integer", "").integer(value);
}
FbxNode& FbxNode::property_enum(const char* name, int32_t value) {
  return property(name, "enum", "", "").integer(value);
}
FbxNode& FbxNode::property_time(const char* name, int64_t value) {
  return property(name, "KTime", "Time", "").id(value);
}
FbxNode& FbxNode::property_text(const char* name, const char* kind, const std::string& value) {
  return property(name, "KString", kind, "").text(value);
}
FbxNode& FbxNode::property_vector(const char* name, const char* type, const char* kind, const char* flags,
                                  const std::array<double, 3>& value) {
  return property(name, type, kind, flags).number(value[0]).number(value[1]).number(value[2]);
}

void FbxNode::write(std::vector<uint8_t>* out) const {
  const size_t begin = out->size();
  put(uint64_t{0}, out);  // where it ends
  put(property_count_, out);
  put(static_cast<uint64_t>(properties_.size()), out);
  out->push_back(static_cast<uint8_t>(name_.size()));
  put_text(name_, out);
  out->insert(out->end(), properties_.begin(), properties_.end());
  for (const FbxNode& node : nodes_) node.write(out);
  // Readers want a list of these, though it is empty.
  const bool listed = name_ == "AnimationLayer" || name_ == "AnimationStack";
  if (!nodes_.empty() || property_count_ == 0 || listed) out->insert(out->end(), kHead, uint8_t{0});
  overwrite(out->size(), begin, out);
}

std::string fbx_name(const std::string& name, const char* of) {
  std::string out = name;
  out += '\0';
  out += '\1';
  return out + of;
}

std::vector<uint8_t> fbx_file(const std::vector<FbxNode>& nodes) {
  std::vector<uint8_t> out;
  put_text("Kaydara FBX Binary  ", &out);
  out.insert(out.end(), {uint8_t{0}, uint8_t{0x1a}, uint8_t{0}});
  put(kVersion, &out);
  for (const FbxNode& node : nodes) node.write(&out);
  out.insert(out.end(), kHead, uint8_t{0});
  out.insert(out.end(), kFoot.begin(), kFoot.end());
  out.insert(out.end(), 4, uint8_t{0});
  out.insert(out.end(), 16 - out.size() % 16, uint8_t{0});
  put(kVersion, &out);
  out.insert(out.end(), 120, uint8_t{0});
  out.insert(out.end(), kEnd.begin(), kEnd.end());
  return out;
}

const std::array<uint8_t, 16>& fbx_file_id() {
  static const std::array<uint8_t, 16> kId = {0x28, 0xb3, 0x2a, 0xeb, 0xb6, 0x24, 0xcc, 0xc2,
                                              0xbf, 0xc8, 0xb0, 0x2a, 0xa9, 0x2b, 0xfc, 0xf1};
  return kId;
}

const char* fbx_creation_time() { return "1970-01-01 10:00:00:000"; }

}  // namespace sinew
