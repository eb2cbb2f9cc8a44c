/* The example of changeover_loadorder.h, as it stands there. */
#include "changeover/loadorder/changeover_loadorder.h"

#include <stdio.h>

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

static uint64_t pairs_done;

static void compute(uint32_t item, uint32_t other) { pairs_done += item < other ? 1 : 0; }

uint64_t steps_of_c_example(void);
uint64_t pairs_of_c_example(uint64_t* said);

/* The number of the last step with at most 16 items in memory. */
uint64_t steps_of_c_example(void) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  changeover_loadorder* order = changeover_loadorder_open(64, 16, error, sizeof error);
  if (order == NULL) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  changeover_loadorder_step step;
  int status;
  while ((status = changeover_loadorder_next(order, &step)) == CHANGEOVER_LOADORDER_STEP) {
    for (size_t i = 0; i < step.evict_count; ++i) drop(step.evict[i]);
    for (size_t i = 0; i < step.load_count; ++i) fetch(step.load[i]);
    compute_what_is_new(step.number);
  }
  if (status == CHANGEOVER_LOADORDER_ERROR) {
    fprintf(stderr, "%s\n", changeover_loadorder_error(order));
  }
  changeover_loadorder_close(order);
  return steps_done;
}

/* The pairs that worker 2 of four computes; *said: what is said of them. */
uint64_t pairs_of_c_example(uint64_t* said) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  changeover_loadorder* order;
  changeover_loadorder_step step;
  changeover_loadorder_options options = {.size = sizeof options};
  options.workers = 4;
  options.with_pairs = 1;
  order = changeover_loadorder_open_with(64, 16, &options, error, sizeof error);
  if (order == NULL) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  changeover_loadorder_take_worker(order, 2); /* the steps to come are those of worker 2 */
  while (changeover_loadorder_next(order, &step) == CHANGEOVER_LOADORDER_STEP) {
    size_t count = 0;
    const uint32_t* pairs = changeover_loadorder_pairs(order, &count);
    for (size_t i = 0; i < count; ++i) compute(pairs[2 * i], pairs[2 * i + 1]);
  }
  *said = changeover_loadorder_worker_pairs(order, 2);
  changeover_loadorder_close(order);
  return pairs_done;
}
