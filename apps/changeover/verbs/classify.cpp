// changeover classify V K B: all designs with these parameters, up to names, rotation and reversal.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "answer/answer.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/error.hpp"
#include "changeover/search/enumeration.hpp"
#include "cli/team.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/parameters.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

constexpr std::uint64_t shown_by_default = 10;

struct ClassifyRequest {
  ParameterRequest asked;
  std::optional<std::uint64_t> blocks;
  bool reversal = false;
  bool designs = false;
  RunRequest run;
  OutputRequest output;
};

struct Classified {
  Parameters parameters;
  std::uint64_t b = 0;
  bool reversal = false;
  std::optional<std::string> impossible;
  Classification found;
  double seconds = 0;

  [[nodiscard]] bool complete() const { return found.why_stopped == WhyStopped::exhausted; }
};

// A member of a team tells the others what it found as words: counts, group orders, then classes.
std::string pack_classification(const Classification& found) {
  std::string text =
      fmt::format("{} {} {} {} {} {} {} {} {}", static_cast<unsigned>(found.why_stopped),
                  found.standard_forms, found.classes, found.tight, found.nodes, found.prefixes,
                  found.prefixes_done, found.group_orders.size(), found.kept.size());
  for (const auto& [order, classes] : found.group_orders) {
    text += fmt::format(" {} {}", order, classes);
  }
  for (const DesignClass& each : found.kept) {
    text += fmt::format(" {} {} {} {} {} {} {}", each.forms, each.group_order, each.rotations,
                        each.reflections ? 1 : 0, each.fixed, each.tight ? 1 : 0,
                        each.economical ? 1 : 0);
    text += fmt::format(" {}", each.representative.block_count());
    for (const Element x : each.representative.elements()) {
      text += fmt::format(" {}", x);
    }
  }
  return text;
}

// Adds what another member found.
void unpack_into(Classification& all, const std::string& message, const Parameters& p) {
  std::istringstream words(message);
  Classification other;
  unsigned why = 0;
  std::size_t orders = 0;
  std::size_t kept = 0;
  words >> why >> other.standard_forms >> other.classes >> other.tight >> other.nodes >>
      other.prefixes >> other.prefixes_done >> orders >> kept;
  // Who was stopped speaks for all.
  const auto reason = static_cast<WhyStopped>(why);
  all.why_stopped =
      all.why_stopped == WhyStopped::running || all.why_stopped == WhyStopped::exhausted
          ? reason
          : all.why_stopped;
  all.standard_forms += other.standard_forms;
  all.classes += other.classes;
  all.tight += other.tight;
  all.nodes += other.nodes;
  all.prefixes = std::max(all.prefixes, other.prefixes);
  all.prefixes_done += other.prefixes_done;
  for (; orders > 0; --orders) {
    std::string order;
    std::uint64_t classes = 0;
    words >> order >> classes;
    all.group_orders[order] += classes;
  }
  for (; kept > 0 && words; --kept) {
    DesignClass each{.representative = Design(p), .group_order = {}};
    std::size_t b = 0;
    words >> each.forms >> each.group_order >> each.rotations >> each.reflections >> each.fixed >>
        each.tight >> each.economical >> b;
    Block block(p.k);
    for (; b > 0 && words; --b) {
      for (Element& x : block) {
        words >> x;
      }
      each.representative.append(block);
    }
    all.kept.push_back(std::move(each));
  }
  if (words.fail()) {
    throw InternalError("a message between the processes of a team is malformed");
  }
}

Classification of_all(const Classification& mine, const Parameters& p) {
  Team& team = Team::world();
  if (team.size() == 1) {
    return mine;
  }
  Classification all;
  for (const std::string& message : team.exchange(pack_classification(mine))) {
    unpack_into(all, message, p);
  }
  return all;
}

std::string sameness(const Classified& answer) {
  std::string text = "up to relabelling";
  text += answer.parameters.kind == Kind::circular
              ? (answer.reversal ? ", rotation" : " and rotation")
              : "";
  return text + (answer.reversal ? " and reversal" : "");
}

std::string qualities(const DesignClass& each) {
  std::string text = each.tight ? ", tight" : "";
  text += each.economical ? ", economical" : "";
  return text + (each.fixed > 0 ? ", " + count_of(each.fixed, "element") + " in every block" : "");
}

std::string how_far(const Classified& answer) {
  const Classification& found = answer.found;
  if (answer.complete()) {
    return found.classes > 0 ? "these are all" : "there is none";
  }
  return fmt::format("NOT ALL: stopped ({}) {}", to_string(found.why_stopped),
                     found.prefixes == 0 ? std::string("at the beginning")
                                         : fmt::format("with {} of {} prefixes explored",
                                                       found.prefixes_done, found.prefixes));
}

std::string text(const Classified& answer) {
  const Classification& found = answer.found;
  std::string text = fmt::format("{}, {}: ", name(answer.parameters), count_of(answer.b, "block"));
  if (answer.impossible) {
    return text + fmt::format("none, for {}\n", *answer.impossible);
  }
  text += fmt::format("{} in {} {}", count_of(found.standard_forms, "standard form"),
                      count_of(found.classes, "class", "classes"), sameness(answer));
  text += found.tight > 0 ? fmt::format(", {} tight\n", found.tight) : "\n";
  text += how_far(answer);
  text += fmt::format("; {} in {:.2f} s{}\n", count_of(found.nodes, "node"), answer.seconds,
                      found.classes > 0 ? "; each design verified" : "");
  for (const auto& [order, classes] : found.group_orders) {
    text += fmt::format("group order {}: {}\n", order, count_of(classes, "class", "classes"));
  }
  std::uint64_t number = 0;
  for (const DesignClass& each : found.kept) {
    text += fmt::format("\nclass {}: {}, group order {}", ++number,
                        count_of(each.forms, "standard form"), each.group_order);
    text += each.rotations > 1 ? fmt::format(" with {} rotations", each.rotations) : "";
    text += (each.reflections ? ", its own reversal" : "") + qualities(each) + "\n";
    for (std::size_t i = 0; i < each.representative.block_count(); ++i) {
      text += fmt::format("{}\n", fmt::join(each.representative.block(i), " "));
    }
  }
  if (found.classes > found.kept.size()) {
    text += fmt::format("\n{} more; --designs shows all\n",
                        count_of(found.classes - found.kept.size(), "class", "classes"));
  }
  return text;
}

std::string json(const Classified& answer) {
  const Classification& found = answer.found;
  JsonWriter json;
  json.begin_object().cell(answer.parameters).key("b").value(answer.b);
  json.key("reversal").value(answer.reversal);
  json.key("complete").value(answer.complete()).key("stopped").value(to_string(found.why_stopped));
  json.key("reason").value(answer.impossible);
  json.key("standard_forms").value(found.standard_forms).key("classes").value(found.classes);
  json.key("tight").value(found.tight).key("nodes").value(found.nodes);
  json.key("prefixes").value(found.prefixes).key("prefixes_done").value(found.prefixes_done);
  json.key("seconds").value(answer.seconds);
  json.key("group_orders").begin_object();
  for (const auto& [order, classes] : found.group_orders) {
    json.key(order).value(classes);
  }
  json.end_object();
  json.objects("groups", found.group_orders, [&](const auto& group) {
    json.key("order").raw(group.first).key("classes").value(group.second);
  });
  json.objects("representatives", found.kept, [&](const DesignClass& each) {
    json.key("standard_forms").value(each.forms);
    json.key("group_order").value(each.group_order).key("rotations").value(each.rotations);
    json.key("own_reversal").value(each.reflections).key("fixed").value(each.fixed);
    json.key("tight").value(each.tight).key("economical").value(each.economical);
    json.key("blocks").value(each.representative.blocks());
  });
  json.end_object();
  return json.take() + "\n";
}

Answer run(const ClassifyRequest& request) {
  Classified answer{.parameters = request.asked.of_one_kind(Kind::linear),
                    .reversal = request.reversal,
                    .impossible = {},
                    .found = {}};
  const Parameters& p = answer.parameters;
  if (request.blocks == 0) {
    throw UsageError{"B is 0: a design has at least one block"};
  }
  answer.b = request.blocks ? *request.blocks : lower_bound(p).blocks;
  answer.impossible = impossibility(p);
  const auto running = std::make_shared<Running>(request.run, request.output);
  if (answer.impossible) {
    answer.found.why_stopped = WhyStopped::exhausted;
  } else {
    const std::uint64_t keep =
        request.designs ? std::numeric_limits<std::uint64_t>::max() : shown_by_default;
    const Classification mine = classify_designs(
        p, answer.b, {.reversal = request.reversal, .keep = keep}, running->control());
    running->finish();
    answer.found = of_all(mine, p);
    answer.seconds = running->control().elapsed().count();
  }
  return final_answer(
      running, text_answer(request.output.json() ? json(answer) : text(answer), request.output,
                           answer.complete() ? exit_code::done : exit_code::limit_reached));
}

}  // namespace

void add_classify(Program& program) {
  auto [verb, request] = program.add<ClassifyRequest>(
      "classify", "count and list all designs with a given number of blocks", run);
  request.asked.add_to(verb, true, linear_kind);
  verb.positional("B", request.blocks, "number of blocks (default: the lower bound)", false);
  verb.flag("--reversal", request.reversal, "a design and its reversal are the same");
  verb.flag(
      "--designs", request.designs,
      fmt::format("show a design of every class, not only of the first {}", shown_by_default));
  request.run.add_limits_to(verb, "", request.output);
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover classify 12 4 21 --change 1      2554 standard forms",
                 "changeover classify 9 4 12 --change 1 --circular --json",
                 "changeover classify 7 3 --reversal --designs -o all.txt",
                 "linear unless --circular"});
  verb.outcomes({{exit_code::done, "these are all"},
                 {exit_code::limit_reached, "stopped, by a limit or by Ctrl-C, before the end"}});
}

}  // namespace changeover::cli
