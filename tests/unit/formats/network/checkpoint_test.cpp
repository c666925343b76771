// SPDX-License-Identifier: MIT
// Checkpoints come back whole; a cut, flipped or foreign file is refused.
#include "sinew_formats/checkpoint.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

using namespace sinew;

namespace {

Checkpoint sample() {
  Checkpoint c;
  c.network.architecture = "field";
  c.network.feature_set = 3;
  c.network.buffers = {{Domain::kVertex, 4}, {Domain::kPair, 5}, {Domain::kPair, 2}};
  c.network.layers.push_back({LayerKind::kLinear, kLayerRelu, {1, 0, 5}, {2, 0, 2}, {}, 0});
  c.network.parameters.push_back({5, 2, {1, 2, 3, 4, 5, 6, 7, 8, 9, -0.5f}, {0.25f, 1e-30f}});
  c.latest = c.network;
  c.latest.parameters[0].weights[0] = 7;
  c.state.step = 1ull << 40;
  c.state.seconds = 12.5;
  c.state.averages = {c.network};
  c.state.adam_m = {{1, 2}, {}};
  c.state.adam_v = {{3}};
  c.state.rng = {0xffffffffffffffffull, 2};
  c.state.queue = {5, 6, 7};
  c.state.best_score = 0.125;
  c.state.config_json = "{\"a\": 1}";
  c.state.log_csv = "step,loss\n";
  return c;
}

TEST(Checkpoint, ComesBackWhole) {
  const TempFolder folder;
  write_checkpoint(folder.file("a.ckpt"), sample());
  const Checkpoint c = read_checkpoint(folder.file("a.ckpt"));
  EXPECT_EQ(c.network.architecture, "field");
  EXPECT_EQ(c.network.layers[0].in.channels, 5);
  EXPECT_EQ(c.network.parameters[0].weights, sample().network.parameters[0].weights);
  EXPECT_EQ(c.latest.parameters[0].weights[0], 7);
  EXPECT_EQ(c.state.rng, sample().state.rng);
  EXPECT_EQ(c.state.log_csv, sample().state.log_csv);
  write_checkpoint(folder.file("b.ckpt"), c);  // every field, byte for byte
  EXPECT_EQ(folder.text_of("a.ckpt"), folder.text_of("b.ckpt"));
  EXPECT_TRUE(is_checkpoint(folder.file("a.ckpt")));
}

// All of the header, and every fifth byte after it.
TEST(Checkpoint, TruncationsAndFlippedBytesAreRefused) {
  const TempFolder folder;
  write_checkpoint(folder.file("a.ckpt"), sample());
  const std::string whole = folder.text_of("a.ckpt");
  for (size_t length = 0; length < whole.size(); length += length < 30 ? 1 : 5)
    EXPECT_THROW(read_checkpoint(folder.write("cut", whole.substr(0, length))), Error) << length;
  for (size_t i = 0; i < whole.size(); i += i < 30 ? 1 : 5) {
    std::string bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x10);
    EXPECT_THROW(read_checkpoint(folder.write("flip", bytes)), Error) << i;
  }
  EXPECT_THROW(read_checkpoint(folder.write("long", whole + "x")), Error);
}

TEST(Checkpoint, ErrorsSayWhatIsWrong) {
  const TempFolder folder;
  write_checkpoint(folder.file("a.ckpt"), sample());
  std::string bytes = folder.text_of("a.ckpt");
  EXPECT_ERROR(read_checkpoint(folder.write("x.txt", "hello")), "x.txt", "checkpoint", "SINEWCKP");
  EXPECT_ERROR(read_checkpoint(folder.write("cut.ckpt", bytes.substr(0, 100))), "cut.ckpt", "truncated", "found 76");
  bytes[8] = 9;
  EXPECT_ERROR(read_checkpoint(folder.write("new.ckpt", bytes)), "new.ckpt", "version 1", "found 9");
  EXPECT_ERROR(read_checkpoint(folder.file("none.ckpt")), "none.ckpt", "no such file");
  EXPECT_FALSE(is_checkpoint(folder.file("x.txt")));
  EXPECT_FALSE(is_checkpoint(folder.path()));
  Checkpoint broken = sample();
  broken.network.layers[0].out.offset = 1;
  write_checkpoint(folder.file("b.ckpt"), broken);
  EXPECT_ERROR(read_checkpoint(folder.file("b.ckpt")), "layer 0", "outside its buffers");
  broken = sample();
  broken.latest.parameters[0].bias.pop_back();
  write_checkpoint(folder.file("b.ckpt"), broken);
  EXPECT_ERROR(read_checkpoint(folder.file("b.ckpt")), "latest network", "weight block 0");
}

}  // namespace
