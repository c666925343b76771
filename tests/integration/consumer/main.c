/* SPDX-License-Identifier: MIT
 * The smallest user of an installed sinew: asks for a workspace size, opens the installed models if there are, and prints the version. */
#include <sinew/sinew.h>
#include <stdio.h>

#if defined(SINEW_DEFAULT_MODEL) && defined(SINEW_RIG_MODEL) && defined(SINEW_HANDS_MODEL)
static double model_bytes[1 << 17]; /* aligned as sinew_model_open() wants it */

static int open_model(const char* path, sinew_status (*open)(const void*, size_t, sinew_model*)) {
  sinew_model model;
  FILE* file = fopen(path, "rb");
  size_t size;
  if (file == NULL) return 0;
  size = fread(model_bytes, 1, sizeof model_bytes, file);
  fclose(file);
  if (open(model_bytes, size, &model) != SINEW_OK) return 0;
  printf("opened %s\n", path);
  return 1;
}
static int open_models(void) {
  return open_model(SINEW_DEFAULT_MODEL, sinew_model_open) && open_model(SINEW_RIG_MODEL, sinew_rig_model_open) &&
         open_model(SINEW_HANDS_MODEL, sinew_rig_model_open);
}
#else
static int open_models(void) { return 1; }
#endif

int main(void) {
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  size_t bytes = 0;
  options.method = SINEW_METHOD_HEAT;
  if (sinew_bind_workspace_size(NULL, 8, 12, 36, 2, &options, &bytes) != SINEW_OK || bytes == 0) return 1;
  if (!open_models()) return 1;
  printf("sinew %s: %lu bytes of workspace\n", sinew_version(), (unsigned long)bytes);
  return 0;
}
