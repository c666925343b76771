// SPDX-License-Identifier: MIT
// The published networks, for weights and for skeletons, on the repository's own samples: what their models are asked to do.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "expect_error.hpp"
#include "features/attributes.hpp"
#include "features/channel_values.hpp"
#include "network/slot_network.hpp"
#include "sinew/published.h"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_quant/model_writer.hpp"
#include "sinew_quant/quantize.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/rig_difference.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {
namespace {

using namespace rigging;

const std::string kNetworkData = SINEW_SOURCE_DIR "/samples/data/";

Character sample_character(const char* name) { return read_character(kNetworkData + name + ".obj"); }

TEST(PublishedNetworks, AttributesArePositionsNormalsLaplaciansAndDistances) {
  const Character character = sample_character("snake__long");
  const Sample plain = make_sample(character, 8, 64, kAttributesFlag);
  const Sample own = make_sample(character, 8, 64);
  ASSERT_EQ(plain.inputs[0].channels, kVertexAttributes);
  ASSERT_EQ(plain.inputs[1].channels, kPairAttributes);
  EXPECT_EQ(make_sample(character, 8, 64, kAttributesFlag | kSpectralFlag).inputs[0].channels,
            kVertexAttributes + kSpectralChannels);
  for (uint32_t v = 0; v < plain.vertices; ++v) {
    const int16_t* const row = &plain.inputs[0].rows[size_t{v} * kVertexAttributes];
    double normal = 0;
    for (uint32_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(row[kAttributePosition + c] / 16384.0, static_cast<double>(plain.positions[size_t{3} * v + c]), 1e-4);
      normal += row[kAttributeNormal + c] * row[kAttributeNormal + c] / (8192.0 * 8192.0);
    }
    EXPECT_NEAR(normal, 1, 0.01) << v;
    const int16_t* const all = &own.inputs[0].rows[size_t{v} * own.inputs[0].channels];
    EXPECT_EQ(row[kAttributeCurvature], all[features::kV_mean_curvature]);
    EXPECT_EQ(row[kAttributeCurvature + 1], all[features::kV_gauss_curvature]);
    for (uint32_t k = 1; k < plain.candidates; ++k) {
      const int16_t* const pair = &plain.inputs[1].rows[(size_t{v} * plain.candidates + k) * kPairAttributes];
      if (plain.candidate[size_t{v} * plain.candidates + k] == 0xFFFF) continue;
      EXPECT_GE(pair[kAttributeThrough], (pair - kPairAttributes)[kAttributeThrough]) << "the nearest come first";
    }
  }
  EXPECT_EQ(own.inputs[1].channels, kPairFeatures) << "other models see what they saw";
}

// A classic network of published attributes binds without heat: less memory, and the weights are those of its logits.
TEST(PublishedNetworks, ClassicBindsWithoutHeat) {
  const Character character = sample_character("snake__long");
  const std::vector<Sample> samples = {make_sample(character, 8, 64, kAttributesFlag)};
  const FloatNetwork network = make_classic(8, 64, 3, kAttributesFlag, 2);
  EXPECT_EQ(network.parameters.size(), make_classic(8, 64, 3, kAttributesFlag, 1).parameters.size() + 3)
      << "a second layer in each of three perceptrons";
  const QuantizedModel quantized = quantize(network, calibrate(network, samples));
  const std::unique_ptr<LoadedModel> model = model_from_bytes(quantized.bytes, "classic");
  EXPECT_EQ(model->model.feature_set, kFeatureSet | kAttributesFlag);
  BindOptions options;
  options.method = SINEW_METHOD_MODEL;
  options.model = &model->model;
  const BindResult bound = bind(character, options);
  const auto expected = sample_influences(samples[0], softmax(samples[0], engine_logits(model->model, samples[0])), 4);
  size_t same = 0;
  for (size_t v = 0; v < expected.size(); ++v)
    same +=
        !bound.influences[v].empty() && !expected[v].empty() && bound.influences[v][0].joint == expected[v][0].joint;
  EXPECT_GE(same, expected.size() * 98 / 100);
}

// Both networks in one file, run by the engine alone: the same joints by every kernel, and a broken second half is refused.
TEST(PublishedNetworks, SlotsAreTwoNetworksInOneFileAndTheSameByEveryKernel) {
  const FloatNetwork both = make_slot_network({8, 2}, 5);
  const SlotNetworks networks = calibrate_slots(both, SINEW_SOURCE_DIR "/samples/data", 3);
  const std::vector<uint8_t> first = quantize(networks.joints, networks.joint_ranges).bytes;
  std::vector<uint8_t> bytes =
      with_second_network(first, quantize(networks.connections, networks.connection_ranges).bytes);
  const std::unique_ptr<LoadedModel> model = model_from_bytes(bytes, "slots", ModelUse::kSlotJoints);
  EXPECT_ERROR(model_from_bytes(bytes, "slots", ModelUse::kRig), "slots: ");
  EXPECT_ERROR(model_from_bytes(first, "alone", ModelUse::kSlotJoints), "alone: ");
  const SlotDifference difference = compare_slots(both, model->model, SINEW_SOURCE_DIR "/samples/data", 3);
  EXPECT_LT(difference.most, 1e-3) << "of the longest side, beside float";

  SkeletonOptions options;
  options.method = SINEW_RIG_SLOTS;
  options.model = &model->model;
  const Character mesh = sample_character("biped__robot");
  const PredictedSkeleton joints = predict_skeleton(mesh, options);
  ASSERT_GE(joints.joints.size(), 1u);
  EXPECT_EQ(joints.joints[0].parent, -1);
  options.kernel = SINEW_KERNEL_REF;
  const PredictedSkeleton again = predict_skeleton(mesh, options);
  ASSERT_EQ(again.joints.size(), joints.joints.size());
  for (size_t j = 0; j < joints.joints.size(); ++j) {
    EXPECT_EQ(again.joints[j].name, joints.joints[j].name);
    EXPECT_EQ(again.joints[j].parent, joints.joints[j].parent);
    EXPECT_EQ(again.joints[j].position.x, joints.joints[j].position.x);
    EXPECT_EQ(again.joints[j].position.y, joints.joints[j].position.y);
    EXPECT_EQ(again.joints[j].position.z, joints.joints[j].position.z);
  }
  options.category = 9;
  EXPECT_ERROR(predict_skeleton(mesh, options), "biped__robot: ");
}

// The shipped model is small enough to be bundled, and finds a humanoid's limbs.
TEST(PublishedNetworks, ShippedSlotsFindAHumanoid) {
  const std::vector<uint8_t> bytes = read_file(kNetworkData + "sinew_slots.sinew");
  EXPECT_LE(bytes.size(), 300000u);
  const std::unique_ptr<LoadedModel> model = model_from_bytes(bytes, "sinew_slots.sinew", ModelUse::kSlotJoints);
  SkeletonOptions options;
  options.method = SINEW_RIG_SLOTS;
  options.model = &model->model;
  const PredictedSkeleton found = predict_skeleton(sample_character("biped__robed"), options);
  for (const JointClass c : {kClassPelvis, kClassHead, kClassUpperArm, kClassHand, kClassThigh, kClassFoot})
    EXPECT_NE(std::count(found.classes.begin(), found.classes.end(), c), 0) << static_cast<int>(c);
}

}  // namespace
}  // namespace sinew
