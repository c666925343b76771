// SPDX-License-Identifier: MIT
// Every line of the README that calls the command, as it stands there, on sample characters under the names that it uses.
#include "cli_fixture.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

const std::string kCommand = "    build/release/sinew", kLabCommand = kCommand + "-lab ";

std::vector<std::string> commands_of_readme() {
  std::vector<std::string> found;
  std::ifstream file(SINEW_SOURCE_DIR "/README.md");
  for (std::string line; std::getline(file, line);) {
    const size_t at = line.rfind(kLabCommand, 0) == 0 ? kLabCommand.size() : kCommand.size() + 1;
    if (line.rfind(kCommand, 0) != 0) continue;
    line = line.substr(at, line.find(" #") - at);
    found.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
  }
  return found;
}

// What follows an option that names a file to write.
std::vector<std::string> outputs_of(const std::string& command) {
  std::vector<std::string> found;
  std::istringstream words(command);
  for (std::string word; words >> word;)
    if (word == "-o" || word == "--png" || word == "--sheet" || word == "--report") {
      words >> word;
      found.push_back(word);
    }
  return found;
}

class CliReadme : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    const auto sample = [&](const std::string& from, const std::string& to) {
      fs::copy_file(kData + "/" + from, folder_ / to);
    };
    sample("biped__robed.obj", "bare.obj");
    sample("biped__robed.rig.txt", "mine.rig.txt");
    sample("snake__long.obj", "mesh.obj");
    sample("snake__long.rig.txt", "skeleton.rig.txt");
    sample("biped__robed.obj", "jacket.obj");
    sample("drawing__child.png", "drawing.png");
    const Motion walk = walking_person();
    write_bvh(in("walk.bvh"), walk, walk.clips[0]);
    good("bind " + kCaped + " -o character.glb");
    for (const std::string set : {"train", "val"}) {
      fs::create_directories(folder_ / "characters" / set);
      for (const std::string name : {"snake__long", "bird__winged"})
        for (const std::string end : {".obj", ".rig.txt"}) sample(name + end, "characters/" + set + "/" + name + end);
    }
  }

  // Training and baking as the README has them take their time.
  void expect_works(std::string command) {
    const size_t minutes = command.find("--minutes 30");
    if (minutes != std::string::npos) command.replace(minutes, 12, "--minutes 0.01");
    if (command.rfind("bake ", 0) == 0) command += " --poses 10";
    good(command);
    for (const std::string& name : outputs_of(command)) {
      EXPECT_TRUE(fs::exists(folder_ / name) && fs::file_size(folder_ / name) > 0) << "sinew " << command;
    }
  }
};

TEST_F(CliReadme, EveryCommandWorksAndWritesWhatItSays) {
  const std::vector<std::string> commands = commands_of_readme();
  EXPECT_GT(commands.size(), 12u);
  for (const std::string& command : commands) expect_works(command);
}

}  // namespace
}  // namespace sinew
