// SPDX-License-Identifier: MIT
// A network's linear layers as vector kernels want them: packed parameters, columns that rows share, and the rows
// that nobody reads because of that.
#ifndef SINEW_NETWORK_PACKED_LAYERS_HPP
#define SINEW_NETWORK_PACKED_LAYERS_HPP

#include "core/arena.hpp"
#include "kernels/kernels.hpp"
#include "model/layout.hpp"
#include "network/network.hpp"
#include "network/plan.hpp"

namespace sinew {

// Bytes of the model's weights as vector kernels read them (a multiple of 64; 0 in builds without such kernels), and
// the weights themselves, for sinew_model::packed.
size_t packed_bytes(const sinew_model& model);
void pack_model(const sinew_model& model, uint8_t* memory);

// A linear layer's parameters in the model's bytes.
LinearView make_linear_view(const ModelTables& tables, const Layer& layer);

// Whether memory is asked for packed weights. Does not look at the processor, so that the size query is the same
// everywhere; a processor whose kernels do not want them leaves the memory unused.
bool wants_packed(const NetworkOptions& options);

// A pair layer whose columns are partly the same in all slots of a vertex, or in all pairs of a joint in the part:
// those are multiplied once per vertex and once per joint and part.
struct SharedColumns {
  ColumnRange own[kMaxRanges], shared[kMaxRanges - 1];
  ColumnRange by_joint;                     // a part mean's
  uint8_t own_count = 0, shared_count = 0;  // with by_joint.count all 0: the layer is computed row by row
  uint16_t part_mean = 0;                   // layer
  bool any() const { return shared_count + by_joint.count > 0; }
};

SharedColumns find_shared_columns(const NetworkPlan& plan, uint32_t index, const LinearRecord& record);

// Layer index of the part means that a candidate maximum may read by joint, from their table; -1: it reads the tile.
int table_of_maximum(const NetworkPlan& plan, uint32_t index);

// Which rows of a layer's output anyone reads in a tile whose shared columns are multiplied once.
enum class RowsRead : uint8_t { kAll, kFirstOfVertex, kNone };

// The linear layers' packed parameters: the model's, or made in the workspace.
struct PackedLayers {
  const uint8_t* memory = nullptr;  // null = nowhere
  size_t offsets[kMaxLayers];
  uint8_t* own = nullptr;            // `memory` where it is still to be filled
  bool has_shared = false;           // some layer has shared columns
  SharedColumns* columns = nullptr;  // [layers]
  int32_t* starts = nullptr;         // [lanes x tile x outputs] sums of columns that a vertex' slots share
  uint32_t outputs = 0;              // of the widest layer that has them
  RowsRead rows_read[kMaxLayers];

  bool allocate(const sinew_model& model, const NetworkPlan& plan, const ModelTables& tables,
                const NetworkOptions& options, uint32_t lanes, Arena& arena);
  // Leaves the memory unused where no kernel wants it.
  void fill(const NetworkPlan& plan, const ModelTables& tables, bool wanted);
  PackedLinear view(const LinearView& linear, uint32_t index) const {
    return packed_view(linear, memory + offsets[index]);
  }
};

}  // namespace sinew
#endif
