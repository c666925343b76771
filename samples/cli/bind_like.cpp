// SPDX-License-Identifier: MIT
// Transfer, then hints where it fits.
#include "bind_like.hpp"

#include "sinew_character/transfer.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "thread_pool.hpp"
#include "transfer_target.hpp"

namespace sinew::cli {

void add_hints_like(const BindSettings& settings, const Binder& binder, const std::vector<uint8_t>& locked,
                    Character* character, std::vector<uint8_t>* hints) {
  if (settings.like.empty()) return;
  constexpr uint8_t kSure = 128;        // of 255
  constexpr uint32_t kCarried = 32768;  // half of a part's weights
  const Character source = read_character(settings.like);
  if (source.joints.empty() || source.influences.empty())
    throw Error(settings.like + ": --like needs a bound character, and this one has no skin weights");
  Character target = *character;
  target.influences.clear();
  std::string mapped_by;
  const JointMapping mapping = find_joint_map(source, "", settings.mesh, target, &mapped_by);
  TransferOptions options;
  options.model = binder.model;
  options.influence_count = settings.influences;
  options.up_axis = options.source_up_axis = settings.up == "z" ? 1 : 0;
  options.thread_count = settings.threads;
  ThreadPool pool(settings.threads);
  options.parallel_for = ThreadPool::parallel_for;
  options.parallel_user = &pool;
  const TransferResult carried = transfer(source, target, mapping, options);
  hints->resize(character->vertices.size(), 0);
  character->influences.resize(character->vertices.size());
  size_t count = 0;
  for (size_t v = 0; v < hints->size(); ++v) {
    if ((*hints)[v] != 0 || (!locked.empty() && locked[v] != 0) || carried.confidence[v] < kSure ||
        carried.parts.at(carried.vertex_parts[v]).carried_q16 < kCarried)
      continue;
    character->influences[v] = carried.influences[v];
    (*hints)[v] = 1;
    ++count;
  }
  if (count == 0) hints->clear();
  character->notes.push_back(
      "like " + source.name + ": " + std::to_string(mapped_count(mapping)) + " joints mapped by " + mapped_by +
      print(", %.0f %% of the vertices keep its weights and steer the others",
            100.0 * static_cast<double>(count) / static_cast<double>(character->vertices.size())) +
      (count == 0 ? ": it does not fit, or is what a bind gives anyway" : ""));
}

}  // namespace sinew::cli
