// SPDX-License-Identifier: MIT
// A folder of meshes bound file by file.
#include "bind_folder.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <new>
#include <set>
#include <utility>
#include <vector>

#include "dataset.hpp"
#include "progress.hpp"
#include "sinew_datasets/bind_page.hpp"
#include "sinew_datasets/image.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/parallel.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

constexpr int kPicture = 160;  // pixels

struct Task {
  std::string name;  // below the folder
  std::string mesh, skeleton, output;
};

struct Done {
  BoundRow row;
  nlohmann::ordered_json json;
};

std::string real_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(path, ignored).string();
}

// Outputs of one run would be the inputs of the next.
void refuse_folder_inside(const FolderSettings& s) {
  const fs::path in = real_path(s.folder), out = real_path(s.output_folder);
  const std::string below = out.lexically_relative(in).string();
  if (below == ".") throw UsageError("-o " + s.output_folder + ": is the folder of the inputs; give another");
  if (!below.empty() && below.rfind("..", 0) != 0)
    throw UsageError("-o " + s.output_folder + ": lies inside " + s.folder +
                     ", where the next run would find its files as inputs; give a folder outside");
}

std::vector<Task> make_tasks(const FolderSettings& s) {
  refuse_folder_inside(s);
  const std::vector<std::string> meshes = list_meshes(s.folder);
  if (meshes.empty()) throw Error(s.folder + ": no mesh in it nor below it; expected .obj, .gltf, .glb or .vrm");
  std::set<std::string> inputs;
  for (const std::string& mesh : meshes) inputs.insert(real_path(mesh));
  std::map<std::string, std::string> taken;  // output -> mesh
  std::vector<Task> tasks;
  for (const std::string& mesh : meshes) {
    const fs::path name = fs::path(mesh).lexically_relative(s.folder);
    Task task;
    task.name = name.string();
    task.mesh = mesh;
    task.skeleton = s.each.skeleton;
    std::error_code ignored;
    if (task.skeleton.empty() && has_extension(mesh, ".obj") && fs::exists(rig_path_beside(mesh), ignored))
      task.skeleton = rig_path_beside(mesh);
    task.output = (fs::path(s.output_folder) / name.parent_path() / (stem_of(mesh) + s.extension)).string();
    const auto [first, fresh] = taken.emplace(task.output, mesh);
    if (!fresh) throw Error(first->second + " and " + mesh + " would both become " + task.output + "; rename one");
    if (inputs.count(real_path(task.output)) != 0)
      throw Error(task.output + ": is a link to one of the inputs, which are not replaced; give another folder");
    tasks.push_back(std::move(task));
  }
  return tasks;
}

BoundRow row_of(const Task& task, const BindSummary& summary) {
  BoundRow row;
  row.name = task.name;
  row.vertices = summary.vertices;
  row.joints = summary.joints;
  row.joints_used = summary.joints_used;
  row.seconds = summary.seconds;
  row.doubts = doubts_text(summary.doubts);
  row.notes = summary.notes;
  if (summary.replaced.vertices > 0) row.notes.insert(row.notes.begin(), replaced_text(summary.replaced));
  return row;
}

std::vector<uint8_t> picture_of(const Character& character, const BindSettings& settings) {
  RenderOptions view;
  view.width = view.height = kPicture;
  view.draw_skeleton = false;
  view.up_z = settings.up == "z";
  return encode_png(render(character, weight_colours(character), view));
}

Done failure(const Task& task, const std::string& why) {
  Done done;
  done.row.name = task.name;
  done.row.error = printable(why);
  done.json = {{"mesh", task.mesh}, {"error", done.row.error}};
  return done;
}

Done bind_task(const FolderSettings& s, const Binder& binder, const Task& task) {
  BindSettings one = s.each;
  one.mesh = task.mesh;
  one.skeleton = task.skeleton;
  one.output = task.output;
  try {
    make_folder(fs::path(task.output).parent_path().string());
    const BoundFile bound = bind_one(one, binder, false);
    Done done{row_of(task, bound.summary), summary_json(bound.summary)};
    if (!s.report.empty()) done.row.png = picture_of(bound.character, one);
    return done;
  } catch (const UsageError&) {
    throw;  // the same for every file
  } catch (const std::bad_alloc&) {
    return failure(task, task.mesh + ": out of memory; fewer --jobs need less");
  } catch (const std::exception& error) {
    return failure(task, error.what());
  }
}

std::string line_of(const BoundRow& row) {
  std::string line = print("%s: %zu vertices, %zu of %zu joints, %.3f s", printable(row.name).c_str(), row.vertices,
                           row.joints_used, row.joints, row.seconds);
  if (!row.doubts.empty()) line += "; " + row.doubts;
  for (const std::string& note : row.notes) line += "; " + note;
  return line;
}

// Tells of the files in their order, whichever is ready first.
class Teller {
 public:
  Teller(const FolderSettings& s, size_t count)
      : settings_(s), done_(count), ready_(count), progress_(count, "files") {}

  void add(size_t index, Done done) {
    const std::lock_guard<std::mutex> guard(lock_);
    done_[index] = std::move(done);
    ready_[index] = true;
    progress_.step();
    for (; next_ < done_.size() && ready_[next_]; ++next_) tell(done_[next_]);
  }
  // When all are told.
  std::vector<BoundRow> rows() const {
    std::vector<BoundRow> rows;
    for (const Done& done : done_) rows.push_back(done.row);
    return rows;
  }

 private:
  void tell(const Done& done) {
    if (!done.row.error.empty()) progress_.say(stderr, "sinew: error: " + done.row.error);
    if (settings_.json) {
      progress_.say(stdout, json_line(done.json));
    } else if (done.row.error.empty()) {
      progress_.say(stdout, line_of(done.row));
    }
  }

  const FolderSettings& settings_;
  std::mutex lock_;
  std::vector<Done> done_;
  std::vector<char> ready_;
  size_t next_ = 0;
  Progress progress_;
};

}  // namespace

void bind_folder(const FolderSettings& s, const Binder& binder) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Task> tasks = make_tasks(s);
  std::vector<BoundRow> rows;
  {
    Teller teller(s, tasks.size());
    parallel_for(tasks.size(), s.jobs, [&](size_t i, unsigned) { teller.add(i, bind_task(s, binder, tasks[i])); });
    rows = teller.rows();
  }
  size_t failed = 0;
  for (const BoundRow& row : rows) failed += row.error.empty() ? 0 : 1;
  if (!s.report.empty()) write_text_file(s.report, bind_html(s.folder, binder.name, rows));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::fprintf(s.json ? stderr : stdout, "%zu files: %zu bound, %zu failed, %.1f s\n", rows.size(),
               rows.size() - failed, failed, seconds);
  if (failed > 0) throw Error(print("%zu of %zu files failed, see above", failed, rows.size()));
}

}  // namespace sinew::cli
