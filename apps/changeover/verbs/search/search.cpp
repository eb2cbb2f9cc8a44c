// changeover search: designs that no construction gives, and proofs that there are none.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <utility>
#include <variant>

#include "answer/design/show_design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "cli/team.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "request/output.hpp"
#include "request/parameters.hpp"
#include "request/search_request.hpp"
#include "run/grace.hpp"
#include "verbs.hpp"

namespace changeover::cli {

std::string provenance(const SearchRequest& request, const Parameters& p, const std::string& way) {
  std::string text = fmt::format("changeover {}: search {} {} --change {} --{}", version, p.v, p.k,
                                 p.change, to_string(p.kind));
  text += p.strength == 2 ? "" : fmt::format(" --strength {}", p.strength);
  text += request.blocks ? fmt::format(" --blocks {}", *request.blocks) : "";
  text += way.empty() ? "" : " " + way;
  const std::string limits = request.run.command(!way.starts_with("--exact"));
  return limits.empty() ? text : text + " " + limits;
}

Judgement judge(const SearchFind& find) {
  Judgement judgement = judge(verify(find.design), find.proved);
  if (!judgement.verdict.valid) {
    throw InternalError("a search handed out a list of blocks that is not a design");
  }
  if (find.proved && judgement.bound.name == "checked proofs") {
    judgement.from_tables = true;
    judgement.bound.name = "tables of checked proofs, not this search";
  }
  return judgement;
}

Answer none_for(const SearchRequest& request, const Parameters& p, const std::string& reason,
                const std::string& what) {
  return no_design(
      request.output, exit_code::proved_none,
      fmt::format("No {} {}{}: {}.", name(p),
                  request.blocks ? fmt::format("with {}", count_of(*request.blocks, "block"))
                                 : std::string("exists"),
                  what, reason));
}

std::optional<Answer> proved_none(const SearchRequest& request, const Parameters& p,
                                  RunControl& control, std::optional<Bound>& bound) {
  if (const auto reason = impossibility(p)) {
    return none_for(request, p, *reason);
  }
  try {
    const RunGrace grace(control, usual_grace);
    bound = lower_bound(p);
  } catch (const Stopped&) {
    bound.reset();
  }
  return bound && request.blocks && *request.blocks < bound->blocks
             ? std::optional(none_for(request, p, bound->reason))
             : std::nullopt;
}

Answer show_find(const SearchFind& find, const SearchRequest& request, int code) {
  Exhibit exhibit;
  exhibit.judgement = judge(find);
  exhibit.header = {find.design.labels(), find.design.recipe};
  exhibit.leaving = request.leaving;
  exhibit.positions = find.positions;
  exhibit.title =
      fmt::format("{}, {}: {}", name(find.design.parameters()),
                  count_of(find.design.block_count(), "block"), quality(exhibit.judgement));
  for (const std::string& line : find.lines) {
    exhibit.title += "\n" + line;
  }
  exhibit.title += "\nverified: " + exhibit.judgement.certificate;
  return show_design(find.design, std::move(exhibit), request.output, code);
}

std::string checkpoint_of(const LocalSearch& request, std::uint64_t process) {
  return process == 0 ? request.checkpoint : fmt::format("{}.{}", request.checkpoint, process);
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

// What the parser fills: all options of all ways.
struct SearchOptions : SearchRequest {
  ParameterRequest asked;
  bool exact = false;
  bool base_blocks = false;
  bool tight = false;
  std::string proof_directory;
  std::string order_file;
  std::string extend_file;
  std::string repair_file;
  std::string contains_file;
  std::string first;
  std::string last;
  bool expansion_set = false;
  bool anew = false;
  std::string checkpoint;
  std::optional<std::uint64_t> cycle_length;
  std::optional<std::uint64_t> fixed_points;
};

// The answer must not replace the state of the search, of any of the processes that share it.
void require_another_output(const LocalSearch& request) {
  if (request.checkpoint.empty() || request.output.path.empty()) {
    return;
  }
  for (std::uint64_t i = 0; i < Team::world().size(); ++i) {
    check_kept(request.output.path, {"the checkpoint", checkpoint_of(request, i)});
  }
}

using AnySearch = std::variant<LocalSearch, ExactSearch, BaseBlockSearch, OrderSearch, ExtendSearch,
                               RepairSearch, LockedSearch>;

// Who does not mark elements, or writes a list of blocks that need be no design, has fewer formats.
void require_formats(const SearchOptions& given) {
  if (given.leaving) {
    given.output.require("--leaving", formats_of_marks());
  }
  if (!given.order_file.empty() && !given.asked.change) {
    given.output.require("--order without --change", {"table", "text", "json"});
  }
}

// "0,1,5" as elements. @throws UsageError if it is no list of them.
Block elements_of(std::string_view option, std::string_view list) {
  Block elements;
  const char* at = list.data();
  const char* const end = at + list.size();
  while (at != end) {
    Element x = 0;
    const auto [rest, failure] = std::from_chars(at, end, x);
    if (failure != std::errc() || (rest != end && (*rest != ',' || rest + 1 == end))) {
      throw UsageError{fmt::format("{}: '{}' is not a list of elements; write it as 0,1,2", option,
                                   printable(list))};
    }
    elements.push_back(x);
    at = rest == end ? end : rest + 1;
  }
  return elements;
}

// What the design must have besides, so far as the options say it.
WantedRequest wanted_of(const SearchOptions& given, const Parameters& p) {
  WantedRequest request{
      {elements_of("--first", given.first), elements_of("--last", given.last), given.expansion_set},
      given.contains_file,
      given.asked.reading(),
      given.anew};
  if (const std::string defect = wanted_defect(p, request.wanted); !defect.empty()) {
    throw UsageError{fmt::format("no {} can have what you ask for: {}", name(p), defect)};
  }
  return request;
}

// The way that was chosen, with what it knows.
AnySearch chosen(const SearchOptions& given) {
  const SearchRequest& shared = given;
  require_formats(given);
  if (!given.order_file.empty()) {
    if (given.asked.v || given.asked.k) {
      throw UsageError{"--order takes V and K from the file; leave them out"};
    }
    return OrderSearch{shared, given.order_file, given.asked.kind.value_or(Kind::linear),
                       given.asked.change};
  }
  if (!given.extend_file.empty()) {
    return ExtendSearch{shared, given.extend_file, given.asked.reading()};
  }
  if (!given.repair_file.empty()) {
    return RepairSearch{shared, given.repair_file, given.asked.reading()};
  }
  const Parameters p = given.asked.of_one_kind(given.base_blocks ? Kind::circular : Kind::linear);
  if (const auto defect = format_defect(p, 1, given.output.format())) {
    throw UsageError{*defect};  // However few blocks are found.
  }
  if (given.blocks == 0) {
    throw UsageError{"--blocks 0: a design has at least one block"};
  }
  if (given.exact) {
    return ExactSearch{shared, wanted_of(given, p), p, given.proof_directory};
  }
  if (given.base_blocks) {
    BaseBlockOptions options;
    options.shapes.n = given.cycle_length;
    options.shapes.fixed = given.fixed_points;
    options.shapes.tight = given.tight;
    options.shapes.most_blocks = given.blocks;
    options.rounds = 20;  // as long as there is time
    return BaseBlockSearch{shared, p, options};
  }
  const WantedRequest wanted = wanted_of(given, p);
  if (wanted.wanted.any() || !wanted.contains_file.empty()) {
    if (p.strength != 2) {
      throw UsageError{fmt::format(
          "--strength {}: local search keeps what is wanted for strength 2 only; give --exact, too",
          p.strength)};
    }
    return LockedSearch{shared, wanted, p};
  }
  LocalSearch local{shared, p, given.checkpoint};
  require_file("--checkpoint", local.checkpoint, "it is read and replaced");
  require_another_output(local);
  return local;
}

Answer run(const SearchOptions& given) {
  const AnySearch request = chosen(given);
  const bool shared =
      std::holds_alternative<LocalSearch>(request) || std::holds_alternative<ExactSearch>(request);
  if (!shared && Team::world().size() > 1) {
    throw UsageError{
        "several processes share local search and --exact only; run this without mpirun"};
  }
  check_inputs(given.output, {{"--order", given.order_file},
                              {"--extend", given.extend_file},
                              {"--repair", given.repair_file},
                              {"--contains", given.contains_file}});
  return std::visit([](const auto& one) { return search(one); }, request);
}

}  // namespace

void add_search(Program& program) {
  auto [verb, request] = program.add<SearchOptions>(
      "search", "search for designs with fewer blocks, or prove that there are none", run);
  request.asked.add_to(verb, false, linear_kind);
  request.asked.add_strength_to(verb);
  verb.option("-b,--blocks", request.blocks, "B",
              "the number of blocks wanted (default: as few as possible)");
  verb.flag("--exact", request.exact,
            "decide by a SAT solver: every number of blocks is found or excluded with a proof");
  verb.option("--proof", request.proof_directory, "DIR",
              "keep formulas and proofs of --exact in DIR");
  verb.flag("--base-blocks", request.base_blocks,
            "search for circular designs made from base blocks");
  verb.option("--cycle", request.cycle_length, "N",
              "length of the automorphism's cycles (default: all that fit)");
  verb.option("--fixed-points", request.fixed_points, "F",
              "number of fixed points of the automorphism (default: 0, 1 and 2)");
  verb.flag("--tight", request.tight, "with --base-blocks: tight designs only");
  verb.option(
      "--order", request.order_file, "FILE",
      "put the blocks of FILE in order: M changes at every step, or without -m the fewest in all");
  verb.option("--extend", request.extend_file, "FILE",
              "keep the blocks of FILE, add missing blocks");
  verb.option("--repair", request.repair_file, "FILE",
              "make a design of the blocks of FILE, changing little");
  verb.option("--first", request.first, "A,B,...", "these elements are in the first block");
  verb.option("--last", request.last, "A,B,...", "these elements are in the last block");
  verb.flag("--expansion-set", request.expansion_set,
            "require unchanged subsets that together hold every other element once");
  verb.option("--contains", request.contains_file, "FILE",
              "the blocks of FILE are consecutive blocks of the design");
  verb.flag("--anew", request.anew, "begin with no known design");
  verb.option("--checkpoint", request.checkpoint, "FILE",
              "keep the state of a local search in FILE, and go on from it if it is there");
  verb.flag("--leaving", request.leaving, "mark leaving elements too, in tables and LaTeX");
  request.run.add_to(verb, "60s", request.output);
  request.output.add_to(verb, design_formats());
  const std::vector<std::string> ways{"--exact", "--base-blocks", "--order", "--extend",
                                      "--repair"};
  verb.exclude(ways);
  verb.only_with({"--proof"}, {"--exact"});
  verb.only_with({"--tight", "--cycle", "--fixed-points"}, {"--base-blocks"});
  verb.never_with({"--checkpoint"}, ways);
  const std::vector<std::string> wanted{"--first", "--last", "--expansion-set", "--contains"};
  verb.never_with(wanted, {"--order", "--extend", "--repair", "--checkpoint"});
  verb.never_with({"--first"}, {"--base-blocks"}, "a development has no first block");
  verb.never_with({"--last"}, {"--base-blocks"}, "a development has no last block");
  verb.not_served_with({"--contains"}, {"--base-blocks"},
                       "which makes all blocks from a few base blocks");
  verb.not_served_with({"--expansion-set"}, {"--base-blocks"},
                       "which makes all blocks from a few base blocks");
  verb.only_with({"--anew"}, {"--first", "--last", "--expansion-set", "--contains", "--exact"});
  verb.never_with({"--blocks"}, {"--order", "--repair"});
  verb.never_with({"--strength"}, {"--order"});
  verb.never_with({"--seed"}, {"--exact"});
  verb.examples(
      {"changeover search 20 5                           local search for 60 seconds",
       "changeover search 9 5 --linear --exact           the minimum, with proof",
       "changeover search 8 5 --blocks 9 --exact --proof proofs",
       "changeover search 6 3 -m 1 --exact --first 0,1 --last 0,1",
       "changeover search 28 6 --base-blocks --tight     from base blocks",
       "changeover search 20 5 -m 1 --first 0,1,2,3 --expansion-set --blocks 46",
       "changeover search --order blocks.txt -m 2        an order with 2 changes per step",
       "mpirun -n 4 changeover search 30 6 --time 10m    several processes share it"});
  verb.outcomes(
      {{exit_code::found, "found"},
       {exit_code::proved_none, "proved that there is none"},
       {exit_code::limit_reached, "stopped, by a limit or by Ctrl-C, before that was known"}});
}

}  // namespace changeover::cli
