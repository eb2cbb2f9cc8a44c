// Internal: searches whose result gets no worse with more time, nor is worse than without any.
//
// The fixed work, which is done without a search, comes first, and the limit of the search does not
// cut it short: its time begins afterwards. What follows goes the same way whenever it ends. Only a
// limit of both together (LoadOrderOptions::time_in_all) leaves some of it out.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// The limit that this thread's work obeys where that leaves a result, and nowhere else.
inline thread_local RunControl* soft_limit = nullptr;

/// Makes a control that limit, or nothing, until the end of the block.
class SoftLimit {
 public:
  explicit SoftLimit(RunControl* control) : outer_(std::exchange(soft_limit, control)) {}
  ~SoftLimit() { soft_limit = outer_; }
  SoftLimit(const SoftLimit&) = delete;
  SoftLimit& operator=(const SoftLimit&) = delete;

 private:
  RunControl* outer_;
};

/// What fixed work does when its time is up.
enum class AtTheLimit : std::uint8_t {
  stops,    ///< it ends with Stopped, wherever it has a result without what is under way
  hurries,  ///< only must_hurry() says so: there is no result before all its parts are done
};

/// Does the fixed work, and returns the time that is left for the search: none if it was cut short.
[[nodiscard]] inline std::chrono::duration<double> time_after(const LoadOrderOptions& options,
                                                              RunControl& beyond, AtTheLimit at,
                                                              const std::function<void()>& fixed) {
  RunControl whole(beyond, options.time_in_all.value_or(std::chrono::hours(24 * 36500)));
  {
    const RunScope scope(at == AtTheLimit::stops ? whole : beyond);
    const SoftLimit soft(&whole);
    fixed();
  }
  if (whole.why_stopped() != WhyStopped::time_limit) {
    return *whole.time_left();
  }
  if (options.on_cut_short) {
    options.on_cut_short();
  }
  return {};
}

/// Does `fixed`, then `more` until the search of the caller stops, if there is one; `more` may end
/// with Stopped wherever its best so far is whole, and so may `fixed` if there is `time_in_all`.
inline void fixed_first(const LoadOrderOptions& options, const std::function<void()>& fixed,
                        const std::function<void(RunControl&)>& more,
                        AtTheLimit at = AtTheLimit::stops) {
  bool has_begun = false;
  const auto begin = [&] {
    has_begun = true;
    fixed();
  };
  if (options.search_pairs) {
    options.search_pairs([&] {
      RunControl* control = RunScope::current();
      if (control == nullptr) {
        return begin();
      }
      const auto beyond = RunControl::beyond_limit(*control);
      const auto left = time_after(options, *beyond, at, begin);
      std::optional<RunControl> timed;
      if (control->settings().time) {
        control = &timed.emplace(*beyond, std::min(*control->settings().time, left));
      }
      const RunScope scope(*control);
      try {
        if (!control->stop_wanted()) {
          more(*control);
        }
      } catch (const Stopped&) {
        // What was found before is kept.
      }
    });
  }
  if (!has_begun) {
    fixed();
  }
}

/// Whether fixed work ends with what there is, since the search of the caller is stopped by more
/// than its limit, or its soft limit is over. @throws Stopped if there is no such search and this
/// thread is asked to stop
[[nodiscard]] inline bool must_hurry() {
  if (soft_limit != nullptr && soft_limit->stop_wanted()) {
    return true;
  }
  RunControl* const control = RunScope::current();
  if (control == nullptr || !control->keeps_best()) {
    stop_if_asked();
    return false;
  }
  return control->stop_wanted();
}

/// Does `more`, and returns whether it came to its end: there is a result without it if it had to
/// hurry.
template <typename More>
[[nodiscard]] bool done(bool has_result, const More& more) {
  try {
    more();
  } catch (const Stopped&) {
    RunControl* const control = RunScope::current();
    if (!has_result || control == nullptr || !control->keeps_best()) {
      throw;
    }
    return false;
  }
  return true;
}

/// Does what a first result needs: the limit of the fixed work does not cut it short.
inline void in_spite_of_the_time(const std::function<void()>& first) {
  RunControl* const control = RunScope::current();
  if (control == nullptr || !control->keeps_best()) {
    return first();
  }
  const auto beyond = RunControl::beyond_limit(*control);
  const RunScope scope(*beyond);
  const SoftLimit none(nullptr);
  first();
}

/// The same options, for the fixed work alone.
[[nodiscard]] inline LoadOrderOptions fixed_work(LoadOrderOptions options) {
  options.improve = nullptr;
  options.search_pairs = nullptr;
  return options;
}

/// For what is made of searches, such that less of one is not always less of the whole: the best of
/// what `make` returns with the fixed work alone and, round after round, with searches of a fixed
/// length, four times that of the round before.
template <typename Make, typename Better>
[[nodiscard]] auto best_in_rounds(const LoadOrderOptions& options, const Make& make,
                                  const Better& is_better) {
  std::optional<decltype(make(options))> best;
  fixed_first(
      options, [&] { best = make(fixed_work(options)); },
      [&](RunControl& control) {
        constexpr std::uint64_t first_length = 4096;
        bool goes_on = true;
        for (std::uint64_t length = first_length; goes_on; length *= 4) {
          goes_on = false;
          LoadOrderOptions its = options;
          its.time_in_all.reset();  // its fixed work ends with the search
          const auto in_part = [&](const auto& search) {
            RunControl part(control, Questions{length});
            const RunScope scope(part);
            search(part);
            goes_on = goes_on || part.why_stopped() == WhyStopped::step_limit;
          };
          its.search_pairs = [&](const std::function<void()>& search) {
            in_part([&](RunControl&) { search(); });
          };
          if (options.improve) {
            its.improve = [&](const Design& start, std::uint64_t least) {
              std::optional<Design> found;
              in_part([&](RunControl& part) { found = improve_by_search(part)(start, least); });
              return found;
            };
          }
          auto other = make(its);
          if (control.stop_wanted()) {
            return;  // it may have ended anywhere
          }
          if (is_better(other, *best)) {
            best = std::move(other);
          }
        }
      },
      AtTheLimit::hurries);
  return std::move(*best);
}

}  // namespace changeover
