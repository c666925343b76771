/* SPDX-License-Identifier: MIT
 * Starts a test program on a Cortex-M under qemu-system-arm: vectors, floating point unit, C library, the command line
 * from semihosting. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

extern char bss_start[], bss_end[], stack_top[];
int main(int argc, char** argv);
void initialise_monitor_handles(void);
void __libc_init_array(void);
void reset(void);

/* What newlib and libstdc++ ask of the start files; there is nothing behind them. */
void* __dso_handle;
void _init(void) {}
void _fini(void) {}
/* GoogleTest's, for reports that nobody asks for here. */
int mkdir(const char* path, unsigned mode) {
  (void)path, (void)mode;
  return -1;
}

static int semihosting(int operation, void* block) {
  register int r0 __asm__("r0") = operation;
  register void* r1 __asm__("r1") = block;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

/* A fault would hang in the emulator; this ends the run with a message. */
static void fault(void) {
  static char text[] = "the processor faulted\n";
  uint32_t exit_code[2] = {0x20026, 1}; /* ADP_Stopped_ApplicationExit */
  semihosting(0x04, text);
  semihosting(0x20, exit_code);
  for (;;) {
  }
}

__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {(void (*)(void))stack_top,
                                                                                     reset,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault,
                                                                                     fault};

void reset(void) {
#if defined(__ARM_FP) || defined(__ARM_FEATURE_MVE)
  *(volatile uint32_t*)0xE000ED88u |= 0xFu << 20; /* CPACR: coprocessors 10 and 11 */
  __asm__ volatile("dsb\n\tisb");
#endif
  memset(bss_start, 0, (size_t)(bss_end - bss_start));
  initialise_monitor_handles();
  __libc_init_array();

  static char line[1024];
  static char* argv[32];
  struct {
    char* text;
    uint32_t size;
  } block = {line, sizeof line};
  int argc = 0;
  if (semihosting(0x15, &block) == 0) { /* SYS_GET_CMDLINE */
    for (char* word = strtok(line, " "); word != NULL && argc < 31; word = strtok(NULL, " ")) argv[argc++] = word;
  }
  exit(main(argc, argv));
}
