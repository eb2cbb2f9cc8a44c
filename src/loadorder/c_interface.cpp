#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "changeover/loadorder/changeover_loadorder.h"
#include "changeover/loadorder/load_order.hpp"

struct changeover_loadorder {
  explicit changeover_loadorder(changeover::LoadOrder given) : order(std::move(given)) {}

  changeover::LoadOrder order;
  changeover::Step step;
  std::string error;
};

namespace {

// Cut to the size given, always ended.
void say(char* error, std::size_t size, const char* text) {
  if (error != nullptr && size > 0) {
    const std::size_t length = std::min(std::strlen(text), size - 1);
    std::memcpy(error, text, length);
    error[length] = '\0';
  }
}

int fail(changeover_loadorder* order, const char* text) noexcept {
  try {
    order->error = text;
  } catch (...) {
    order->error.clear();  // the return value still says that something is wrong
  }
  return CHANGEOVER_LOADORDER_ERROR;
}

// What `act` returns; whatever it throws ends here, in a line that is given to `tell`.
template <typename Act, typename Tell>
auto without_throwing(const Act& act, const Tell& tell) noexcept -> decltype(act()) {
  try {
    return act();
  } catch (const std::bad_alloc&) {
    return tell("not enough memory for these parameters");
  } catch (const std::length_error&) {
    return tell("not enough memory for these parameters");
  } catch (const std::exception& fault) {
    return tell(fault.what());
  } catch (...) {
    return tell("something unknown went wrong");
  }
}

}  // namespace

changeover_loadorder* changeover_loadorder_open(uint64_t items, uint64_t room, char* error,
                                                size_t error_size) {
  say(error, error_size, "");
  return without_throwing(
      [&] { return new changeover_loadorder(changeover::plan_load_order(items, room)); },
      [&](const char* text) -> changeover_loadorder* {
        say(error, error_size, text);
        return nullptr;
      });
}

int changeover_loadorder_next(changeover_loadorder* order, changeover_loadorder_step* step) {
  if (order == nullptr || step == nullptr) {
    return order == nullptr ? CHANGEOVER_LOADORDER_ERROR : fail(order, "step is NULL");
  }
  return without_throwing(
      [&]() -> int {
        if (!order->order.next(order->step)) {
          return CHANGEOVER_LOADORDER_END;
        }
        const changeover::Step& next = order->step;
        *step = {next.number, next.evict.data(), next.evict.size(), next.load.data(),
                 next.load.size()};
        return CHANGEOVER_LOADORDER_STEP;
      },
      [&](const char* text) { return fail(order, text); });
}

int changeover_loadorder_rewind(changeover_loadorder* order) {
  if (order == nullptr) {
    return CHANGEOVER_LOADORDER_ERROR;
  }
  return without_throwing(
      [&]() -> int {
        order->order.rewind();
        return CHANGEOVER_LOADORDER_END;
      },
      [&](const char* text) { return fail(order, text); });
}

uint64_t changeover_loadorder_loads(const changeover_loadorder* order) {
  return order == nullptr ? 0 : order->order.facts().loads;
}

uint64_t changeover_loadorder_steps(const changeover_loadorder* order) {
  return order == nullptr ? 0 : order->order.facts().steps;
}

uint64_t changeover_loadorder_lower_bound(const changeover_loadorder* order) {
  return order == nullptr ? 0 : order->order.facts().bound.loads;
}

const char* changeover_loadorder_error(const changeover_loadorder* order) {
  return order == nullptr ? "there is no order" : order->error.c_str();
}

void changeover_loadorder_close(changeover_loadorder* order) { delete order; }
