/* The example of changeover_loadorder.h, as it stands there. */
#include "changeover/loadorder/changeover_loadorder.h"

static size_t in_memory;
static uint64_t steps_done;

static void drop(uint32_t item) {
  (void)item;
  --in_memory;
}

static void fetch(uint32_t item) {
  (void)item;
  ++in_memory;
}

static void compute_what_is_new(uint64_t number) {
  if (in_memory <= 16) {
    steps_done = number;
  }
}

uint64_t steps_of_c_example(void);

/* The number of the last step with at most 16 items in memory. */
uint64_t steps_of_c_example(void) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  changeover_loadorder* order = changeover_loadorder_open(64, 16, error, sizeof error);
  changeover_loadorder_step step;
  while (changeover_loadorder_next(order, &step) == CHANGEOVER_LOADORDER_STEP) {
    for (size_t i = 0; i < step.evict_count; ++i) drop(step.evict[i]);
    for (size_t i = 0; i < step.load_count; ++i) fetch(step.load[i]);
    compute_what_is_new(step.number);
  }
  changeover_loadorder_close(order);
  return steps_done;
}
