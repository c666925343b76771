/* SPDX-License-Identifier: MIT
 * The smallest user of an installed sinew: asks for a workspace size, opens the installed model if there is one, and prints the version. */
#include <sinew/sinew.h>
#include <stdio.h>

#ifdef SINEW_DEFAULT_MODEL
static double model_bytes[1 << 17]; /* aligned as sinew_model_open() wants it */

static int open_model(void) {
  sinew_model model;
  FILE* file = fopen(SINEW_DEFAULT_MODEL, "rb");
  size_t size;
  if (file == NULL) return 0;
  size = fread(model_bytes, 1, sizeof model_bytes, file);
  fclose(file);
  if (sinew_model_open(model_bytes, size, &model) != SINEW_OK) return 0;
  printf("opened %s\n", SINEW_DEFAULT_MODEL);
  return 1;
}
#else
static int open_model(void) { return 1; }
#endif

int main(void) {
  sinew_options options = sinew_options_init();
  size_t bytes = 0;
  options.method = SINEW_METHOD_HEAT;
  if (sinew_bind_workspace_size(NULL, 8, 12, 36, 2, &options, &bytes) != SINEW_OK || bytes == 0) return 1;
  if (!open_model()) return 1;
  printf("sinew %s: %lu bytes of workspace\n", sinew_version(), (unsigned long)bytes);
  return 0;
}
