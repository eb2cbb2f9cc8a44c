#include "serve/api/known_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "answer/known/known_table.hpp"
#include "changeover/run/control.hpp"

namespace changeover::serve {

KnownTables::Place KnownTables::find(const std::string& key) {
  return std::ranges::find(entries_, key, &Entry::key);
}

std::shared_ptr<const cli::KnownTable> KnownTables::of(const cli::TableRange& range,
                                                       const std::string& generation) {
  constexpr std::size_t most_tables = 12;
  constexpr auto between_looks = std::chrono::milliseconds(50);
  const std::string key = fmt::format(
      "{} {} {} {} {} {} {}", range.k.from, range.k.to, range.v.from, range.v.to, range.change,
      range.kind ? to_string(*range.kind) : std::string_view(), generation);
  {
    std::unique_lock lock(mutex_);
    for (;;) {
      const Place place = find(key);
      if (place == entries_.end()) {
        break;
      }
      if (place->table) {
        entries_.splice(entries_.begin(), entries_, place);
        return entries_.front().table;
      }
      changed_.wait_for(lock, between_looks);
      stop_if_asked();
    }
    entries_.push_front({key, nullptr});
  }
  std::shared_ptr<const cli::KnownTable> table;
  try {
    table = std::make_shared<const cli::KnownTable>(cli::known_table(range));
  } catch (...) {
    // A request that waits makes it anew: the limits were those of this request.
    const std::lock_guard lock(mutex_);
    entries_.erase(find(key));
    changed_.notify_all();
    throw;
  }
  const std::lock_guard lock(mutex_);
  find(key)->table = table;
  auto last = entries_.end();
  while (entries_.size() > most_tables && last != entries_.begin()) {
    --last;
    if (last->table && last->table != table) {
      last = entries_.erase(last);
    }
  }
  changed_.notify_all();
  return table;
}

}  // namespace changeover::serve
