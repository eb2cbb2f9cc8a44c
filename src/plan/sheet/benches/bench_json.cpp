// Writes the sheets of several benches as JSON.
#include <ranges>

#include "io/write/json_writer.hpp"
#include "plan/sheet/benches/bench_words.hpp"
#include "plan/sheet/benches/handovers.hpp"
#include "plan/sheet/places_json.hpp"
#include "plan/sheet/sheet_document.hpp"
#include "plan/sheet/values_json.hpp"

namespace changeover {
namespace {

// The day on which something ends, and the hour of that day.
void write_finish(JsonWriter& json, Amount end, const BenchCalendar& calendar, const Money& money) {
  json.begin_object().key("day").value(calendar.last_day(end));
  json.key("hour").raw(money(calendar.last_hour(end)));
  if (const std::string date = calendar.iso_date(calendar.last_day(end)); !date.empty()) {
    json.key("date").value(date);
  }
  json.end_object();
}

// Begin and end of a step; with days also as days and hours.
void write_times(JsonWriter& json, const StepTime& time, const BenchCalendar& calendar,
                 const Money& money) {
  json.key("begin").raw(money(time.begin)).key("end").raw(money(time.end));
  if (calendar.has_days()) {
    json.key("day").value(calendar.day(time.begin));
    json.key("hour").raw(money(calendar.hour(time.begin)));
    if (const std::string date = calendar.iso_date(calendar.day(time.begin)); !date.empty()) {
      json.key("date").value(date);
    }
    json.key("finish");
    write_finish(json, time.end, calendar, money);
  }
}

void write_bench(JsonWriter& json, const BenchDocument& document, std::size_t bench,
                 const Money& money, const BenchCalendar& calendar, const BenchSheets& sheets,
                 const PlacesInJson& places) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const Bench& asked = plan.benches[bench];
  const RunSheet& sheet = plan.sheets[bench];
  json.begin_object().key("bench").value(bench + 1).key("name").value(name_of(plan.benches, bench));
  json.key("down").value(asked.down).key("tests_done").value(asked.tests_done);
  json.key("start").value(names_of(job, asked.start.value_or(job.start)));
  json.key("hours");
  asked.hours ? json.raw(to_string(*asked.hours)) : json.null();
  json.key("tests").value(sheet.steps.size());
  json.key("changes").value(sheet.changes).key("cost").raw(money(sheet.cost));
  json.key("end").raw(money(plan.times[bench].empty() ? Amount{} : plan.times[bench].back().end));
  const auto write_met = [&](const RunStep& step) {
    json.key("new_" + what_meets(job)).value(new_here(job, step));
  };
  const ValuesInJson values(*sheets.shown[bench].job, sheet);  // the bench has its own start
  places.write_steps(
      json, bench, money, [&](std::size_t at) { values.write(json, at); }, write_met,
      [&](std::size_t at) {
        write_times(json, plan.times[bench][at], calendar, money);
        if (const Block& again = plan.schedule[bench][at].again; !again.empty()) {
          json.key("again").value(names_of(job, again));
        }
      });
  json.end_object();
}

// Parts that go from one bench to another, by the names of benches and the numbers of steps.
void write_handovers(JsonWriter& json, const Job& job, const BenchPlan& plan) {
  json.objects("handovers", handovers(job, plan), [&](const Handover& each) {
    const auto number = [&](std::size_t bench, std::size_t step) {
      return plan.benches[bench].steps_before() + step + 1;
    };
    json.key("part").value(job.names[each.part]);
    json.key("from").value(name_of(plan.benches, each.from));
    json.key("to").value(name_of(plan.benches, each.to));
    json.key("step").value(number(each.to, each.step)).key("early").value(each.is_early);
    json.key("after");
    each.after ? json.value(number(each.from, *each.after)) : json.null();
  });
}

}  // namespace

std::string json_of(const BenchDocument& document) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const Money money = money_of(document);
  const BenchCalendar calendar = calendar_of(document);
  JsonWriter json;
  json.begin_object().key("format").value("changeover-benches/1");
  json.key("title").value(document.title).key("benches").value(plan.sheets.size());
  json.key("objective").value(to_string(document.objective));
  json.key("cost").raw(money(plan.cost)).key("makespan").raw(money(plan.makespan));
  json.key("tests").value(plan.tests).key("changes").value(plan.changes);
  json.key("why_stopped").value(to_string(plan.why_stopped));
  json.key("pairs_needed").value(plan.pairs_needed).key("pairs_tested").value(plan.pairs_tested);
  json.key("triples_needed").value(plan.triples_needed);
  json.key("triples_tested").value(plan.triples_tested);
  json.key("lower_bound").begin_object().key("cost").raw(money(plan.bound.cost));
  json.key("tests").value(plan.bound.tests).key("makespan").raw(money(plan.makespan_bound));
  json.key("cost_reason").value(plan.bound.reason);
  json.key("makespan_reason").value(plan.makespan_reason);
  if (calendar.has_days()) {
    json.key("finish");
    write_finish(json, plan.makespan_bound, calendar, money);
  }
  json.end_object().key("budget");
  document.budget ? json.raw(money(*document.budget)) : json.null();
  json.key("tests_done").value(tests_done_of(document));
  json.key("met_only_in_failed").value(job.met_only_in_failed);
  json.key("trust_failed").value(job.trust_failed);
  write_weight(json, job, plan.weight_needed, plan.weight_tested, plan.most_weight);
  json.key("stock").begin_array();
  for (Element x = 0; x < job.quantities.size(); ++x) {
    if (job.quantities[x] != enough_for_all) {
      json.begin_object().key("name").value(job.names[x]);
      json.key("quantity").value(job.quantities[x]).end_object();
    }
  }
  json.end_array();
  if (calendar.has_days()) {
    json.key("finish");
    write_finish(json, plan.makespan, calendar, money);
  }
  write_unit(json, job);
  const BenchSheets sheets(document);
  const PlacesInJson places(sheets.shown);
  places.write_all(json);
  if (job.model != nullptr) {
    write_model(json, job);
    json.key("proved_fewest_tests").value(plan.proved_fewest());
  }
  json.list("sheets", std::views::iota(std::size_t{0}, plan.sheets.size()), [&](std::size_t bench) {
    write_bench(json, document, bench, money, calendar, sheets, places);
  });
  write_handovers(json, job, plan);
  json.objects("candidates", plan.candidates, [&](const BenchCandidate& c) {
    json.key("name").value(c.name).key("how").value(c.how);
    json.key("tests").value(c.tests).key("changes").value(c.changes);
    json.key("cost").raw(money(c.cost)).key("makespan").raw(money(c.makespan));
    json.key("pairs_tested").value(c.pairs_tested).key("triples_tested").value(c.triples_tested);
  });
  json.key("notes").value(document.notes).end_object();
  return json.take() + "\n";
}

}  // namespace changeover
