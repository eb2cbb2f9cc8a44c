/* Goes through a load order in C, of all pairs of 64 items with memory for 16, and says what to do.
 *
 *     cc load_order.c $(pkg-config --cflags --libs changeover_loadorder)
 */
#include <changeover/loadorder/changeover_loadorder.h>
#include <stdio.h>

int main(void) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  changeover_loadorder* order = changeover_loadorder_open(64, 16, error, sizeof error);
  if (order == NULL) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  changeover_loadorder_step step;
  int status;
  while ((status = changeover_loadorder_next(order, &step)) == CHANGEOVER_LOADORDER_STEP) {
    for (size_t i = 0; i < step.evict_count; ++i) {
      printf("drop %u\n", (unsigned)step.evict[i]);
    }
    for (size_t i = 0; i < step.load_count; ++i) {
      printf("read %u\n", (unsigned)step.load[i]);
    }
  }
  if (status == CHANGEOVER_LOADORDER_ERROR) {
    fprintf(stderr, "%s\n", changeover_loadorder_error(order));
  }
  changeover_loadorder_close(order);
  return status == CHANGEOVER_LOADORDER_END ? 0 : 1;
}
