// SPDX-License-Identifier: MIT
// sinew serve: what a client asks line by line, what is refused, that nothing outside of the folder is read or written.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"

namespace sinew {
namespace {

using Json = nlohmann::json;

class CliServe : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    fs::create_directories(in("served/deep"));
    fs::copy_file(kData + "/snake__long.obj", in("served/snake.obj"));
    fs::copy_file(kData + "/snake__long.obj", in("outside.obj"));
  }

  static std::string call(int id, const std::string& tool, const Json& arguments) {
    return Json{{"jsonrpc", "2.0"},
                {"id", id},
                {"method", "tools/call"},
                {"params", {{"name", tool}, {"arguments", arguments}}}}
               .dump() +
           "\n";
  }

  // Answers by id; a message that is no request is answered with id null, -1 here.
  std::map<int, Json> ask(const std::string& messages, const std::string& options = "") {
    std::map<int, Json> answers;
    const Outcome outcome = good("serve --mcp --folder served " + options, messages);
    for (size_t from = 0, end; (end = outcome.out.find('\n', from)) != std::string::npos; from = end + 1) {
      const Json message = Json::parse(outcome.out.substr(from, end - from));
      EXPECT_EQ(message.value("jsonrpc", ""), "2.0");
      if (!message.contains("id"))
        notes_.push_back(message);
      else
        answers[message["id"].is_null() ? -1 : message["id"].get<int>()] = message;
    }
    return answers;
  }
  static std::string text(const Json& answer) { return answer["result"]["content"][0]["text"]; }

  std::vector<Json> notes_;
};

TEST_F(CliServe, IntroducesItselfAndListsItsTools) {
  const auto answers = ask(
      R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"2025-03-26","capabilities":{},"clientInfo":{"name":"t","version":"1"}}}
{"jsonrpc":"2.0","method":"notifications/initialized"}
{"jsonrpc":"2.0","id":2,"method":"tools/list"}
{"jsonrpc":"2.0","id":3,"method":"ping"}
{"jsonrpc":"2.0","id":4,"method":"resources/list"}
)");
  ASSERT_EQ(answers.size(), 4u);
  EXPECT_EQ(answers.at(1)["result"]["protocolVersion"], "2025-03-26");
  EXPECT_EQ(answers.at(1)["result"]["serverInfo"]["name"], "sinew");
  std::vector<std::string> names;
  for (const Json& tool : answers.at(2)["result"]["tools"]) {
    names.push_back(tool["name"]);
    EXPECT_EQ(tool["inputSchema"]["type"], "object");
    EXPECT_FALSE(tool["inputSchema"]["required"].empty());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"rig", "bind", "animate", "springs", "transfer", "map", "check", "lod",
                                             "simplify", "bake", "pose", "inspect"}));
  EXPECT_EQ(answers.at(3)["result"], Json::object());
  ASSERT_EQ(answers.at(4)["result"]["resources"].size(), 1u);
  EXPECT_EQ(answers.at(4)["result"]["resources"][0]["uri"], "sinew:///snake.obj");
}

TEST_F(CliServe, RigsChecksAndDrawsAsTheCommandDoes) {
  Json rig = Json::parse(call(1, "rig", {{"mesh", "snake.obj"}, {"output", "deep/snake.glb"}}));
  rig["params"]["_meta"]["progressToken"] = "t";
  const auto first = ask(rig.dump() + "\n");
  EXPECT_EQ(first.at(1)["result"]["isError"], false) << first.at(1);
  EXPECT_EQ(first.at(1)["result"]["structuredContent"]["output"], "./deep/snake.glb");
  ASSERT_FALSE(notes_.empty());
  EXPECT_EQ(notes_[0]["method"], "notifications/progress");
  EXPECT_EQ(notes_[0]["params"]["progressToken"], "t");
  good("rig served/snake.obj -o alone.glb");
  EXPECT_EQ(slurp(in("served/deep/snake.glb")), slurp(in("alone.glb")));

  const auto then =
      ask(call(2, "check", {{"file", "deep/snake.glb"}}) +
              call(3, "pose", {{"character", "deep/snake.glb"}, {"output", "pose.png"}, {"random", 7}}) +
              R"({"jsonrpc":"2.0","id":4,"method":"resources/read","params":{"uri":"sinew:///snake.obj"}})"
              "\n",
          "--jobs 2");
  EXPECT_EQ(then.at(2)["result"]["structuredContent"]["sinew_check"], 1);
  bool drawn = false;
  for (const Json& part : then.at(3)["result"]["content"])
    drawn = drawn || (part["type"] == "image" && part["data"].get<std::string>().rfind("iVBORw0KGgo", 0) == 0);
  EXPECT_TRUE(drawn) << then.at(3);
  EXPECT_EQ(then.at(4)["result"]["contents"][0]["text"], slurp(in("served/snake.obj")));
}

TEST_F(CliServe, SimplifiesMapsTransfersAndWritesForProgramsAsTheCommandDoes) {
  const auto first = ask(call(1, "rig", {{"mesh", "snake.obj"}, {"output", "snake.glb"}, {"for", "blender"}}));
  EXPECT_EQ(first.at(1)["result"]["isError"], false) << first.at(1);
  good("rig served/snake.obj --for blender -o alone.glb");
  EXPECT_EQ(slurp(in("served/snake.glb")), slurp(in("alone.glb")));
  const auto then =
      ask(call(2, "simplify", {{"character", "snake.glb"}, {"output", "low.glb"}, {"level", "low"}}) +
          call(3, "map", {{"target", "snake.glb"}, {"from", "snake.glb"}, {"output", "map.txt"}}) +
          call(4, "transfer",
               {{"source", "snake.glb"}, {"target", "snake.obj"}, {"output", "worn.glb"}, {"garment", true}}) +
          call(5, "bake", {{"character", "snake.glb"}, {"output", "baked.glb"}, {"poses", 20}, {"error", 0.2}}) +
          call(6, "rig", {{"mesh", "snake.obj"}, {"output", "x.glb"}, {"for", "softimage"}}));
  for (const int id : {2, 3, 4, 5}) EXPECT_EQ(then.at(id)["result"]["isError"], false) << then.at(id);
  for (const char* file : {"low.glb", "map.txt", "worn.glb", "baked.glb"})
    EXPECT_TRUE(fs::exists(in("served/" + std::string(file)))) << file;
  EXPECT_NE(then.at(6).dump().find("mixamo"), std::string::npos) << then.at(6);
}

TEST_F(CliServe, PlacesWritesControlsScoresAndMakesLevelsAsTheCommandDoes) {
  const auto first = ask(call(1, "rig",
                              {{"mesh", "snake.obj"},
                               {"output", "snake.glb"},
                               {"controls", "snake.controls.json"},
                               {"turn", "y"},
                               {"height", 2},
                               {"floor", true}}));
  EXPECT_EQ(first.at(1)["result"]["isError"], false) << first.at(1);
  good("rig served/snake.obj --turn y --height 2 --floor --controls alone.controls.json -o alone.glb");
  EXPECT_EQ(slurp(in("served/snake.glb")), slurp(in("alone.glb")));
  EXPECT_EQ(slurp(in("served/snake.controls.json")), slurp(in("alone.controls.json")));

  const auto then = ask(call(2, "lod", {{"character", "snake.glb"}, {"output", "deep/far.glb"}, {"levels", 2}}) +
                        call(3, "check", {{"file", "snake.glb"}, {"no_poses", true}, {"score", true}}) +
                        call(4, "lod", {{"character", "snake.glb"}, {"output", "../far.glb"}}));
  EXPECT_EQ(then.at(2)["result"]["isError"], false) << then.at(2);
  EXPECT_NE(text(then.at(2)).find("\"level\":2,\"output\":\"./deep/far.lod2.glb\""), std::string::npos)
      << text(then.at(2));
  EXPECT_EQ(then.at(2)["result"]["content"].size(), 1u) << "no link to a file that was not written";
  good("lod alone.glb --levels 2 -o far.glb");
  for (const char* level : {"far.lod1.glb", "far.lod2.glb"})
    EXPECT_EQ(slurp(in(std::string("served/deep/") + level)), slurp(in(level)));
  EXPECT_TRUE(then.at(3)["result"]["structuredContent"]["score"].is_number()) << then.at(3);
  EXPECT_EQ(then.at(4)["result"]["isError"], true) << "outside of the folder";
}

TEST_F(CliServe, NothingOutsideOfTheFolderIsReadOrWritten) {
  fs::create_symlink(in("outside.obj"), in("served/link.obj"));
  fs::create_directory_symlink(folder_, in("served/up"));
  // A file of the folder that refers to another one: the process that reads it sees the folder alone, where the system can.
  put(in("served/refers.gltf"), R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"../outside.obj"}]})");
  std::string messages;
  int id = 0;
  for (const std::string& name : {std::string("../outside.obj"), in("outside.obj"), std::string("link.obj"),
                                  std::string("up/outside.obj"), std::string("")})
    messages += call(++id, "inspect", {{"file", name}});
  for (const std::string& name : {std::string("../new.glb"), std::string("up/new.glb"), in("new.glb")})
    messages += call(++id, "rig", {{"mesh", "snake.obj"}, {"output", name}});
  messages += R"({"jsonrpc":"2.0","id":9,"method":"resources/read","params":{"uri":"sinew:///..%2foutside.obj"}})"
              "\n";
  messages += call(10, "inspect", {{"file", "refers.gltf"}});
  const auto answers = ask(messages);
  ASSERT_EQ(answers.size(), 10u);
  for (int k = 1; k <= id; ++k) EXPECT_EQ(answers.at(k)["result"]["isError"], true) << answers.at(k);
  EXPECT_NE(text(answers.at(3)).find("a link leads out"), std::string::npos);
  EXPECT_EQ(answers.at(9)["error"]["code"], -32002);
  EXPECT_FALSE(fs::exists(in("new.glb")));
  if (run("serve --mcp --folder served").error.empty()) {  // else a warning says that the system cannot
    EXPECT_EQ(answers.at(10)["result"]["isError"], true) << answers.at(10);
  }
}

TEST_F(CliServe, WhatIsNoCallIsALine) {
  const auto answers =
      ask("{\n"
          R"({"jsonrpc":"2.0","id":1,"method":"dance"})"
          "\n"
          R"({"jsonrpc":"2.0","id":2,"method":"tools/call","params":[]})"
          "\n" +
          call(3, "fly", Json::object()) + call(4, "rig", {{"mesh", "snake.obj"}}) +
          call(5, "rig", {{"mesh", "snake.obj"}, {"output", "a.glb"}, {"class", "dragon"}}) +
          call(6, "rig", {{"mesh", "snake.obj"}, {"output", "a.glb"}, {"wings", 2}}) +
          call(7, "rig", {{"mesh", "none.obj"}, {"output", "a.glb"}}) +
          call(8, "rig", {{"mesh", "snake.obj"}, {"output", "a.exe"}}));
  ASSERT_EQ(answers.size(), 9u);
  EXPECT_EQ(answers.at(-1)["error"]["code"], -32700);
  EXPECT_EQ(answers.at(1)["error"]["code"], -32601);
  EXPECT_EQ(answers.at(2)["error"]["code"], -32602);
  for (int k = 3; k <= 8; ++k) {
    EXPECT_EQ(answers.at(k)["result"]["isError"], true) << k;
    EXPECT_FALSE(text(answers.at(k)).empty());
  }
  EXPECT_NE(text(answers.at(4)).find("expected an argument 'output'"), std::string::npos);
  EXPECT_NE(text(answers.at(5)).find("one of biped, quadruped"), std::string::npos);
  EXPECT_EQ(fs::exists(in("served/a.glb")), false);
}

TEST_F(CliServe, JobsHaveLimits) {
  const auto late = ask(call(1, "rig", {{"mesh", "snake.obj"}, {"output", "a.glb"}}), "--timeout 0.1 ");
  if (late.at(1)["result"]["isError"] == true) {  // a fast machine is done by then
    EXPECT_NE(text(late.at(1)).find("--timeout"), std::string::npos);
  }
  const auto large = ask(call(1, "inspect", {{"file", "snake.obj"}}), "--most-bytes 100");
  EXPECT_NE(text(large.at(1)).find("--most-bytes"), std::string::npos);
  bad(2, "serve");
  EXPECT_NE(bad(2, "serve --mcp --http 127.0.0.1:0").error.find("--http"), std::string::npos);
  bad(1, "serve --mcp --folder nowhere");
}

}  // namespace
}  // namespace sinew
