// Plans: a request as a document in, and its answer as documents out.
#include <algorithm>

#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/job_request.hpp"
#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "io/write/json_writer.hpp"
#include "long_work.hpp"
#include "plan/job/bench_list.hpp"
#include "plan/job/parts/heading_words.hpp"
#include "plan_state.hpp"

namespace changeover::python {
namespace {

std::unique_ptr<Planned> plan(const std::string& document, py::object progress) {
  const OpenedRequest opened =
      stoppable([&] { return open_workbook(job_request(document, "", Door::python)); });
  const JobRequest& request = opened.request;
  auto planned = std::make_unique<Planned>(
      Planned{.request = request, .asked = checked(opened), .whole = without_files(request)});
  LongWork work(limits(request.seconds, request.threads.value_or(1), request.seed.value_or(1),
                       std::move(progress)));
  work.run([&](RunControl& control) { planned->answer = answer_to(planned->asked, control); });
  return planned;
}

std::string what_if_of(const Planned& self, std::optional<double> time, std::uint64_t threads,
                       std::uint64_t seed, py::object progress) {
  LongWork work(limits(time, threads, seed, std::move(progress)));
  WhatIf answer;
  work.run([&](RunControl& control) {
    answer = what_if(self.job(), *self.answer.plan, self.answer.options, control);
  });
  return written(self.job(), answer, "json");
}

std::string diagnosis_of(const Planned& self,
                         const std::vector<std::pair<std::vector<std::string>, bool>>& results) {
  return stoppable([&] {
    Job job = self.job();
    std::vector<TestedSetup> tested;
    tested.reserve(results.size());
    for (const auto& [setup, failed] : results) {
      tested.push_back({parts_named(setup, job), failed});
    }
    if (!tested.empty()) {
      job.start = tested.back().setup;  // it is on the bench
      job.places.clear();
    }
    return written(self.job(), diagnose(job, tested), "json");
  });
}

// The parts of a table as a document, read as a file of it would be.
std::string parts_in(const std::string& text) {
  const PartList list = read_parts(*input_from_text(text, "parts"), Header::given);
  JsonWriter parts;
  parts.begin_array();
  for (std::size_t i = 0; i < list.names.size(); ++i) {
    parts.begin_object().key("name").value(list.names[i]);
    if (list.change_costs[i]) {
      parts.key("cost").value(to_string(*list.change_costs[i]));
    }
    if (!list.slots.empty()) {
      parts.key("slot").value(list.slots[i]);
    }
    if (!list.quantities.empty()) {
      parts.key("quantity").value(std::to_string(list.quantities[i]));
    }
    parts.end_object();
  }
  return parts.end_array().take();
}

// Words as a fault quotes them: a long text is cut, but not within a character.
std::string quoted(const std::string& words) {
  constexpr std::size_t most_bytes = 60;
  std::size_t end = std::min(words.size(), most_bytes);
  while (end < words.size() && (static_cast<unsigned char>(words[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  return "'" + printable(words.substr(0, end)) + (end < words.size() ? "…'" : "'");
}

void check_amount(const std::string& argument, const std::string& words) {
  try {
    static_cast<void>(parse_measure(words, argument.ends_with("hours")           ? "number of hours"
                                           : argument.ends_with("change_factor") ? "factor"
                                                                                 : "cost"));
  } catch (const BadInput& fault) {
    throw BadInput(argument + ": " + fault.what());
  } catch (const ImpossibleParameters& fault) {
    throw ImpossibleParameters(argument + ": " + fault.what());
  }
}

// What the heading of a column says of it; "" if that is nothing.
std::string meaning(const std::string& heading) {
  return heads_parts(heading)                           ? "name"
         : heads_slots(heading)                         ? "slot"
         : heads_quantities(heading)                    ? "quantity"
         : heads_costs(heading) || heads_times(heading) ? "cost"
                                                        : "";
}

// What a test said; "" if that is nothing.
std::string outcome(const std::string& words) {
  const TestResult result = result_of(words);
  return result == TestResult::pass     ? "pass"
         : result == TestResult::fail   ? "fail"
         : result == TestResult::unread ? "unread"
                                        : "";
}

// A text as a file with it would be read: a table of parts, the heading of a column, a result.
std::string read_as(const std::string& what, const std::string& text) {
  return what == "parts" ? parts_in(text) : what == "heading" ? meaning(text) : outcome(text);
}

}  // namespace

void bind_plan(py::module_& module) {
  py::class_<Planned>(module, "Planned")
      .def_static("of", &plan)
      .def_static("again", &planned_again)
      .def("state", &state_of)
      .def_property_readonly("complete",
                             [](const Planned& self) {
                               return self.answer.benches ? self.answer.benches->does_the_job()
                                                          : self.answer.plan->sheet.does_the_job();
                             })
      .def("written",
           [](const Planned& self, const std::string& format) {
             return py::bytes(written(self.asked, self.answer, format));
           })
      .def("request_json", [](const Planned& self) { return to_json(self.request); })
      .def("check_parts",
           [](const Planned& self, const std::vector<std::string>& parts) {
             static_cast<void>(parts_named(parts, self.job()));
           })
      .def("what_if", &what_if_of)
      .def("diagnose", &diagnosis_of);
  module.def("quoted", &quoted);
  module.def("check_amount", &check_amount);
  module.def("read_as", &read_as);
}

}  // namespace changeover::python
