// SPDX-License-Identifier: MIT
// sinew_character_transfer(): the job of `sinew transfer`.
#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/check/check.hpp"
#include "sinew_character/jobs/transfer_job.hpp"
#include "sinew_formats/base/thread_pool.hpp"

namespace sinew {
namespace {

void check(const sinew_character_transfer_options& options) {
  check_at_most("method", options.method, SINEW_TRANSFER_REBIND);
  check_at_most("influence_count", options.influence_count, SINEW_MAX_INFLUENCES);
  check_at_most("thread_count", options.thread_count, SINEW_MAX_THREADS);
  check_at_most("pair_count", options.pair_count, SINEW_MAX_TRANSFER_PAIRS);
  need(options.pairs != nullptr || options.pair_count == 0, "pairs");
  const bool biharmonic = options.method == SINEW_TRANSFER_BIHARMONIC;
  if (biharmonic && options.garment != 0)
    throw Failure(SINEW_ERROR_ARGUMENT, "garment: needs another method than biharmonic");
  if (!biharmonic && (options.pair_count != 0 || options.as_drawn != 0))
    throw Failure(SINEW_ERROR_ARGUMENT, "pairs and as_drawn need SINEW_TRANSFER_BIHARMONIC");
  if (options.garment != 0 && (options.map != nullptr || options.locked != nullptr))
    throw Failure(SINEW_ERROR_ARGUMENT, "garment: uses the skeleton of the source, expected neither map nor locked");
}

TransferOptions job_of(const sinew_character_transfer_options& options, const Character& source,
                       const Character& target) {
  TransferOptions job;
  job.method = options.method;
  if (options.influence_count != 0) job.influence_count = options.influence_count;
  if (options.thread_count != 0) job.thread_count = options.thread_count;
  job.up_axis = up_axis_of("target_up", options.target_up);
  job.source_up_axis = up_axis_of("source_up", options.source_up);
  job.garment = options.garment != 0;
  job.as_drawn = options.as_drawn != 0;
  for (uint32_t p = 0; p < options.pair_count; ++p) {
    const sinew_vertex_pair& pair = options.pairs[p];
    if (pair.source >= source.vertices.size() || pair.target >= target.vertices.size())
      throw Failure(SINEW_ERROR_RANGE, "pairs: pair " + std::to_string(p) + " names a vertex that does not exist");
    job.pairs.push_back(pair);
  }
  if (options.locked != nullptr) {
    job.locked.assign(options.locked, options.locked + target.vertices.size());
    for (size_t v = 0; v < job.locked.size(); ++v)
      if (job.locked[v] != 0 && (target.influences.empty() || target.influences[v].empty()))
        throw Error("locked: vertex " + std::to_string(v) + " of " + target.name + " has no weights to keep");
  }
  return job;
}

void fill_result(const TransferTarget& target, const TransferResult& done, ResultViews* views,
                 sinew_character_transfer_result* result) {
  if (result == nullptr) return;
  *views = {};
  views->parts = done.parts;
  views->text = target.mapped_by;
  sinew_character_transfer_result filled = SINEW_INIT(sinew_character_transfer_result);
  filled.mapped_joints = count32(mapped_count(target.mapping));
  filled.fitted = target.fitted ? 1 : 0;
  filled.bound = done.bound ? 1 : 0;
  filled.bound_by = done.bound_by;
  filled.part_count = count32(views->parts.size());
  filled.carried = done.carried;
  filled.style = done.style;
  filled.mismatch = done.mismatch;
  filled.seconds = done.seconds;
  filled.mapped_by = views->text.c_str();
  filled.parts = views->parts.data();
  give(filled, result);
}

void carry(const sinew_character_transfer_options& options, ProgressOfCaller* progress, const sinew_character& from,
           sinew_character* to, sinew_character_transfer_result* result) {
  check(options);
  const Character& source = from.character;
  if (source.vertices.empty() || source.influences.empty())
    throw Error(file_of(from) + ": has no weights to transfer; expected a bound character");
  if (to->character.vertices.empty()) throw Error(file_of(*to) + ": has no mesh to bind");
  std::unique_ptr<LoadedModel> bind, rig;
  TransferTargetOptions target_options;
  target_options.path = file_of(*to);
  target_options.skeleton = "its own";
  target_options.map = text_or_empty(options.map);
  target_options.garment = options.garment != 0;
  target_options.up_axis = up_axis_of("target_up", options.target_up);
  target_options.rig_model = [&] {
    rig = model_of(options.models, ModelUse::kRig);
    return &rig->model;
  };
  TransferTarget target = transfer_target(source, to->character, target_options);
  TransferOptions job = job_of(options, source, target.character);
  const bool binds = options.method == SINEW_TRANSFER_AUTO || options.method == SINEW_TRANSFER_REBIND;
  if (binds && options.heat == 0) bind = model_of(options.models, ModelUse::kBind);
  if (bind) job.model = &bind->model;
  job.progress = progress->callback();
  job.progress_user = progress->user();
  ThreadPool pool(job.thread_count);
  job.parallel_for = ThreadPool::parallel_for;
  job.parallel_user = &pool;
  const TransferResult done = transfer(source, target.character, target.mapping, job);
  const bool other_skeleton = target.fitted || options.garment != 0;
  target.character.influences = done.influences;
  target.character.confidence = done.confidence;
  to->character = std::move(target.character);
  add_checked_note(&to->character);
  to->keep_confidence = false;
  if (other_skeleton) {
    to->own_skeleton = false;
    to->clips.clear();
  }
  changed(to);
  fill_result(target, done, &to->results, result);
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_transfer(const sinew_character* source, sinew_character* target,
                                                 const sinew_character_transfer_options* given,
                                                 sinew_character_transfer_result* result) {
  ProgressOfCaller progress = progress_of(given);
  return guarded(
      target,
      [&] {
        need(source != nullptr, "source");
        need(target != nullptr, "target");
        check_result(result);
        carry(options_of(given), &progress, *source, target, result);
      },
      &progress);
}
