// changeover same A B: are two designs the same up to names, rotation and reversal.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "changeover/io/input.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/output.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct SameRequest {
  std::string one;
  std::string other;
  std::optional<Kind> kind;
  bool reversal = false;
  OutputRequest output;
};

std::string shape(const Design& design) {
  return fmt::format("{}, {}", name(design.parameters()), count_of(design.block_count(), "block"));
}

struct Comparison {
  std::optional<Isomorphism> map;
  std::string group_order;                // of the first design
  std::optional<bool> same_block_system;  // if the shapes agree and the designs differ
};

Comparison compare(const Design& one, const Design& other, const Sameness& same) {
  Comparison answer;
  answer.map = find_isomorphism(one, other, same);
  answer.group_order = automorphisms(one, same).order;
  if (!answer.map && one.v() == other.v() && one.k() == other.k() &&
      one.block_count() == other.block_count()) {
    answer.same_block_system = block_system(one).blocks == block_system(other).blocks;
  }
  return answer;
}

std::string text(const Comparison& answer, const Design& one, const Design& other) {
  if (!answer.map) {
    std::string text = "not the same\n";
    if (!answer.same_block_system || one.parameters().kind != other.parameters().kind) {
      text += fmt::format("one is {}, the other {}\n", shape(one), shape(other));
    }
    if (answer.same_block_system) {
      text += *answer.same_block_system
                  ? "without their order the blocks are the same up to relabelling\n"
                  : "even without their order the blocks differ\n";
    }
    return text;
  }
  const std::size_t b = one.block_count();
  std::string text = "the same: " + shape(one) + "\n";
  if (b > 0) {
    text += fmt::format("block 1 of the first is block {} of the second{}\n",
                        position(*answer.map, 0, b) + 1,
                        answer.map->reversed ? ", which is read backwards" : "");
  }
  for (Element x = 0; x < one.v(); ++x) {
    text += fmt::format("{} -> {}\n", one.label(x), other.label(answer.map->elements[x]));
  }
  return text + fmt::format("automorphisms: {}\n", answer.group_order);
}

std::string json(const Comparison& answer, const Design& one, const Design& other) {
  JsonWriter json;
  json.begin_object().key("same").value(answer.map.has_value());
  if (answer.map) {
    json.key("shift").value(answer.map->shift).key("reversed").value(answer.map->reversed);
    json.key("elements").begin_object();
    for (Element x = 0; x < one.v(); ++x) {
      json.key(one.label(x)).value(other.label(answer.map->elements[x]));
    }
    json.end_object();
  }
  json.key("same_blocks_in_any_order");
  answer.map ? json.value(true) : json.value(answer.same_block_system);
  json.key("group_order").value(answer.group_order).end_object();
  return json.take() + "\n";
}

Answer run(const SameRequest& request) {
  check_inputs(request.output, {{"A", request.one}, {"B", request.other}});
  ReadOptions options;
  options.kind = request.kind;
  const Design one = read_design(request.one, options);
  const Design other = read_design(request.other, options);
  const Comparison answer = compare(one, other, {.rotation = true, .reversal = request.reversal});
  return text_answer(request.output.json() ? json(answer, one, other) : text(answer, one, other),
                     request.output, answer.map ? exit_code::done : exit_code::refuted);
}

}  // namespace

void add_same(Program& program) {
  auto [verb, request] =
      program.add<SameRequest>("same", "compare two designs up to relabelling and rotation", run);
  verb.positional("A", request.one,
                  "a design: text, JSON, CSV, GAP, Sage, XML or sets {A,B}; - is standard input");
  verb.positional("B", request.other, "another one");
  add_kind_to(verb, request.kind, "take both as circular, whatever the files say",
              "take both as linear");
  verb.flag("--reversal", request.reversal, "a design and its reversal are the same");
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover same mine.txt theirs.json",
                 "changeover same mine.txt theirs.json --reversal --json",
                 "changeover same a.txt b.txt --circular    circular designs may also be rotated"});
  verb.outcomes({{exit_code::done, "the same"}, {exit_code::refuted, "not the same"}});
}

}  // namespace changeover::cli
