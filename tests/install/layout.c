/* Prints what a compiled program knows of the header: sizes, places and numbers. On 64-bit machines. */
#include <changeover/loadorder/changeover_loadorder.h>
#include <stdio.h>

#define PLACE(member) printf(#member " %zu\n", offsetof(changeover_loadorder_step, member))
#define OPTION(member) \
  printf("option " #member " %zu\n", offsetof(changeover_loadorder_options, member))
#define NUMBER(name) printf(#name " %d\n", (int)(name))

int main(void) {
  printf("changeover_loadorder_step %zu\n", sizeof(changeover_loadorder_step));
  PLACE(number);
  PLACE(evict);
  PLACE(evict_count);
  PLACE(load);
  PLACE(load_count);
  OPTION(size);
  OPTION(workers);
  OPTION(pairs);
  OPTION(pair_count);
  OPTION(against);
  OPTION(done_items);
  OPTION(with_pairs);
  OPTION(first_holder);
  OPTION(unread);
  OPTION(seconds);
  OPTION(seed);
  OPTION(pair_cost);
  OPTION(cancelled);
  OPTION(data);
  OPTION(group_items);
  OPTION(group_sizes);
  OPTION(group_count);
  OPTION(disjoint);
  NUMBER(CHANGEOVER_LOADORDER_ERROR_SIZE);
  NUMBER(CHANGEOVER_LOADORDER_END);
  NUMBER(CHANGEOVER_LOADORDER_STEP);
  NUMBER(CHANGEOVER_LOADORDER_ERROR);
  return 0;
}
