// changeover loadorder: loads and evictions after which every pair of items has been in memory
// together.
#include <functional>
#include <memory>

#include "changeover/loadorder/load_request.hpp"
#include "cli/status_line.hpp"
#include "core/printable.hpp"
#include "loadorder/order/searched.hpp"
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

Answer run(const LoadOrderRequest& typed) {
  RunRequest run = typed.run;
  LoadRequest request =
      whole_request(typed.load, run, load_table(), typed.file, typed.output, load_request);
  take_memory_of_items(request, run);
  const std::string format = typed.output.format();
  // These formats are of the pairs of steps, which prefetch does not have.
  const bool of_pairs = format == "marius" || format == "colmap";
  request.new_pairs = request.new_pairs || (of_pairs && !request.prefetch);
  check_options(request, Door::command_line);
  OutputRequest output = typed.output;
  output.precious = false;  // Without a search the same command makes it again.
  if (typed.file.show) {
    return text_answer(to_json(request), output);
  }
  const CheckedLoads asked = checked_loads(request, Door::command_line);
  check_format(asked, format);
  output.check_writable();
  for (const std::string& note : asked.notes()) {
    status_line().say("changeover: " + printable(note));
  }
  LoadOrderOptions options;
  options.seed = request.seed.value_or(1);
  if (const double seconds = run.settings().time->count(); seconds > 0) {
    // The time is for the searches alone.
    options = searched(seconds, options.seed, [&](const std::function<void(RunControl&)>& search) {
      output.precious = true;
      Running running(run, typed.output);
      search(running.control());
    });
  }
  // Made now, so that what cannot be is said before anything is written.
  const auto loads = std::make_shared<const LoadsAnswer>(asked, options);
  Answer answer;
  answer.write = [format, loads](OutputFile& out) { loads->write(format, out); };
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
