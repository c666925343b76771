// SPDX-License-Identifier: MIT
// The model files of tests/golden are what their seeds give, and between them use every kind of layer. With
// SINEW_UPDATE_GOLDEN set in the environment the files are written instead.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "features/features.hpp"
#include "network_fixture.hpp"
#include "sinew/sinew.h"
#include "sinew_formats/io.hpp"
#include "spectral/spectral.hpp"

namespace sinew::test {
namespace {

struct GoldenModel {
  const char* file;
  uint32_t seed, candidates, grid;
  bool spectral;
};
// Seeds of small files with many layers.
constexpr GoldenModel kModels[] = {{"mixed.sinew", 162, 8, 32, false},
                                   {"narrow.sinew", 160, 3, 16, false},
                                   {"broad.sinew", 113, 16, 24, false},
                                   {"spectral.sinew", 95, 8, 16, true}};

IntegerModel make(const GoldenModel& golden) {
  IntegerModel model =
      random_model(golden.seed, golden.candidates, kVertexFeatures + (golden.spectral ? kSpectralChannels : 0));
  model.grid_size = golden.grid;
  if (golden.spectral) model.feature_set |= kSpectralFlag;
  return model;
}

std::string path_of(const GoldenModel& golden) {
  return std::string(SINEW_SOURCE_DIR) + "/tests/golden/models/" + golden.file;
}

TEST(GoldenModels, AreWhatTheirSeedsGive) {
  for (const GoldenModel& golden : kModels) {
    const std::vector<uint8_t> bytes = write_model(make(golden));
    AlignedBytes aligned(bytes);
    sinew_model model = {};
    ASSERT_EQ(sinew_model_open(aligned.data(), bytes.size(), &model), SINEW_OK) << golden.file;
    if (std::getenv("SINEW_UPDATE_GOLDEN") != nullptr) write_file(path_of(golden), bytes);
    EXPECT_TRUE(read_file(path_of(golden)) == bytes)
        << golden.file << ": run this with SINEW_UPDATE_GOLDEN=1, then tests/golden/golden_test.sh with --update";
  }
}

TEST(GoldenModels, UseEveryKindOfLayer) {
  std::set<int> kinds, classes;
  bool residual = false, partial = false;
  for (const GoldenModel& golden : kModels) {
    const IntegerModel model = make(golden);
    for (const Layer& layer : model.layers) {
      kinds.insert(static_cast<int>(layer.kind));
      residual = residual || (layer.flags & kLayerResidual) != 0;
    }
    for (const IntegerLinear& linear : model.linears) {
      classes.insert(static_cast<int>(linear.accumulator));
      partial = partial || linear.block < linear.in;
    }
  }
  EXPECT_EQ(kinds.size(), size_t{kLayerKindCount});
  EXPECT_EQ(classes.size(), 2u);
  EXPECT_TRUE(residual);
  EXPECT_TRUE(partial) << "no layer of class W in several blocks";
}

}  // namespace
}  // namespace sinew::test
