// SPDX-License-Identifier: MIT
// The C API: the version, what a status says, and which kernels run here.
#include "kernels/select.hpp"
#include "sinew/sinew.h"

#define SINEW_STRING_(x) #x
#define SINEW_STRING(x) SINEW_STRING_(x)

extern "C" {

const char* sinew_version(void) {
  return SINEW_STRING(SINEW_VERSION_MAJOR) "." SINEW_STRING(SINEW_VERSION_MINOR) "." SINEW_STRING(SINEW_VERSION_PATCH);
}

const char* sinew_status_text(sinew_status status) {
  switch (status) {
    case SINEW_OK:
      return "ok";
    case SINEW_ERROR_ARGUMENT:
      return "a pointer is null or an option is out of range";
    case SINEW_ERROR_WORKSPACE:
      return "the workspace is too small or not aligned to 64 bytes";
    case SINEW_ERROR_COUNT:
      return "no vertices, corners or joints, too many of them, or faces with fewer than two corners";
    case SINEW_ERROR_NOT_FINITE:
      return "a position is NaN or infinite";
    case SINEW_ERROR_INDEX:
      return "a face names a vertex, or a parent a joint, that does not exist; or a face has fewer than two corners";
    case SINEW_ERROR_HIERARCHY:
      return "the joint parents form a cycle";
    case SINEW_ERROR_NO_JOINT:
      return "every joint is excluded from binding";
    case SINEW_ERROR_CANCELLED:
      return "cancelled by the progress callback";
    case SINEW_ERROR_MODEL_MAGIC:
      return "not a sinew model file";
    case SINEW_ERROR_MODEL_VERSION:
      return "the model needs another version of this library";
    case SINEW_ERROR_MODEL_TRUNCATED:
      return "the model file is shorter or longer than its header says";
    case SINEW_ERROR_MODEL_CHECKSUM:
      return "the model file's checksum does not match its bytes";
    case SINEW_ERROR_MODEL_LAYOUT:
      return "the model file contradicts itself";
    case SINEW_ERROR_MODEL_OVERFLOW:
      return "the model file has an accumulator that could overflow";
    case SINEW_ERROR_MODEL_ALIGNMENT:
      return "the model bytes must start at an address divisible by 8";
    case SINEW_ERROR_RANGE:
      return "a joint index or weight is out of range";
    case SINEW_ERROR_MODEL_TASK:
      return "the model is for another task than this call";
    case SINEW_ERROR_NOT_BUILT:
      return "this library was built without the requested feature";
    case SINEW_ERROR_CHAIN:
      return "joints of a spring chain are not a chain of children, or two chains rotate the same joint";
    case SINEW_ERROR_KERNEL:
      return "this library or processor lacks the requested kernels";
    case SINEW_ERROR_VERSION:
      return "an option is set that this library does not know; the caller is newer than the library";
  }
  return "unknown status";
}

const char* sinew_kernel_name(uint32_t kernel) { return sinew::kernel_name(kernel); }

uint32_t sinew_kernel_select(uint32_t kernel) {
  sinew::Kernels kernels;
  return sinew::select_kernels(kernel, &kernels) ? kernels.id : 0;
}

}  // extern "C"
