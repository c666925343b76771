/* SPDX-License-Identifier: MIT
 * The smallest user of an installed sinew: asks for a workspace size and prints the version. */
#include <sinew/sinew.h>
#include <stdio.h>

int main(void) {
  sinew_options options = sinew_options_init();
  size_t bytes = 0;
  options.method = SINEW_METHOD_HEAT;
  if (sinew_bind_workspace_size(NULL, 8, 12, 36, 2, &options, &bytes) != SINEW_OK || bytes == 0) return 1;
  printf("sinew %s: %lu bytes of workspace\n", sinew_version(), (unsigned long)bytes);
  return 0;
}
