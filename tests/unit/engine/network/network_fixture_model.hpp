// SPDX-License-Identifier: MIT
// A quantized network, opened, and its plan.
#ifndef SINEW_TESTS_NETWORK_FIXTURE_MODEL_HPP
#define SINEW_TESTS_NETWORK_FIXTURE_MODEL_HPP

#include <gtest/gtest.h>

#include "network/plan.hpp"
#include "network_fixture.hpp"
#include "sinew_quant/quantize.hpp"

namespace sinew::test {

struct OpenedModel {
  explicit OpenedModel(const std::vector<uint8_t>& bytes) : file(bytes) {
    EXPECT_EQ(sinew_model_open(file.data(), file.size(), &model), SINEW_OK);
    make_plan(model, model.candidate_count, &plan);
  }
  AlignedBytes file;
  sinew_model model{};
  NetworkPlan plan;
};

inline OpenedModel field_model(uint32_t k) {
  const FloatNetwork network = field_like(3, k, 16, 2);
  const Graph g = random_graph(5, 60, k, 20, 4, usual_feature);
  return OpenedModel(quantize(network, {run_float(network, g).layer_max}).bytes);
}

}  // namespace sinew::test
#endif
