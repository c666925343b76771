// SPDX-License-Identifier: MIT
#include "sinew_formats/memory_files.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "expect_error.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

FileBytes of_texts(std::initializer_list<std::pair<std::string, std::string>> texts) {
  FileBytes files;
  for (const auto& [name, text] : texts) files[name] = {text.begin(), text.end()};
  return files;
}

TEST(MemoryFiles, ReadersSeeThemInPlaceOfTheDisk) {
  const TempFolder folder;
  const std::string on_disk = folder.write("a.txt", "disk");
  const FileBytes files = of_texts({{"hero.obj", "mtllib skin.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
                                    {"skin.mtl", "newmtl red\nKd 1 0 0\n"}});
  const MemoryFiles scope(&files, nullptr);
  EXPECT_TRUE(is_file("hero.obj"));
  EXPECT_TRUE(is_file("parts/../hero.obj"));
  EXPECT_FALSE(is_file(on_disk));
  EXPECT_ANY_THROW(read_file(on_disk));
  const Character hero = read_obj("hero.obj");
  EXPECT_EQ(hero.vertices.size(), 3u);
  ASSERT_EQ(hero.materials.size(), 1u) << "the .mtl beside it";
  EXPECT_EQ(hero.materials[0].base_color[0], 1.0f);
}

TEST(MemoryFiles, TakeWhatIsWrittenAndTheLatestCounts) {
  const TempFolder folder;
  std::vector<NamedBytes> first, second;
  {
    const MemoryFiles outer(nullptr, &first);
    write_text_file("a.txt", "one");
    {
      const MemoryFiles inner(nullptr, &second);
      write_files({{"b.bin", {1}}, {"b.gltf", {2}}});
    }
    write_text_file("c.txt", "two");
    std::thread([&] {  // another thread sees the disk
      write_text_file(folder.file("d.txt"), "three");
    })
        .join();
  }
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[1].path, "c.txt");
  ASSERT_EQ(second.size(), 2u);
  EXPECT_EQ(second[0].path, "b.bin");
  EXPECT_TRUE(is_file(folder.file("d.txt")));
  EXPECT_FALSE(is_file(folder.file("a.txt")));
}

}  // namespace
}  // namespace sinew
