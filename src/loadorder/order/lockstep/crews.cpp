#include "loadorder/order/lockstep/crews.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/checked.hpp"

namespace changeover {

std::vector<Crew> crews(std::uint64_t items, std::uint64_t room, std::uint64_t workers) {
  if (items / workers >= room) {
    return {{workers, room}};
  }
  const std::uint64_t full = items / room;
  std::vector<std::uint64_t> busy{full, ceil_div(items, room), items / 2, workers};
  while (busy.back() > std::max<std::uint64_t>(1, full)) {
    busy.push_back(busy.back() / 2);
  }
  std::erase_if(busy, [&](const std::uint64_t some) {
    return some > workers || some == 0 || (some > items / 2 && some > 1);
  });
  std::ranges::sort(busy, std::greater());
  busy.erase(std::unique(busy.begin(), busy.end()), busy.end());
  std::vector<Crew> all;
  all.reserve(busy.size());
  for (const std::uint64_t some : busy) {
    all.push_back({some, some == 1 ? room : std::min(room, items / some)});
  }
  return all;
}

std::string say_idle(std::uint64_t busy, std::uint64_t workers) {
  return busy == workers ? ""
                         : fmt::format("{} of {} workers {} nothing to do. ", workers - busy,
                                       workers, workers - busy == 1 ? "has" : "have");
}

}  // namespace changeover
