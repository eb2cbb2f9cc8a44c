// Load orders and the executor: the systems door.
#include <chrono>
#include <cstring>
#include <memory>
#include <optional>
#include <variant>

#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "gil.hpp"
#include "loadorder/show/loads_answer.hpp"
#include "long_work.hpp"
#include "memory.hpp"

namespace changeover::python {
namespace {

struct Steps {
  std::unique_ptr<StepSource> source;
  bool busy = false;
};

py::tuple next_step(Steps& self) {
  const OneAtATime one(self.busy);
  Step step;
  bool more = false;
  {
    const GilReleased released;
    more = self.source->next(step);
  }
  if (!more) {
    throw py::stop_iteration();
  }
  return py::make_tuple(py::cast(step.evict), py::cast(step.load));
}

// Pairs as the bytes of their items, one after the other.
std::shared_ptr<const PairGraph> pairs_in(std::optional<std::uint64_t> items,
                                          const std::optional<py::bytes>& ends) {
  if (!ends) {
    return nullptr;
  }
  const auto bytes = static_cast<std::string_view>(*ends);
  std::vector<Element> numbers(bytes.size() / sizeof(Element));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  std::vector<ItemPair> listed;
  std::uint64_t most = 0;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    listed.emplace_back(numbers[i], numbers[i + 1]);
    most = std::max<std::uint64_t>({most, numbers[i] + 1ULL, numbers[i + 1] + 1ULL});
  }
  return std::make_shared<const PairGraph>(items.value_or(most), listed);
}

// An answer, of one worker or of several.
struct Loads {
  std::shared_ptr<const LoadsAnswer> answer;

  [[nodiscard]] const LoadOrder* one() const { return std::get_if<LoadOrder>(&answer->loads()); }
  [[nodiscard]] const WorkerSplit& split() const { return std::get<WorkerSplit>(answer->loads()); }
  [[nodiscard]] std::string to_json() const {
    const GilReleased released;
    StringSink sink;
    answer->write("jsonl", sink);
    return sink.text();
  }
};

py::dict facts_of(const Loads& loads) {
  if (const LoadOrder* const one = loads.one()) {
    const auto& facts = one->facts();
    return py::dict(py::arg("items") = facts.items, py::arg("room") = facts.room,
                    py::arg("loads") = facts.loads, py::arg("steps") = facts.steps,
                    py::arg("lower_bound") = facts.bound.loads,
                    py::arg("reason") = facts.bound.reason, py::arg("method") = facts.method,
                    py::arg("certificate") = facts.certificate);
  }
  const auto& facts = loads.split().facts();
  std::vector<std::uint64_t> of_workers;
  for (const WorkerFacts& worker : facts.workers) {
    of_workers.push_back(worker.loads);
  }
  return py::dict(
      py::arg("items") = facts.items, py::arg("room") = facts.room, py::arg("loads") = facts.loads,
      py::arg("worker_loads") = of_workers, py::arg("makespan") = facts.makespan,
      py::arg("makespan_bound") = facts.makespan_bound.loads,
      py::arg("reason") = facts.makespan_bound.reason, py::arg("certificate") = facts.certificate);
}

py::tuple order(const std::string& document, const std::optional<py::bytes>& pairs,
                std::optional<double> time, std::uint64_t threads, std::uint64_t seed,
                py::object progress) {
  LoadRequest request = load_request(document);
  request.seconds = time;
  request.seed = seed;
  const CheckedLoads asked = checked_loads(request, Door::document, pairs_in(request.items, pairs));
  LongWork work({.threads = threads,
                 .seed = seed,
                 .progress = std::move(progress),
                 .keeps_best = time.has_value()});
  Loads loads;
  const auto plan = [&](const LoadOrderOptions& options) {
    loads.answer = std::make_shared<const LoadsAnswer>(asked, request, options);
  };
  work.run([&](RunControl& control) {
    LoadOrderOptions options;
    options.seed = seed;
    plan(options);
    if (time) {
      RunControl limited(control, std::chrono::duration<double>(*time));
      options.improve = improve_by_search(limited);
      options.search_pairs = [&](const std::function<void()>& search) {
        const RunScope scope(limited);
        search();
      };
      try {
        plan(options);
      } catch (const Stopped&) {
        // Ctrl-C: the order that needed no search is the best so far.
      }
    }
  });
  const py::dict facts = facts_of(loads);
  return py::make_tuple(std::move(loads), facts);
}

// Says which pair compute() was given: as a note of the exception, where Python has notes (3.11).
void note_pair(py::error_already_set& fault, const PairWork& pair) {
  if (py::hasattr(fault.value(), "add_note")) {
    const auto note =
        py::str("compute({}, {}) raised this").format(pair.first.item, pair.second.item);
    fault.value().attr("add_note")(note);
  }
}

void call(const py::function& compute, const PairWork& pair) {
  const GilHeld held;
  const py::object first = view_of(pair.first);
  const py::object second = view_of(pair.second);
  const py::tuple arguments = py::make_tuple(pair.first.item, pair.second.item, first, second);
  try {
    made_by_python([&] { return PyObject_CallObject(compute.ptr(), arguments.ptr()); });
  } catch (py::error_already_set& fault) {
    note_pair(fault, pair);
    throw;
  }
  end_view(first);
  end_view(second);
}

py::dict run(const std::string& path, std::uint64_t item_bytes, std::uint64_t room,
             const py::function& compute, std::uint64_t header_bytes, std::uint64_t threads,
             const std::string& journal) {
  constexpr std::uint64_t most_threads = 4096;
  if (threads < 1 || threads > most_threads) {
    throw BadInput("threads is a number from 1 to 4096");
  }
  AllPairsReport report;
  LongWork work({.threads = 1});
  work.run([&](RunControl& control) {
    FileItems file(path, item_bytes, {.header_bytes = header_bytes});
    const LoadOrder loads = plan_load_order(file.item_count(), room);
    std::atomic<bool> cancelled = false;
    AllPairsOptions options;
    options.threads = static_cast<unsigned>(threads);
    options.journal = journal;
    options.cancelled = &cancelled;
    report = all_pairs(
        file, loads,
        [&](const PairWork& pair) {
          if (control.stop_wanted()) {
            cancelled = true;
            return;
          }
          call(compute, pair);
        },
        options);
    if (cancelled) {
      throw Stopped(control.why_stopped());
    }
  });
  return py::dict(py::arg("finished") = report.finished, py::arg("steps") = report.steps,
                  py::arg("steps_resumed") = report.steps_resumed, py::arg("loads") = report.loads,
                  py::arg("bytes_read") = report.bytes_read, py::arg("pairs") = report.pairs,
                  py::arg("most_in_memory") = report.most_in_memory);
}

}  // namespace

void bind_loads(py::module_& module) {
  py::class_<Steps>(module, "Steps")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &next_step);
  py::class_<Loads>(module, "Loads")
      .def("to_json", &Loads::to_json)
      .def("steps", [](const Loads& self, std::uint64_t worker) {
        return Steps{self.one() != nullptr ? self.one()->stream() : self.split().stream(worker)};
      });
  module.attr("most_items") = most_items;
  module.def("load_order", &order);
  module.def("all_pairs", &run);
}

}  // namespace changeover::python
