// SPDX-License-Identifier: MIT
// Fuzz target: messages to `sinew serve`. Each is answered by one message of JSON-RPC or is a notification; what would run is one of the
// tools, its files lie below the served folder, and no word of the caller's becomes an option of its own.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "fuzz.hpp"
#include "serve/server.hpp"

namespace {

using sinew::cli::ChildResult;
using sinew::cli::OrderedJson;
using sinew::test::demand;

ChildResult look_at(const std::vector<std::string>& words, const std::string&, double, const std::atomic<bool>&,
                    const std::function<void(const std::string&)>& on_line) {
  constexpr const char* kTools[] = {"rig", "bind", "animate", "check", "pose", "inspect"};
  demand(!words.empty() && std::find(std::begin(kTools), std::end(kTools), words[0]) != std::end(kTools),
         "a tool runs");
  for (size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    demand(!word.empty() && word.find('\0') == std::string::npos, "words are words");
    demand(word[0] == '-' || word.rfind("./", 0) == 0, "what is no option is a file: " + word);
    if (word.rfind("./", 0) == 0)
      demand(("/" + word + "/").find("/../") == std::string::npos, "below the folder: " + word);
    if (word[0] == '-' && word.find('=') == std::string::npos)
      for (const char c : word) demand(c == '-' || (c >= 'a' && c <= 'z'), "an option of ours: " + word);
  }
  on_line("done");
  ChildResult result;
  result.out = "{\"a\": 1}";
  return result;
}

sinew::cli::Server& server() {
  static sinew::cli::Server one = [] {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "sinew_serve_fuzz";
    std::filesystem::create_directories(folder / "deep");
    for (const char* name : {"a.obj", "a.glb", "deep/b.bvh"}) std::ofstream(folder / name) << "v 0 0 0\n";
    return sinew::cli::Server(sinew::cli::ServedFolder(folder.string(), 1000), {}, look_at);
  }();
  return one;
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string message(reinterpret_cast<const char*>(data), size);
  const auto answer = server().answer(message, [](const OrderedJson& note) {
    demand(note.at("method") == "notifications/progress", "notes tell progress");
  });
  if (!answer) return 0;
  demand(answer->at("jsonrpc") == "2.0" && answer->contains("id"), "an answer of JSON-RPC");
  demand(answer->contains("result") != answer->contains("error"), "a result or an error");
  demand(!answer->dump(-1, ' ', false, OrderedJson::error_handler_t::replace).empty(), "an answer can be written");
  return 0;
}
