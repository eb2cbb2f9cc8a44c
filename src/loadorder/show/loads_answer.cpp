#include "loadorder/show/loads_answer.hpp"

#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/workers.hpp"

namespace changeover {
namespace {

LoadsShown shown_as_asked(const LoadRequest& request) {
  const std::uint64_t seed = request.seed.value_or(1);
  LoadsShown how{.format = {},
                 .compute = {.ordered = request.ordered, .self = request.self},
                 .new_pairs = request.new_pairs,
                 .write_back = request.write_back,
                 .searched = request.seconds.has_value(),
                 .seed = seed,
                 .item_bytes = request.item_bytes};
  if (request.shuffle) {
    how.compute.shuffle = seed;
  }
  return how;
}

AnyLoads planned(const CheckedLoads& asked, const LoadRequest& request,
                 const LoadOrderOptions& options) {
  const WantedPairs& wanted = asked.wanted();
  const bool all = wanted.are_all();
  const std::uint64_t items = asked.items();
  const std::uint64_t room = asked.room();
  if (request.disjoint) {
    return plan_disjoint_order(items, room, *request.workers, options);
  }
  if (request.fast_room) {
    if (request.workers) {
      return split_two_levels(items, room, *request.fast_room, *request.workers);
    }
    return plan_two_levels(items, room, *request.fast_room);
  }
  if (request.prefetch) {
    if (request.workers) {
      return all ? split_prefetch(items, room, *request.workers, options)
                 : split_prefetch(wanted, room, *request.workers, options);
    }
    return all ? plan_prefetch(items, room, options) : plan_prefetch(wanted, room, options);
  }
  if (request.workers) {
    return all ? split_load_order(items, room, *request.workers, options)
               : split_load_order(wanted, room, *request.workers, options);
  }
  return all ? plan_load_order(items, room, options) : plan_load_order(wanted, room, options);
}

}  // namespace

LoadsAnswer::LoadsAnswer(const CheckedLoads& asked, const LoadRequest& request,
                         const LoadOrderOptions& options)
    : room_(asked.room()),
      how_(shown_as_asked(request)),
      loads_(planned(asked, request, options)) {}

void LoadsAnswer::write(const std::string& format, Sink& sink) const {
  LoadsShown how = how_;
  how.format = format;
  std::visit([&](const auto& loads) { show_loads(loads, room_, how, sink); }, loads_);
}

std::string LoadsAnswer::head() const {
  StringSink sink;
  LoadsShown how = how_;
  how.format = "jsonl";
  how.head_only = true;
  std::visit([&](const auto& loads) { show_loads(loads, room_, how, sink); }, loads_);
  std::string line = sink.text();
  line.pop_back();  // its end
  return line;
}

}  // namespace changeover
