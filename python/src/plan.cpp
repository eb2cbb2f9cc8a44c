// Run sheets: the experimenters' door.
#include "changeover/core/error.hpp"
#include "long_work.hpp"
#include "sheets.hpp"

namespace changeover::python {
namespace {

template <typename Kind>
py::object planned(JobRequest request, AskedJob asked, LongWork& work) {
  Kind kind;
  kind.request = std::move(request);
  kind.asked = std::move(asked);
  work.run(
      [&](RunControl& control) { kind.answer = answer_to(kind.request, kind.asked, control); });
  kind.interrupted = work.interrupted();
  return py::cast(std::move(kind));
}

py::object plan(py::object parts, std::uint64_t at_once, py::object test_cost,
                py::object change_cost, py::object change_costs, std::uint64_t strength,
                py::object pairs, py::object never, py::object slots, py::object slot_of,
                py::object mounted, py::object start, py::object first, py::object weights,
                py::object done, bool trust_failed, py::object budget,
                std::optional<std::uint64_t> benches, const std::optional<std::string>& objective,
                std::optional<double> time, std::uint64_t threads, std::uint64_t seed,
                py::object progress, std::optional<std::uint64_t> done_first,
                std::optional<std::uint64_t> shuffle, const std::optional<std::string>& title,
                bool compact, std::optional<std::uint64_t> steps) {
  JobRequest request = request_of(
      {std::move(parts), std::move(test_cost), std::move(change_cost), std::move(change_costs),
       std::move(pairs), std::move(never), std::move(slots), std::move(slot_of), std::move(mounted),
       std::move(start), std::move(first), std::move(weights), std::move(done), std::move(budget)});
  request.at_once = at_once;
  request.strength = strength;
  request.trust_failed = trust_failed;
  request.benches = benches;
  request.objective = objective.value_or("");
  request.seconds = time;
  request.done_first = done_first;
  request.shuffle = shuffle;
  request.title = title.value_or("");
  request.compact = compact;
  request.steps = steps;
  if (objective && *objective != "makespan" && *objective != "cost") {
    throw BadInput(
        "objective is 'makespan', what the bench costs that costs most, or 'cost', of all benches");
  }
  AskedJob asked = stoppable([&] { return checked_job(request, Door::document); });
  LongWork work({.seconds = time,
                 .threads = threads,
                 .seed = seed,
                 .progress = std::move(progress),
                 .keeps_best = true});
  return benches ? planned<Sheets>(std::move(request), std::move(asked), work)
                 : planned<Sheet>(std::move(request), std::move(asked), work);
}

py::list steps_of_plan(const Sheet& self) { return steps_of(self.job(), self.plan().sheet); }

// Exact, a Fraction.
py::object fraction(const Ratio& ratio) {
  return py::module_::import("fractions").attr("Fraction")(ratio.over, ratio.under);
}

py::object fraction_or_none(const std::optional<Ratio>& ratio) {
  return ratio ? fraction(*ratio) : py::none();
}

std::vector<std::vector<std::string>> names_of_setups(const Job& job,
                                                      const std::vector<Block>& setups) {
  std::vector<std::vector<std::string>> all;
  for (const Block& setup : setups) {
    all.push_back(names(job, setup));
  }
  return all;
}

py::dict ratios(const Sheet& self, std::optional<double> time, std::uint64_t threads,
                std::uint64_t seed, py::object progress) {
  LongWork work({.seconds = time,
                 .threads = threads,
                 .seed = seed,
                 .progress = std::move(progress),
                 .keeps_best = true});
  WhatIf answer;
  work.run([&](RunControl& control) {
    answer = changeover::what_if(self.job(), self.plan(), self.answer.options, control);
  });
  py::list ranges;
  for (const WhatIf::Range& range : answer.ranges) {
    py::dict one;
    one["from"] = fraction_or_none(range.from);
    one["to"] = fraction_or_none(range.to);
    one["name"] = range.plan.name;
    one["how"] = range.plan.how;
    one["tests"] = range.plan.tests();
    one["changes"] = range.plan.changes;
    one["setups"] = names_of_setups(self.job(), range.plan.setups);
    ranges.append(one);
  }
  py::dict all;
  all["by_factor"] = answer.by_factor;
  all["asked"] = fraction_or_none(answer.asked);
  all["ranges"] = ranges;
  all["interrupted"] = work.interrupted();
  return all;
}

}  // namespace

py::list steps_of(const Job& job, const RunSheet& sheet) {
  py::list steps;
  std::uint64_t number = job.tests_done;
  for (const RunStep& each : sheet.steps) {
    py::dict step;
    step["number"] = ++number;
    step["take_out"] = names(job, each.take_out);
    step["put_in"] = names(job, each.put_in);
    step["setup"] = names(job, each.setup);
    step["cost"] = decimal(each.cost);
    step["cost_so_far"] = decimal(each.cost_so_far);
    steps.append(step);
  }
  return steps;
}

void bind_plan(py::module_& module) {
  py::class_<Sheet> sheet(module, "RunSheet",
                          "A run sheet, counted by code that shares nothing with what made it.");
  bind_formats(sheet);
  sheet
      .def_property_readonly(
          "steps", &steps_of_plan,
          "A dict for each test: number, take_out, put_in, setup (names), cost, cost_so_far.")
      .def_property_readonly("tests",
                             [](const Sheet& self) { return self.plan().sheet.steps.size(); })
      .def_property_readonly("changes", [](const Sheet& self) { return self.plan().sheet.changes; })
      .def_property_readonly(
          "complete", [](const Sheet& self) { return self.plan().sheet.does_the_job(); },
          "All that must meet does; a budget may not pay for it.")
      .def_property_readonly(
          "pairs_tested", [](const Sheet& self) { return self.plan().sheet.pairs_tested; },
          "Of the pairs that must meet.")
      .def_property_readonly(
          "met_only_in_failed", [](const Sheet& self) { return self.job().met_only_in_failed; },
          "Pairs (triples with strength 3) that met only in tests that failed or whose result is not understood.")
      .def_property_readonly("pairs_needed",
                             [](const Sheet& self) { return self.plan().sheet.pairs_needed; })
      .def_property_readonly(
          "triples_tested", [](const Sheet& self) { return self.plan().sheet.triples_tested; },
          "Of three parts that must meet, with strength 3.")
      .def_property_readonly("triples_needed",
                             [](const Sheet& self) { return self.plan().sheet.triples_needed; })
      .def_property_readonly(
          "cost", [](const Sheet& self) { return decimal(self.plan().sheet.cost); },
          "Exact, a Decimal.")
      .def_property_readonly(
          "lower_bound", [](const Sheet& self) { return decimal(self.plan().bound.cost); },
          "No list of tests that does the job costs less.")
      .def_property_readonly(
          "reason", [](const Sheet& self) { return self.plan().bound.reason; }, "Of the bound.")
      .def_property_readonly(
          "cheapest", [](const Sheet& self) { return self.plan().proved_cheapest(); },
          "Proved: nothing is cheaper.")
      .def_readonly("interrupted", &Sheet::interrupted, "Ctrl-C ended the search.")
      .def_property_readonly(
          "candidates",
          [](const Sheet& self) {
            py::list all;
            for (const Candidate& each : self.plan().candidates) {
              py::dict one;
              one["name"] = each.name;
              one["how"] = each.how;
              one["tests"] = each.tests();
              one["changes"] = each.changes;
              one["cost"] = decimal(each.cost);
              all.append(one);
            }
            return all;
          },
          "What it was compared with, cheapest first.")
      .def(
          "what_if", &ratios, py::kw_only(), py::arg("time") = py::none(), py::arg("threads") = 1,
          py::arg("seed") = 1, py::arg("progress") = py::none(),
          "Which plan is cheapest when changes become dearer or cheaper against tests, and where it breaks even.\n\n"
          "A dict: ranges, by ratio of the cost of a change to that of a test (of a factor of all change costs, if these differ: "
          "by_factor) without gaps, each with from and to (Fractions; None: from 0, without end), name, how, tests, "
          "changes and setups; asked, where the sheet stands (None if tests cost nothing); interrupted. time: seconds; None: a fixed "
          "amount of search for each ratio.\n\nRaises BadInput if costs depend on what is replaced.")
      .def(
          "diagnose", &diagnosis_of, py::arg("results"),
          "Which one fault explains the results, and which tests tell apart what is left.\n\n"
          "results: for each of the first tests of the sheet True if it passed, False if it failed, None if nothing is known, or a "
          "text such as 'FAILED - hang'; or tuples (set-up, result) for tests of other set-ups.\n\n"
          "A dict: passed, failed; unread, the texts that are not understood, each with its place in results; suspects, each a tuple of one part or of two that do not work together; two, pairs of suspects "
          "that explain all together where none does alone; contradictions, (what failed, what passed though it had all of it); "
          "tests, a tree of dicts with after (results so far, True for passed), setup, take_out, put_in, cost, if_it_fails and "
          "if_it_passes (suspects); most_cost, of the tests that are made. Raises BadInput for other results.")
      .def("__len__", [](const Sheet& self) { return self.plan().sheet.steps.size(); })
      .def("__repr__", [](const Sheet& self) {
        return "<RunSheet: " + std::to_string(self.plan().sheet.steps.size()) + " tests, " +
               std::to_string(self.plan().sheet.changes) + " changes, cost " +
               to_string(self.plan().sheet.cost) + ">";
      });
  module.def(
      "plan", &plan, py::arg("parts"), py::arg("at_once"), py::kw_only(), py::arg("test_cost"),
      py::arg("change_cost") = py::none(), py::arg("change_costs") = py::none(),
      py::arg("strength") = 2, py::arg("pairs") = py::none(), py::arg("never") = py::tuple(),
      py::arg("slots") = py::none(), py::arg("slot_of") = py::none(),
      py::arg("mounted") = py::tuple(), py::arg("start") = py::tuple(),
      py::arg("first") = py::tuple(), py::arg("weights") = py::none(),
      py::arg("done") = py::tuple(), py::arg("trust_failed") = false,
      py::arg("budget") = py::none(), py::arg("benches") = py::none(),
      py::arg("objective") = py::none(), py::arg("time") = py::none(), py::arg("threads") = 1,
      py::arg("seed") = 1, py::arg("progress") = py::none(), py::arg("done_first") = py::none(),
      py::arg("shuffle") = py::none(), py::arg("title") = py::none(), py::arg("compact") = false,
      py::arg("steps") = py::none(),
      "The cheapest list of tests that was found in which every two parts are mounted together at least once.\n\n"
      "parts: how many, a list of names, or a dict from names to what it costs to mount them; at_once of them fit. "
      "Costs are numbers, Decimals or strings, and exact.\n\n"
      "change_cost: of a part whose cost is not given. change_costs: a dict from (out, in) to the cost of putting in one part "
      "where the other was taken out, for every two parts. strength: 2, every two parts must meet, or 3, every three. "
      "pairs: only these must; never: these must not. slots: a dict from the name of a slot to how many of its parts a "
      "set-up has, a number or (least, most), None for no limit, with slot_of, a dict from parts to their slots; parts that "
      "cannot meet then need not. mounted: parts that stay; start: parts that are mounted before the first test; first: "
      "set-ups that must be run first; weights: a dict from pairs to what testing them is worth (others 1); done: tests that "
      "were done, lists of names, each alone or as (names, result), where result is True (passed), False (failed), None or a text "
      "such as 'FAILED - hang'. Pairs that met only in tests that failed, or whose text is not understood, are needed again, unless "
      "trust_failed. budget: test as much as it pays for. benches: so many side by side, which gives BenchSheets; objective: 'makespan' (None), "
      "what the bench costs that costs most is least, or 'cost', of all of them. time: seconds of search; None: a fixed amount of "
      "it, or steps, moves of each local search. done_first: only so many of done were done. shuffle: a seed by which parts "
      "are exchanged that nothing tells apart. title, compact: of what is written.\n\nRaises BadInput with the reason if no list can do it.");
}

}  // namespace changeover::python
