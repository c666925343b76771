// SPDX-License-Identifier: MIT
// The task of a network: the rows it reads and the rows it writes. A model file names its task; the caller that opens
// it gives the inputs of that task in this library.
#ifndef SINEW_MODEL_TASK_HPP
#define SINEW_MODEL_TASK_HPP

#include "model/layers.hpp"

namespace sinew {

// Numbers of tasks in model files; never reused. Numbers from kFirstPrivateTask on are free for experiments and
// tests.
constexpr uint32_t kTaskBind = 0;  // skin weights: bind/bind.hpp
constexpr uint32_t kTaskRig = 1;   // a skeleton for a bare mesh: votes/rig_task.hpp
constexpr uint32_t kFirstPrivateTask = 0x80000000u;

// Name of an input in a model file: four letters, the first in the lowest byte.
constexpr uint32_t input_name(const char (&letters)[5]) {
  uint32_t name = 0;
  for (int i = 3; i >= 0; --i) name = (name << 8) | static_cast<uint8_t>(letters[i]);
  return name;
}

struct TaskInput {
  uint32_t name = 0;  // input_name()
  Buffer buffer;
};

struct ModelTask {
  uint32_t id = kTaskBind;
  uint32_t input_count = 0;
  TaskInput inputs[kMaxInputs];
  Buffer output;               // of the last layer's region
  bool far_neighbors = false;  // vertices have far neighbors beside those of the one-ring
};

}  // namespace sinew
#endif
