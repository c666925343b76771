// SPDX-License-Identifier: MIT
// A workspace for the engine: 64-byte aligned bytes, freed at the end of the scope.
#ifndef SINEW_TRAINER_ALIGNED_BLOCK_HPP
#define SINEW_TRAINER_ALIGNED_BLOCK_HPP

#include <cstddef>
#include <new>

#include "sinew/sinew.h"

namespace sinew {

class AlignedBlock {
 public:
  explicit AlignedBlock(size_t bytes)
      : data_(::operator new (bytes, std::align_val_t{SINEW_WORKSPACE_ALIGNMENT})), size_(bytes) {}
  ~AlignedBlock() { ::operator delete (data_, std::align_val_t{SINEW_WORKSPACE_ALIGNMENT}); }
  AlignedBlock(const AlignedBlock&) = delete;
  AlignedBlock& operator=(const AlignedBlock&) = delete;
  void* data() const { return data_; }
  size_t size() const { return size_; }

 private:
  void* data_;
  size_t size_;
};

}  // namespace sinew
#endif
