// SPDX-License-Identifier: MIT
// Fuzz target: the model reader, on the bytes as they are and with size and checksum made right (no fuzzer guesses a
// checksum). A model that is accepted binds a small mesh, with the same bytes from every kernel.
#include "bind_checks.hpp"
#include "fuzz.hpp"
#include "model/layout.hpp"
#include "network_fixture.hpp"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace {

using namespace sinew;
using namespace sinew::test;

bool is_model_status(sinew_status status) {
  return status == SINEW_OK || (status <= SINEW_ERROR_MODEL_MAGIC && status >= SINEW_ERROR_MODEL_ALIGNMENT) ||
         status == SINEW_ERROR_MODEL_TASK;
}

void bind_with(const sinew_model& model) {
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0.25f, 1, 1};
  const uint32_t faces[] = {0, 1, 2, 0, 1, 3, 1, 2, 3, 0, 2, 3};
  const float joint_positions[] = {0, 0, 0, 0.25f, 1, 0, 0, 2, 0.25f};
  const int32_t parents[] = {-1, 0, 1};
  sinew_mesh mesh = {};
  mesh.positions = positions;
  mesh.vertex_count = 4;
  mesh.face_vertices = faces;
  mesh.face_count = 4;
  mesh.corner_count = 12;
  sinew_skeleton skeleton = sinew_test::skeleton_of(joint_positions, parents, 3);
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.grid_size = 16;
  Binding first, second;
  for (Binding* binding : {&first, &second}) {
    options.kernel = binding == &first ? SINEW_KERNEL_REF : SINEW_KERNEL_AUTO;
    options.weights_in_place = binding == &first;
    size_t need = 0;
    demand(sinew_bind_workspace_size(&model, 4, 4, 12, 3, &options, &need) == SINEW_OK, "an opened model has a size");
    if (need > size_t{1} << 28) return;  // channels by the ten thousand are legal and take their memory
    sinew_model used = model;
    size_t packed_bytes = 0;
    demand(sinew_model_pack_workspace_size(&model, &packed_bytes) == SINEW_OK, "an opened model has a packed size");
    const sinew::Workspace packed(binding == &first ? 0 : packed_bytes);
    if (binding == &second) {
      demand(sinew_model_pack(&used, packed.data(), packed.size()) == SINEW_OK, "an opened model is packed");
    }
    binding->run(&used, mesh, skeleton, options, nullptr, need, 4, sizeof(uint16_t));
    demand(binding->status == SINEW_OK, std::string("an opened model runs: ") + sinew_status_text(binding->status));
    check_rows(*binding, mesh, skeleton, options);
  }
  demand(first.joints == second.joints && first.weights == second.weights, "every kernel gives the same bytes");
}

// True when the bytes are a model.
bool open_and_judge(const uint8_t* data, size_t size) {
  AlignedBytes file(std::vector<uint8_t>(data, data + size));
  sinew_model model, again, untouched;
  std::memset(&model, 0x5A, sizeof model);
  std::memset(&again, 0x5A, sizeof again);
  std::memset(&untouched, 0x5A, sizeof untouched);
  const sinew_status status = sinew_model_open(file.data(), size, &model);
  demand(is_model_status(status), "sinew_model_open returns what it documents");
  demand(std::strlen(sinew_status_text(status)) > 0 && std::strchr(sinew_status_text(status), '\n') == nullptr,
         "a status is one line");
  demand(sinew_model_open(file.data(), size, &again) == status, "a second opening says the same");
  if (status != SINEW_OK) {
    demand(std::memcmp(&model, &untouched, sizeof model) == 0, "*model is untouched on failure");
    return false;
  }
  demand(model.bytes == file.data() && model.size_bytes == size && model.candidate_count >= 1 &&
             model.candidate_count <= SINEW_MAX_CANDIDATES &&
             (model.grid_size == 0 || (model.grid_size >= 16 && model.grid_size <= 128)) && model.layer_count >= 1 &&
             model.parameter_count <= size,
         "an opened model's figures are in their ranges");
  bind_with(model);
  return true;
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (open_and_judge(data, size) || size < kHeaderBytes) return 0;
  std::vector<uint8_t> sealed(data, data + size);
  store_u64(&sealed[kHeaderSize], size);
  store_u32(&sealed[kHeaderChecksum], model_checksum(sealed.data(), size));
  open_and_judge(sealed.data(), size);
  return 0;
}
