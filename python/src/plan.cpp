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

std::unique_ptr<Planned> plan(const std::string& document, std::optional<double> time,
                              std::uint64_t threads, std::uint64_t seed, py::object progress) {
  auto planned = std::make_unique<Planned>();
  const OpenedRequest opened = stoppable([&] {
    JobRequest request = job_request(document);
    request.seconds = time;
    return open_workbook(std::move(request));
  });
  planned->request = opened.request;
  planned->asked = checked_in_time(opened);
  planned->whole = without_files(planned->request);
  LongWork work(limits(time, threads, seed, std::move(progress)));
  work.run([&](RunControl& control) {
    planned->answer = answer_to(planned->request, planned->asked, control);
  });
  return planned;
}

std::vector<std::string> names(const Job& job, const Block& parts) {
  return each_of<std::string>(parts, [&](const Element part) { return job.names[part]; });
}

// A fraction as (over, under).
py::object two_of(const std::optional<Ratio>& ratio) {
  return ratio ? py::object(py::make_tuple(ratio->over, ratio->under)) : py::none();
}

py::dict ratios(const Planned& self, std::optional<double> time, std::uint64_t threads,
                std::uint64_t seed, py::object progress) {
  LongWork work(limits(time, threads, seed, std::move(progress)));
  WhatIf answer;
  work.run([&](RunControl& control) {
    answer = changeover::what_if(self.job(), *self.answer.plan, self.answer.options, control);
  });
  py::list ranges;
  for (const WhatIf::Range& range : answer.ranges) {
    std::vector<std::vector<std::string>> setups;
    setups.reserve(range.plan.setups.size());
    for (const Block& setup : range.plan.setups) {
      setups.push_back(names(self.job(), setup));
    }
    ranges.append(py::dict(py::arg("from") = two_of(range.from), py::arg("to") = two_of(range.to),
                           py::arg("name") = range.plan.name, py::arg("how") = range.plan.how,
                           py::arg("tests") = range.plan.tests(),
                           py::arg("changes") = range.plan.changes, py::arg("setups") = setups));
  }
  return py::dict(py::arg("by_factor") = answer.by_factor, py::arg("asked") = two_of(answer.asked),
                  py::arg("ranges") = ranges, py::arg("interrupted") = work.interrupted());
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

ParsedJob checked_in_time(const OpenedRequest& opened) {
  constexpr double more_seconds = 3;  // for rules of a model, as the command line has them
  const std::optional<double> time = opened.request.seconds;
  return stoppable(
      [&] { return checked_job(opened, Door::document); },
      time ? std::optional(std::min<double>(*time + more_seconds, most_seconds)) : std::nullopt);
}

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
             return py::bytes(written(self.request, self.asked, self.answer, format));
           })
      .def("request_json", [](const Planned& self) { return to_json(self.request); })
      .def("check_parts",
           [](const Planned& self, const std::vector<std::string>& parts) {
             static_cast<void>(parts_named(parts, self.job()));
           })
      .def("what_if", &ratios)
      .def("diagnose", &diagnosis_of);
  module.def("quoted", &quoted);
  module.def("check_amount", &check_amount);
  module.def("read_as", &read_as);
}

}  // namespace changeover::python
