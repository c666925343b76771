/* SPDX-License-Identifier: MIT
 * Arm MPS2 board with a Cortex-M7 (AN500), or qemu-system-arm -M mps2-an500: vectors, start, semihosting, SysTick. */
#include <stddef.h>
#include <string.h>

#include "board.h"

extern char data_start[], data_end[], data_load[], bss_start[], bss_end[], stack_top[];
int main(void);
void reset(void);

static int semihosting(int operation, const void* block) {
  register int r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = block;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

void board_print(const char* text) { semihosting(0x04, text); } /* SYS_WRITE0 */

static void board_exit(int code) {
  const uint32_t block[2] = {0x20026, (uint32_t)code}; /* ADP_Stopped_ApplicationExit */
  semihosting(0x20, block);
  for (;;) {
  }
}

static void fault(void) {
  board_print("the processor faulted\n");
  board_exit(1);
}

#define SYSTICK ((volatile uint32_t*)0xE000E010u) /* control, reload, current */
static volatile uint32_t turns;                   /* of the 24-bit counter */
static void systick(void) { ++turns; }

/* SysTick counts the board's clock of 25 MHz: 40 ns a tick. With -icount shift=6 every instruction takes 64 ns. */
uint64_t board_instructions(void) {
  uint32_t before, now;
  do {
    before = turns;
    now = 0xFFFFFFu - SYSTICK[2];
  } while (before != turns);
  return (((uint64_t)before << 24) + now) * 40 / 64;
}

__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {
    (void (*)(void))stack_top, reset, fault, fault, fault, fault, fault, [15] = systick};

void reset(void) {
  *(volatile uint32_t*)0xE000ED88u |= 0xFu << 20; /* CPACR: the floating point unit */
  __asm__ volatile("dsb\n\tisb");
  memcpy(data_start, data_load, (size_t)(data_end - data_start));
  memset(bss_start, 0, (size_t)(bss_end - bss_start));
  SYSTICK[1] = 0xFFFFFFu;
  SYSTICK[2] = 0;
  SYSTICK[0] = 7; /* on, interrupt, processor's clock */
  board_exit(main());
}
