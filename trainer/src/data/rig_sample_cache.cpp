// SPDX-License-Identifier: MIT
#include "data/rig_sample_cache.hpp"

#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>
#include <utility>

#include "data/cache_file.hpp"
#include "data/front_sample.hpp"
#include "data/rig_sample.hpp"
#include "data/slot_sample.hpp"

namespace sinew {
namespace {

constexpr uint64_t kVersion = 1;  // of the layout below

// Every member of what all samples have.
template <class Archive>
void visit_network_sample(Archive& archive, NetworkSample& s) {
  archive(s.name, s.family, s.vertices, s.candidates, s.part_count, s.joints, s.candidate, s.row_offsets, s.col_indices,
          s.far_offsets, s.far_indices, s.part, s.part_offsets, s.part_vertices);
  uint64_t count = s.inputs.size();
  archive(count);
  s.inputs.resize(static_cast<size_t>(count));
  for (NetworkSample::Input& input : s.inputs) archive(input.channels, input.rows);
}

template <class Archive>
void visit(Archive& archive, RigSample& s) {
  visit_network_sample(archive, s);
  archive(s.medial, s.start, s.end, s.weight, s.class_weight, s.start_class, s.end_class);
}
template <class Archive>
void visit(Archive& archive, SlotSample& s) {
  visit_network_sample(archive, s);
  archive(s.joints, s.present, s.connected);
}
template <class Archive>
void visit(Archive& archive, FrontSample& s) {
  visit_network_sample(archive, s);
  archive(s.positions, s.normals, s.front);
}

template <class Kind>
bool write_as(const RigSamples& samples, uint8_t kind, cereal::BinaryOutputArchive* archive) {
  if (dynamic_cast<const Kind*>(samples.at(0).get()) == nullptr) return false;
  (*archive)(kind, static_cast<uint64_t>(samples.size()));
  for (const auto& sample : samples) {
    Kind copy = dynamic_cast<const Kind&>(*sample);
    visit(*archive, copy);
  }
  return true;
}

template <class Kind>
RigSamples read_as(uint64_t count, cereal::BinaryInputArchive* archive) {
  RigSamples samples;
  for (uint64_t i = 0; i < count; ++i) {
    auto sample = std::make_unique<Kind>();
    visit(*archive, *sample);
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace

std::optional<RigSamples> read_rig_samples(const std::string& path) {
  const std::optional<std::string> payload = read_cache_file(path, kVersion);
  if (!payload) return std::nullopt;
  std::istringstream stream(*payload, std::ios::binary);
  cereal::BinaryInputArchive archive(stream);
  uint8_t kind = 0;
  uint64_t count = 0;
  archive(kind, count);
  return kind == 0   ? read_as<RigSample>(count, &archive)
         : kind == 1 ? read_as<SlotSample>(count, &archive)
                     : read_as<FrontSample>(count, &archive);
}

void write_rig_samples(const std::string& path, const RigSamples& samples) {
  std::ostringstream stream(std::ios::binary);
  {
    cereal::BinaryOutputArchive archive(stream);
    if (!write_as<RigSample>(samples, 0, &archive) && !write_as<SlotSample>(samples, 1, &archive))
      write_as<FrontSample>(samples, 2, &archive);
  }
  write_cache_file(path, kVersion, stream.str());
}

}  // namespace sinew
