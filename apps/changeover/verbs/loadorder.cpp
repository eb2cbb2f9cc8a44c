// changeover loadorder: loads and evictions after which every pair of items has been in memory
// together.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "loadorder/show/loads_answer.hpp"
#include "request/request_options.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct LoadOrderRequest {
  LoadRequest load;
  RequestFileRequest file;
  RunRequest run;
  OutputRequest output;
};

// With sizes, those of the options or of the file, --memory is of items and not of a search.
void take_memory_of_items(LoadRequest& request, RunRequest& run) {
  if (request.sizes.is_given() && !run.memory.empty()) {
    request.memory = parse_size(run.memory, "--memory");
    run.memory.clear();
  }
}

// So long an order that is searched may take at least, in all.
constexpr std::chrono::seconds shortest{10};

// When memory is full for the first time, all pairs in it are new.
void require_memory_for_a_step(const CheckedLoads& asked, bool ordered) {
  const std::uint64_t room = asked.room();
  const std::uint64_t there = std::min(room, asked.items());
  const std::uint64_t pairs = std::min(there * (there - 1) / 2, asked.wanted().count());
  const std::uint64_t copies = ordered ? 3 : 2;  // as they are found, and as they are said
  require_memory(pairs * copies * sizeof(ItemPair),
                 fmt::format("a step of --new-pairs with --room {}", room));
}

Answer run(const LoadOrderRequest& typed) {
  RunRequest run = typed.run;
  LoadRequest request =
      whole_request(typed.load, run, load_table(), typed.file, typed.output, load_request);
  take_memory_of_items(request, run);
  if (typed.output.format() == "marius") {
    if (request.workers || request.fast_room || request.fast_memory || request.prefetch ||
        request.write_back || request.from_step || request.verify_beside) {
      throw UsageError{
          "--format marius is for one buffer: without --workers, --fast-room, --fast-memory, "
          "--prefetch, --write-back, --from-step and --verify-beside"};
    }
    request.new_pairs = request.ordered = request.self = true;
  }
  if (typed.output.format() == "colmap") {
    if (request.prefetch || request.epochs || request.ordered || request.self ||
        request.from_step || request.write_back) {
      throw UsageError{
          "--format colmap has each pair once: without --prefetch, --epochs, --ordered, --self, "
          "--from-step and --write-back"};
    }
    request.new_pairs = true;
  }
  check_options(request, Door::command_line);
  OutputRequest output = typed.output;
  output.precious = false;  // Without a search the same command makes it again.
  if (typed.file.show) {
    return text_answer(to_json(request), output);
  }
  const CheckedLoads asked = checked_loads(request, Door::command_line);
  if (request.new_pairs) {
    require_memory_for_a_step(asked, request.ordered);
  }
  if (typed.output.format() == "marius") {
    check_whole_epochs(request, asked.wanted(), Door::command_line);
  }
  LoadOrderOptions options;
  options.seed = request.seed.value_or(1);
  output.check_writable();
  if (run.settings().time->count() > 0) {
    // The time is for the searches alone.
    const auto searching = [&](const std::function<void(RunControl&)>& search) {
      output.precious = true;
      Running running(run, typed.output);
      search(running.control());
    };
    options.improve = [=](const Design& start, std::uint64_t blocks) {
      std::optional<Design> found;
      searching([&](RunControl& control) { found = improve_by_search(control)(start, blocks); });
      return found;
    };
    options.search_pairs = [=](const std::function<void()>& search) {
      searching([&](RunControl&) { search(); });
    };
    options.time_in_all = std::max<std::chrono::duration<double>>(*run.settings().time, shortest);
  }
  // Made now, so that what cannot be is said before anything is written.
  const auto loads = std::make_shared<const LoadsAnswer>(asked, request, options);
  if (request.from_step) {
    try {
      static_cast<void>(loads->order()->stream_from(*request.from_step));
    } catch (const BadInput& fault) {
      throw BadInput(fmt::format("--from-step {}: {}", *request.from_step, fault.what()));
    }
  }
  Answer answer;
  answer.write = [format = output.format(), loads](OutputFile& out) { loads->write(format, out); };
  answer.output = output;
  return answer;
}

}  // namespace

void add_loadorder(Program& program) {
  auto [verb, request] = program.add<LoadOrderRequest>(
      "loadorder", "order loads so that all pairs of items meet", run);
  add_request_options(verb, request.load, load_table());
  request.file.add_to(verb, load_table().format);
  request.run.add_to(verb, seconds_text(load_table().times.command_line), request.output);
  request.output.add_to(verb, {"text", "jsonl", "csv", "marius", "colmap"});
  verb.require([&asked = request] {
    if (!asked.run.memory.empty() && asked.run.time.empty() && asked.file.path.empty() &&
        !asked.load.sizes.is_given()) {
      throw UsageError{"--memory SIZE is for --time or --sizes; give both"};
    }
  });
  verb.examples(
      {"changeover loadorder --items 64 --room 16",
       "changeover loadorder --items 20 --room 5 --time 20s      search for fewer loads",
       "changeover loadorder --items 1000 --room 100 --json -o order.jsonl",
       "changeover loadorder --items 1000 --room 100 --workers 8",
       "changeover loadorder --items 64 --room 8 --workers 2 --disjoint   for training",
       "changeover loadorder --items 64 --room 16 --epochs 10 --write-back    for training",
       "changeover loadorder --items 64 --room 16 --epochs 10 --spread --format marius",
       "changeover loadorder --items 200 --room 40 --fast-room 8      two levels",
       "changeover loadorder --items 64 --room 16 --prefetch",
       "changeover loadorder --pairs edges.txt --room 10       only some pairs",
       "changeover loadorder --groups clusters.txt --room 500 --format colmap -o pairs.txt",
       "changeover loadorder --sizes parts.csv --memory 8G     items of different size",
       "changeover loadorder --items 12 --against 20 --room 4  two sets",
       "changeover loadorder --items 1024 --done-items 1000 --room 64"});
}

}  // namespace changeover::cli
