#include "answer/design/judgement.hpp"

#include <fmt/format.h>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/difference.hpp"
#include "changeover/verify/fans.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/parameters.hpp"

namespace changeover::cli {

Judgement judge(const Verdict& verdict, const std::optional<Bound>& proved) {
  Judgement judgement;
  judgement.bound = lower_bound(verdict.parameters);
  if (proved && proved->blocks >= judgement.bound.blocks) {
    judgement.bound = *proved;
  }
  judgement.verdict = {.valid = verdict.valid(),
                       .tight = verdict.tight(),
                       .economical = verdict.economical(),
                       .b = verdict.b,
                       .lower_bound = judgement.bound.blocks,
                       .minimum_proved = verdict.valid() && verdict.b == judgement.bound.blocks};
  judgement.certificate = "every block read";
  if (verdict.valid() && verdict.b < judgement.bound.blocks) {
    throw InternalError(fmt::format("{} has {}, below the lower bound {}", name(verdict.parameters),
                                    count_of(verdict.b, "block"), judgement.bound.blocks));
  }
  return judgement;
}

// What a design is, as found without reading every block.
struct Certificate {
  bool valid = false;
  bool tight = false;
  bool economical = false;
  std::uint64_t b = 0;
  const char* by = "";
};

static Certificate by_differences(const DifferenceVerdict& found) {
  return {found.valid(), found.tight, found.tight, found.b, "differences of the base blocks"};
}

// The certificate of a development, or of fans, if the recipe has one.
static std::optional<Certificate> certificate(const Recipe& recipe) {
  const Registry& registry = Registry::standard();
  const Construction& construction = registry.construction_of(recipe);
  if (const auto base = construction.interval_base_blocks(recipe)) {
    return by_differences(verify_differences(*base));
  }
  if (const auto base = construction.base_blocks(recipe)) {
    return by_differences(verify_differences(*base));
  }
  if (const auto base = construction.orbit_base_blocks(recipe)) {
    return by_differences(verify_differences(base->base, base->automorphism));
  }
  if (const auto fans = construction.fans(recipe, registry)) {
    const FanVerdict found = verify_fans(*fans);
    return Certificate{found.valid(), found.tight(), found.economical(), found.b,
                       "intervals of elements beside unchanged subsets"};
  }
  return std::nullopt;
}

// Whether reading all blocks takes more than about a second.
static bool is_long(const Parameters& p, std::uint64_t b) {
  constexpr std::uint64_t many_elements = 20'000'000;
  constexpr std::uint64_t many_pairs_from_v = 20'000;
  return p.v > many_pairs_from_v || b > many_elements / p.k;
}

static void hold_to_promise(const Judgement& judgement, const Offer& promise) {
  const DesignVerdict& verdict = judgement.verdict;
  if (!verdict.valid || verdict.b != promise.b || (promise.tight && !verdict.tight) ||
      (promise.economical && !verdict.economical)) {
    throw InternalError(fmt::format("the construction {} does not keep its promise for {}",
                                    promise.recipe.construction, name(promise.recipe.parameters)));
  }
}

std::optional<Judgement> judge_at_once(const BlockSource& source, const Offer& promise) {
  const Parameters& p = source.parameters();
  const auto found =
      is_long(p, promise.b) ? certificate(promise.recipe) : std::optional<Certificate>();
  if (!found) {
    return std::nullopt;
  }
  Judgement judgement;
  judgement.bound = lower_bound(p);
  judgement.verdict = {.valid = found->valid,
                       .tight = found->tight,
                       .economical = found->economical,
                       .b = found->b,
                       .lower_bound = judgement.bound.blocks,
                       .minimum_proved = found->valid && found->b == judgement.bound.blocks};
  judgement.certificate = found->by;
  hold_to_promise(judgement, promise);
  return judgement;
}

bool takes_long_to_judge(const BlockSource& source, const Offer& promise) {
  return is_long(source.parameters(), promise.b);
}

std::string not_verified_here(const Parameters& p, std::string_view options) {
  if (p.v > max_elements_in_memory) {
    return fmt::format(
        "not verified here: of designs with more than {} elements only those can be verified that "
        "are developed from not too many base blocks, or made by concatenation",
        max_elements_in_memory);
  }
  return fmt::format(
      "not verified here, for that takes long: changeover design {} {} --change {} --{}{} does",
      p.v, p.k, p.change, to_string(p.kind), options);
}

JudgedWhileRead::JudgedWhileRead(BlockSource& source, const Offer& promise)
    : source_(source), promise_(promise), running_(source.parameters()) {}

std::span<const Element> JudgedWhileRead::read(std::span<Element> room) {
  const std::span<const Element> blocks = source_.read(room);
  if (!blocks.empty()) {
    running_.add(blocks);
    constexpr std::uint64_t blocks_between_looks = 4096;
    const std::uint64_t looks = blocks_ / blocks_between_looks;
    blocks_ += blocks.size() / source_.parameters().k;
    if (blocks_ / blocks_between_looks != looks) {
      stop_if_asked();
      if (progress_due()) {
        report_progress({.phase = fmt::format("verifying {} of {}", name(source_.parameters()),
                                              count_of(promise_.b, "block")),
                         .steps = blocks_,
                         .unit = "blocks"});
      }
    }
    return blocks;
  }
  if (!judgement_) {
    Judgement judgement = judge(running_.finish());
    hold_to_promise(judgement, promise_);
    judgement_ = std::move(judgement);
  }
  return blocks;
}

const Judgement& JudgedWhileRead::judgement() const {
  if (!judgement_) {
    throw InternalError("a design was judged before its last block");
  }
  return *judgement_;
}

Judgement judge(BlockSource& source, const Offer& promise) {
  if (std::optional<Judgement> judgement = judge_at_once(source, promise)) {
    return *std::move(judgement);
  }
  JudgedWhileRead judged(source, promise);
  for_each_batch(judged, [](std::span<const Element>) {});
  if (!source.rewind()) {
    throw InternalError("a construction that cannot be read twice");
  }
  return judged.judgement();
}

std::string quality(const Judgement& judgement) {
  const DesignVerdict& verdict = judgement.verdict;
  std::string text;
  if (verdict.tight) {
    text += "tight, ";
  } else if (verdict.economical) {
    text += "economical, ";
  }
  if (verdict.minimum_proved) {
    return text + fmt::format("minimum (its {} {} the lower bound: {})",
                              count_of(verdict.b, "block"), verdict.b == 1 ? "is" : "are",
                              judgement.bound.name);
  }
  return text + fmt::format("{} {} over the lower bound {}{}",
                            count_of(verdict.b - verdict.lower_bound, "block"),
                            verdict.b - verdict.lower_bound == 1 ? "is" : "are",
                            verdict.lower_bound,
                            judgement.from_tables ? " (" + judgement.bound.name + ")" : "");
}

std::vector<std::string> names_among_numbers(const std::vector<std::string>& labels) {
  constexpr std::size_t most_names = 2;
  constexpr std::size_t least_numbers = 3;
  std::vector<std::string> names;
  for (const std::string& label : labels) {
    if (!whole_number(label)) {
      names.push_back(label);
    }
  }
  const bool among = names.size() <= most_names && labels.size() - names.size() >= least_numbers;
  return among ? names : std::vector<std::string>();
}

std::string verify_json(const Verdict& verdict, const Judgement& judgement,
                        const std::vector<std::string>& labels) {
  JsonWriter json;
  json.begin_object();
  json.key("verdict").raw(verdict_to_json(judgement.verdict));
  json.key("bound").begin_object();
  json.key("name").value(judgement.bound.name).key("reason").value(judgement.bound.reason);
  json.end_object();
  json.key("details").raw(verdict_to_json(verdict, labels));
  json.key("names_among_numbers").value(names_among_numbers(labels));
  return json.end_object().take();
}

}  // namespace changeover::cli
