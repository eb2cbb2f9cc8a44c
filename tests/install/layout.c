/* Prints what a compiled program knows of the header: sizes, places and numbers. On 64-bit machines. */
#include <changeover/loadorder/changeover_loadorder.h>
#include <stdio.h>

#define PLACE(member) printf(#member " %zu\n", offsetof(changeover_loadorder_step, member))
#define NUMBER(name) printf(#name " %d\n", (int)(name))

int main(void) {
  printf("changeover_loadorder_step %zu\n", sizeof(changeover_loadorder_step));
  PLACE(number);
  PLACE(evict);
  PLACE(evict_count);
  PLACE(load);
  PLACE(load_count);
  NUMBER(CHANGEOVER_LOADORDER_ERROR_SIZE);
  NUMBER(CHANGEOVER_LOADORDER_END);
  NUMBER(CHANGEOVER_LOADORDER_STEP);
  NUMBER(CHANGEOVER_LOADORDER_ERROR);
  return 0;
}
