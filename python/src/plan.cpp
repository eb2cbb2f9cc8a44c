// Run sheets: the experimenters' door.
#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/plan/sheet_formats.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

// Numbers, strings and decimals alike, exactly as they are written.
Amount amount_of(const py::handle& value) {
  return parse_amount(py::str(value).cast<std::string>());
}

py::object decimal(Amount amount) {
  return py::module_::import("decimal").attr("Decimal")(to_string(amount));
}

// A run sheet with the job that it names its parts from.
struct Sheet {
  Job job;
  RunPlan plan;
  bool interrupted = false;
};

std::vector<std::string> names(const Job& job, const Block& parts) {
  std::vector<std::string> all;
  for (const Element part : parts) {
    all.push_back(job.names[part]);
  }
  return all;
}

Element part_named(const Job& job, const py::handle& part) {
  const auto text = py::str(part).cast<std::string>();
  for (std::size_t i = 0; i < job.names.size(); ++i) {
    if (job.names[i] == text) {
      return static_cast<Element>(i);
    }
  }
  throw BadInput("no part is called '" + text + "'");
}

Job job_of(const py::object& parts, std::uint64_t at_once, const py::object& test_cost,
           const py::object& change_cost, const py::iterable& never, const py::iterable& done) {
  const bool is_number = py::isinstance<py::int_>(parts);
  std::vector<std::string> listed;
  std::vector<Amount> costs;
  if (!is_number) {
    const bool is_map = py::isinstance<py::dict>(parts);
    for (const py::handle part : parts) {
      listed.push_back(py::str(part).cast<std::string>());
      if (is_map) {
        costs.push_back(amount_of(parts[part]));
      }
    }
    if (const auto twice = py::set(py::cast(listed)); twice.size() != listed.size()) {
      throw BadInput("two parts have the same name");
    }
  }
  if (is_number && !(parts >= py::int_(2) && parts <= py::int_(max_parts))) {
    throw BadInput("parts is a number from 2 to 1000, or names");
  }
  const std::uint64_t count = is_number ? parts.cast<std::uint64_t>() : listed.size();
  if (count < 2) {
    throw BadInput("a pair needs two parts");
  }
  if (change_cost.is_none() && costs.empty()) {
    throw BadInput("give change_cost, or parts as a dict from names to their change costs");
  }
  Job job = make_job(count, at_once, amount_of(test_cost),
                     change_cost.is_none() ? Amount{} : amount_of(change_cost));
  if (!listed.empty()) {
    job.names = listed;
  }
  for (std::size_t i = 0; i < costs.size(); ++i) {
    job.change_costs[i] = costs[i];
  }
  for (const py::handle pair : never) {
    const auto two = py::reinterpret_borrow<py::sequence>(pair);
    if (two.size() != 2) {
      throw BadInput("never is pairs of parts");
    }
    job.never.insert(part_named(job, two[0]), part_named(job, two[1]));
  }
  job.needed = all_pairs_but(job.never);
  std::vector<Block> setups;
  for (const py::handle test : done) {
    Block setup;
    for (const py::handle part : test) {
      setup.push_back(part_named(job, part));
    }
    setups.push_back(std::move(setup));
  }
  if (!setups.empty()) {
    mark_done(job, setups);
  }
  check(job);
  return job;
}

Sheet plan(const py::object& parts, std::uint64_t at_once, const py::object& test_cost,
           const py::object& change_cost, const py::iterable& never, const py::iterable& done,
           std::optional<double> time, std::uint64_t threads, std::uint64_t seed,
           py::object progress) {
  Sheet sheet{job_of(parts, at_once, test_cost, change_cost, never, done), {}, false};
  LongWork work({.seconds = time,
                 .threads = threads,
                 .seed = seed,
                 .progress = std::move(progress),
                 .keeps_best = true});
  work.run([&](RunControl& control) {
    sheet.plan = make_run_plan(sheet.job, {.until_stopped = time.has_value()}, control);
  });
  sheet.interrupted = work.interrupted();
  return sheet;
}

py::list steps_of(const Sheet& self) {
  py::list steps;
  std::uint64_t number = self.job.tests_done;
  for (const RunStep& each : self.plan.sheet.steps) {
    py::dict step;
    step["number"] = ++number;
    step["take_out"] = names(self.job, each.take_out);
    step["put_in"] = names(self.job, each.put_in);
    step["setup"] = names(self.job, each.setup);
    step["cost"] = decimal(each.cost);
    step["cost_so_far"] = decimal(each.cost_so_far);
    steps.append(step);
  }
  return steps;
}

}  // namespace

void bind_plan(py::module_& module) {
  py::class_<Sheet>(module, "RunSheet",
                    "A run sheet, counted by code that shares nothing with what made it.")
      .def_property_readonly(
          "steps", &steps_of,
          "A dict for each test: number, take_out, put_in, setup (names), cost, cost_so_far.")
      .def_property_readonly("tests",
                             [](const Sheet& self) { return self.plan.sheet.steps.size(); })
      .def_property_readonly("changes", [](const Sheet& self) { return self.plan.sheet.changes; })
      .def_property_readonly(
          "cost", [](const Sheet& self) { return decimal(self.plan.sheet.cost); },
          "Exact, a Decimal.")
      .def_property_readonly(
          "lower_bound", [](const Sheet& self) { return decimal(self.plan.bound.cost); },
          "No list of tests that does the job costs less.")
      .def_property_readonly(
          "reason", [](const Sheet& self) { return self.plan.bound.reason; }, "Of the bound.")
      .def_property_readonly(
          "cheapest", [](const Sheet& self) { return self.plan.proved_cheapest(); },
          "Proved: nothing is cheaper.")
      .def_readonly("interrupted", &Sheet::interrupted, "Ctrl-C ended the search.")
      .def_property_readonly(
          "candidates",
          [](const Sheet& self) {
            py::list all;
            for (const Candidate& each : self.plan.candidates) {
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
      .def("to_csv",
           [](const Sheet& self) { return sheet_as_csv({.job = &self.job, .plan = &self.plan}); })
      .def("to_html",
           [](const Sheet& self) { return sheet_as_html({.job = &self.job, .plan = &self.plan}); })
      .def("__len__", [](const Sheet& self) { return self.plan.sheet.steps.size(); })
      .def("__repr__", [](const Sheet& self) {
        return "<RunSheet: " + std::to_string(self.plan.sheet.steps.size()) + " tests, " +
               std::to_string(self.plan.sheet.changes) + " changes, cost " +
               to_string(self.plan.sheet.cost) + ">";
      });
  module.def(
      "plan", &plan, py::arg("parts"), py::arg("at_once"), py::kw_only(), py::arg("test_cost"),
      py::arg("change_cost") = py::none(), py::arg("never") = py::tuple(),
      py::arg("done") = py::tuple(), py::arg("time") = py::none(), py::arg("threads") = 1,
      py::arg("seed") = 1, py::arg("progress") = py::none(),
      "The cheapest list of tests that was found in which every two parts are mounted together at least once.\n\n"
      "parts: how many, a list of names, or a dict from names to what it costs to mount them; at_once of them fit. "
      "Costs are numbers, Decimals or strings, and exact. never: pairs that must not meet; done: tests that were "
      "done, lists of names. time: seconds of search; None: a fixed amount of it. Raises BadInput with the reason if "
      "no list can do it.");
}

}  // namespace changeover::python
