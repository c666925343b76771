// SPDX-License-Identifier: MIT
// Pictures through sinew/character.h: the command's bytes, what was found, an outline of the user's own, what is refused.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "character_handle.hpp"
#include "cli_fixture.hpp"
#include "sinew/character.h"

namespace sinew {
namespace {

const std::string kChild = kData + "/drawing__child.png", kCat = kData + "/drawing__cat.png";

Handle open_memory(const std::vector<std::string>& paths, const sinew_character_picture_options& options) {
  const MemoryFiles files(paths);
  sinew_character* character = nullptr;
  EXPECT_EQ(sinew_character_open_picture_files(files.data(), files.count(), &options, &character), SINEW_OK)
      << sinew_character_error(nullptr);
  return Handle(character);
}

sinew_character_picture_info info_of(const Handle& character) {
  sinew_character_picture_info info = SINEW_INIT(sinew_character_picture_info);
  EXPECT_EQ(sinew_character_picture(character.get(), &info), SINEW_OK) << sinew_character_error(character.get());
  return info;
}

class PictureC : public Cli {
 protected:
  void good_call(sinew_status status, const Handle& character) {
    ASSERT_EQ(status, SINEW_OK) << sinew_character_error(character.get());
  }
  void expect_command(const Handle& character, const std::string& commands) {
    const sinew_file* files = nullptr;
    uint32_t count = 0;
    good_call(sinew_character_write(character.get(), commands.c_str(), &files, &count), character);
    ASSERT_EQ(count, 1u);
    const std::string command = slurp(in(commands));
    EXPECT_GT(command.size(), 0u);
    EXPECT_TRUE(std::string(static_cast<const char*>(files[0].bytes), files[0].size_bytes) == command) << commands;
  }
};

TEST_F(PictureC, RigsAndPlaysAsTheCommand) {
  good("rig " + kChild + " -o rigged.glb");
  const Handle child = open(kChild);
  sinew_character_picture_info info = info_of(child);
  EXPECT_EQ(info.width, 360u);
  EXPECT_EQ(info.body_class, uint32_t{SINEW_BODY_CLASS_FOUND}) << "it is not rigged yet";
  good_call(sinew_character_rig(child.get(), nullptr, nullptr), child);
  info = info_of(child);
  EXPECT_EQ(info.body_class, uint32_t{SINEW_BODY_CLASS_BIPED});
  EXPECT_EQ(info.view, uint32_t{SINEW_PICTURE_VIEW_FRONT});
  EXPECT_GT(info.certainty, 0.5f);
  EXPECT_LE(info.certainty, 1.0f);
  expect_command(child, "rigged.glb");

  good("animate " + kChild + " -o waving.glb");
  const Handle waving = open(kChild);
  sinew_character_animate_result result = SINEW_INIT(sinew_character_animate_result);
  good_call(sinew_character_animate(waving.get(), nullptr, nullptr, &result), waving);
  EXPECT_EQ(result.rigged, 1u);
  EXPECT_EQ(result.clip_count, 1u);
  EXPECT_EQ(info_of(waving).body_class, uint32_t{SINEW_BODY_CLASS_BIPED});
  expect_command(waving, "waving.glb");
  good_call(sinew_character_animate(child.get(), nullptr, nullptr, nullptr), child);
  expect_command(child, "waving.glb");
}

TEST_F(PictureC, OptionsAreTheCommands) {
  good("rig " + kCat + " --flat --units pixels --class quadruped --mask-out mask.png -o cat.glb");
  sinew_character_picture_options options = SINEW_INIT(sinew_character_picture_options);
  options.body_class = SINEW_BODY_CLASS_QUADRUPED;
  options.flat = options.pixels = 1;
  const Handle cat = open_memory({kCat}, options);
  good_call(sinew_character_rig(cat.get(), nullptr, nullptr), cat);
  expect_command(cat, "cat.glb");

  good("animate " + kCat + " --motion builtin:quadruped/walk --depth --mask mask.png -o walk.glb");
  sinew_character_picture_options masked = SINEW_INIT(sinew_character_picture_options);
  masked.mask = "mask.png";
  const Handle walking = open_memory({kCat, in("mask.png")}, masked);
  const Handle walk = open("builtin:quadruped/walk");
  sinew_character_animate_options depth = SINEW_INIT(sinew_character_animate_options);
  depth.depth = 1;
  good_call(sinew_character_animate(walking.get(), walk.get(), &depth, nullptr), walking);
  expect_command(walking, "walk.glb");
}

// The outline that was found, given back, is the same figure; without its left half it is half a figure.
TEST_F(PictureC, AnOutlineOfTheUsersOwnIsTheFigure) {
  const Handle child = open(kChild);
  const sinew_character_picture_info found = info_of(child);
  ASSERT_GE(found.line_count, 1u);
  std::vector<uint32_t> offsets(found.line_offsets, found.line_offsets + found.line_count + 1);
  std::vector<float> outline(found.outline, found.outline + size_t{2} * offsets.back());
  sinew_character_picture_options options = SINEW_INIT(sinew_character_picture_options);
  options.pixels = 1;
  options.line_count = found.line_count;
  options.line_offsets = offsets.data();
  options.outline = outline.data();
  const auto width_of = [](const Handle& character) {
    sinew_character_arrays arrays = SINEW_INIT(sinew_character_arrays);
    EXPECT_EQ(sinew_character_view(character.get(), &arrays), SINEW_OK);
    float low = 1e9f, high = -1e9f;
    for (uint32_t v = 0; v < arrays.vertex_count; ++v) {
      low = std::min(low, arrays.positions[3 * v]);
      high = std::max(high, arrays.positions[3 * v]);
    }
    return high - low;
  };
  const float whole = width_of(open_memory({kChild}, options));
  EXPECT_GT(whole, 150);
  for (size_t i = 0; i < outline.size(); i += 2) outline[i] = std::max(outline[i], 180.0f);
  EXPECT_NEAR(width_of(open_memory({kChild}, options)), whole / 2, 4);
}

TEST_F(PictureC, WhatIsWrongIsALine) {
  sinew_character* none = nullptr;
  sinew_character_picture_options options = SINEW_INIT(sinew_character_picture_options);
  options.body_class = 8;
  EXPECT_EQ(sinew_character_open_picture(kChild.c_str(), &options, &none), SINEW_ERROR_ARGUMENT);
  options.body_class = 0;
  options.figure = 2;
  EXPECT_EQ(sinew_character_open_picture(kChild.c_str(), &options, &none), SINEW_ERROR_INPUT);
  EXPECT_NE(std::string(sinew_character_error(nullptr)).find("no figure 2"), std::string::npos);
  EXPECT_EQ(none, nullptr);
  const Handle snake = open(kSnake);
  sinew_character_picture_info info = SINEW_INIT(sinew_character_picture_info);
  EXPECT_EQ(sinew_character_picture(snake.get(), &info), SINEW_ERROR_INPUT);
  EXPECT_EQ(sinew_character_animate(snake.get(), nullptr, nullptr, nullptr), SINEW_ERROR_ARGUMENT);
  EXPECT_STREQ(sinew_character_extensions(SINEW_READ_PICTURE), ".png .jpg .jpeg");
  EXPECT_STREQ(sinew_character_extensions(SINEW_READ_MESH | SINEW_READ_PICTURE), "");
}

}  // namespace
}  // namespace sinew
