/* A program in C outside the project: goes through an order and prints its loads, after it has seen every pair of items
 * together and never more of them than there is room. */
#include <changeover/loadorder/changeover_loadorder.h>
#include <stdio.h>
#include <string.h>

enum { ITEMS = 50, ROOM = 9 };

int main(void) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  static char there[ITEMS], met[ITEMS][ITEMS];
  changeover_loadorder_step step;
  unsigned long loads = 0, inside = 0, pairs = 0;
  int status = 0;
  changeover_loadorder* order = changeover_loadorder_open(1, 0, error, sizeof error);
  if (order != NULL || strlen(error) == 0) {
    fputs("an impossible order was not refused\n", stderr);
    return 1;
  }
  order = changeover_loadorder_open(ITEMS, ROOM, error, sizeof error);
  if (order == NULL) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  while ((status = changeover_loadorder_next(order, &step)) == CHANGEOVER_LOADORDER_STEP) {
    for (size_t i = 0; i < step.evict_count; ++i) {
      there[step.evict[i]] = 0;
      --inside;
    }
    for (size_t i = 0; i < step.load_count; ++i) {
      there[step.load[i]] = 1;
      ++inside;
      ++loads;
    }
    for (size_t i = 0; i < step.load_count; ++i) {
      for (size_t other = 0; other < ITEMS; ++other) {
        const size_t x = step.load[i];
        if (there[other] && other != x && !met[x][other]) {
          met[x][other] = met[other][x] = 1;
          ++pairs;
        }
      }
    }
    if (inside > ROOM) {
      fputs("too many items in memory\n", stderr);
      return 1;
    }
  }
  if (status != CHANGEOVER_LOADORDER_END || pairs != ITEMS * (ITEMS - 1) / 2 ||
      loads != changeover_loadorder_loads(order)) {
    fprintf(stderr, "status %d, %lu pairs, %lu loads\n", status, pairs, loads);
    return 1;
  }
  printf("%lu\n", loads);
  changeover_loadorder_close(order);
  return 0;
}
