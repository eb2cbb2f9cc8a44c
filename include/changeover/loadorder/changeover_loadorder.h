/* Load orders for programs in C, and in whatever calls C.
 *
 *     char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
 *     changeover_loadorder* order = changeover_loadorder_open(64, 16, error, sizeof error);
 *     changeover_loadorder_step step;
 *     while (changeover_loadorder_next(order, &step) == CHANGEOVER_LOADORDER_STEP) {
 *       for (size_t i = 0; i < step.evict_count; ++i) drop(step.evict[i]);
 *       for (size_t i = 0; i < step.load_count; ++i) fetch(step.load[i]);
 *       compute_what_is_new(step.number);
 *     }
 *     changeover_loadorder_close(order);
 *
 * After the last step every pair of items has been in memory together, and never were more than
 * `room` there. The order is the best that is known, and verified: see loadorder/load_order.hpp. An
 * order is used by one thread at a time; different orders have nothing to do with each other.
 * Nothing is thrown. NULL for an order is an error where one can be returned, and otherwise an
 * order of no loads and no steps.
 *
 * Several workers, some pairs only, a time for a search, and a way to give up are options:
 *
 *     changeover_loadorder_options options = {.size = sizeof options};
 *     options.workers = 4;
 *     options.with_pairs = 1;
 *     order = changeover_loadorder_open_with(64, 16, &options, error, sizeof error);
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

/* Enough for any error text. */
#define CHANGEOVER_LOADORDER_ERROR_SIZE 512

typedef struct changeover_loadorder changeover_loadorder;

/* One step: evict first, then load. The arrays live until the next call with the same order. */
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

/* An order of `items` items with room for `room`, at its first step; NULL if there is none, with
 * one line in `error` that says why (cut to error_size bytes; error may be NULL). */
changeover_loadorder* changeover_loadorder_open(uint64_t items, uint64_t room, char* error,
                                                size_t error_size);

/* What else can be asked. All that is 0 is not asked for; set `size`, so that programs that were
 * compiled with an older header go on to work. */
typedef struct changeover_loadorder_options {
  size_t size; /* sizeof (changeover_loadorder_options) */
  /* Each has room of its own; they may run at the same time or one after another. */
  uint64_t workers;
  /* Only these, two items a pair. They are read before the call returns. */
  const uint32_t* pairs;
  size_t pair_count;
  /* Only pairs of each of the items with each of so many others, numbered after them. */
  uint64_t against;
  /* All pairs but those of the first so many items. */
  uint64_t done_items;
  /* Say what each step computes: changeover_loadorder_pairs(). */
  int with_pairs;
  /* The first worker that has a pair computes it; otherwise pairs are spread evenly. */
  int first_holder;
  /* Begin without reading the steps first: then read them with a check of your own. */
  int unread;
  double seconds; /* of search for an order with fewer loads */
  uint64_t seed;  /* of that search */
  /* 0 or more: costs are spread instead of numbers of pairs. */
  double (*pair_cost)(uint32_t item, uint32_t other, void* data);
  /* Asked now and then; another value than 0: give up, with an error. */
  int (*cancelled)(void* data);
  void* data; /* for the functions */
} changeover_loadorder_options;

/* The same with options, NULL: none. Of several workers it begins with worker 0. */
changeover_loadorder* changeover_loadorder_open_with(uint64_t items, uint64_t room,
                                                     const changeover_loadorder_options* options,
                                                     char* error, size_t error_size);

/* The next step is the first of this worker, from 0: CHANGEOVER_LOADORDER_END, or _ERROR. */
int changeover_loadorder_take_worker(changeover_loadorder* order, uint64_t worker);

/* The next step is step `number` of one worker's order, from 1; it loads all that is in memory
 * then. Not with pairs, nor of several workers. CHANGEOVER_LOADORDER_END, or _ERROR. */
int changeover_loadorder_seek(changeover_loadorder* order, uint64_t number);

/* What the last step computes, if that was asked for: *count pairs, two items each, the smaller
 * first. They live until the next call with the same order. */
const uint32_t* changeover_loadorder_pairs(const changeover_loadorder* order, size_t* count);

/* Writes the next step into *step. */
int changeover_loadorder_next(changeover_loadorder* order, changeover_loadorder_step* step);

/* Back to the first step: CHANGEOVER_LOADORDER_END, or _ERROR. */
int changeover_loadorder_rewind(changeover_loadorder* order);

/* All loads of the order, its steps, and the number of loads that no order can go below. */
uint64_t changeover_loadorder_loads(const changeover_loadorder* order);
uint64_t changeover_loadorder_steps(const changeover_loadorder* order);
uint64_t changeover_loadorder_lower_bound(const changeover_loadorder* order);

/* How many workers there are, what one of them loads and computes (0 if that is not known), and the
 * loads that some worker has at least. */
uint64_t changeover_loadorder_workers(const changeover_loadorder* order);
uint64_t changeover_loadorder_worker_loads(const changeover_loadorder* order, uint64_t worker);
uint64_t changeover_loadorder_worker_pairs(const changeover_loadorder* order, uint64_t worker);
uint64_t changeover_loadorder_makespan_bound(const changeover_loadorder* order);

/* The last error of this order in one line, "" if there was none; lives as long as the order. */
const char* changeover_loadorder_error(const changeover_loadorder* order);

/* Frees the order; NULL is allowed. */
void changeover_loadorder_close(changeover_loadorder* order);

#ifdef __cplusplus
}
#endif

#endif
