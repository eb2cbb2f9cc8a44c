// changeover loadorder: loads and evictions after which every pair of items has been in memory together.
#include <fmt/format.h>

#include "answer/loads/show_loads.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/disjoint.hpp"
#include "changeover/loadorder/two_levels.hpp"
#include "request/inputs.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct LoadOrderRequest {
  std::optional<std::uint64_t> items;
  std::optional<std::uint64_t> room;
  std::optional<std::uint64_t> against;
  std::optional<std::uint64_t> done_items;
  std::string pairs;
  std::optional<std::uint64_t> fast_room;
  std::optional<std::uint64_t> item_bytes;
  std::optional<std::uint64_t> workers;
  bool disjoint = false;
  bool write_back = false;
  bool prefetch = false;
  bool new_pairs = false;
  bool ordered = false;
  bool self = false;
  bool shuffle = false;
  RunRequest run;
  OutputRequest output;
};

LoadsShown shown(const LoadOrderRequest& request) {
  const std::uint64_t seed = request.run.seed.value_or(1);
  LoadsShown how{.format = request.output.format(),
                 .compute = {.ordered = request.ordered, .self = request.self},
                 .new_pairs = request.new_pairs,
                 .write_back = request.write_back,
                 .searched = !request.run.time.empty(),
                 .seed = seed,
                 .item_bytes = request.item_bytes};
  if (request.shuffle) {
    how.compute.shuffle = seed;
  }
  return how;
}

// What the options say, before a file is read.
void check(const LoadOrderRequest& request) {
  const bool listed = !request.pairs.empty();
  if (!request.room || (!listed && !request.items)) {
    throw UsageError{listed ? "--room C is required" : "--items P and --room C are required"};
  }
  if (request.items && *request.items == 0) {
    throw UsageError{"--items 0: give at least 1 item"};
  }
  if (*request.room < 2) {
    throw UsageError{
        fmt::format("--room {}: no two items could meet; give room for at least 2", *request.room)};
  }
  if (*request.room > most_items) {
    throw UsageError{fmt::format("--room {}: give at most {}, the most items that there can be",
                                 *request.room, most_items)};
  }
  if (request.workers && *request.workers == 0) {
    throw UsageError{"--workers 0: give at least 1 worker"};
  }
  if (request.workers && *request.workers > most_workers) {
    throw UsageError{fmt::format("--workers {}: give 1 to {}", *request.workers, most_workers)};
  }
  if (request.against && *request.against == 0) {
    throw UsageError{"--against 0: give at least 1 item"};
  }
  if (request.done_items && *request.done_items >= *request.items) {
    throw UsageError{fmt::format("--done-items {}: of --items {} none would be new",
                                 *request.done_items, *request.items)};
  }
  if (request.disjoint && *request.workers > 1 &&
      *request.items / *request.workers < *request.room) {
    throw UsageError{fmt::format(
        "--disjoint: {} workers with room for {} would hold more than {}; give --room {} or less, or "
        "fewer workers",
        *request.workers, *request.room, count_of(*request.items, "item"),
        *request.items / *request.workers)};
  }
  if ((request.disjoint || request.fast_room) && *request.items > max_elements_in_memory) {
    throw UsageError{fmt::format("{}: at most {} items; make items larger",
                                 request.disjoint ? "--disjoint" : "--fast-room",
                                 max_elements_in_memory)};
  }
  if (request.fast_room && (*request.fast_room < 2 || *request.fast_room > *request.room)) {
    throw UsageError{fmt::format("--fast-room {}: of --room {} give 2 to {}", *request.fast_room,
                                 *request.room, *request.room)};
  }
  if (request.item_bytes && *request.item_bytes == 0) {
    throw UsageError{"--item-bytes 0: give at least 1"};
  }
  const std::uint64_t most = most_items;
  if (request.items.value_or(0) > most || request.against.value_or(0) > most) {
    throw UsageError{fmt::format("--items and --against are at most {}", most)};
  }
  if (request.against && *request.items + *request.against > most) {
    throw UsageError{fmt::format("--items {} and --against {} are {} items together; at most {}",
                                 *request.items, *request.against,
                                 *request.items + *request.against, most)};
  }
}

WantedPairs wanted_by(const LoadOrderRequest& request) {
  if (!request.pairs.empty()) {
    return WantedPairs::listed(read_pairs(request.pairs, {.items = request.items}));
  }
  if (request.against) {
    return WantedPairs::between(*request.items, *request.against);
  }
  if (request.done_items) {
    return WantedPairs::beyond(*request.done_items, *request.items);
  }
  return {};
}

// When memory is full for the first time, all pairs in it are new.
void require_memory_for_a_step(const LoadOrderRequest& request, const WantedPairs& wanted,
                               std::uint64_t items, std::uint64_t room) {
  const std::uint64_t there = std::min(room, items);
  std::uint64_t pairs = there * (there - 1) / 2;
  if (!wanted.are_all()) {
    pairs = std::min(pairs, wanted.count());
  }
  const std::uint64_t copies = request.ordered ? 3 : 2;  // as they are found, and as they are said
  require_memory(pairs * copies * sizeof(ItemPair),
                 fmt::format("a step of --new-pairs with --room {}", room));
}

Answer run(const LoadOrderRequest& request) {
  check(request);
  const WantedPairs wanted = wanted_by(request);
  const std::uint64_t items = wanted.are_all() ? *request.items : wanted.items();
  const std::uint64_t room = *request.room;
  if (request.new_pairs) {
    require_memory_for_a_step(request, wanted, items, room);
  }
  LoadOrderOptions options;
  options.seed = request.run.seed.value_or(1);
  OutputRequest output = request.output;
  output.precious = false;  // Without a search the same command makes it again.
  output.check_writable();
  if (request.run.settings().time->count() > 0) {
    options.improve = [&](const Design& start, std::uint64_t blocks) {
      output.precious = true;
      Running running(request.run, request.output);  // The time is for the search alone.
      return improve_by_search(running.control())(start, blocks);
    };
    options.search_pairs = [&](const std::function<void()>& search) {
      output.precious = true;
      const Running running(request.run, request.output);
      search();
    };
  }
  // Made now, so that what cannot be is said before anything is written.
  Answer answer;
  const LoadsShown how = shown(request);
  if (request.disjoint || (request.fast_room && !request.workers)) {
    const auto order = std::make_shared<const LoadOrder>(
        request.disjoint ? plan_disjoint_order(items, room, *request.workers, options)
                         : plan_two_levels(items, room, *request.fast_room));
    answer.write = [how, order](OutputFile& out) { show_loads(*order, how, out); };
  } else if (request.workers && request.prefetch) {
    const auto plan = std::make_shared<const PrefetchSplit>(
        wanted.are_all() ? split_prefetch(items, room, *request.workers, options)
                         : split_prefetch(wanted, room, *request.workers, options));
    answer.write = [how, room, plan](OutputFile& out) { show_loads(*plan, room, how, out); };
  } else if (request.workers) {
    const auto split = std::make_shared<const WorkerSplit>(
        request.fast_room  ? split_two_levels(items, room, *request.fast_room, *request.workers)
        : wanted.are_all() ? split_load_order(items, room, *request.workers, options)
                           : split_load_order(wanted, room, *request.workers, options));
    answer.write = [how, split](OutputFile& out) { show_loads(*split, how, out); };
  } else if (request.prefetch) {
    const auto plan = std::make_shared<const PrefetchPlan>(
        wanted.are_all() ? plan_prefetch(items, room, options)
                         : plan_prefetch(wanted, room, options));
    answer.write = [how, room, plan](OutputFile& out) { show_loads(*plan, room, how, out); };
  } else {
    const auto order = std::make_shared<const LoadOrder>(
        wanted.are_all() ? plan_load_order(items, room, options)
                         : plan_load_order(wanted, room, options));
    answer.write = [how, order](OutputFile& out) { show_loads(*order, how, out); };
  }
  answer.output = output;
  return answer;
}

}  // namespace

void add_loadorder(Program& program) {
  auto [verb, request] =
      program.add("loadorder", "an order of loads that brings all pairs of items together", run);
  verb.option("--items", request.items, "P", "items, e.g. partitions of a file");
  verb.option("--room", request.room, "C", "how many are in memory at once");
  verb.option(
      "--pairs", request.pairs, "FILE",
      "only the pairs listed there, two items per line (text, CSV, .xlsx); \"-\": standard input");
  verb.option("--against", request.against, "B", "each of the P items with each of B others");
  verb.option("--done-items", request.done_items, "N", "the pairs of the first N items are done");
  verb.option("--fast-room", request.fast_room, "C",
              "so many of those in memory are on an accelerator, where pairs meet");
  verb.option("--item-bytes", request.item_bytes, "N",
              "bytes an item, to say what both levels move");
  verb.option("--workers", request.workers, "W", "split it for W workers with room C each");
  verb.flag("--disjoint", request.disjoint,
            "workers step together and never hold one item twice, so that items may change");
  verb.flag("--write-back", request.write_back,
            "items change while they are held: say what is stored when");
  verb.flag("--prefetch", request.prefetch,
            "say what is computed when, so that loads overlap computation");
  verb.flag("--new-pairs", request.new_pairs, "say of each step which pairs are computed");
  verb.flag("--ordered", request.ordered, "pairs both ways: (i,j) and (j,i)");
  verb.flag("--self", request.self, "each item with itself, too: (i,i)");
  verb.flag("--shuffle", request.shuffle, "pairs of a step in random order, by --seed");
  request.run.add_to(verb, "0s", request.output);
  request.output.add_to(verb, {"text", "jsonl", "csv"});
  verb.exclude({"--new-pairs", "--prefetch"});
  verb.only_with({"--disjoint"}, {"--workers"});
  verb.never_with({"--fast-room"},
                  {"--disjoint", "--prefetch", "--pairs", "--against", "--done-items", "--time"});
  verb.only_with({"--item-bytes"}, {"--fast-room"});
  verb.require([&request = request] {
    if (request.write_back && request.workers && !request.disjoint) {
      throw UsageError{
          "--write-back --workers: two workers would change one item at once; add --disjoint"};
    }
  });
  verb.never_with({"--disjoint"}, {"--prefetch", "--pairs", "--against", "--done-items"});
  verb.only_with({"--ordered", "--self", "--shuffle"},
                 {"--new-pairs", "--write-back", "--prefetch"});
  verb.exclude({"--pairs", "--against", "--done-items"});
  verb.never_with({"--time"}, {"--against", "--done-items"});
  verb.require([&request = request] {
    check_inputs(request.output, {{"the list of pairs", list_file(request.pairs)}});
  });
  verb.only_with({"--threads", "--memory"}, {"--time"});
  verb.examples({"changeover loadorder --items 64 --room 16",
                 "changeover loadorder --items 20 --room 5 --time 20s      search for fewer loads",
                 "changeover loadorder --items 1000 --room 100 --json -o order.jsonl",
                 "changeover loadorder --items 1000 --room 100 --workers 8",
                 "changeover loadorder --items 64 --room 8 --workers 2 --disjoint   for training",
                 "changeover loadorder --items 200 --room 40 --fast-room 8      two levels",
                 "changeover loadorder --items 64 --room 16 --prefetch",
                 "changeover loadorder --pairs edges.txt --room 10       only some pairs",
                 "changeover loadorder --items 12 --against 20 --room 4  two sets",
                 "changeover loadorder --items 1024 --done-items 1000 --room 64"});
}

}  // namespace changeover::cli
