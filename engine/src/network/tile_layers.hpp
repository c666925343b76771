// SPDX-License-Identifier: MIT
// Layers over a tile: some vertices of a stage. To add a kind of layer, run_layer() gets a case.
#ifndef SINEW_NETWORK_TILE_LAYERS_HPP
#define SINEW_NETWORK_TILE_LAYERS_HPP

#include "network/run.hpp"

namespace sinew::network {

// Some vertices of a run, in a stage.
struct Tile {
  const Run& run;
  uint32_t lane;        // whose scratch they use
  uint32_t table_lane;  // whose tables they read
  uint32_t count;       // vertices
  bool shared;          // its shared columns are multiplied once
  const uint32_t* vertices() const { return run.scratch.vertices + first(); }
  const uint16_t* joints() const { return run.scratch.joints + first() * run.plan.candidates; }
  size_t first() const { return static_cast<size_t>(lane) * run.sizes.tile; }  // vertex of the scratch
};

inline int16_t* tile_row(const Tile& tile, const Region& region, size_t row) {
  const NetworkPlan& plan = tile.run.plan;
  return tile.run.scratch.tile[region.buffer] +
         (tile.first() * plan.slots(region.buffer) + row) * plan.buffers[region.buffer].channels + region.offset;
}
inline RowsView tile_rows(const Tile& tile, const Region& region) {
  return {tile_row(tile, region, 0), tile.run.plan.buffers[region.buffer].channels};
}

// Runs a layer whose input, tables and storage are there.
void run_layer(const Tile& tile, uint32_t index);

}  // namespace sinew::network
#endif
