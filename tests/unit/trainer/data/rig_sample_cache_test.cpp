// SPDX-License-Identifier: MIT
// Samples come back from the disk as they were; a damaged file is none.
#include "data/rig_sample_cache.hpp"

#include <gtest/gtest.h>

#include "data/front_sample.hpp"
#include "data/rig_sample.hpp"
#include "data/slot_sample.hpp"
#include "sinew_data_sets/synthesize.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

Character cached_biped() {
  SynthesizeOptions options;
  options.plan = BodyPlan::kBiped;
  options.seed = 4;
  options.resolution = 24;
  return synthesize(options);
}

template <class Kind>
Kind through_the_disk(const Kind& sample, const TempFolder& folder) {
  RigSamples samples;
  samples.push_back(std::make_unique<Kind>(sample));
  samples.push_back(std::make_unique<Kind>(sample));
  write_rig_samples(folder.file("a.samples"), samples);
  const std::optional<RigSamples> read = read_rig_samples(folder.file("a.samples"));
  EXPECT_TRUE(read.has_value());
  if (!read) return {};
  EXPECT_EQ(read->size(), 2u);
  return dynamic_cast<const Kind&>(*read->back());
}

void expect_cached_inputs(const NetworkSample& a, const NetworkSample& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.family, b.family);
  EXPECT_EQ(a.vertices, b.vertices);
  ASSERT_EQ(a.inputs.size(), b.inputs.size());
  for (size_t i = 0; i < a.inputs.size(); ++i) {
    EXPECT_EQ(a.inputs[i].channels, b.inputs[i].channels);
    EXPECT_EQ(a.inputs[i].rows, b.inputs[i].rows);
  }
  EXPECT_EQ(a.col_indices, b.col_indices);
  EXPECT_EQ(a.far_indices, b.far_indices);
  EXPECT_EQ(a.part_vertices, b.part_vertices);
}

TEST(RigSampleCache, SamplesComeBackAsTheyWere) {
  const TempFolder folder;
  const RigSource source(cached_biped());
  const RigSample votes = source.make(7, {});
  const RigSample again = through_the_disk(votes, folder);
  expect_cached_inputs(votes, again);
  EXPECT_EQ(votes.medial, again.medial);
  EXPECT_EQ(votes.start, again.start);
  EXPECT_EQ(votes.end_class, again.end_class);
  EXPECT_EQ(votes.weight, again.weight);
  const SlotSample slots = make_slot_sample(source, 7, 0);
  const SlotSample slots_again = through_the_disk(slots, folder);
  expect_cached_inputs(slots, slots_again);
  EXPECT_EQ(slots.joints, slots_again.joints);
  EXPECT_EQ(slots.connected, slots_again.connected);
  const FrontSample front = FrontSource(cached_biped()).original(7);
  const FrontSample front_again = through_the_disk(front, folder);
  expect_cached_inputs(front, front_again);
  EXPECT_EQ(front.front, front_again.front);
  EXPECT_EQ(front.normals, front_again.normals);
}

TEST(RigSampleCache, ADamagedFileIsNone) {
  const TempFolder folder;
  EXPECT_FALSE(read_rig_samples(folder.file("none.samples")).has_value());
  (void)through_the_disk(RigSource(cached_biped()).make(7, {}), folder);
  std::string bytes = folder.text_of("a.samples");
  bytes[bytes.size() / 2] ^= 1;
  EXPECT_FALSE(read_rig_samples(folder.write("damaged.samples", bytes)).has_value());
  EXPECT_FALSE(read_rig_samples(folder.write("cut.samples", bytes.substr(0, 100))).has_value());
}

}  // namespace
}  // namespace sinew
