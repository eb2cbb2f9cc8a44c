// The options of load orders, one record each, and the checks of a request.
#include "changeover/loadorder/load_request.hpp"

#include <fmt/format.h>

#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "io/request/option.hpp"
#include "io/request/request_document.hpp"
#include "io/request/request_schema.hpp"
#include "io/request/request_words.hpp"
#include "io/request/search_options.hpp"
#include "loadorder/pairs/pair_costs.hpp"
#include "loadorder/shares/owners/pair_table.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

using R = LoadRequest;

// A search leaves the server time to read what it finds.
constexpr SearchTimes times_of_orders{.command_line = 0, .server = 0, .most_of_server = 30};

// Orders in Python have items by their numbers.
constexpr std::string_view only_numbers = "numbers only";

std::vector<RequestOption<R>> options() {
  auto all = with_search_options<R>(
      {
          option("items", "P", "items, e.g. partitions of a file", &R::items,
                 {.unit = "items", .c = "items"}),
          option("room", "C", "how many items fit in memory at once", &R::room,
                 {.unit = "items", .c = "room"}),
          option("pairs", "FILE",
                 "only the pairs listed there, two items per line (text, CSV, .xlsx); \"-\": "
                 "standard input; with --workers a third column may say what a pair costs",
                 &R::pairs, {.shape = RowShape::costs, .in_python = only_numbers, .c = "pairs"}),
          option("groups", "FILE",
                 "only the pairs within the groups listed there, one group of items per line",
                 &R::groups,
                 {.shape = RowShape::groups, .in_python = only_numbers, .c = "group_items"}),
          option("against", "B", "each of the P items with each of B others", &R::against,
                 {.unit = "items", .c = "against"}),
          option("done_items", "N", "the pairs of the first N items are done", &R::done_items,
                 {.unit = "items", .c = "done_items"}),
          option("fast_room", "C",
                 "number of the items in memory that fit on an accelerator, where pairs meet",
                 &R::fast_room, {.unit = "items"}),
          option("item_bytes", "N", "bytes an item, to say how many are moved", &R::item_bytes,
                 {.unit = "bytes", .not_in_python = "what is moved is the loads times the bytes"}),
          option("sizes", "FILE",
                 "items differ in size: an item and its bytes per line, or the bytes of items "
                 "0, 1, … in turn; --memory says how many fit",
                 &R::sizes, {.shape = RowShape::sizes, .in_python = only_numbers}),
          option("memory", "SIZE", "bytes in memory at once, of items with --sizes", &R::memory,
                 {.unit = "bytes", .of_every_search = true}),
          option("fast_memory", "SIZE",
                 "bytes of the memory that fit on an accelerator, where pairs meet",
                 &R::fast_memory, {.unit = "bytes"}),
          option("workers", "W", "split it for W workers with room C each", &R::workers,
                 {.unit = "workers", .by_default = "1", .c = "workers"}),
          option("worker", "I", "only the steps of worker I of these, from 0", &R::worker,
                 {.not_in_server = "its figures are of all workers, and its steps name theirs",
                  .not_in_python = "there steps(I) has them",
                  .c = "changeover_loadorder_take_worker()"}),
          option("balance", "", "spread pairs evenly over the workers that have them", &R::balance,
                 {.by_default = "yes",
                  .not_in_python = "it is the default, and first_holder is an argument"}),
          option("first_holder", "", "the first worker that has a pair computes it",
                 &R::first_holder, {.c = "first_holder"}),
          option("pair_cost", "FILE",
                 "what pairs cost to compute, two items and a number per line; costs are spread "
                 "evenly over workers",
                 &R::pair_cost,
                 {.by_default = "1 each",
                  .shape = RowShape::weights,
                  .in_python = only_numbers,
                  .c = "pair_cost"}),
          option("from_step", "N",
                 "begin at step N, which loads all that is in memory then; not for workers or new "
                 "pairs",
                 &R::from_step,
                 {.not_in_python = "there steps_from(N) begins at it",
                  .c = "changeover_loadorder_seek()"}),
          option("epochs", "N",
                 "every pair meets in each of N epochs, back and forth: what is in memory at "
                 "the end of one stays for the next",
                 &R::epochs, {.by_default = "1"}),
          option("verify_beside", "",
                 "begin at once: steps are read while they are written, and the end says whether "
                 "they are right",
                 &R::verify_beside, {.not_in_server = "it sends an answer when that is verified"}),
          option("disjoint", "",
                 "workers step together and never hold one item twice, so that items may change",
                 &R::disjoint, {.c = "disjoint"}),
          option("write_back", "", "items change while they are held: say what is stored when",
                 &R::write_back),
          option("prefetch", "", "say what is computed when, so that loads overlap computation",
                 &R::prefetch),
          option("new_pairs", "", "say of each step which pairs are computed", &R::new_pairs,
                 {.c = "with_pairs"}),
          option("ordered", "", "pairs both ways: (i,j) and (j,i)", &R::ordered),
          option("self", "", "each item with itself, too: (i,i)", &R::self,
                 {.python = "with_self"}),
          option("shuffle", "", "pairs of a step in random order, by --seed", &R::shuffle),
          option("spread", "",
                 "each pair at random in one of the steps that hold both items, evenly, by "
                 "--seed",
                 &R::spread),
      },
      "how long to search for a better order", times_of_orders);
  for (RequestOption<R>& each : all) {
    if (each.record.key == "seconds" || each.record.key == "seed") {
      each.record.c = each.record.key;
    }
  }
  return all;
}

std::vector<OptionRule> rules() {
  using Says = OptionRule::Says;
  return {
      {Says::never_with,
       {"fast_room"},
       {"sizes"},
       "{} counts items, not their bytes; with {sizes} give {fast_memory=}"},
      {Says::exclude, {"new_pairs", "prefetch"}},
      {Says::needs, {"sizes"}, {"memory"}},
      {Says::only_with, {"memory"}, {"sizes"}},
      {Says::only_with, {"fast_memory"}, {"sizes"}},
      // How many items fit depends on which they are.
      {Says::never_with, {"sizes"}, {"room", "item_bytes"}},
      {Says::only_with,
       {"disjoint", "worker", "balance", "first_holder", "pair_cost"},
       {"workers"}},
      {Says::exclude, {"balance", "first_holder"}},
      {Says::exclude, {"first_holder", "pair_cost"}},
      {Says::never_with,
       {"from_step", "verify_beside"},
       {"disjoint", "fast_room", "fast_memory", "prefetch", "write_back"}},
      {Says::never_with, {"from_step"}, {"workers", "new_pairs", "verify_beside"}},
      {Says::never_with, {"balance", "first_holder", "pair_cost"}, {"disjoint"}},
      {Says::never_with, {"disjoint"}, {"prefetch"}},
      {Says::only_with, {"ordered", "self", "shuffle"}, {"new_pairs", "write_back", "prefetch"}},
      {Says::only_with, {"spread"}, {"new_pairs", "write_back"}},
      // Prefetch decides which step computes a pair.
      {Says::never_with, {"spread"}, {"prefetch"}},
      // In the other direction another worker has a pair first.
      {Says::never_with, {"epochs"}, {"first_holder"}},
      {Says::exclude, {"pairs", "groups", "against", "done_items"}},
      {Says::only_with, {"threads"}, {"seconds"}},
      // A search of some seconds found no order of one level with fewer loads than groups have.
      {Says::needs,
       {"seconds"},
       {"disjoint", "fast_room", "sizes"},
       "{seconds=} with {where} is for {disjoint}, {fast_room} or {sizes}; leave it out",
       {"against", "done_items"}},
      {Says::needs,
       {"write_back"},
       {"disjoint"},
       "{} {workers}: two workers would change one item at once; add {disjoint}",
       {"workers"}},
  };
}

using Words = RequestWords<LoadRequest>;

void check_epochs_of(const LoadRequest& request, const Words& words) {
  if (request.epochs && (*request.epochs == 0 || *request.epochs > most_epochs)) {
    words.refuse("epochs", fmt::format("{} {}: give 1 to {}", words.key("epochs"), *request.epochs,
                                       most_epochs));
  }
}

void check_from_step_of(const LoadRequest& request, const Words& words) {
  if (request.from_step && *request.from_step == 0) {
    words.refuse("from_step",
                 fmt::format("{} 0: give at least 1, the first step", words.key("from_step")));
  }
}

void check_workers_of(const LoadRequest& request, const Words& words) {
  if (request.workers && (*request.workers == 0 || *request.workers > most_workers)) {
    words.refuse("workers", *request.workers == 0
                                ? fmt::format("{} 0: give at least 1 worker", words.key("workers"))
                                : fmt::format("{} {}: give 1 to {}", words.key("workers"),
                                              *request.workers, most_workers));
  }
  if (request.worker && *request.worker >= *request.workers) {
    words.refuse("worker",
                 fmt::format("{} {}: of {} {} give 0 to {}", words.key("worker"), *request.worker,
                             words.key("workers"), *request.workers, *request.workers - 1));
  }
}

// Numbers that are out of range by themselves.
void check_ranges(const LoadRequest& request, const Words& words) {
  const auto at_least_one = [&](std::string_view name, const std::optional<std::uint64_t>& value,
                                std::string_view what) {
    if (value && *value == 0) {
      words.refuse(name, fmt::format("{} 0: give at least 1{}", words.key(name), what));
    }
  };
  at_least_one("items", request.items, " item");
  if (*request.room < 2) {
    words.refuse("room", fmt::format("{} {}: no two items could meet; give room for at least 2",
                                     words.key("room"), *request.room));
  }
  if (*request.room > most_items) {
    words.refuse("room", fmt::format("{} {}: give at most {}, the largest number of items",
                                     words.key("room"), *request.room, most_items));
  }
  check_workers_of(request, words);
  check_from_step_of(request, words);
  check_epochs_of(request, words);
  at_least_one("against", request.against, " item");
  at_least_one("item_bytes", request.item_bytes, "");
  if (request.fast_room && (*request.fast_room < 2 || *request.fast_room > *request.room)) {
    words.refuse("fast_room",
                 fmt::format("{} {}: of {} {} give 2 to {}", words.key("fast_room"),
                             *request.fast_room, words.key("room"), *request.room, *request.room));
  }
}

// For items with sizes.
void at_least_two_fit(const LoadRequest& request, const Words& words) {
  if (*request.memory < 2) {
    words.refuse("memory", fmt::format("{} {}: no two items could meet; give at least 2 bytes",
                                       words.key("memory"), *request.memory));
  }
  if (request.fast_memory && (*request.fast_memory < 2 || *request.fast_memory > *request.memory)) {
    words.refuse("fast_memory", fmt::format("{} {}: of {} {} give 2 to {}",
                                            words.key("fast_memory"), *request.fast_memory,
                                            words.key("memory"), *request.memory, *request.memory));
  }
  if (request.items && (*request.items == 0 || *request.items > max_elements_in_memory)) {
    words.refuse("items", fmt::format("{} {}: with {} give 1 to {}", words.key("items"),
                                      *request.items, words.key("sizes"), max_elements_in_memory));
  }
  if (request.against || request.done_items) {
    const std::uint64_t items = request.items.value_or(0);
    if (items == 0 || request.against.value_or(1) == 0 || request.done_items.value_or(0) >= items) {
      words.refuse(
          request.against ? "against" : "done_items",
          fmt::format("{}: the number of items is missing; give {}, 1 or more and above the "
                      "number of done items",
                      words.key(request.against ? "against" : "done_items"), words.key("items")));
    }
  }
  check_epochs_of(request, words);
  check_workers_of(request, words);
  check_from_step_of(request, words);
}

// Numbers that cannot be combined.
void check_together(const LoadRequest& request, const Words& words, bool all) {
  const std::uint64_t items = request.items.value_or(0);
  if (request.done_items && *request.done_items >= items) {
    words.refuse("done_items",
                 fmt::format("{} {}: all {} items would be done, and none new; give fewer",
                             words.key("done_items"), *request.done_items, items));
  }
  if ((request.disjoint || request.fast_room) && all && items > max_elements_in_memory) {
    words.refuse(request.disjoint ? "disjoint" : "fast_room",
                 fmt::format("{}: at most {} items; group items into larger ones",
                             words.key(request.disjoint ? "disjoint" : "fast_room"),
                             max_elements_in_memory));
  }
  const auto at_most = [&](std::string_view key, std::uint64_t given) {
    if (given > most_items) {
      words.refuse(key, fmt::format("{} {}: give at most {}", words.key(key), given, most_items));
    }
  };
  at_most("items", items);
  at_most("against", request.against.value_or(0));
  if (request.against && items + *request.against > most_items) {
    words.refuse("items", fmt::format("{} {} and {} {} are {} items together; at most {}",
                                      words.key("items"), items, words.key("against"),
                                      *request.against, items + *request.against, most_items));
  }
  if (request.epochs.value_or(1) > 1 && request.workers && !request.disjoint && all &&
      items > most_items_of_a_table && (request.new_pairs || request.prefetch)) {
    words.refuse(
        "epochs",
        fmt::format("{} {}: {} then takes at most {} items; leave it out, or group items into "
                    "larger ones",
                    words.key("epochs"), *request.epochs,
                    words.key(request.new_pairs ? "new_pairs" : "prefetch"),
                    most_items_of_a_table));
  }
}

void check(const LoadRequest& request, const Words& words, bool has_pairs) {
  check_rules(load_table(), request, words);
  check_threads(request, words);
  if (request.sizes.is_given()) {
    at_least_two_fit(request, words);
    return;
  }
  // No rule of the table: a caller may have the pairs, beside the request.
  if (!request.room || (!has_pairs && !request.items)) {
    words.refuse(request.room ? "items" : "room",
                 has_pairs ? fmt::format("{} is required", words.with_value("room"))
                           : fmt::format("{} and {} are required", words.with_value("items"),
                                         words.with_value("room")));
  }
  check_ranges(request, words);
  check_together(request, words, !has_pairs);
}

}  // namespace

const RequestTable<LoadRequest>& load_table() {
  static const RequestTable<LoadRequest> table{.format = "changeover-load-request/1",
                                               .options = options(),
                                               .rules = rules(),
                                               .times = times_of_orders};
  return table;
}

std::string to_json(const LoadRequest& request) { return request_as_json(load_table(), request); }

LoadRequest load_request(std::string json, std::string name, Door door) {
  return read_request(load_table(),
                      RequestDocument(load_table().format, std::move(json), std::move(name), door));
}

std::string load_request_schema() {
  return request_schema(load_table().format, "What is asked of a load order",
                        records_of(load_table()), load_table().rules);
}

namespace {

// Reads item sizes, and returns their places; names of items without a list of pairs define the
// items.
SizePlace take_sizes(const LoadRequest& request, const Words& words,
                     std::shared_ptr<const PairGraph>& pairs,
                     std::shared_ptr<const ItemSizes>& sizes, std::vector<std::string>& notes) {
  std::optional<std::uint64_t> items = request.items;
  if (items && request.against) {
    items = checked_add(*items, *request.against);
  }
  auto [bytes, names, place] =
      read_sizes(words.open("sizes", request.sizes), items, pairs.get(), &notes);
  if (!names.empty()) {
    constexpr std::uint64_t most_named = 2'000;
    if (names.size() > most_named || request.against || request.done_items) {
      words.refuse(
          "sizes",
          fmt::format("{}: at most {} items with names, all pairs of them; number them, or list "
                      "the pairs",
                      words.key("sizes"), most_named));
    }
    pairs = std::make_shared<const PairGraph>(
        names.size(),
        [count = static_cast<Element>(names.size())](const PairGraph::Visit& visit) {
          for (Element y = 1; y < count; ++y) {
            for (Element x = 0; x < y; ++x) {
              visit(x, y);
            }
          }
        },
        std::move(names));
  }
  sizes = std::make_shared<const ItemSizes>(
      ItemSizes{std::move(bytes), *request.memory, request.fast_memory.value_or(0)});
  return place;
}

bool lists_pairs(const LoadRequest& request) {
  return request.pairs.is_given() || request.groups.is_given();
}

// What a third column of the pairs would say has no meaning.
std::string why_no_costs(const LoadRequest& request, const Words& words) {
  for (const std::string_view other : {"pair_cost", "first_holder", "disjoint"}) {
    if ((other == "pair_cost" && request.pair_cost.is_given()) ||
        (other == "first_holder" && request.first_holder) ||
        (other == "disjoint" && request.disjoint)) {
      return fmt::format("; with {} no third column says what a pair costs", words.key(other));
    }
  }
  return request.workers
             ? ""
             : fmt::format("; a third column, what a pair costs, is for {}", words.key("workers"));
}

std::shared_ptr<const PairGraph> listed_pairs(const LoadRequest& request, const Words& words,
                                              std::function<double(Element, Element)>& cost,
                                              std::vector<std::string>& notes) {
  const bool groups = request.groups.is_given();
  const auto input =
      groups ? words.open("groups", request.groups) : words.open("pairs", request.pairs);
  const std::string no_costs = why_no_costs(request, words);
  return read_pairs(*input, {.items = request.items,
                             .groups = groups,
                             .costs = no_costs.empty() ? &cost : nullptr,
                             .no_costs = no_costs,
                             .notes = &notes});
}

}  // namespace

void check_options(const LoadRequest& request, Door door) {
  check(request, Words(load_table(), request, door), lists_pairs(request));
}

namespace {

// Several epochs are kept in memory for "spread" and for Marius.
void check_whole_epochs(const LoadRequest& request, const WantedPairs& wanted, const Words& words) {
  constexpr std::uint64_t most_pairs = 100'000'000;
  const std::uint64_t epochs = request.epochs.value_or(1);
  const std::uint64_t pairs = wanted.count();
  if (epochs > 1 && pairs > most_pairs / epochs) {
    const std::uint64_t most = most_pairs / pairs;
    words.refuse(
        "epochs",
        fmt::format(
            "{} {}: with {} or for Marius all epochs have at most {} pairs; give {}",
            words.key("epochs"), epochs, words.key("spread"), most_pairs,
            most < 2 ? "fewer items" : fmt::format("{} {} or less", words.key("epochs"), most)));
  }
}

// The keys that such a list has no place for.
void refuse_in_format(const CheckedLoads& asked, std::string_view why,
                      std::initializer_list<std::string_view> keys) {
  const Words words(load_table(), asked.request(), asked.door());
  for (const std::string_view key : keys) {
    if (is_given(asked.request(), option_of(load_table(), key))) {
      words.refuse(key, fmt::format("{}; leave out {}", why, words.key(key)));
    }
  }
}

// Text and CSV write pairs as a|b.
void check_names_of_pairs(const CheckedLoads& asked) {
  const PairGraph* const graph = asked.wanted().graph();
  if (graph == nullptr || !(asked.request().new_pairs || asked.request().prefetch)) {
    return;
  }
  const Words words(load_table(), asked.request(), asked.door());
  for (const std::string& name : graph->names()) {
    if (name.find('|') != std::string::npos) {
      throw BadInput(
          fmt::format("the name '{}' has a '|', which stands between the names of a pair in text "
                      "and CSV; rename it, ask for JSON, or leave out {}",
                      name, words.key(asked.request().prefetch ? "prefetch" : "new_pairs")));
    }
  }
}

}  // namespace

void check_format(const CheckedLoads& asked, std::string_view format) {
  if (format == "marius") {
    refuse_in_format(asked, "Marius has one buffer, and its order from the first step",
                     {"workers", "fast_room", "fast_memory", "prefetch", "from_step"});
    check_whole_epochs(asked.request(), asked.wanted(),
                       Words(load_table(), asked.request(), asked.door()));
  }
  if (format == "text" || format == "csv") {
    check_names_of_pairs(asked);
  }
  if (format == "colmap") {
    refuse_in_format(asked, "a list for COLMAP has each pair once",
                     {"prefetch", "epochs", "ordered", "self", "from_step"});
    if (asked.wanted().graph() == nullptr && asked.items() > max_elements_in_memory) {
      throw BadInput(
          fmt::format("a list for COLMAP has each pair once; give at most {} items, or "
                      "list the pairs",
                      max_elements_in_memory));
    }
  }
}

CheckedLoads checked_loads(LoadRequest asked, Door door, std::shared_ptr<const PairGraph> pairs) {
  CheckedLoads checked;
  checked.request_ = std::move(asked);
  checked.door_ = door;
  const LoadRequest& request = checked.request_;
  const Words words(load_table(), request, door);
  check(request, words, lists_pairs(request) || pairs != nullptr);
  with_places(request.places, [&] {
    checked.room_ = request.room.value_or(0);
    if (pairs == nullptr && lists_pairs(request)) {
      pairs = listed_pairs(request, words, checked.cost_, checked.notes_);
    }
    const bool listed = pairs != nullptr;
    SizePlace place_of_size;
    if (request.sizes.is_given()) {
      place_of_size = take_sizes(request, words, pairs, checked.sizes_, checked.notes_);
    }
    if (pairs) {
      checked.wanted_ =
          listed ? WantedPairs::listed(std::move(pairs)) : WantedPairs::whole(std::move(pairs));
    } else if (request.against) {
      checked.wanted_ = WantedPairs::between(*request.items, *request.against);
    } else if (request.done_items) {
      checked.wanted_ = WantedPairs::beyond(*request.done_items, *request.items);
    } else {
      checked.wanted_ = checked.sizes_ ? checked.sizes_->bytes.size() : *request.items;
    }
    if (checked.sizes_) {
      check_sizes(*checked.sizes_, checked.wanted_, place_of_size);
      if (request.fast_memory) {
        check_sizes({checked.sizes_->bytes, *request.fast_memory}, checked.wanted_, place_of_size,
                    "the accelerator");
      }
      checked.room_ = most_held(*checked.sizes_, checked.wanted_);
    }
    if (request.spread) {
      check_whole_epochs(request, checked.wanted_, words);
    }
    if (request.pair_cost.is_given()) {
      checked.cost_ = read_pair_costs(*words.open("pair_cost", request.pair_cost), checked.wanted_,
                                      &checked.notes_);
    }
  });
  return checked;
}

}  // namespace changeover
