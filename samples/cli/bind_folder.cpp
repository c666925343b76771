// SPDX-License-Identifier: MIT
// A folder of meshes bound file by file.
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "bind_files.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/page/pages.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

constexpr int kPicture = 160;  // pixels

struct Task : FolderFile {
  std::string skeleton;
};

struct FinishedTask {
  BoundRow row;
  nlohmann::ordered_json json;
};

std::vector<Task> make_tasks(const FolderSettings& s) {
  std::vector<Task> tasks;
  for (const FolderFile& file : folder_files(s.folder, s.output_folder, s.extension)) {
    Task task{file, s.each.skeleton};
    if (task.skeleton.empty() && has_rig_beside(task.mesh)) task.skeleton = rig_path_beside(task.mesh);
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
  view.up = axis_of(settings.up);
  return encode_png(render(character, weight_colors(character), view));
}

FinishedTask failure(const Task& task, const std::string& why) {
  FinishedTask done;
  done.row.name = task.name;
  done.row.error = printable(why);
  done.json = {{"mesh", task.mesh}, {"error", done.row.error}};
  return done;
}

FinishedTask bind_task(const FolderSettings& s, const Binder& binder, const Task& task) {
  BindSettings one = s.each;
  one.mesh = task.mesh;
  one.skeleton = task.skeleton;
  one.output = task.output;
  try {
    make_folder(fs::path(task.output).parent_path().string());
    const BoundFile bound = bind_one(one, binder, false);
    FinishedTask done{row_of(task, bound.summary), summary_json(bound.summary)};
    if (!s.report.empty()) done.row.png = picture_of(bound.character, one);
    return done;
  } catch (const UsageError&) {
    throw;  // the same for every file
  } catch (const std::bad_alloc&) {
    return failure(task, task.mesh + ": out of memory; use fewer --jobs");
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

// Reports the files in their order, whichever is ready first.
class FolderReporter {
 public:
  FolderReporter(const FolderSettings& s, size_t count)
      : settings_(s), done_(count), ready_(count), progress_(count, "files") {}

  void add(size_t index, FinishedTask done) {
    const std::lock_guard<std::mutex> guard(lock_);
    done_[index] = std::move(done);
    ready_[index] = true;
    progress_.step();
    for (; next_ < done_.size() && ready_[next_]; ++next_) tell(done_[next_]);
  }
  // After all are reported.
  std::vector<BoundRow> rows() const {
    std::vector<BoundRow> rows;
    for (const FinishedTask& done : done_) rows.push_back(done.row);
    return rows;
  }

 private:
  void tell(const FinishedTask& done) {
    if (!done.row.error.empty()) progress_.say(stderr, "sinew: error: " + done.row.error);
    if (settings_.json) {
      progress_.say(stdout, json_line(done.json));
    } else if (done.row.error.empty()) {
      progress_.say(stdout, line_of(done.row));
    }
  }

  const FolderSettings& settings_;
  std::mutex lock_;
  std::vector<FinishedTask> done_;
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
    FolderReporter reporter(s, tasks.size());
    parallel_for(tasks.size(), s.jobs, [&](size_t i, unsigned) { reporter.add(i, bind_task(s, binder, tasks[i])); });
    rows = reporter.rows();
  }
  size_t failed = 0;
  for (const BoundRow& row : rows) failed += row.error.empty() ? 0 : 1;
  if (!s.report.empty()) write_text_file(s.report, bind_html(s.folder, binder.name, rows));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::fprintf(s.json ? stderr : stdout, "%zu files: %zu bound, %zu failed, %.1f s\n", rows.size(),
               rows.size() - failed, failed, seconds);
  check_failed(failed, rows.size(), "files");
}

}  // namespace sinew::cli
