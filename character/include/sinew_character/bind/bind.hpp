// SPDX-License-Identifier: MIT
// Binds a Character by sinew.h and returns its influences.
#ifndef SINEW_CHARACTER_BIND_HPP
#define SINEW_CHARACTER_BIND_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Options as in sinew_bind_options, for a Character with V vertices and J joints.
struct BindOptions {
  uint32_t method = SINEW_METHOD_HEAT;  // sinew_method
  const sinew_model* model = nullptr;   // needed for SINEW_METHOD_MODEL
  uint32_t influence_count = 4;         // N, 1..12
  Axis up_axis = Axis::kY;
  std::vector<uint8_t> joint_flags;     // [J] SINEW_JOINT_* or empty
  std::vector<uint8_t> locked;          // [V] or empty; locked rows come from character.influences
  std::vector<uint8_t> hints;           // [V] or empty; the same; their rows also guide the vertices around them
  uint32_t rigid_parts = 0;             // sinew_rigid_parts
  uint32_t softness_percent = 100;      // of the model's weights
  uint32_t surface_vertices = 0;        // see sinew_bind_options
  bool symmetric = false;               // mirrored vertices get mirrored rows
  std::vector<sinew_answer> answers;    // the user's answers about parts
  uint32_t question_count = 0;          // maximum number of questions, 0..SINEW_MAX_QUESTIONS
  uint32_t kernel = SINEW_KERNEL_AUTO;  // AUTO uses kernel_from_environment()
  sinew_progress progress = nullptr;
  void* progress_user = nullptr;
  uint32_t thread_count = 1;                  // pieces of work to run in parallel
  sinew_parallel_for parallel_for = nullptr;  // runs them, see sinew_bind_options
  void* parallel_user = nullptr;
};

struct BindResult {
  std::vector<std::vector<Influence>> influences;  // [V] the same as `joints` and `weights`, weights unorm16 / 65535
  std::vector<uint16_t> joints, weights;           // [V x N] as sinew_bind() writes them, weights unorm16
  std::vector<uint8_t> confidence;                 // [V] 0..255, see sinew_bind_outputs
  uint32_t symmetric_vertices = 0;                 // with BindOptions::symmetric
  std::vector<sinew_question> questions;           // by descending gain; with BindOptions::question_count
  std::vector<uint32_t> vertex_questions;          // [V] index of a question or SINEW_NO_QUESTION, with the same
  std::vector<uint32_t> vertex_parts;              // [V] see sinew_bind_outputs, with the same
  size_t workspace_bytes = 0, used_bytes = 0;
  double seconds = 0;  // duration of sinew_bind()
};

// Throws Error with the character's name and the status text, and OutOfMemory if there is no memory for the
// workspace.
BindResult bind(const Character& character, const BindOptions& options);

// FNV-1a in hexadecimal over the joints, then the weights of all rows as sinew_bind() writes them (unorm16, N influences
// each, low byte first): equal for equal weights on every machine.
std::string bind_hash(const std::vector<std::vector<Influence>>& rows, uint32_t influence_count);

// Returns the sinew_kernel of the environment variable SINEW_KERNEL (ref, avx2, vnni, ...), or AUTO without it.
// Throws Error that lists the available ones if it is unknown or missing in this build or processor.
uint32_t kernel_from_environment();

// Reduces a row to its `keep` largest weights (1..12), rounded to unorm16 / 65535 exactly like the engine. Empty for
// a row without weight.
std::vector<Influence> round_influences(const std::vector<Influence>& row, uint32_t keep);

}  // namespace sinew
#endif
