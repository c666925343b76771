// SPDX-License-Identifier: MIT
// Real characters, where this machine has them: all are read, checked and written without a complaint.
#include <gtest/gtest.h>

#include <cmath>

#include "gltf_validator.hpp"
#include "shared_data.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

using namespace sinew;

namespace {

std::vector<std::string> characters(const char* set) {
  const std::filesystem::path folder = shared_folder();
  return folder.empty() ? std::vector<std::string>() : list_characters((folder / "data" / "characters" / set).string());
}

#define SKIP_WITHOUT_SHARED_DATA() \
  if (shared_folder().empty())     \
  GTEST_SKIP() << "NO SHARED DATA HERE: real characters were not read; set SINEW_SHARED_DIR"

TEST(SharedCharacters, AllAreReadAndSound) {
  SKIP_WITHOUT_SHARED_DATA();
  size_t count = 0;
  for (const char* set : {"train", "val"})
    for (const std::string& path : characters(set)) {
      const Character c = read_character(path);
      ++count;
      EXPECT_NE(family_of(c.name), "all") << path;
      EXPECT_EQ(c.influences.size(), c.vertices.size()) << path;
      const CheckReport report = check_character(c);
      EXPECT_EQ(report.bad_weight_sums, 0u) << path;
      EXPECT_EQ(report.hierarchy_cycles, 0u) << path;
      EXPECT_LE(report.max_influences, 8u) << path;
      for (const CheckFinding& finding : report.findings)
        EXPECT_NE(finding.level, CheckFinding::Level::kError) << path << ": " << finding.text;
    }
  EXPECT_GE(count, 300u);
}

TEST(SharedCharacters, DecimatedToHalfAndAQuarter) {
  SKIP_WITHOUT_SHARED_DATA();
  const std::vector<std::string> paths = characters("val");
  for (size_t i = 0; i < paths.size(); i += 4) {
    const Character c = read_character(paths[i]);
    for (const double ratio : {0.5, 0.25}) {
      const Character d = decimate(c, ratio);
      EXPECT_NEAR(static_cast<double>(d.vertices.size()) / (ratio * static_cast<double>(c.vertices.size())), 1, 0.1)
          << paths[i];
      EXPECT_EQ(check_character(d).bad_weight_sums, 0u) << paths[i];
    }
  }
}

TEST(SharedCharacters, GlbComesBackAndPassesTheValidator) {
  SKIP_WITHOUT_SHARED_DATA();
  const TempFolder folder;
  const std::vector<std::string> paths = characters("val");
  std::vector<std::string> files;
  for (size_t i = 0; i < paths.size(); i += 3) {
    const Character c = read_character(paths[i]);
    for (int round = 0; round < 2; ++round) {
      files.push_back(folder.file(c.name + std::to_string(round) + ".glb"));
      write_glb(files.back(), round == 0 ? c : read_character(files[files.size() - 2]));
    }
    const Character back = read_character(files.back());
    EXPECT_EQ(back.vertices.size(), c.vertices.size()) << paths[i];
    EXPECT_EQ(back.joints.size(), c.joints.size()) << paths[i];
  }
  SINEW_EXPECT_VALID_GLTF(files);
}

}  // namespace
