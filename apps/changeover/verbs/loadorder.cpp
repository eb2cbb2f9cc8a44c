// changeover loadorder: loads and evictions after which every pair of items has been in memory
// together.
#include <fmt/format.h>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "loadorder/show/loads_answer.hpp"
#include "request/request_options.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct LoadOrderRequest : LoadRequest {
  RequestFileRequest file;
  RunRequest run;
  OutputRequest output;
};

// What is asked, by the options and the file together; limits of the search stand in both.
LoadOrderRequest whole(LoadOrderRequest request) {
  request.threads = request.run.threads;
  request.seed = request.run.seed;
  if (!request.run.time.empty()) {
    request.seconds = parse_duration(request.run.time, "--time").count();
  }
  static_cast<LoadRequest&>(request) =
      whole_request<LoadRequest>(request, load_table(), request.file.path, load_request);
  request.run.threads = request.threads;
  request.run.seed = request.seed;
  if (request.run.time.empty() && request.seconds) {
    request.run.time = fmt::format("{}s", *request.seconds);
  }
  return request;
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

Answer run(const LoadOrderRequest& typed) {
  std::vector<InputFile> files{{"--request", typed.file.path}};
  check_inputs(typed.output, files);
  const LoadOrderRequest request = whole(typed);
  check_options(request, Door::command_line);
  OutputRequest output = request.output;
  output.precious = false;  // Without a search the same command makes it again.
  if (request.file.show) {
    return text_answer(to_json(request), output);
  }
  files.emplace_back("the list of pairs", list_file(request.pairs.file));
  check_inputs(request.output, files);
  const CheckedLoads asked = checked_loads(request, Door::command_line);
  if (request.new_pairs) {
    require_memory_for_a_step(request, asked.wanted(), asked.items(), asked.room());
  }
  LoadOrderOptions options;
  options.seed = request.run.seed.value_or(1);
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
  const auto loads = std::make_shared<const LoadsAnswer>(asked, request, options);
  Answer answer;
  answer.write = [format = request.output.format(), loads](OutputFile& out) {
    loads->write(format, out);
  };
  answer.output = output;
  return answer;
}

}  // namespace

void add_loadorder(Program& program) {
  auto [verb, request] = program.add<LoadOrderRequest>(
      "loadorder", "an order of loads that brings all pairs of items together", run);
  add_request_options(verb, static_cast<LoadRequest&>(request), load_table());
  request.file.add_to(verb, load_table().format);
  request.run.add_to(verb, "0s", request.output);
  request.output.add_to(verb, {"text", "jsonl", "csv"});
  verb.require([&request = request] {
    if (!request.run.memory.empty() && request.run.time.empty() && request.file.path.empty()) {
      throw UsageError{"--memory SIZE is for --time; give both"};
    }
  });
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
