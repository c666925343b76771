// SPDX-License-Identifier: MIT
// Cuts a model's layers into stages and places the outputs that must be stored.
#include "network/plan.hpp"

#include "model/layout.hpp"
#include "model/regions.hpp"

namespace sinew {
namespace {

// Calls visit(producer) for every layer that wrote a part of what layer `reader` reads, its residual included.
template <class Visit>
void for_each_producer(const NetworkPlan& plan, uint32_t reader, Visit visit) {
  const Layer& layer = plan.layers[reader];
  const Region* regions[2] = {&layer.in, &layer.residual};
  const uint32_t count = (layer.flags & kLayerResidual) != 0 ? 2 : 1;
  for (uint32_t i = 0; i < count; ++i) {
    for (uint32_t channel = regions[i]->offset; channel < region_end(*regions[i]);) {
      const Segment segment = segment_at(plan.layers, plan.input_count, reader, *regions[i], channel);
      if (segment.producer >= 0) visit(static_cast<uint32_t>(segment.producer));
      channel += segment.count;
    }
  }
}

// First each layer as early as its inputs allow. Then every layer without weights as late as its readers allow:
// they are cheap and mostly hand on or widen values, so it is better to store what they read (often stored anyway).
void assign_stages(NetworkPlan* plan) {
  for (uint32_t i = 0; i < plan->layer_count; ++i) {
    const uint16_t wait = reads_other_rows(plan->layers[i].kind) ? 1 : 0;
    uint16_t stage = 0;
    for_each_producer(*plan, i, [&](uint32_t producer) {
      const uint16_t ready = static_cast<uint16_t>(plan->stage[producer] + wait);
      if (ready > stage) stage = ready;
    });
    plan->stage[i] = stage;
    if (stage + 1u > plan->stage_count) plan->stage_count = stage + 1u;
  }
  uint16_t latest[kMaxLayers];
  for (uint32_t i = 0; i < plan->layer_count; ++i) latest[i] = UINT16_MAX;
  for (uint32_t i = plan->layer_count; i-- > 0;) {
    if (!has_weights(plan->layers[i].kind) && latest[i] != UINT16_MAX) plan->stage[i] = latest[i];
    const uint16_t wait = reads_other_rows(plan->layers[i].kind) ? 1 : 0;
    const uint16_t needed = static_cast<uint16_t>(plan->stage[i] - wait);
    for_each_producer(*plan, i, [&](uint32_t producer) {
      if (needed < latest[producer]) latest[producer] = needed;
    });
  }
}

// First fit: an output takes the lowest offset that no output alive at the same time occupies.
void place_stored(NetworkPlan* plan) {
  for (uint32_t i = 0; i < plan->layer_count; ++i) {
    plan->stored[i] = plan->last_use[i] > plan->stage[i];
    plan->store_offset[i] = 0;
    if (!plan->stored[i]) continue;
    const Region& out = plan->layers[i].out;
    const uint64_t size = static_cast<uint64_t>(out.channels) * plan->slots(out.buffer);
    uint64_t offset = 0;
    for (bool moved = true; moved;) {
      moved = false;
      for (uint32_t other = 0; other < i; ++other) {
        if (!plan->stored[other] || plan->stage[other] > plan->last_use[i] || plan->stage[i] > plan->last_use[other])
          continue;
        const Region& taken = plan->layers[other].out;
        const uint64_t begin = plan->store_offset[other];
        const uint64_t end = begin + static_cast<uint64_t>(taken.channels) * plan->slots(taken.buffer);
        if (offset < end && begin < offset + size) {
          offset = end;
          moved = true;
        }
      }
    }
    plan->store_offset[i] = offset;
    if (offset + size > plan->store_values) plan->store_values = offset + size;
  }
}

}  // namespace

void make_plan(const sinew_model& model, uint32_t candidates, NetworkPlan* plan) {
  const ModelTables tables(model.bytes);
  plan->candidates = candidates;
  plan->layer_count = tables.layer_count();
  plan->buffer_count = tables.buffer_count();
  plan->input_count = model.input_count;
  plan->stage_count = 0;
  plan->store_values = 0;
  for (uint32_t i = 0; i < plan->buffer_count; ++i) plan->buffers[i] = tables.buffer(i);
  for (uint32_t i = 0; i < plan->layer_count; ++i) plan->layers[i] = tables.layer(i);
  assign_stages(plan);
  for (uint32_t i = 0; i < plan->layer_count; ++i) plan->last_use[i] = plan->stage[i];
  for (uint32_t i = 0; i < plan->layer_count; ++i) {
    for_each_producer(*plan, i, [&](uint32_t producer) {
      if (plan->stage[i] > plan->last_use[producer]) plan->last_use[producer] = plan->stage[i];
    });
  }
  place_stored(plan);
}

}  // namespace sinew
