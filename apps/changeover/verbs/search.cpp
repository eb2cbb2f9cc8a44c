// changeover search: designs that no construction gives, and proofs that there are none.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <filesystem>

#include "answer/show_design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "cli/team.hpp"
#include "io/write/json_writer.hpp"
#include "request/input_files.hpp"
#include "request/search_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {

Parameters SearchRequest::parameters(Kind kind_by_default) const {
  if (!v || !k) {
    throw UsageError{"give V and K, the number of elements and of those in a block"};
  }
  if (circular && linear) {
    throw UsageError{"--circular and --linear exclude each other"};
  }
  Parameters p{.v = *v,
               .k = *k,
               .change = change.value_or(2),
               .kind = circular ? Kind::circular
                       : linear ? Kind::linear
                                : kind_by_default,
               .strength = 2};
  if (strength) {
    if (*strength < 2 || *strength > max_strength) {
      throw UsageError{
          fmt::format("--strength {} is out of range; give 2 to {}", *strength, max_strength)};
    }
    p.strength = static_cast<std::uint32_t>(*strength);
  }
  check(p);
  if (blocks == 0) {
    throw UsageError{"--blocks 0: a design has at least one block"};
  }
  return p;
}

std::string SearchRequest::provenance(const Parameters& p, const std::string& options) const {
  std::string text = fmt::format("changeover {}: search {} {} --change {} --{}", version, p.v, p.k,
                                 p.change, to_string(p.kind));
  text += p.strength == 2 ? "" : fmt::format(" --strength {}", p.strength);
  text += blocks ? fmt::format(" --blocks {}", *blocks) : "";
  text += options.empty() ? "" : " " + options;
  return text + " " + run.command();
}

void show_find(const SearchFind& find, const SearchRequest& request) {
  Exhibit exhibit;
  exhibit.judgement = judge(verify(find.design), find.proved);
  if (!exhibit.judgement.verdict.valid) {
    throw InternalError("a search handed out a list of blocks that is no design");
  }
  exhibit.header.labels = find.design.labels();
  exhibit.header.recipe = find.design.recipe;
  exhibit.leaving = request.leaving;
  exhibit.title =
      fmt::format("{}, {}: {}", name(find.design.parameters()),
                  count_of(find.design.block_count(), "block"), quality(exhibit.judgement));
  for (const std::string& line : find.lines) {
    exhibit.title += "\n" + line;
  }
  exhibit.title += "\nverified: " + exhibit.judgement.certificate;
  DesignSource source(find.design);
  show_design(source, exhibit, request.output);
}

std::string checkpoint_of(const SearchRequest& request, std::uint64_t process) {
  return process == 0 ? request.checkpoint : fmt::format("{}.{}", request.checkpoint, process);
}

void show_none(const SearchRequest& request, const std::string& words, const std::string& json) {
  if (request.output.chosen() == "json") {
    deliver(json + "\n", request.output);
  } else {
    deliver(words + "\n", request.output.words());
  }
}

void show_none(const SearchRequest& request, const std::string& words) {
  JsonWriter json;
  json.begin_object().key("found").value(false).key("explanation").value(words).end_object();
  show_none(request, words, json.take());
}

std::string pack(const Design& design) {
  return fmt::format("{}", fmt::join(design.elements(), " "));
}

Design unpack(const Parameters& p, std::string_view message) {
  Design design(p);
  Block block;
  const char* at = message.data();
  const char* const end = at + message.size();
  while (at != end) {
    Element x = 0;
    const auto [rest, failure] = std::from_chars(at, end, x);
    if (failure != std::errc()) {
      throw InternalError("a message from another process is damaged");
    }
    block.push_back(x);
    if (block.size() == p.k) {
      design.append(block);
      block.clear();
    }
    at = rest == end ? end : rest + 1;
  }
  return design;
}

namespace {

// The file that a path names when it is written: links are followed, also to where nothing is yet.
std::filesystem::path written_file(std::filesystem::path path) {
  constexpr int most_links = 40;
  std::error_code ignored;
  for (int links = 0; links < most_links && std::filesystem::is_symlink(path, ignored); ++links) {
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::filesystem::path real = std::filesystem::weakly_canonical(folder, ignored);
  return (real.empty() ? folder : real) / path.filename();
}

bool same_file(const std::string& one, const std::string& other) {
  std::error_code ignored;
  return std::filesystem::equivalent(one, other, ignored) ||
         written_file(one) == written_file(other);
}

// The answer must not replace the state of the search, of any of the processes that share it.
void require_another_output(const SearchRequest& request) {
  const std::string& output = request.output.path;
  if (request.checkpoint.empty() || output.empty() || output == "-") {
    return;
  }
  for (std::uint64_t i = 0; i < Team::world().size(); ++i) {
    const std::string state = checkpoint_of(request, i);
    if (same_file(output, state) || same_file(output, state + ".lock")) {
      throw UsageError{fmt::format(
          "-o {} would replace the checkpoint {}; give the answer another file", output, state)};
    }
  }
}

// Options that only one way of searching knows.
void require_the_right_way(const SearchRequest& request, int ways) {
  if (request.checkpoint == "-") {
    throw UsageError{"--checkpoint -: it is read and replaced; name a file"};
  }
  if (!request.proof_directory.empty() && !request.exact) {
    throw UsageError{"--proof DIR keeps the proofs of --exact; give both"};
  }
  if (!request.base_blocks) {
    const char* const option = request.tight          ? "--tight"
                               : request.cycle_length ? "--cycle N"
                               : request.fixed_points ? "--fixed-points F"
                                                      : nullptr;
    if (option != nullptr) {
      throw UsageError{fmt::format("{} is for --base-blocks; give both", option)};
    }
  }
  if (!request.checkpoint.empty() && ways > 0) {
    throw UsageError{"--checkpoint FILE is for local search; other ways keep no state"};
  }
  if (request.blocks && (!request.order_file.empty() || !request.repair_file.empty())) {
    throw UsageError{"--blocks B has no meaning with --order and --repair; leave it out"};
  }
}

int run(const SearchRequest& request) {
  const int ways = (request.exact ? 1 : 0) + (request.base_blocks ? 1 : 0) +
                   (request.order_file.empty() ? 0 : 1) + (request.extend_file.empty() ? 0 : 1) +
                   (request.repair_file.empty() ? 0 : 1);
  if (ways > 1) {
    throw UsageError{"--exact, --base-blocks, --order, --extend and --repair exclude each other"};
  }
  if (ways > 0 && !request.exact && Team::world().size() > 1) {
    throw UsageError{
        "several processes share local search and --exact only; run this without mpirun"};
  }
  require_the_right_way(request, ways);
  require_another_output(request);
  if (request.exact) {
    return search_exactly(request);
  }
  if (request.base_blocks) {
    return search_base_blocks(request);
  }
  refuse_to_overwrite_inputs(request.output.path, {{"--order", request.order_file},
                                                   {"--extend", request.extend_file},
                                                   {"--repair", request.repair_file}});
  if (!request.repair_file.empty()) {
    return search_repair(request);
  }
  if (!request.extend_file.empty()) {
    return search_extend(request);
  }
  return request.order_file.empty() ? search_locally(request) : search_order(request);
}

}  // namespace

void add_search(Program& program) {
  auto request = std::make_shared<SearchRequest>();
  Verb& verb = program.add("search", "designs with fewer blocks, or a proof that there are none");
  verb.positional("V", request->v, "number of elements");
  verb.positional("K", request->k, "elements in a block");
  verb.option("-m,--change", request->change, "M",
              "elements in which consecutive blocks differ (default 2)");
  verb.flag("--circular", request->circular, "the last and the first block are consecutive too");
  verb.flag("--linear", request->linear, "they need not be (default)");
  verb.option("-t,--strength", request->strength, "T",
              "cover every T-subset of the elements (default 2)");
  verb.option("-b,--blocks", request->blocks, "B",
              "the number of blocks wanted (default: as few as possible)");
  verb.flag("--exact", request->exact,
            "decide by a SAT solver: every number of blocks is found or excluded with a proof");
  verb.option("--proof", request->proof_directory, "DIR",
              "keep formulas and proofs of --exact in DIR");
  verb.flag("--base-blocks", request->base_blocks,
            "circular designs with an automorphism, from base blocks");
  verb.option("--cycle", request->cycle_length, "N", "of the automorphism (default: all that fit)");
  verb.option("--fixed-points", request->fixed_points, "F",
              "of the automorphism (default: 0, 1 and 2)");
  verb.flag("--tight", request->tight, "with --base-blocks: tight designs only");
  verb.option(
      "--order", request->order_file, "FILE",
      "put the blocks of FILE in order: M changes at every step, or without -m the fewest in all");
  verb.option("--extend", request->extend_file, "FILE", "keep the blocks of FILE, add what lacks");
  verb.option("--repair", request->repair_file, "FILE",
              "make a design of the blocks of FILE, changing little");
  verb.option("--checkpoint", request->checkpoint, "FILE",
              "keep the state of a local search in FILE, and go on from it if it is there");
  verb.flag("--leaving", request->leaving, "mark leaving elements too, in tables and LaTeX");
  request->run.add_to(verb, "60s", request->output);
  request->output.add_to(verb, design_formats());
  verb.examples({"changeover search 20 5                           local search for 60 seconds",
                 "changeover search 9 4 --change 1 --exact         the minimum, with proof",
                 "changeover search 8 5 --blocks 9 --exact --proof proofs",
                 "changeover search 28 6 --base-blocks --tight     from base blocks",
                 "changeover search --order blocks.txt --change 2 an order with 2 changes a step",
                 "mpirun -n 4 changeover search 30 6 --time 10m    several processes share it"});
  verb.run([request] { return run(*request); });
}

}  // namespace changeover::cli
