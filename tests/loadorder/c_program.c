/* The C header, read by a C compiler: runs an order and counts what met. */
#include "changeover/loadorder/changeover_loadorder.h"

#include <stdlib.h>
#include <string.h>

/* Returns the number of pairs that met, or a negative number that says what went wrong. */
long count_pairs_in_c(uint64_t items, uint64_t room, uint64_t* loads_seen) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  changeover_loadorder* order = changeover_loadorder_open(items, room, error, sizeof error);
  changeover_loadorder_step step;
  char* there = NULL;
  char* met = NULL;
  long pairs = 0;
  uint64_t in_memory = 0;
  int status = 0;
  if (order == NULL) {
    return -1;
  }
  there = calloc(items, 1);
  met = calloc(items * items, 1);
  *loads_seen = 0;
  while (there != NULL && met != NULL &&
         (status = changeover_loadorder_next(order, &step)) == CHANGEOVER_LOADORDER_STEP) {
    for (size_t i = 0; i < step.evict_count; ++i) {
      there[step.evict[i]] = 0;
      --in_memory;
    }
    for (size_t i = 0; i < step.load_count; ++i) {
      const uint32_t x = step.load[i];
      for (uint64_t y = 0; y < items; ++y) {
        if (there[y] && !met[x * items + y]) {
          met[x * items + y] = met[y * items + x] = 1;
          ++pairs;
        }
      }
      there[x] = 1;
      ++in_memory;
      ++*loads_seen;
    }
    if (in_memory > room) {
      pairs = -2;
      break;
    }
  }
  if (status == CHANGEOVER_LOADORDER_ERROR || *loads_seen != changeover_loadorder_loads(order) ||
      strcmp(changeover_loadorder_error(order), "") != 0 ||
      changeover_loadorder_lower_bound(order) > *loads_seen) {
    pairs = -3;
  }
  free(there);
  free(met);
  changeover_loadorder_close(order);
  return pairs;
}

/* What open() says of parameters that are wrong. */
int error_in_c(uint64_t items, uint64_t room, char* error, size_t size) {
  changeover_loadorder* order = changeover_loadorder_open(items, room, error, size);
  changeover_loadorder_close(order);
  return order == NULL;
}
