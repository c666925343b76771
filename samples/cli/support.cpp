// SPDX-License-Identifier: MIT
// Outputs, files of folders, models and lists of names.
#include "support.hpp"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {

void refuse_given(const GivenOptions& options, const std::string& why) {
  for (const auto& [option, given] : options)
    if (given) throw UsageError(option + why);
}

void check_output(const std::string& path, const std::vector<std::string>& extensions, bool stream_allowed) {
  if (path == "-") {
    if (stream_allowed) return;
    throw UsageError("this output cannot go to standard output; give a file name");
  }
  std::string known;
  for (const std::string& extension : extensions) {
    if (has_extension(path, extension.c_str())) {
      std::error_code ignored;
      if (fs::is_directory(path, ignored)) throw Error(path + ": cannot write, it is a directory; give a file name");
      const fs::path folder = fs::path(path).parent_path();
      if (!folder.empty() && !fs::is_directory(folder, ignored)) {
        throw Error(path + ": cannot write, the folder " + folder.string() + " does not exist; create it first");
      }
      return;
    }
    known += (known.empty() ? "" : ", ") + extension;
  }
  if (has_use(path, kReadsWhole) && !has_use(path, kWritesCharacter))
    throw UsageError("output " + path + ": sinew reads this format but does not write it; write .glb and import that");
  throw UsageError("output " + path + ": unknown extension, expected " + known);
}

void check_output(const std::string& path, uint32_t uses, bool stream_allowed) {
  check_output(path, extensions_of(uses), stream_allowed);
}

Character read_mesh_and_skeleton(const std::string& mesh, const std::string& skeleton, bool with_skin) {
  if (has_extension(mesh, ".txt")) {
    throw UsageError(mesh +
                     " is a skeleton, but a mesh is expected; give the mesh first and the skeleton with --skeleton");
  }
  if (has_extension(skeleton, ".obj")) {
    throw UsageError("--skeleton " + skeleton + ": an OBJ holds no skeleton; expected " +
                     extensions_text(kReadsSkeleton));
  }
  Character character = read_mesh(mesh);
  if (!skeleton.empty()) {
    read_skeleton(skeleton, with_skin, &character);
  } else if (character.joints.empty()) {
    std::string hint;
    if (has_rig_beside(mesh)) hint = " (" + rig_path_beside(mesh) + " lies beside it)";
    throw Error(mesh + ": has no skeleton; give one with --skeleton FILE" + hint);
  }
  return character;
}

namespace {

// Lines of a list with their numbers, without comments and blanks around.
std::vector<std::pair<size_t, std::string>> list_lines(const std::string& path) {
  std::istringstream text(read_text_file(path));
  std::vector<std::pair<size_t, std::string>> lines;
  std::string line;
  for (size_t number = 1; std::getline(text, line); ++number) {
    const size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    lines.emplace_back(number, line.substr(first, line.find_last_not_of(" \t\r") - first + 1));
  }
  return lines;
}

}  // namespace

std::vector<size_t> read_joint_list(const std::string& path, const Character& character) {
  std::map<std::string, size_t> known;
  for (size_t j = 0; j < character.joints.size(); ++j) known.emplace(character.joints[j].name, j);
  std::vector<size_t> joints;
  for (const auto& [number, name] : list_lines(path)) {
    const auto found = known.find(name);
    if (found == known.end()) {
      throw Error(path + ": line " + std::to_string(number) + ": the skeleton has no joint " + name +
                  " (its first is " + (character.joints.empty() ? std::string("missing") : character.joints[0].name) +
                  ")");
    }
    joints.push_back(found->second);
  }
  if (joints.empty()) throw Error(path + ": names no joint; expected one name per line");
  return joints;
}

std::vector<size_t> read_vertex_list(const std::string& path, const Character& character) {
  std::vector<size_t> vertices;
  for (const auto& [number, word] : list_lines(path)) {
    size_t value = 0;
    for (char c : word) {
      if (c < '0' || c > '9' || value > character.vertices.size()) {
        value = character.vertices.size();
        break;
      }
      value = value * 10 + static_cast<size_t>(c - '0');
    }
    if (value >= character.vertices.size()) {
      throw Error(path + ": line " + std::to_string(number) + ": expected a vertex index 0.." +
                  std::to_string(character.vertices.size() - 1) + ", found " + word);
    }
    vertices.push_back(value);
  }
  return vertices;
}

std::vector<uint8_t> read_vertex_locks(const std::string& lock, const Character& character) {
  std::vector<uint8_t> locked(character.vertices.size(), 0);
  if (lock == "all") {
    for (size_t v = 0; v < locked.size(); ++v) locked[v] = character.influences[v].empty() ? 0 : 1;
    return locked;
  }
  for (const size_t v : read_vertex_list(lock, character)) {
    if (character.influences[v].empty())
      throw Error(lock + ": vertex " + std::to_string(v) + " has no weights to keep");
    locked[v] = 1;
  }
  return locked;
}

namespace {

std::atomic<bool> stop_requested = false;

}  // namespace

std::vector<FoundCharacter> expand(const std::vector<std::string>& inputs) {
  std::vector<FoundCharacter> found;
  for (const std::string& input : inputs) {
    std::error_code ignored;
    if (!fs::is_directory(input, ignored)) {
      found.push_back({input, stem_of(input), ""});
      continue;
    }
    const std::vector<FoundCharacter> inside = characters_in(input);
    found.insert(found.end(), inside.begin(), inside.end());
  }
  return found;
}

Character read_any(const std::string& path) {
  if (has_extension(path, ".obj") && !has_rig_beside(path)) return read_mesh(path);
  return path == "-" ? read_mesh(path) : read_character(path);
}

bool has_rig_beside(const std::string& mesh) {
  std::error_code ignored;
  return has_extension(mesh, ".obj") && fs::exists(rig_path_beside(mesh), ignored);
}

void make_folder(const std::string& path) {
  std::error_code failed;
  fs::create_directories(path, failed);
  if (failed || !fs::is_directory(path)) throw Error(path + ": cannot create this folder: " + failed.message());
}

void check_failed(size_t failed, size_t count, const std::string& things, const std::string& first) {
  if (failed == 0) return;
  throw Error(std::to_string(failed) + " of " + std::to_string(count) + " " + things + " failed" +
              (first.empty() ? ", see above" : "; the first: " + first));
}

void check_failed(const std::map<std::string, std::string>& failures, size_t count) {
  if (failures.empty()) return;
  const auto& [name, error] = *failures.begin();
  check_failed(failures.size(), count, "characters", name + ": " + error);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

const std::atomic<bool>& stop_on_signals() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stop_requested = true; });
  return stop_requested;
}

std::vector<FoundCharacter> characters_in(const std::string& folder) {
  const std::vector<std::string> paths = list_characters(folder);
  if (paths.empty())
    throw Error(folder + ": no characters in it nor below it; expected NAME.obj with NAME.rig.txt, or .glb files");
  const std::vector<std::string> names = character_names(folder, paths);
  std::vector<FoundCharacter> found;
  for (size_t i = 0; i < paths.size(); ++i)
    found.push_back({paths[i], names[i], fs::path(paths[i]).lexically_relative(folder).parent_path().string()});
  return found;
}

Character read_found(const FoundCharacter& found) {
  Character character = read_character(found.path);
  character.name = found.name;
  return character;
}

std::string report_date() {
  const char* const text = std::getenv("SOURCE_DATE_EPOCH");
  if (text == nullptr || *text == 0) return "";
  char* end = nullptr;
  const long long seconds = std::strtoll(text, &end, 10);
  if (*end != 0 || seconds < 0)
    throw Error(std::string("SOURCE_DATE_EPOCH: expected seconds since 1970, found ") + text);
  const std::time_t when = static_cast<std::time_t>(seconds);
  std::tm parts{};
  if (gmtime_r(&when, &parts) == nullptr) throw Error(std::string("SOURCE_DATE_EPOCH: out of range: ") + text);
  char date[64];
  std::strftime(date, sizeof date, "%Y-%m-%d", &parts);
  return date;
}

std::string json_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string with_version(const std::string& command, const std::string& kind, const std::string& of,
                         const std::string& text) {
  nlohmann::ordered_json whole = {{"sinew_" + command, 1}, {kind, of}};
  whole.update(nlohmann::ordered_json::parse(text));
  return whole.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string printable(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 32 || byte == 127) c = c == '\n' || c == '\r' || c == '\t' ? ' ' : '?';
  }
  return text;
}

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

namespace {

std::string real_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(path, ignored).string();
}

// Outputs of one run would be the inputs of the next.
void refuse_folder_inside(const std::string& folder, const std::string& output_folder) {
  const fs::path in = real_path(folder), out = real_path(output_folder);
  const std::string below = out.lexically_relative(in).string();
  if (below == ".") throw UsageError("-o " + output_folder + ": is the folder of the inputs; give another");
  if (!below.empty() && below.rfind("..", 0) != 0)
    throw UsageError("-o " + output_folder + ": lies inside " + folder +
                     ", where the next run would find its files as inputs; give a folder outside");
}

}  // namespace

std::vector<FolderFile> folder_files(const std::string& folder, const std::string& output_folder,
                                     const std::string& extension, bool or_pictures) {
  refuse_folder_inside(folder, output_folder);
  std::vector<std::string> meshes = list_meshes(folder);
  if (meshes.empty() && or_pictures) meshes = list_files(folder, kReadsPicture);
  if (meshes.empty())
    throw Error(folder + ": no mesh " + (or_pictures ? "and no picture " : "") + "in it or its subfolders; expected " +
                extensions_text(kReadsMesh) + (or_pictures ? ", " + extensions_text(kReadsPicture) : ""));
  std::set<std::string> inputs;
  for (const std::string& mesh : meshes) inputs.insert(real_path(mesh));
  std::map<std::string, std::string> taken;  // output -> mesh
  std::vector<FolderFile> files;
  for (const std::string& mesh : meshes) {
    const fs::path name = fs::path(mesh).lexically_relative(folder);
    FolderFile file;
    file.name = name.string();
    file.mesh = mesh;
    file.output = (fs::path(output_folder) / name.parent_path() / (stem_of(mesh) + extension)).string();
    const auto [first, fresh] = taken.emplace(file.output, mesh);
    if (!fresh)
      throw Error(first->second + " and " + mesh + " would both become " + file.output + "; rename one of them");
    if (inputs.count(real_path(file.output)) != 0)
      throw Error(file.output + ": is a link to an input, which is never replaced; give another folder");
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace sinew::cli
