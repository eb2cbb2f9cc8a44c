// What is said of each of several things: as a list, added up, the largest, or in words.
//
//     each_of<std::string>(parts, [&](Element x) { return job.names[x]; })
//     sum_of(groups, &ItemRange::size)
//     largest_of(inputs, depth)                       // 0 if there is none
//     joined(words)                                   // one, two, three
//     joined(factors, " and ", in_words)              // the words of each
//
// `of` is a function, or a member, of each; it is called once for each, in their order.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace changeover {

template <typename Of, typename Range>
concept OfEach =
    std::ranges::input_range<Range> && std::invocable<Of&, std::ranges::range_reference_t<Range>>;

template <typename Value, typename Range, OfEach<Range> Of>
[[nodiscard]] std::vector<Value> each_of(Range&& range, Of&& of) {
  std::vector<Value> all;
  if constexpr (std::ranges::sized_range<Range>) {
    all.reserve(static_cast<std::size_t>(std::ranges::size(range)));
  }
  for (auto&& each : range) {
    all.push_back(std::invoke(of, each));
  }
  return all;
}

template <typename Sum = std::uint64_t, typename Range, OfEach<Range> Of>
[[nodiscard]] Sum sum_of(Range&& range, Of&& of) {
  Sum sum{};
  for (auto&& each : range) {
    sum += std::invoke(of, each);
  }
  return sum;
}

template <typename Value = std::uint64_t, typename Range, OfEach<Range> Of>
[[nodiscard]] Value largest_of(Range&& range, Of&& of) {
  Value largest{};
  for (auto&& each : range) {
    largest = std::max<Value>(largest, std::invoke(of, each));
  }
  return largest;
}

template <typename Range, OfEach<Range> Of>
[[nodiscard]] std::string joined(Range&& range, std::string_view between, Of&& of) {
  std::string text;
  bool first = true;
  for (auto&& each : range) {
    text += first ? std::string_view() : between;
    text += std::invoke(of, each);
    first = false;
  }
  return text;
}
template <typename Range, OfEach<Range> Of>
[[nodiscard]] std::string joined(Range&& range, Of&& of) {
  return joined(range, ", ", of);
}
/// Words as they are.
template <typename Range>
[[nodiscard]] std::string joined(Range&& words, std::string_view between = ", ") {
  return joined(words, between, [](std::string_view word) { return word; });
}

}  // namespace changeover
