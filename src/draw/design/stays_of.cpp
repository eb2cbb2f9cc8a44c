#include "draw/design/stays_of.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "changeover/core/design.hpp"

namespace changeover {
namespace {

// In a circular design that is drawn whole, the stay that is there at its end is the one that is
// there at its beginning.
void close_circle(std::vector<DrawnStay>& stays) {
  if (stays.empty() || !stays.front().began_before || !stays.back().goes_on) {
    return;
  }
  DrawnStay stay = stays.back();
  stay.over_the_end = true;
  if (stays.size() > 1) {
    stay.to = stays.front().to;
    stay.length += stays.front().length;
    stays.pop_back();
  }
  stay.began_before = stay.goes_on = false;
  stays.front() = stay;
}

}  // namespace

DrawnStays stays_of(const Drawing& drawing) {
  DrawnStays stays;
  stays.of.resize(static_cast<std::size_t>(drawing.parameters().v));
  stays.first = drawing.options.from;
  std::vector<bool> there(stays.of.size());
  bool whole = stays.first == 1;
  Transitions steps(drawing.source);
  while (steps.next()) {
    if (drawing.beyond_range(steps.index())) {
      whole = false;
      break;
    }
    if (!drawing.in_range(steps.index())) {
      continue;
    }
    const std::uint64_t number = steps.index() + 1;
    stays.last = number;
    drawing.require_fits(number + 1 - stays.first);
    for (const Element x : steps.block()) {
      if (!there[x]) {
        stays.of[x].push_back(
            {.from = number, .to = number, .began_before = true, .goes_on = true});
        there[x] = true;
      }
      stays.of[x].back().to = number;
      ++stays.of[x].back().length;
    }
    for (const Element x : steps.introduced()) {
      stays.of[x].back().began_before = false;
    }
    for (const Element x : steps.leaving()) {
      stays.of[x].back().goes_on = false;
      there[x] = false;
    }
  }
  drawing.require_range(stays.last);
  if (whole && drawing.parameters().kind == Kind::circular) {
    for (std::vector<DrawnStay>& each : stays.of) {
      close_circle(each);
    }
  }
  return stays;
}

std::vector<Element> ordered(const DrawnStays& stays, ElementOrder order) {
  std::vector<Element> elements(stays.of.size());
  std::iota(elements.begin(), elements.end(), Element{0});
  if (order == ElementOrder::given) {
    return elements;
  }
  // The first block that holds it and the last of that stay. What goes over the end is there from
  // the first block on.
  const auto entry = [&](Element x) {
    constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
    const std::vector<DrawnStay>& own = stays.of[x];
    return own.empty() ? std::pair(never, never)
                       : std::pair(own.front().over_the_end ? stays.first : own.front().from,
                                   own.front().to);
  };
  const auto before = [&](Element x, Element y) {
    const std::size_t a = stays.of[x].size();
    const std::size_t b = stays.of[y].size();
    if (order == ElementOrder::stays && a != b && a > 0 && b > 0) {
      return a < b;
    }
    return entry(x) < entry(y);
  };
  std::stable_sort(elements.begin(), elements.end(), before);
  return elements;
}

}  // namespace changeover
