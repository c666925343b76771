// SPDX-License-Identifier: MIT
// A run's logits do not depend on where weights are read or how vertices are cut into tiles. The arithmetic itself is
// compared with an interpreter in tests/integration/executor_test.cpp.
#include "network/network.hpp"

#include "kernels/select.hpp"
#include "network_fixture_model.hpp"

namespace sinew::test {
namespace {

std::vector<int16_t> logits_of(const OpenedModel& opened, const Graph& g, const NetworkOptions& options) {
  const Kernels kernels = fastest_kernels();
  const NetworkInput input = g.input();
  Arena measuring;
  EXPECT_EQ(run_network(opened.model, input, kernels, {}, measuring, nullptr, options), SINEW_OK);
  AlignedBytes memory(measuring.high_water());
  Arena arena(memory.data(), memory.size());
  std::vector<int16_t> logits(size_t{g.vertices} * g.k, 12345);
  EXPECT_EQ(run_network(opened.model, input, kernels, {}, arena, logits.data(), options), SINEW_OK);
  EXPECT_EQ(arena.used(), 0u);
  return logits;
}

TEST(Network, WeightsInPlaceAndTilesOfAnySizeGiveTheSame) {
  const OpenedModel opened = field_model(6);
  const Graph g = random_graph(9, 83, 6, 12, 3, any_feature);
  const std::vector<int16_t> want = logits_of(opened, g, {});
  EXPECT_GT(std::set<int16_t>(want.begin(), want.end()).size(), 50u);
  EXPECT_EQ(logits_of(opened, g, {true, kTileVertices}), want);
  for (const uint32_t tile : {1u, 7u, 200u}) {
    EXPECT_EQ(logits_of(opened, g, {false, tile}), want) << tile;
    EXPECT_EQ(logits_of(opened, g, {true, tile}), want) << tile;
  }
}

TEST(Network, AFullWorkspaceIsSaidAndScratchIsGivenBack) {
  const OpenedModel opened = field_model(6);
  const Graph g = random_graph(9, 40, 6, 12, 3, any_feature);
  Arena measuring;
  ASSERT_EQ(run_network(opened.model, g.input(), fastest_kernels(), {}, measuring, nullptr), SINEW_OK);
  AlignedBytes memory(measuring.high_water() - 64);
  Arena arena(memory.data(), memory.size());
  std::vector<int16_t> logits(size_t{g.vertices} * g.k);
  EXPECT_EQ(run_network(opened.model, g.input(), fastest_kernels(), {}, arena, logits.data()), SINEW_ERROR_WORKSPACE);
  EXPECT_EQ(arena.used(), 0u);
}

}  // namespace
}  // namespace sinew::test
