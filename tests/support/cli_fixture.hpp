// SPDX-License-Identifier: MIT
// The sinew command run in a folder of its own, with what it said and left behind.
#ifndef SINEW_TEST_CLI_FIXTURE_HPP
#define SINEW_TEST_CLI_FIXTURE_HPP

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "../../samples/cli/commands.hpp"
#include "sinew_formats/io.hpp"

namespace fs = std::filesystem;

namespace sinew {

// sinew, or sinew-lab for what is one of its commands; "lab --help" is sinew-lab --help.
inline std::string program_of(const std::string& arguments) {
  const std::string command = arguments.substr(0, arguments.find(' '));
  return cli::is_lab_command(command) || command == "lab" ? "sinew-lab" : "sinew";
}
inline const std::string kData = std::string(SINEW_SOURCE_DIR) + "/samples/data";
inline const std::string kSnake = kData + "/snake__long.obj", kSnakeRig = kData + "/snake__long.rig.txt";
inline const std::string kRobed = kData + "/biped__robed.obj", kRobedRig = kData + "/biped__robed.rig.txt";
inline const std::string kCaped = kData + "/biped__caped.gltf";

struct Outcome {
  int status = -1;
  std::string out, error;
};

inline std::string slurp(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void put(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

// Mean over vertices of the sum over joints of the weights' differences, 0..2. Both have the same joints.
inline double mean_l1(const Character& a, const Character& b) {
  double sum = 0;
  for (size_t v = 0; v < a.vertices.size(); ++v) {
    std::vector<double> row(a.joints.size(), 0);
    for (const Influence& i : a.influences[v]) row[i.joint] += static_cast<double>(i.weight);
    for (const Influence& i : b.influences[v]) row[i.joint] -= static_cast<double>(i.weight);
    for (const double x : row) sum += std::fabs(x);
  }
  return sum / static_cast<double>(a.vertices.size());
}

class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("sinew_cli_" + name + "_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Runs in the test's own folder. `input` goes to standard input.
  Outcome run(const std::string& arguments, const std::string& input = "") {
    const fs::path error = folder_ / ".stderr", feed = folder_ / ".stdin";
    put(feed, input);
    const std::string command = "cd '" + folder_.string() + "' && '" + SINEW_BINARY_DIR "/" + program_of(arguments) +
                                "' " + arguments.substr(arguments.rfind("lab ", 0) == 0 ? 4 : 0) + " <'" +
                                feed.string() + "' 2>'" + error.string() + "'";
    Outcome outcome;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return outcome;
    char buffer[4096];
    for (size_t n = std::fread(buffer, 1, sizeof buffer, pipe); n > 0; n = std::fread(buffer, 1, sizeof buffer, pipe)) {
      outcome.out.append(buffer, n);
    }
    const int status = pclose(pipe);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.error = slurp(error);
    return outcome;
  }
  Outcome good(const std::string& arguments, const std::string& input = "") {
    Outcome outcome = run(arguments, input);
    EXPECT_EQ(outcome.status, 0) << "sinew " << arguments << "\n" << outcome.error;
    return outcome;
  }
  // A failure is exactly one line that starts with the program, as in "sinew: error: ".
  Outcome bad(int status, const std::string& arguments, const std::string& input = "") {
    Outcome outcome = run(arguments, input);
    EXPECT_EQ(outcome.status, status) << "sinew " << arguments << "\n" << outcome.error;
    EXPECT_EQ(outcome.error.rfind(program_of(arguments) + ": error: ", 0), 0u) << "sinew " << arguments << "\n"
                                                                               << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << "sinew " << arguments << "\n"
                                                                               << outcome.error;
    return outcome;
  }
  size_t files() const {
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_))
      count += entry.path().filename().string()[0] == '.' ? 0 : 1;
    return count;
  }
  std::string in(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

inline void expect_bound(const Character& character, size_t most) {
  ASSERT_EQ(character.influences.size(), character.vertices.size());
  for (const auto& row : character.influences) {
    ASSERT_GE(row.size(), 1u);
    ASSERT_LE(row.size(), most);
    float sum = 0;
    for (const Influence& i : row) sum += i.weight;
    ASSERT_NEAR(sum, 1.0f, 1e-4f);
  }
}

}  // namespace sinew
#endif
