// SPDX-License-Identifier: MIT
// Training on several processes: `mpirun -n N sinew-lab train` gives the checkpoint of one process, writes through rank 0
// alone, and ends as a whole when one rank fails.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "sinew_formats/checkpoint.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

namespace fs = std::filesystem;

const std::string kData = SINEW_SOURCE_DIR "/samples/data";

class RanksTest : public ::testing::Test {
 protected:
  RanksTest() {
    folder_.write("a.json", R"({"field": {"width": 8, "vertex_width": 4, "rounds": 1, "candidates": 8, "grid": 32},
                                "steps": 7, "batch": 5, "validate_every": 3, "learning_rate": 0.01, "variants": 0, "synthetic": 0})");
    folder_.write("b.json", R"({"field": {"width": 8, "vertex_width": 4, "rounds": 1, "candidates": 8, "grid": 32},
                                "steps": 7, "batch": 5, "validate_every": 3, "learning_rate": 0.01, "variants": 0, "synthetic": 0, "seed": 2})");
  }
  // Containers run as root, and machines have fewer cores than a test has ranks.
  static std::string mpirun() {
    return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1 "
           "OMPI_MCA_btl_vader_single_copy_mechanism=none timeout 300 " SINEW_MPIRUN " --oversubscribe --bind-to none ";
  }
  std::string train(const std::string& data, const std::string& config, const std::string& output) const {
    return SINEW_BINARY_DIR "/sinew-lab train " + data + " --val " + kData + " --config " + folder_.file(config) +
           " --cache " + folder_.file("cache") + " -o " + folder_.file(output) + " --threads 1";
  }
  int run(const std::string& command) {
    const int status = std::system(("cd '" + folder_.path() + "' && " + command + " >out.txt 2>err.txt").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::vector<std::string> error_lines() const {
    std::istringstream text(folder_.text_of("err.txt"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) {
      if (line.find("sinew-lab: error: ") != std::string::npos) lines.push_back(line);
    }
    return lines;
  }
  const TempFolder folder_;
};

std::vector<float> all_numbers(const Checkpoint& checkpoint) {
  std::vector<float> all;
  std::vector<const FloatNetwork*> networks = {&checkpoint.network, &checkpoint.latest};
  for (const FloatNetwork& average : checkpoint.state.averages) networks.push_back(&average);
  for (const FloatNetwork* network : networks) {
    for (const LinearParameters& p : network->parameters) {
      all.insert(all.end(), p.weights.begin(), p.weights.end());
      all.insert(all.end(), p.bias.begin(), p.bias.end());
    }
  }
  for (const auto* moments : {&checkpoint.state.adam_m, &checkpoint.state.adam_v}) {
    for (const std::vector<float>& block : *moments) all.insert(all.end(), block.begin(), block.end());
  }
  return all;
}

// The log without its column of seconds.
std::string log_of(const Checkpoint& checkpoint) {
  std::istringstream text(checkpoint.state.log_csv);
  std::string out;
  for (std::string line; std::getline(text, line);) {
    const size_t first = line.find(','), second = line.find(',', first + 1);
    out += line.substr(0, first) + line.substr(second) + "\n";
  }
  return out;
}

TEST_F(RanksTest, AnyNumberOfRanksGivesTheCheckpointOfOne) {
  ASSERT_EQ(run(train(kData, "a.json", "one.ckpt")), 0) << folder_.text_of("err.txt");
  const Checkpoint one = read_checkpoint(folder_.file("one.ckpt"));
  ASSERT_EQ(one.state.step, 7u);
  for (const std::string ranks : {"2", "3"}) {  // 5 characters a step: never the same number each
    fs::remove_all(folder_.file("cache"));      // which the ranks fill together
    ASSERT_EQ(run(mpirun() + "-n " + ranks + " " + train(kData, "a.json", "many.ckpt")), 0)
        << folder_.text_of("err.txt");
    EXPECT_NE(folder_.text_of("err.txt").find(ranks + " ranks x 1 thread: 7 steps"), std::string::npos)
        << folder_.text_of("err.txt");
    const Checkpoint many = read_checkpoint(folder_.file("many.ckpt"));
    // Not a tolerance but the same bits: every rank adds the gradients of all characters in the order of the draw.
    EXPECT_EQ(all_numbers(many), all_numbers(one)) << ranks << " ranks";
    EXPECT_EQ(many.state.queue, one.state.queue);
    EXPECT_EQ(many.state.rng, one.state.rng);
    EXPECT_EQ(log_of(many), log_of(one));
  }
  // The comparison can fail: one character drawn in another order is enough.
  ASSERT_EQ(run(train(kData, "b.json", "other.ckpt")), 0);
  EXPECT_NE(all_numbers(read_checkpoint(folder_.file("other.ckpt"))), all_numbers(one));
}

TEST_F(RanksTest, RankZeroAloneWrites) {
  ASSERT_EQ(
      run(mpirun() + "-n 1 " + train(kData, "a.json", "zero.ckpt") + " : -n 1 " + train(kData, "a.json", "one.ckpt")),
      0)
      << folder_.text_of("err.txt");
  EXPECT_TRUE(fs::exists(folder_.file("zero.ckpt")));
  EXPECT_FALSE(fs::exists(folder_.file("one.ckpt")));
  EXPECT_FALSE(fs::exists(folder_.file("one.ckpt.csv")));
}

TEST_F(RanksTest, OneRanksFailureEndsAllWithOneLine) {
  const std::string good = train(kData, "a.json", "x.ckpt");
  EXPECT_EQ(run(mpirun() + "-n 1 " + good + " : -n 1 " + train("nowhere", "a.json", "x.ckpt")), 1);
  ASSERT_EQ(error_lines().size(), 1u) << folder_.text_of("err.txt");
  EXPECT_NE(error_lines()[0].find("sinew-lab: error: rank 1: nowhere: expected a folder"), std::string::npos);

  EXPECT_EQ(run(mpirun() + "-n 2 " + train("nowhere", "a.json", "x.ckpt")), 1);
  ASSERT_EQ(error_lines().size(), 1u) << folder_.text_of("err.txt");
  EXPECT_NE(error_lines()[0].find("sinew-lab: error: nowhere"), std::string::npos)
      << "said by all, so by none in particular";

  EXPECT_EQ(run(mpirun() + "-n 1 " + good + " : -n 1 " + train(kData, "b.json", "x.ckpt")), 1);
  ASSERT_EQ(error_lines().size(), 1u) << folder_.text_of("err.txt");
  EXPECT_NE(error_lines()[0].find("rank 1: has a configuration, checkpoint or characters unlike rank 0's"),
            std::string::npos);

  EXPECT_EQ(run(mpirun() + "-n 2 " SINEW_BINARY_DIR "/sinew-lab train"), 2);
  EXPECT_EQ(error_lines().size(), 1u) << folder_.text_of("err.txt");
  EXPECT_FALSE(fs::exists(folder_.file("x.ckpt")));
}

}  // namespace
}  // namespace sinew
