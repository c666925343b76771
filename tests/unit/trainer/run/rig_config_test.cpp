// SPDX-License-Identifier: MIT
// Configuration files of skeletons: what is shipped is valid, errors name the key.
#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/rig_train.hpp"

namespace sinew {
namespace {

TEST(RigTrainConfig, ShippedFilesAreValid) {
  for (const char* name : {"votes", "votes_more", "votes_left_out", "votes_grown", "votes_grown_more", "hands",
                           "hands_more", "slots", "slots_first", "slots_more", "front"}) {
    const std::string path = std::string(SINEW_SOURCE_DIR) + "/trainer/configs/" + name + ".json";
    const RigTrainConfig config = parse_rig_config(read_text_file(path), path);
    const std::string first = std::string(name).substr(0, std::string(name).find('_'));
    EXPECT_EQ(config.architecture, first == "slots" || first == "front" ? first : "votes");
    EXPECT_EQ(rig_config_json(parse_rig_config(rig_config_json(config), "again")), rig_config_json(config));
  }
}

TEST(RigTrainConfig, ErrorsNameFileAndKey) {
  EXPECT_ERROR(parse_rig_config(R"({"architecture": "field"})", "run.json"), "run.json: architecture",
               "\"votes\", \"slots\" or \"front\"");
  EXPECT_ERROR(parse_rig_config(R"({"balance": 1.5})", "run.json"), "run.json: balance: expected 0 to 1");
  EXPECT_ERROR(parse_rig_config(R"({"patience": -1})", "run.json"), "run.json: patience");
  EXPECT_ERROR(parse_rig_config(R"({"grown": 1.5})", "run.json"), "run.json: grown: expected 0 to 1");
  EXPECT_ERROR(parse_rig_config(R"({"least_variants": 13})", "run.json"), "run.json: least_variants", "0 to variants");
  EXPECT_ERROR(parse_rig_config(R"({"rounds": 9})", "run.json"), "run.json: rounds: expected 2 to 8");
}

}  // namespace
}  // namespace sinew
