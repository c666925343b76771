// SPDX-License-Identifier: MIT
// Whole files and folders: what a failed write leaves on disk, what a folder of characters holds.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

TEST(Files, AFailedWriteLeavesTheTargetAndNoRubbish) {
  const TempFolder folder;
  folder.write("old.txt", "old");
  write_text_file(folder.file("old.txt"), "new");
  EXPECT_EQ(folder.text_of("old.txt"), "new");
  EXPECT_ERROR(write_text_file(folder.file("missing/x.txt"), "x"), "missing/x.txt", "does not exist");
  std::filesystem::create_directory(folder.file("dir"));
  EXPECT_ERROR(write_text_file(folder.file("dir"), "x"), "dir", "directory");
  EXPECT_EQ(folder.file_count(), 2u);
  const Character empty;
  EXPECT_ERROR(write_glb(folder.file("old.txt"), empty), "old.txt", "without faces");
  EXPECT_EQ(folder.text_of("old.txt"), "new");
}

TEST(Files, AFullDiskLeavesTheTargetAndNoRubbish) {
  const TempFolder folder;
  folder.write("old.txt", "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 4096;
  signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  std::string message;
  try {
    write_text_file(folder.file("old.txt"), std::string(100000, 'x'));
  } catch (const Error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_NE(message.find("cannot write"), std::string::npos) << message;
  EXPECT_EQ(folder.text_of("old.txt"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Files, FollowsLinksAndWritesDevices) {
  const TempFolder folder;
  folder.write("real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder.file("link.txt"));
  write_text_file(folder.file("link.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(folder.text_of("real.txt"), "new");
  EXPECT_NO_THROW(write_text_file("/dev/null", "gone"));
}

TEST(Folders, AMeshWithoutARigIsNoFailureOfTheFolder) {
  const TempFolder folder;
  folder.write("alone.obj", "v 0 0 0\n");
  EXPECT_TRUE(list_characters(folder.path()).empty());
  std::filesystem::create_symlink(folder.file("nowhere"), folder.file("dangling.glb"));
  EXPECT_TRUE(list_characters(folder.path()).empty());
}

TEST(Folders, ListsPairsAndGltfSortedByName) {
  const TempFolder folder;
  for (const char* name : {"b__2.obj", "b__2.rig.txt", "a__1.GLB", "c.obj", "d.rig.txt", "e__.vrm", "readme.txt"})
    folder.write(name, "x");
  const std::vector<std::string> found = list_characters(folder.path());
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0], folder.file("a__1.GLB"));
  EXPECT_EQ(found[1], folder.file("b__2.obj"));
  EXPECT_EQ(family_of("b__2"), "b");
  EXPECT_EQ(family_of("b_2"), "all");
  EXPECT_EQ(family_of("x__y/b__2"), "b");
  EXPECT_ERROR(list_characters(folder.file("nowhere")), "nowhere");
}

TEST(Folders, LooksBelowOnceAndPastHiddenOnes) {
  const TempFolder folder;
  for (const char* below : {"b/deep", ".git"}) std::filesystem::create_directories(folder.file(below));
  for (const char* name : {"z.glb", "b/deep/a.glb", "b/deep/m.obj", ".git/hidden.glb", "b/._a.glb"})
    folder.write(name, "x");
  std::filesystem::create_directory_symlink("..", folder.file("b/up"));
  std::filesystem::create_directory_symlink("b/deep", folder.file("c"));
  using Paths = std::vector<std::string>;
  EXPECT_EQ(list_characters(folder.path()), (Paths{folder.file("b/deep/a.glb"), folder.file("z.glb")}));
  EXPECT_EQ(list_meshes(folder.path()),
            (Paths{folder.file("b/deep/a.glb"), folder.file("b/deep/m.obj"), folder.file("z.glb")}));
}

TEST(Folders, NamesTellCharactersApart) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(character_names("in", {"in/a.glb", "in/x/a.glb", "in/x/b.obj", "in/y/c.glb", "in/y/c.obj"}),
            (Names{"a", "x/a", "b", "y/c.glb", "y/c.obj"}));
}

}  // namespace
}  // namespace sinew
