// SPDX-License-Identifier: MIT
// Executes a model's layer list stage by stage, tile by tile.
#include "network/network.hpp"

#include <string.h>

#include "network/run.hpp"
#include "network/tile_layers.hpp"

namespace sinew {
namespace network {
namespace {

// Shared columns are read from the first slot's row, which must be present if any is. Candidates that the engine found
// are so. A tile of other candidates is computed row by row.
bool first_slot_speaks_for_all(const uint16_t* joints, uint32_t vertices, uint32_t k) {
  for (uint32_t i = 0; i < vertices; ++i) {
    const uint16_t* row = joints + static_cast<size_t>(i) * k;
    for (uint32_t slot = 1; row[0] == kNoJoint && slot < k; ++slot) {
      if (row[slot] != kNoJoint) return false;
    }
  }
  return true;
}

// Rows of the tile's vertices between a whole-mesh array and the tile. `region` is the array's offset in its buffer.
void load_rows(const Tile& tile, const Region& region, RowsView from) {
  const uint32_t slots = slots_of(tile.run, region), stride = tile.run.plan.buffers[region.buffer].channels;
  int16_t* to = tile_row(tile, region, 0);
  for (uint32_t i = 0; i < tile.count; ++i) {
    const int16_t* row = from.data + static_cast<size_t>(tile.vertices()[i]) * slots * from.stride;
    for (uint32_t slot = 0; slot < slots; ++slot, to += stride, row += from.stride)
      copy_values(to, row, region.channels);
  }
}
void store_rows(const Tile& tile, const Region& region, int16_t* to) {
  const uint32_t slots = slots_of(tile.run, region), stride = tile.run.plan.buffers[region.buffer].channels;
  const int16_t* from = tile_row(tile, region, 0);
  for (uint32_t i = 0; i < tile.count; ++i) {
    int16_t* row = to + static_cast<size_t>(tile.vertices()[i]) * slots * region.channels;
    for (uint32_t slot = 0; slot < slots; ++slot, from += stride, row += region.channels)
      copy_values(row, from, region.channels);
  }
}

// The tile's vertices go through all layers of the stage.
void run_tile(Tile tile, uint32_t stage) {
  const Run& run = tile.run;
  const uint32_t k = run.plan.candidates;
  for (uint32_t i = 0; i < tile.count; ++i) {
    memcpy(run.scratch.joints + (tile.first() + i) * k, run.input.joints + static_cast<size_t>(tile.vertices()[i]) * k,
           k * sizeof(uint16_t));
  }
  tile.shared = kHasPackedWeights && run.packed.has_shared && first_slot_speaks_for_all(tile.joints(), tile.count, k);
  for (uint16_t b = 0; b < run.plan.input_count; ++b) {
    if (!run.scratch.load_input[b]) continue;
    load_rows(tile, {b, 0, run.plan.buffers[b].channels}, whole_mesh(run, b, kFromInput, 0));
  }
  for (uint32_t i = 0; i < run.plan.layer_count; ++i) {
    const Layer& layer = run.plan.layers[i];
    if (run.scratch.load[i]) {
      load_rows(tile, layer.out, whole_mesh(run, layer.out.buffer, static_cast<int>(i), layer.out.offset));
    }
    if (run.plan.stage[i] != stage) continue;
    run_layer(tile, i);
    if (run.plan.stored[i]) {
      store_rows(tile, layer.out, run.storage + static_cast<size_t>(run.plan.store_offset[i]) * run.sizes.vertices);
    }
    if (i + 1 == run.plan.layer_count) store_rows(tile, layer.out, run.logits);
  }
}

bool has_part_layer(const NetworkPlan& plan, uint32_t stage) {
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    if (plan.stage[i] == stage && by_part(plan.layers[i].kind)) return true;
  }
  return false;
}

// One walk over the vertices of a stage.
class StageWalk {
 public:
  StageWalk(const Run& run, uint32_t stage, const Progress& progress)
      : run_(run),
        stage_(stage),
        progress_(progress),
        by_part_(has_part_layer(run.plan, stage)),
        small_part_(uint64_t{run.sizes.tile} * kSmallPart),
        round_(run.sizes.tile_vertices() * kTilesPerRound),
        done_(static_cast<uint64_t>(stage) * run.sizes.vertices) {}

  // Part by part when a layer wants part means, so that one part's table is enough; else in order. Returns false when
  // the caller cancelled.
  bool run() {
    share_tables(run_, stage_, true, nullptr, 0);
    for (uint32_t lane = 1; lane < run_.sizes.lanes; ++lane) copy_global_tables(lane);
    if (!by_part_) return run_range(0, run_.sizes.vertices);
    const uint32_t* offsets = run_.input.part_offsets;
    for (uint32_t part = 0; part < run_.input.part_count;) {
      // A part that keeps all lanes busy, or as many small parts as a round holds: a lane takes those whole.
      uint32_t end = part;
      while (end < run_.input.part_count && offsets[end + 1] - offsets[end] < small_part_ &&
             offsets[end + 1] - offsets[part] <= round_) {
        ++end;
      }
      if (end == part) {
        share_part_tables(part);
        if (!run_range(offsets[part], offsets[part + 1])) return false;
        ++part;
      } else {
        if (!run_parts(part, end)) return false;
        part = end;
      }
    }
    return true;
  }

 private:
  static constexpr uint32_t kTilesPerRound = 32;  // of each lane between two reports of progress
  static constexpr uint32_t kSmallPart = 4;       // tiles

  bool report(uint32_t vertices) {
    const uint64_t all = static_cast<uint64_t>(run_.plan.stage_count) * run_.sizes.vertices;
    const bool go_on = progress_.report(static_cast<uint32_t>(done_ * 1000 / all));
    done_ += vertices;
    return go_on;
  }

  // Global layers are computed once; every lane's own table has them, beside its parts'.
  void copy_global_tables(uint32_t lane) const {
    for (uint32_t i = 0; i < run_.plan.layer_count; ++i) {
      const Layer& layer = run_.plan.layers[i];
      if (run_.plan.stage[i] != stage_ || !uses_table(layer.kind) || by_part(layer.kind)) continue;
      copy_values(table_of(run_, i, lane), table_of(run_, i, 0), layer.in.channels);
    }
  }

  void share_part_tables(uint32_t part) const {
    const uint32_t begin = run_.input.part_offsets[part], end = run_.input.part_offsets[part + 1];
    share_tables(run_, stage_, false, run_.input.part_vertices + begin, end - begin);
    if (kHasPackedWeights) multiply_part_means(run_, stage_, run_.input.part_vertices + begin, end - begin, 0);
  }

  void make_part_tables(uint32_t part, uint32_t lane) const {
    const uint32_t begin = run_.input.part_offsets[part], end = run_.input.part_offsets[part + 1];
    make_tables(run_, stage_, false, run_.input.part_vertices + begin, end - begin, lane);
    if (kHasPackedWeights) {
      multiply_part_means(run_, stage_, run_.input.part_vertices + begin, end - begin, lane);
    }
  }

  void run_tiles(uint32_t first, uint32_t end, uint32_t lane, uint32_t table_lane) const {
    for (; first < end; first += run_.sizes.tile) {
      const Tile tile = {run_, lane, table_lane, end - first < run_.sizes.tile ? end - first : run_.sizes.tile, false};
      for (uint32_t i = 0; i < tile.count; ++i) {
        run_.scratch.vertices[tile.first() + i] = by_part_ ? run_.input.part_vertices[first + i] : first + i;
      }
      run_tile(tile, stage_);
    }
  }

  bool run_range(uint32_t begin, uint32_t end) {
    for (uint32_t first = begin; first < end;) {
      const uint32_t last = end - first < round_ ? end : first + static_cast<uint32_t>(round_);
      if (!report(last - first)) return false;
      run_.input.threads.ranges(last - first, run_.sizes.tile, [&](uint32_t from, uint32_t to, uint32_t lane) {
        run_tiles(first + from, first + to, lane, 0);
      });
      first = last;
    }
    return true;
  }

  bool run_parts(uint32_t first, uint32_t end) {
    const uint32_t* offsets = run_.input.part_offsets;
    if (!report(offsets[end] - offsets[first])) return false;
    run_.input.threads.each(end - first, [&](uint32_t index, uint32_t lane) {
      const uint32_t part = first + index;
      if (offsets[part] == offsets[part + 1]) return;
      make_part_tables(part, lane);
      run_tiles(offsets[part], offsets[part + 1], lane, lane);
    });
    return true;
  }

  const Run& run_;
  const uint32_t stage_;
  const Progress& progress_;
  const bool by_part_;
  const uint64_t small_part_, round_;  // vertices
  uint64_t done_;
};

}  // namespace
}  // namespace network

sinew_status run_network(const sinew_model& model, const NetworkInput& input, const Kernels& kernels,
                         const Progress& progress, Arena& arena, int16_t* logits, const NetworkOptions& options) {
  const ArenaScope scope(arena);
  NetworkPlan plan;
  make_plan(model, input.candidate_count, &plan);
  const ModelTables tables(model.bytes);
  PackedLayers packed;
  const network::Sizes sizes = {input.vertex_count, input.joint_count, options.tile_vertices,
                                input.threads.lane_count()};
  if (kHasPackedWeights) (void)packed.allocate(model, plan, tables, options, sizes.lanes, arena);
  const bool reads_packed = wants_packed(options) && kernels.linear_packed != nullptr;
  const LinearKernel linear = reads_packed ? kernels.linear_packed : kernels.linear;
  network::Run run = {plan, input, tables, kernels, linear, packed, sizes, nullptr, logits, {}};
  run.storage = network::allocate_storage(plan, run.sizes, arena);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (kHasPackedWeights && !arena.measuring()) packed.fill(plan, tables, kernels.linear_packed != nullptr);
  for (uint32_t stage = 0; stage < plan.stage_count; ++stage) {
    const ArenaScope stage_scope(arena);
    if (!network::allocate_stage(plan, tables, options, stage, run.sizes, arena, &run.scratch))
      return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring() && !network::StageWalk(run, stage, progress).run()) return SINEW_ERROR_CANCELLED;
  }
  return SINEW_OK;
}

}  // namespace sinew
