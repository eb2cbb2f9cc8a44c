// Internal: searches whose result gets no worse with more time, nor is worse than without any.
//
// The fixed work, which is done without a search, comes first, and the limit of the search does not
// cut it short: its time begins afterwards. What follows goes the same way whenever it ends.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// Does `fixed`, then `more` until the search of the caller stops, if there is one; `more` may end
/// with Stopped wherever its best so far is whole.
inline void fixed_first(const LoadOrderOptions& options, const std::function<void()>& fixed,
                        const std::function<void(RunControl&)>& more) {
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
      {
        const RunScope scope(*beyond);
        begin();
      }
      std::optional<RunControl> timed;
      if (control->settings().time) {
        control = &timed.emplace(*beyond, *control->settings().time);
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
/// than its limit. @throws Stopped if there is no such search and this thread is asked to stop
[[nodiscard]] inline bool must_hurry() {
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
      });
  return std::move(*best);
}

}  // namespace changeover
