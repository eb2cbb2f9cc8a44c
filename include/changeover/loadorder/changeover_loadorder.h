/* Load orders for C, and for languages that call C.
 *
 *     char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
 *     changeover_loadorder* order = changeover_loadorder_open(64, 16, error, sizeof error);
 *     if (order == NULL) { fprintf(stderr, "%s\n", error); return 1; }
 *     changeover_loadorder_step step;
 *     int status;
 *     while ((status = changeover_loadorder_next(order, &step)) == CHANGEOVER_LOADORDER_STEP) {
 *       for (size_t i = 0; i < step.evict_count; ++i) drop(step.evict[i]);
 *       for (size_t i = 0; i < step.load_count; ++i) fetch(step.load[i]);
 *       compute_what_is_new(step.number);
 *     }
 *     if (status == CHANGEOVER_LOADORDER_ERROR) {
 *       fprintf(stderr, "%s\n", changeover_loadorder_error(order));
 *     }
 *     changeover_loadorder_close(order);
 *
 * After the last step every pair of items has been in memory together, with at most `room` items at
 * a time. The order is the best known one, and verified: see loadorder/load_order.hpp. Only one
 * thread at a time may use an order; different orders are independent. No function throws. A
 * function that can return an error does so for a NULL order; the others treat NULL as an order
 * without loads and steps.
 *
 * Options select several workers, some pairs only, a limit for a search, and a way to cancel:
 *
 *     changeover_loadorder_options options = {.size = sizeof options};
 *     options.workers = 4;
 *     options.with_pairs = 1;
 *     order = changeover_loadorder_open_with(64, 16, &options, error, sizeof error);
 *     if (order == NULL) { fprintf(stderr, "%s\n", error); return 1; }
 *     changeover_loadorder_take_worker(order, 2);       // the steps to come are those of worker 2
 *     while (changeover_loadorder_next(order, &step) == CHANGEOVER_LOADORDER_STEP) {
 *       size_t count = 0;
 *       const uint32_t* pairs = changeover_loadorder_pairs(order, &count);
 *       for (size_t i = 0; i < count; ++i) compute(pairs[2 * i], pairs[2 * i + 1]);
 *     }
 */
#ifndef CHANGEOVER_LOADORDER_H
#define CHANGEOVER_LOADORDER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this header: major * 10000 + minor * 100 + patch. */
#define CHANGEOVER_LOADORDER_VERSION 10000

/* The version of the library that runs, as "1.0.0". It may be newer than the header. */
const char* changeover_loadorder_version(void);

/* Large enough for any error text. */
#define CHANGEOVER_LOADORDER_ERROR_SIZE 512

typedef struct changeover_loadorder changeover_loadorder;

/* One step: evict first, then load. The arrays are valid until the next call with the order. */
typedef struct changeover_loadorder_step {
  uint64_t number; /* from 1 */
  const uint32_t* evict;
  size_t evict_count;
  const uint32_t* load;
  size_t load_count;
} changeover_loadorder_step;

enum {
  CHANGEOVER_LOADORDER_END = 0,   /* no further step */
  CHANGEOVER_LOADORDER_STEP = 1,  /* *step is the next one */
  CHANGEOVER_LOADORDER_ERROR = -1 /* see changeover_loadorder_error() */
};

/* Opens an order of `items` items with memory for `room` items, before its first step. Returns NULL
 * on error, with one line in `error` that says why (cut to error_size bytes; error may be NULL). */
changeover_loadorder* changeover_loadorder_open(uint64_t items, uint64_t room, char* error,
                                                size_t error_size);

/* Options; a member that is 0 has no effect. Set `size` to sizeof: programs that were compiled with
 * an older header then still work. An error are a `size` that ends before `pairs`, and an option of
 * a newer header that this library does not know. */
typedef struct changeover_loadorder_options {
  size_t size; /* sizeof (changeover_loadorder_options) */
  /* The number of workers. Each has its own room; they may run at the same time or one after
   * another. */
  uint64_t workers;
  /* Only these pairs meet: two items per pair. They are copied before the call returns. A pair of
   * an item with itself asks for nothing: it is left out, and so is an item without other pairs. */
  const uint32_t* pairs;
  size_t pair_count;
  /* Only pairs of each of the `items` items with each of this many others, numbered after them. */
  uint64_t against;
  /* All pairs except those of the first so many items. */
  uint64_t done_items;
  /* Report what each step computes: changeover_loadorder_pairs(). */
  int with_pairs;
  /* The first worker that has a pair computes it; by default, pairs are spread evenly. */
  int first_holder;
  /* Open without verifying the steps first; verify them yourself then. */
  int unread;
  double seconds; /* of search for an order with fewer loads */
  uint64_t seed;  /* of that search */
  /* The cost of a pair, 0 or more: costs are spread evenly instead of numbers of pairs. */
  double (*pair_cost)(uint32_t item, uint32_t other, void* data);
  /* Called now and then; a value other than 0 cancels with an error. */
  int (*cancelled)(void* data);
  void* data; /* for the functions */
  /* Only the pairs within these groups meet: the items of all groups, one group after another, and
   * the number of items of each group. Copied before the call returns; instead of pairs. */
  const uint32_t* group_items;
  const size_t* group_sizes;
  size_t group_count;
  /* The workers step together and never hold one item twice, so that items may change. In each
   * step all workers evict, wait for each other, load, and compute. Not with first_holder,
   * pair_cost or unread. Workers that open an order each need the same one: give no `seconds`
   * then, as a timed search may end with another order each time. */
  int disjoint;
} changeover_loadorder_options;

/* The same with options, or NULL for none. An order for several workers starts with worker 0. */
changeover_loadorder* changeover_loadorder_open_with(uint64_t items, uint64_t room,
                                                     const changeover_loadorder_options* options,
                                                     char* error, size_t error_size);

/* Continues with the first step of this worker, from 0: CHANGEOVER_LOADORDER_END, or _ERROR. */
int changeover_loadorder_take_worker(changeover_loadorder* order, uint64_t worker);

/* Makes step `number` (from 1) of one worker's order the next step; it loads everything that is in
 * memory then. Not available with pairs or several workers. Returns CHANGEOVER_LOADORDER_END, or
 * _ERROR. */
int changeover_loadorder_seek(changeover_loadorder* order, uint64_t number);

/* The pairs that the last step computes, if with_pairs was set: *count pairs of two items each, the
 * smaller first. NULL and 0 before the first step and without with_pairs. Valid until the next call
 * with the same order. */
const uint32_t* changeover_loadorder_pairs(const changeover_loadorder* order, size_t* count);

/* Writes the next step into *step. */
int changeover_loadorder_next(changeover_loadorder* order, changeover_loadorder_step* step);

/* Returns to the first step: CHANGEOVER_LOADORDER_END, or _ERROR. */
int changeover_loadorder_rewind(changeover_loadorder* order);

/* The total loads of the order, its steps, which are those of all workers (disjoint ones have the
 * same number each), and the proven minimum of loads of any order. */
uint64_t changeover_loadorder_loads(const changeover_loadorder* order);
uint64_t changeover_loadorder_steps(const changeover_loadorder* order);
uint64_t changeover_loadorder_lower_bound(const changeover_loadorder* order);

/* The number of workers, the loads and pairs of one of them (0 if unknown), and the proven minimum
 * of loads of the busiest worker. */
uint64_t changeover_loadorder_workers(const changeover_loadorder* order);
uint64_t changeover_loadorder_worker_loads(const changeover_loadorder* order, uint64_t worker);
uint64_t changeover_loadorder_worker_pairs(const changeover_loadorder* order, uint64_t worker);
uint64_t changeover_loadorder_makespan_bound(const changeover_loadorder* order);

/* The last error of this order in one line, "" if there was none; valid until the next call with
 * the order. */
const char* changeover_loadorder_error(const changeover_loadorder* order);

/* Frees the order; NULL is allowed. */
void changeover_loadorder_close(changeover_loadorder* order);

#ifdef __cplusplus
}
#endif

#endif
