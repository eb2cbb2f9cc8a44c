// changeover search V K --exact: the minimum, or whether there is a design with B blocks, with
// proofs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <utility>

#include "answer/answer.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/exact.hpp"
#include "cli/team.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/search_request.hpp"

namespace changeover::cli {
namespace {

std::string seconds(std::chrono::duration<double> time) {
  return fmt::format("{:.{}f} s", time.count(), time.count() < 10 ? 2 : 0);
}

std::string bytes(std::uint64_t count) {
  constexpr double kilo = 1000;
  const auto number = static_cast<double>(count);
  return number < kilo          ? fmt::format("{}", count_of(count, "byte"))
         : number < kilo * kilo ? fmt::format("{:.1f} kB", number / kilo)
                                : fmt::format("{:.1f} MB", number / kilo / kilo);
}

// "9 blocks: none; DRAT proof of 12.3 kB in linear-m1-v9-k4-b11.drat, checked; 0.12 s"
std::string line_of(const Decision& step, const Wanted& wanted) {
  std::string line = count_of(step.b, "block") + ": ";
  if (step.outcome == Outcome::found) {
    line += "found";
  } else if (step.excluded()) {
    const std::uint64_t total = sum_of(step.parts, &CheckedPart::proof_bytes);
    line += "none" + wanted_words(wanted) + "; " +
            (step.parts.size() == 1 ? fmt::format("DRAT proof of {}, checked", bytes(total))
                                    : fmt::format("{} DRAT proofs of {} together, checked",
                                                  step.parts.size(), bytes(total)));
    if (step.parts.size() == 1 && !step.parts.front().proof_path.empty()) {
      line += ": " + printable(step.parts.front().proof_path);
    } else if (!step.cubes_path.empty()) {
      line += ": " + printable(step.cubes_path);
    }
  } else {
    line += fmt::format("not decided ({})", to_string(step.why_stopped));
  }
  return line + "; " + seconds(step.time);
}

// What shows that there is none with fewer blocks.
std::string proof_of(const MinimumResult& result, const Wanted& wanted) {
  std::string text =
      fmt::format("at least {}: {}", count_of(result.start.blocks, "block"), result.start.reason);
  for (const Decision& step : result.steps) {
    if (step.excluded()) {
      text += "; " + line_of(step, wanted);
    }
  }
  return text;
}

// What constructions give, as a start from above; nothing if there is no time to look. What is too
// long to be handled quickly is left to changeover design.
std::optional<Offer> known_offer(const Parameters& p, std::uint64_t least) try {
  constexpr std::uint64_t most_elements = 20'000'000;
  if (p.strength != 2 || least > most_elements / p.k) {
    return std::nullopt;
  }
  auto offer = best_known(p);
  return offer && offer->b <= most_elements / p.k ? offer : std::nullopt;
} catch (const Stopped&) {
  return std::nullopt;
}

std::optional<Design> design_of(const std::optional<Offer>& offer) try {
  if (!offer) {
    return std::nullopt;
  }
  Design design = Registry::standard().build_design(offer->recipe);
  design.recipe = offer->recipe;
  return design;
} catch (const Stopped&) {
  return std::nullopt;
}

// The minimum, from what is known. A formula that is too large is refused before anything else is
// done, unless none is needed.
MinimumResult minimum(const Parameters& p, const MinimumOptions& options, RunControl& control) {
  std::optional<Offer> offer;
  if (options.from_known && !options.exact.wanted.any() && !impossibility(p)) {
    const std::uint64_t least = lower_bound_on_paper(p).blocks;
    try {
      (void)require_room(p, least, options.exact, control);
      offer = known_offer(p, least);
    } catch (const MissingResource&) {
      offer = known_offer(p, least);
      if (!offer || offer->b != least) {
        throw;
      }
    } catch (const Stopped&) {
      // find_minimum() says so
    }
  }
  return find_minimum(p, options, control, design_of(offer));
}

// In front of what a member lacks, where its answer would be.
const std::string missing_answer = "missing: ";

// One question, shared by the team: each member takes its cubes. All return the same answer.
Decision decide_together(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                         RunControl& control) {
  Team& team = Team::world();
  if (team.size() == 1) {
    return decide(p, b, options, control);
  }
  Decision own;
  std::string missing;
  try {
    own = decide(p, b, options, control);
  } catch (const MissingResource& fault) {
    missing = fault.what();  // said to all, so that all end together
  }
  if (own.outcome == Outcome::found) {
    team.announce();
  }
  // The answer, the bytes of each proof, and the design if there is one.
  std::string message =
      (missing.empty() ? std::string(to_string(own.outcome)) : missing_answer + missing) + "\n";
  for (const CheckedPart& part : own.parts) {
    message += fmt::format("{} ", part.proof_bytes);
  }
  message += "\n" + (own.design ? pack(*own.design) : std::string()) + "\n";
  for (const UnchangedSubset& subset : own.subsets) {
    message += fmt::format("{} ", subset.position);
  }
  own.parts.clear();
  bool none = true;
  std::optional<Design> design;
  std::vector<std::size_t> positions;
  for (const std::string& said : team.exchange(message)) {
    std::istringstream lines(said);
    std::string answer;
    std::string proofs;
    std::string blocks;
    std::getline(lines, answer);
    std::getline(lines, proofs);
    std::getline(lines, blocks);
    none = none && answer == to_string(Outcome::none);
    if (answer.starts_with(missing_answer)) {
      missing = answer.substr(missing_answer.size());
    }
    if (answer == to_string(Outcome::found) && !design) {
      design = unpack(p, blocks);
      for (std::size_t position = 0; lines >> position;) {
        positions.push_back(position);
      }
    }
    std::istringstream sizes(proofs);
    for (std::uint64_t size = 0; sizes >> size;) {
      own.parts.emplace_back().proof_bytes = size;
    }
  }
  if (!missing.empty() && !design) {
    throw MissingResource(missing);
  }
  if (design) {
    // That it was found elsewhere has ended this search, but what was found is verified here, too.
    RunControl unhurried({});
    const RunScope scope(unhurried);
    own.parameters = p;
    own.b = b;
    own.design = surely_verified(*std::move(design), "what another process found");
    auto subsets = parts_as_wanted(*own.design, options.wanted, positions);
    if (!subsets) {
      throw InternalError("what another process found has not what is wanted");
    }
    own.subsets = *std::move(subsets);
    own.outcome = Outcome::found;
    own.why_stopped = WhyStopped::found;
  } else if (none) {
    own.outcome = Outcome::none;
    own.proved = true;
    own.in_share = false;
    own.why_stopped = WhyStopped::exhausted;
  } else {
    own.outcome = Outcome::unknown;
  }
  return own;
}

// Found with as few blocks as wanted; none; or not known.
int exit_code_of(const ExactSearch& request, const MinimumResult& result) {
  if (result.impossible) {
    return exit_code::proved_none;
  }
  if (request.blocks) {
    const Decision& step = result.steps.front();
    return step.outcome == Outcome::found ? exit_code::found
           : step.excluded()              ? exit_code::proved_none
                                          : exit_code::limit_reached;
  }
  return result.settled() ? exit_code::found : exit_code::limit_reached;
}

// The bound that the steps prove, or from which they start.
Bound proved_by(const MinimumResult& result) {
  return result.lower > result.start.blocks
             ? Bound{result.lower, "proved by this search", proof_of(result, {})}
             : result.start;
}

void write(JsonWriter& json, const Wanted& wanted, const std::vector<UnchangedSubset>& subsets) {
  json.key("wanted").begin_object().key("first").value(wanted.first);
  json.key("last").value(wanted.last).key("expansion_set").value(wanted.expansion_set);
  json.key("contains").value(wanted.contained).end_object();
  json.key("positions").value(positions_of(subsets));
}

std::string to_json(const MinimumResult& result, const std::optional<SearchFind>& find,
                    bool settled, const Wanted& wanted) {
  const Parameters& p = result.parameters;
  JsonWriter json;
  json.begin_object().cell(p).key("strength").value(p.strength);
  if (wanted.any()) {
    write(json, wanted, result.subsets);
  }
  if (result.impossible) {
    json.key("impossible").value(*result.impossible);
  } else if (settled) {
    // What is the fewest with what is wanted need not be the minimum of all.
    json.key(wanted.any() ? "fewest_as_wanted" : "minimum").value(result.lower);
    json.key("proof").value(proof_of(result, wanted));
  } else {
    json.key("lower_bound").value(result.lower).key("upper_bound").value(result.upper());
    json.key("why_stopped").value(to_string(result.why_stopped));
  }
  if (find) {
    const Judgement judgement = judge(*find);
    json.key("verdict").raw(verdict_to_json(judgement.verdict)).key("bound").begin_object();
    json.key("name").value(judgement.bound.name).key("reason").value(judgement.bound.reason);
    json.end_object().key("blocks").value(find->design.blocks());
  }
  json.objects("steps", result.steps, [&](const Decision& step) {
    json.key("blocks").value(step.b).key("answer").value(to_string(step.outcome));
    json.key("seconds").value(step.time.count());
    json.objects("proofs", step.parts, [&](const CheckedPart& part) {
      json.key("cnf").value(part.cnf_path).key("drat").value(part.proof_path);
      json.key("variables").value(part.variables).key("clauses").value(part.clauses);
      json.key("proof_bytes").value(part.proof_bytes).key("proof_steps").value(part.proof_steps);
    });
  });
  json.end_object();
  return json.take();
}

// What the steps come to. `words` say what is wanted besides.
std::string conclusion(const MinimumResult& result, bool settled, const std::string& words) {
  const std::string fewest = count_of(result.lower, "block");
  if (settled) {
    return words.empty()
               ? fmt::format("The minimum is {}: fewer are excluded by the lines above.", fewest)
               : fmt::format("No {}{} has fewer than {}: fewer are excluded by the lines above.",
                             name(result.parameters), words, fewest);
  }
  const std::string most =
      result.upper() ? fmt::format(" and at most {}", *result.upper()) : std::string();
  return words.empty() ? fmt::format("The minimum is at least {}{}; stopped: {}.", result.lower,
                                     most, to_string(result.why_stopped))
                       : fmt::format("The fewest blocks of a {}{} are at least {}{}; stopped: {}.",
                                     name(result.parameters), words, result.lower, most,
                                     to_string(result.why_stopped));
}

Answer answer_of(const ExactSearch& request, const MinimumResult& result) {
  const Wanted& wanted = request.wanted;
  const Parameters& p = result.parameters;
  const int code = exit_code_of(request, result);
  const bool settled = !request.blocks && result.settled();
  std::vector<std::string> lines;
  lines.push_back(result.impossible
                      ? fmt::format("No {} exists: {}.", name(p), *result.impossible)
                      : fmt::format("at least {}: {}", count_of(result.start.blocks, "block"),
                                    result.start.reason));
  for (const Decision& step : result.steps) {
    lines.push_back(line_of(step, wanted));
  }
  if (settled || (!request.blocks && !result.impossible)) {
    lines.push_back(conclusion(result, settled, wanted_words(wanted)));
  }
  std::ranges::move(lines_as_wanted(wanted, result.known, result.subsets),
                    std::back_inserter(lines));
  std::optional<SearchFind> find;
  if (result.best) {
    find = SearchFind{*result.best, lines};
    if (!wanted.any()) {  // Else the steps say nothing about designs that lack it.
      find->proved = proved_by(result);
    }
    find->positions = positions_of(result.subsets);
  }
  if (find && !request.output.json()) {
    return show_find(*find, request, code);
  }
  const std::string json = to_json(result, find, settled, wanted);
  return find ? text_answer(json + "\n", request.output, code)
              : no_design(request.output, code, fmt::format("{}", fmt::join(lines, "\n")), json);
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// For readers who find the proofs without the program: what each file says and how to check it.
void explain_proofs(const ExactSearch& request, const MinimumResult& result) {
  const Parameters& p = result.parameters;
  const std::string words = wanted_words(request.wanted);
  std::string files;
  for (const Decision& step : result.steps) {
    if (!step.excluded()) {
      continue;
    }
    files += fmt::format("## No {} with {}{}\n\n", name(p), count_of(step.b, "block"), words);
    if (!step.cubes_path.empty()) {
      files += fmt::format(
          "The question is split into {}, listed in `{}`; there is a formula and a proof for "
          "each. The cubes leave no case out if their negations, as clauses, have no solution.\n\n",
          count_of(step.cubes, "cube"), file_name(step.cubes_path));
    }
    files += "| formula | variables | clauses | proof | bytes |\n|:---|---:|---:|:---|---:|\n";
    for (const CheckedPart& part : step.parts) {
      if (part.cnf_path.empty()) {
        continue;  // Another process of the team wrote it.
      }
      files += fmt::format("| {} | {} | {} | {} | {} |\n", file_name(part.cnf_path), part.variables,
                           part.clauses, file_name(part.proof_path), part.proof_bytes);
    }
    files += "\n";
  }
  if (files.empty()) {
    return;
  }
  // A number of blocks that was asked for has its own file.
  const std::filesystem::path file = std::filesystem::path(request.proof_directory) /
                                     (file_stem(p, request.blocks, request.wanted) + "-README.md");
  write_file(file.string(), [&](OutputFile& out) {
    out.write(fmt::format(
        "# Proofs about the {}{}\n\nWritten by changeover {}. At least {}: {}\n\nEach formula "
        "(DIMACS, `.cnf`) says that there is such a design with so many blocks: variable v*i + e + "
        "1 says that block i holds element e, both from 0. Each proof (DRAT, `.drat`) shows that "
        "the formula has no solution. Both are text. Any DRAT checker reads them:\n\n"
        "    drat-trim NAME.cnf NAME.drat\n\nprints `s VERIFIED`. The program's own checker has "
        "checked them, too. What has to be trusted is that the formula says what it should, and "
        "the bound above.\n\n{}",
        name(p), words, version, count_of(result.start.blocks, "block"), result.start.reason,
        files));
  });
}

}  // namespace

Answer search(const ExactSearch& asked) {
  ExactSearch request = asked;
  const Parameters& p = request.parameters;
  request.wanted = asked.read(p);
  if (const std::string defect = wanted_defect(p, request.wanted); !defect.empty()) {
    throw BadInput(defect);
  }
  ExactOptions options;
  options.wanted = request.wanted;
  options.proof_directory = request.proof_directory;
  const auto running = std::make_shared<Running>(request.run, request.output);
  const std::string rest = way_of(request.wanted, request.anew);
  const std::string way = "--exact" + (rest.empty() ? "" : " " + rest);
  const auto decider = [&](std::uint64_t b, const ExactOptions& exact) {
    Decision decision = decide_together(p, b, exact, running->control());
    if (decision.design) {
      decision.design->set_recipe(literal_recipe(*decision.design, provenance(request, p, way)));
    }
    return decision;
  };

  if (request.blocks && !impossibility(p)) {
    // More blocks given than there may be need no formula.
    const Bound given = wanted_bound(p, {.contained = request.wanted.contained}, Bound());
    if (*request.blocks < given.blocks) {
      return final_answer(running, none_for(request, p, given.reason, " has what is wanted"));
    }
  }
  MinimumResult result;
  if (request.blocks && !impossibility(p)) {
    result.parameters = p;
    result.start = wanted_bound(p, request.wanted, lower_bound_on_paper(p));
    result.lower = result.start.blocks;
    result.steps.push_back(decider(*request.blocks, options));
    result.best = result.steps.back().design;
    result.subsets = result.steps.back().subsets;
    result.why_stopped = result.steps.back().why_stopped;
  } else {
    const RunScope scope(running->control());
    result = minimum(
        p, {.exact = options, .tries_above = 0, .decider = decider, .from_known = !request.anew},
        running->control());
  }
  running->finish();
  Answer answer = answer_of(request, result);
  answer.fault = result.fault;
  if (!request.proof_directory.empty() && Team::world().first()) {
    try {
      explain_proofs(request, result);
    } catch (const MissingResource&) {  // The answer is worth more.
      answer.fault = answer.fault ? answer.fault : std::current_exception();
    }
  }
  return final_answer(running, std::move(answer));
}

}  // namespace changeover::cli
