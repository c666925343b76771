/* SPDX-License-Identifier: MIT
 * What main.c asks of the board it runs on. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

void board_print(const char* text);
/* Instructions executed so far; 0 where nobody counts. */
uint64_t board_instructions(void);

#endif
