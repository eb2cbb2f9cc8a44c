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
 * After the last step every pair of items has been in memory together, and never were more than `room`
 * there. The order is the best that is known, and verified: see loadorder/load_order.hpp. An order is used
 * by one thread at a time; different orders have nothing to do with each other. Nothing is thrown. NULL for an order is an error where one can
 * be returned, and otherwise an order of no loads and no steps.
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

/* An order of `items` items with room for `room`, at its first step; NULL if there is none, with one line
 * in `error` that says why (cut to error_size bytes; error may be NULL). */
changeover_loadorder* changeover_loadorder_open(uint64_t items, uint64_t room, char* error,
                                                size_t error_size);

/* Writes the next step into *step. */
int changeover_loadorder_next(changeover_loadorder* order, changeover_loadorder_step* step);

/* Back to the first step: CHANGEOVER_LOADORDER_END, or _ERROR. */
int changeover_loadorder_rewind(changeover_loadorder* order);

/* All loads of the order, its steps, and the number of loads that no order can go below. */
uint64_t changeover_loadorder_loads(const changeover_loadorder* order);
uint64_t changeover_loadorder_steps(const changeover_loadorder* order);
uint64_t changeover_loadorder_lower_bound(const changeover_loadorder* order);

/* The last error of this order in one line, "" if there was none; lives as long as the order. */
const char* changeover_loadorder_error(const changeover_loadorder* order);

/* Frees the order; NULL is allowed. */
void changeover_loadorder_close(changeover_loadorder* order);

#ifdef __cplusplus
}
#endif

#endif
