// Writes run sheets as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <ranges>
#include <string>

#include "changeover/plan/job.hpp"
#include "io/write/json_writer.hpp"
#include "plan/sheet/places_json.hpp"
#include "plan/sheet/sheet_document.hpp"
#include "plan/sheet/sheet_words.hpp"
#include "plan/sheet/values_json.hpp"

namespace changeover {
namespace {

void write_figures(JsonWriter& json, const Money& money, const Candidate& candidate) {
  json.key("name").value(candidate.name).key("how").value(candidate.how);
  json.key("tests").value(candidate.tests()).key("changes").value(candidate.changes);
  json.key("cost").raw(money(candidate.cost));
  json.key("pairs_tested").value(candidate.pairs_tested);
  json.key("triples_tested").value(candidate.triples_tested);
  json.key("weight").raw(to_string(candidate.weight));
}

// As a number, and exactly as a text: 0.625, "5/8".
void write_ratio(JsonWriter& json, const std::string& key, const std::optional<Ratio>& ratio) {
  json.key(key);
  ratio ? json.value(static_cast<double>(ratio->over) / static_cast<double>(ratio->under))
        : json.null();
  json.key(key + "_exact");
  const std::uint64_t divisor = ratio ? std::gcd(ratio->over, ratio->under) : 1;
  ratio ? json.value(fmt::format("{}/{}", ratio->over / divisor, ratio->under / divisor))
        : json.null();
}

}  // namespace

std::string json_of(const SheetDocument& document) {
  const Job& job = *document.job;
  const RunPlan& plan = *document.plan;
  const RunSheet& sheet = plan.sheet;
  const Money money(job, document.budget);
  JsonWriter json;
  json.begin_object().key("format").value("changeover-plan/1").key("title").value(document.title);
  json.objects("parts", std::views::iota(std::size_t{0}, job.names.size()), [&](std::size_t i) {
    json.key("name").value(job.names[i]);
    json.key("change_cost").raw(money(job.change_costs[i]));
    if (!job.slots.empty()) {
      json.key("slot");
      job.slot_of[i] == no_slot ? json.null() : json.value(job.slots[job.slot_of[i]].name);
    }
  });
  json.key("at_once").value(job.at_once);
  json.objects("slots", job.slots, [&](const Slot& slot) {
    json.key("name").value(slot.name).key("least").value(slot.least);
    json.key("most").value(std::min(slot.most, job.at_once));
  });
  json.key("test_cost").raw(money(job.test_cost));
  if (job.replaces()) {
    const auto parts = std::views::iota(Element{0}, static_cast<Element>(job.parts()));
    json.list("replace_costs", parts, [&](Element out) {
      json.list(parts, [&](Element in) {
        in == out || !job.may_replace(out, in) ? json.null()
                                               : json.raw(money(job.replace_cost(out, in)));
      });
    });
  }
  json.key("mounted").value(names_of(job, job.mounted));
  json.key("start").value(names_of(job, job.start));
  json.list("first", job.first, [&](const Block& setup) { json.value(names_of(job, setup)); });
  json.key("tests_done").value(job.tests_done);
  json.key("met_only_in_failed").value(job.met_only_in_failed);
  json.key("trust_failed").value(job.trust_failed);
  json.key("tests").value(sheet.steps.size()).key("changes").value(sheet.changes);
  json.key("cost").raw(money(sheet.cost)).key("pairs_needed").value(sheet.pairs_needed);
  json.key("pairs_tested").value(sheet.pairs_tested);
  json.key("proved_cheapest").value(plan.proved_cheapest());
  json.key("why_stopped").value(to_string(plan.why_stopped));
  json.key("lower_bound").begin_object().key("cost").raw(money(plan.bound.cost));
  json.key("tests").value(plan.bound.tests).key("changes").value(plan.bound.introductions);
  json.key("reason").value(plan.bound.reason).end_object().key("budget");
  document.budget ? json.raw(money(*document.budget)) : json.null();
  json.key("triples_needed").value(sheet.triples_needed);
  json.key("triples_tested").value(sheet.triples_tested);
  write_weight(json, job, sheet.weight_needed, sheet.weight_tested, plan.most_weight);
  write_unit(json, job);
  const PlacesInJson places({{&job, &sheet}});
  places.write_all(json);
  const ValuesInJson values(job, sheet);
  if (job.model != nullptr) {
    write_model(json, job);
    json.key("objective").value(plan.objective == PlanObjective::tests ? "tests" : "cost");
    json.key("proved_fewest_tests").value(plan.proved_fewest());
  }
  const auto write_values = [&](std::size_t at) { values.write(json, at); };
  const auto write_met = [&](const RunStep& step) {
    json.list("new_pairs", step.new_pairs, [&](const auto& pair) {
      json.value(names_of(job, {pair.first, pair.second}));
    });
    if (!job.triples.empty()) {
      json.list("new_triples", step.new_triples, [&](const Triple& t) {
        json.value(names_of(job, {t.begin(), t.end()}));
      });
    }
  };
  places.write_steps(json, 0, money, write_values, write_met, [&](std::size_t at) {
    if (!job.weights.empty()) {
      json.key("weight_so_far").raw(to_string(sheet.steps[at].weight_so_far));
    }
  });
  json.objects("candidates", plan.candidates,
               [&](const Candidate& candidate) { write_figures(json, money, candidate); });
  json.key("notes").value(document.notes).end_object();
  return json.take() + "\n";
}

std::string json_of(const Job& job, const WhatIf& answer) {
  const Money money(job);
  JsonWriter json;
  json.begin_object().key("format").value("changeover-what-if/1");
  json.key("by").value(answer.by_factor ? "factor of all change costs"
                                        : "ratio of change cost to test cost");
  write_ratio(json, "asked", answer.asked);
  json.key("why_stopped").value(to_string(answer.why_stopped));
  json.objects("ranges", answer.ranges, [&](const WhatIf::Range& range) {
    write_ratio(json, "from", range.from);
    write_ratio(json, "to", range.to);
    json.key("plan").begin_object();
    write_figures(json, money, range.plan);
    json.list("set_ups", range.plan.setups,
              [&](const Block& setup) { json.value(names_of(job, setup)); });
    json.end_object();
  });
  json.key("met_only_in_failed").value(job.met_only_in_failed);
  json.key("trust_failed").value(job.trust_failed).key("notes").value(answer.notes).end_object();
  return json.take() + "\n";
}

}  // namespace changeover
