// SPDX-License-Identifier: MIT
// Common parts of the subcommands: usage errors, files of folders, outputs that are checked before work starts,
// models, lists of names, signals.
#ifndef SINEW_CLI_SUPPORT_HPP
#define SINEW_CLI_SUPPORT_HPP

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sinew_character/jobs/character_file.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::cli {

// The command line asks for something that makes no sense: exit status 2 instead of 1.
class UsageError : public Error {
 public:
  using Error::Error;
};

// The job is done and its files are written, and what was asked of the result is not so (--gate): exit status 3.
class GateError : public Error {
 public:
  using Error::Error;
};

// Options, and whether each is given. Throws UsageError for the first that is: "--png" and then `why`.
using GivenOptions = std::vector<std::pair<const char*, bool>>;
void refuse_given(const GivenOptions& options, const std::string& why);

// Throws UsageError unless `path` is "-" (when allowed) or ends with one of `extensions`; Error when its folder is
// missing or it is a folder itself. Called before any work.
void check_output(const std::string& path, const std::vector<std::string>& extensions, bool stream_allowed = false);
// The same for files that are good for `uses`, FileUse.
void check_output(const std::string& path, uint32_t uses, bool stream_allowed = false);

// A mesh, with the skeleton of another file when `skeleton` is not empty. UsageError when the two are swapped.
Character read_mesh_and_skeleton(const std::string& mesh, const std::string& skeleton, bool with_skin);

// Joints named in a text file, one per line; '#' starts a comment line. Throws Error naming the line of an unknown
// joint.
std::vector<size_t> read_joint_list(const std::string& path, const Character& character);
std::vector<size_t> read_vertex_list(const std::string& path, const Character& character);
// [V] non-zero: keeps its weights. `lock` is a file with a 0-based index per line, each of a vertex with weights, or
// "all": every vertex that has some. Throws Error naming the line or the vertex.
std::vector<uint8_t> read_vertex_locks(const std::string& lock, const Character& character);

// A character of a folder, under a name that tells it apart from the others there.
struct FoundCharacter {
  std::string path, name;
  std::string below;  // folders from the one that was searched to its file; empty: none
};
// All of a folder and of the folders below it. Throws Error when there are none.
std::vector<FoundCharacter> characters_in(const std::string& folder);
Character read_found(const FoundCharacter& found);

// Files as they are; a folder represents its characters and those of the folders below it. Throws Error for a folder
// without any.
std::vector<FoundCharacter> expand(const std::vector<std::string>& inputs);
// A bare mesh is a character without joints.
Character read_any(const std::string& path);
// NAME.obj with NAME.rig.txt.
bool has_rig_beside(const std::string& mesh);
// With those above it.
void make_folder(const std::string& path);

// Throws Error where any failed: "2 of 9 characters failed, see above", or "; the first: " with what was wrong with it.
void check_failed(size_t failed, size_t count, const std::string& things, const std::string& first = "");
// The same of characters, with the errors by their names.
void check_failed(const std::map<std::string, std::string>& failures, size_t count);

// "a, b, c".
std::string joined(const std::vector<std::string>& names);

// Set by Ctrl-C and by what mpirun and job schedulers send, from this call on: the run ends after its step, with
// everything on disk that --resume needs.
const std::atomic<bool>& stop_on_signals();

// The date of SOURCE_DATE_EPOCH for a page; empty where the caller passes none, since a page with the clock in it would
// differ every time.
std::string report_date();
std::string file_name(const std::string& path);  // without its folders
// Without line breaks: commands that tell of many things print JSON Lines.
std::string json_line(const nlohmann::ordered_json& json);
// An object's text with its version before its members: {"sinew_eval": 1, "study": "rig", ...}. Of formats/spec/COMMAND.schema.json.
//   kind, of  one member more, and its value
std::string with_version(const std::string& command, const std::string& kind, const std::string& of,
                         const std::string& text);
// One line, without a byte of a broken file that a terminal would obey.
std::string printable(std::string text);

struct FolderFile {
  std::string name;  // below the folder
  std::string mesh, output;
};

// output_folder/RELATIVE/NAME + extension for every folder/RELATIVE/NAME.*, by name. Throws UsageError where the outputs
// would be the next run's inputs, and Error where there is no mesh or outputs would replace inputs or each other.
//   or_pictures  a folder without a mesh gives its pictures: beside meshes they are textures
std::vector<FolderFile> folder_files(const std::string& folder, const std::string& output_folder,
                                     const std::string& extension, bool or_pictures = false);

}  // namespace sinew::cli
#endif
