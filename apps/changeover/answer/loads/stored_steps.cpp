#include "answer/loads/stored_steps.hpp"

#include <fmt/format.h>

#include <utility>

#include "answer/answer.hpp"
#include "changeover/core/error.hpp"

namespace changeover::cli {

StoredSteps::StoredSteps(bool asked, const LoadOrderFacts& facts, Reader reader)
    : asked_(asked), facts_(facts), reader_(std::move(reader)) {
  if (!asked) {
    return;
  }
  StoreCheck check(facts.items);
  each([&](const StoredStep& step) {
    check.read({&step, 1});
    count_ += step.store.size();
  });
  if (const std::string fault = check.finish(); !fault.empty()) {
    throw InternalError("what is stored is wrong: " + fault);
  }
}

void StoredSteps::each(const std::function<void(const StoredStep&)>& take) const {
  WriteBack back(facts_.items);
  StoredStep stored;
  reader_([&](const WorkStep& step) {
    stored.work = step;
    if (asked_) {
      back.read(stored);
    }
    take(stored);
  });
  if (asked_) {
    back.finish(stored);
    take(stored);
  }
}

void StoredSteps::add_to(JsonWriter& json, bool alone) const {
  if (asked_) {
    json.key("stores").value(count_).key("store_bound").value(bound(alone).loads);
  }
}

std::string StoredSteps::text(bool alone) const {
  return asked_ ? fmt::format("{}, at least {}: {}\n", count_of(count_, "store"),
                              bound(alone).loads, bound(alone).reason)
                : "";
}

LoadBound StoredSteps::bound(bool alone) const {
  return store_lower_bound(facts_.bound, facts_.wanted, facts_.items, alone);
}

}  // namespace changeover::cli
