// A cyclic design with carriers, who hold t·m places and relieve each other while the base blocks
// go round.
//
// Let a circular m-change design be the development of c base blocks over Z_u, let t ≥ 2 and u ≥
// 2t−1. There are 2t−1 carriers, m elements each; t of them, τ_i, …, τ_{i+t−1} modulo 2t−1, are
// beside the blocks of the translates y_i, …, y_{i+1}−1, where y_i = ⌊iu/(2t−1)⌋. Before translate
// y_i its first block is there with the carriers of before, so in one more block τ_{i−1} is
// relieved by τ_{i+t−1}. That is a circular design on (u + m(2t−1), k + mt) with 2t−1 blocks more:
// each carrier is beside half of the translates, and so it meets all of Z_u. Proof:
// docs/theorems.md, Theorem 9.
//
// For m = 1 other constructions have fewer blocks; for m = 2 this serves odd v between the tight
// designs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "core/words.hpp"

namespace changeover::relayed_cyclic_entry {
namespace {

// Those that are developed over Z_v.
constexpr std::array<std::string_view, 5> cyclic_families{
    "cyclic-single-change", "mcsorley-circular", "cyclic", "cyclic-paper", "cyclic-triple-change"};
// More carriers at a time are not tried: an offer takes bounded time.
constexpr std::uint64_t most_at_a_time = 256;

struct Relay {
  std::uint64_t u;  // elements of the cyclic design
  std::uint64_t c;  // its base blocks
  std::uint64_t m;
  std::uint64_t t;

  [[nodiscard]] std::uint64_t carriers() const { return 2 * t - 1; }
  // The translate before which τ_{i−1} is relieved.
  [[nodiscard]] std::uint64_t relief(std::uint64_t i) const { return i * u / carriers(); }
  [[nodiscard]] std::uint64_t blocks() const { return c * u + carriers(); }
};

Parameters without_carriers(Parameters p, std::uint64_t t) {
  p.v -= p.change * (2 * t - 1);
  p.k -= p.change * t;
  return p;
}

constexpr Description description{
    .name = "relayed-cyclic",
    .summary = "a cyclic design beside carriers, t at a time of 2t-1, who relieve each other",
    .preconditions =
        "circular; a cyclic design on (v-m(2t-1),k-mt), t >= 2, with 2t-1 elements or more",
    .guarantee = "2t-1 blocks more than the cyclic design",
    .place = "docs/theorems.md, Theorem 9",
};

class RelayedSource final : public BlockByBlock<RelayedSource> {
 public:
  RelayedSource(const Parameters& p, const Relay& relay, std::unique_ptr<BlockSource> cyclic)
      : parameters_(p), relay_(relay), cyclic_(std::move(cyclic)) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return relay_.blocks();
  }

  bool make(std::span<Element> block) {
    const std::span<Element> cyclic = block.first(block.size() - relay_.m * relay_.t);
    if (again_) {
      std::ranges::copy(relieved_, cyclic.begin());
      again_ = false;
    } else if (!cyclic_->next(cyclic)) {
      return false;
    } else {
      const std::uint64_t number = blocks_++;
      if (number % relay_.c == 0 && reliefs_ < relay_.carriers() &&
          number / relay_.c == relay_.relief(reliefs_)) {
        relieved_.assign(cyclic.begin(), cyclic.end());
        again_ = true;
      }
    }
    std::size_t filled = cyclic.size();
    for (std::uint64_t i = 0; i < relay_.t; ++i) {
      const std::uint64_t carrier = (reliefs_ + relay_.carriers() - 1 + i) % relay_.carriers();
      for (std::uint64_t copy = 0; copy < relay_.m; ++copy) {
        block[filled++] = static_cast<Element>(relay_.u + relay_.m * carrier + copy);
      }
    }
    reliefs_ += again_ ? 1 : 0;
    return true;
  }

  bool rewind() override {
    blocks_ = reliefs_ = 0;
    again_ = false;
    return cyclic_->rewind();
  }

 private:
  Parameters parameters_;
  Relay relay_;
  std::unique_ptr<BlockSource> cyclic_;
  Block relieved_;             // the block of the cyclic design that comes a second time
  std::uint64_t blocks_ = 0;   // of the cyclic design, that have come
  std::uint64_t reliefs_ = 0;  // that were made; τ_{reliefs−1} is the first of the carriers there
  bool again_ = false;
};

class RelayedCyclic final : public Described<Entry, description> {
 public:
  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    std::optional<Offer> best;
    if (!asks_for_pairs(p, p.change) || p.kind != Kind::circular) {
      return best;
    }
    for (std::uint64_t t = 2; t <= most_at_a_time && could_be(p, t); ++t) {
      const Parameters smaller = without_carriers(p, t);
      for (const std::string_view name : cyclic_families) {
        const Construction* maker = registry.find(name);
        auto input = maker == nullptr ? std::nullopt : maker->offer(smaller, registry);
        if (!input || (best && best->b <= input->b + (2 * t - 1))) {
          continue;
        }
        if (const auto relay = relay_of(input->recipe, t, registry)) {
          best = Offer{recipe_of(p, {{"t", static_cast<std::int64_t>(t)}}, {input->recipe}),
                       relay->blocks()};
          best->economical = best->b == counting_bound(p);
        }
      }
    }
    return best;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Relay relay = required(recipe, registry);
    return std::make_unique<RelayedSource>(recipe.parameters, relay,
                                           registry.build(recipe.inputs.front()));
  }

  std::string explain(const Recipe& recipe) const override {
    const Relay relay = required(recipe, Registry::standard());
    return fmt::format(
        "While the {} goes round, {} of the {} carriers, {} each, are beside its blocks; one "
        "relieves another every {} translates or so.",
        changeover::name(recipe.inputs.front().parameters), relay.t, relay.carriers(),
        count_of(relay.m, "new element"), relay.u / relay.carriers());
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    (void)required(recipe, registry);
    return labels_with_new(recipe, registry);
  }

 private:
  // Whether what is left beside t carriers may be a design.
  static bool could_be(const Parameters& p, std::uint64_t t) {
    return p.change * t + p.change < p.k && p.change * (2 * t - 1) + p.k - p.change * t < p.v;
  }

  // Nothing if the input is not cyclic, or too small.
  static std::optional<Relay> relay_of(const Recipe& input, std::uint64_t t,
                                       const Registry& registry) {
    const std::uint64_t u = input.parameters.v;
    if (std::ranges::find(cyclic_families, input.construction) == cyclic_families.end() ||
        2 * t - 1 > u) {
      return std::nullopt;
    }
    const auto b = registry.build(input)->block_count();
    return b ? std::optional(Relay{u, *b / u, input.parameters.change, t}) : std::nullopt;
  }

  Relay required(const Recipe& recipe, const Registry& registry) const {
    const Parameters& p = recipe.parameters;
    const auto given = recipe.arguments.find("t");
    if (!asks_for_pairs(p, p.change) || p.kind != Kind::circular ||
        given == recipe.arguments.end() || given->second < 2 ||
        static_cast<std::uint64_t>(given->second) > p.k / p.change ||
        !could_be(p, static_cast<std::uint64_t>(given->second))) {
      throw BadInput(
          "relayed-cyclic takes a circular design's parameters and t, the number of carriers at "
          "a time; correct the recipe");
    }
    const auto t = static_cast<std::uint64_t>(given->second);
    require_input(recipe, without_carriers(p, t), {{"t", given->second}});
    const auto relay = relay_of(recipe.inputs.front(), t, registry);
    if (!relay) {
      throw BadInput(fmt::format(
          "relayed-cyclic: the input, the {} made by {}, needs {} elements or more and "
          "one of the constructions {}; use another input",
          changeover::name(recipe.inputs.front().parameters), recipe.inputs.front().construction,
          2 * t - 1, fmt::join(cyclic_families, ", ")));
    }
    return *relay;
  }
};

}  // namespace

const Construction& construction() { return only<RelayedCyclic>(); }

}  // namespace changeover::relayed_cyclic_entry
