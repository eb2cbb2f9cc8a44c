// Load orders and the executor: the systems door.
#include <chrono>
#include <memory>
#include <optional>
#include <variant>

#include "arguments.hpp"
#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/scope.hpp"
#include "gil.hpp"
#include "item_memory.hpp"
#include "loadorder/show/loads_answer.hpp"
#include "long_work.hpp"

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

// Pairs as rows of two item numbers, a NumPy array of them, too.
std::shared_ptr<const PairGraph> pairs_in(std::optional<std::uint64_t> items,
                                          const py::object& pairs) {
  if (pairs.is_none()) {
    return nullptr;
  }
  std::vector<ItemPair> listed;
  std::uint64_t most = 0;
  const py::object rows = rows_of("pairs", pairs);
  require_iterable("pairs", "rows of two items", rows);
  for_each(rows, [&](const py::handle& row) {
    require_iterable("pairs", "rows of two items", row);
    Element ends[2] = {};
    std::size_t count = 0;
    for_each(row, [&](const py::handle& end) {
      if (count == 2) {
        throw BadInput("pairs: row " + std::to_string(listed.size()) +
                       " has more than two items; a pair has two");
      }
      const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(end.ptr()));
      if (!number) {
        throw py::error_already_set();
      }
      if (!(number >= py::int_(0) && number < py::int_(most_items))) {
        throw BadInput("pairs: items are numbered from 0 to " + std::to_string(most_items - 1) +
                       ", not " + quoted(words_of(number)));
      }
      ends[count++] = number.cast<Element>();
    });
    if (count != 2) {
      throw BadInput("pairs: row " + std::to_string(listed.size()) +
                     " has fewer than two items; a pair has two");
    }
    listed.emplace_back(ends[0], ends[1]);
    most = std::max<std::uint64_t>({most, ends[0] + 1ULL, ends[1] + 1ULL});
  });
  return std::make_shared<const PairGraph>(items.value_or(most), listed);
}

// An answer that is a schedule of this kind.
template <typename Schedule>
struct Answered {
  std::shared_ptr<const LoadsAnswer> answer;
  const Schedule* operator->() const { return &std::get<Schedule>(answer->loads()); }
  [[nodiscard]] std::string to_json() const {
    const GilReleased released;
    StringSink sink;
    answer->write("jsonl", sink);
    return sink.text();
  }
};
using OneOrder = Answered<LoadOrder>;
using Split = Answered<WorkerSplit>;

py::object order(std::optional<std::uint64_t> items, std::uint64_t room, const py::object& pairs,
                 std::optional<std::uint64_t> against, std::optional<std::uint64_t> done_items,
                 std::optional<std::uint64_t> workers, std::optional<double> time,
                 std::uint64_t threads, std::uint64_t seed, py::object progress) {
  if (int{!pairs.is_none()} + int{against.has_value()} + int{done_items.has_value()} > 1) {
    throw BadInput("give one of pairs, against and done_items");
  }
  if (!items && pairs.is_none()) {
    throw BadInput("give items, how many there are");
  }
  // The time is that of the search for a better order: the order itself is not cut short.
  if (time && !(*time >= 0 && *time <= 1e9)) {
    throw py::value_error("time is a number of seconds, 0 or more");
  }
  const LoadRequest request{.items = items,
                            .room = room,
                            .against = against,
                            .done_items = done_items,
                            .workers = workers,
                            .seconds = time,
                            .seed = seed};
  const CheckedLoads asked = checked_loads(request, Door::document, pairs_in(items, pairs));
  LongWork work({.threads = threads,
                 .seed = seed,
                 .progress = std::move(progress),
                 .keeps_best = time.has_value()});
  std::shared_ptr<const LoadsAnswer> answer;
  const auto plan = [&](const LoadOrderOptions& options) {
    answer = std::make_shared<const LoadsAnswer>(asked, request, options);
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
  return workers ? py::cast(Split{std::move(answer)}) : py::cast(OneOrder{std::move(answer)});
}

Steps steps_of_worker(const Split& self, std::uint64_t worker) {
  if (worker >= self->facts().workers.size()) {
    throw py::index_error("there are " + std::to_string(self->facts().workers.size()) + " workers");
  }
  return {self->stream(worker)};
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

AllPairsReport run(const std::string& path, std::uint64_t item_bytes, std::uint64_t room,
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
  return report;
}

}  // namespace

void bind_loads(py::module_& module) {
  py::class_<Steps>(module, "_Steps")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &next_step);
  py::class_<OneOrder>(
      module, "LoadOrder",
      "Steps (evict, load), lists of item numbers, after which every pair was in memory together.")
      .def_property_readonly("items", [](const OneOrder& self) { return self->facts().items; })
      .def_property_readonly("room", [](const OneOrder& self) { return self->facts().room; })
      .def_property_readonly(
          "loads", [](const OneOrder& self) { return self->facts().loads; },
          "All loads, the first ones included.")
      .def_property_readonly("steps", [](const OneOrder& self) { return self->facts().steps; })
      .def_property_readonly(
          "lower_bound", [](const OneOrder& self) { return self->facts().bound.loads; },
          "No order has fewer loads.")
      .def_property_readonly(
          "reason", [](const OneOrder& self) { return self->facts().bound.reason; },
          "Of the bound.")
      .def_property_readonly("method", [](const OneOrder& self) { return self->facts().method; })
      .def_property_readonly(
          "certificate", [](const OneOrder& self) { return self->facts().certificate; },
          "How it was verified, one line.")
      .def("to_json", &OneOrder::to_json,
           "changeover-loads/1: an object for the order, then one for each step, a line each.")
      .def("__iter__", [](const OneOrder& self) { return Steps{self->stream()}; })
      .def("__len__", [](const OneOrder& self) { return self->facts().steps; })
      .def("__repr__", [](const OneOrder& self) {
        return "<LoadOrder: " + std::to_string(self->facts().loads) + " loads for " +
               std::to_string(self->facts().items) + " items, room for " +
               std::to_string(self->facts().room) + ">";
      });
  py::class_<Split>(
      module, "WorkerLoads",
      "A load order for several workers: steps (evict, load) of each, after which every pair was in the memory of one of them together.")
      .def_property_readonly("items", [](const Split& self) { return self->facts().items; })
      .def_property_readonly("room", [](const Split& self) { return self->facts().room; })
      .def_property_readonly(
          "loads", [](const Split& self) { return self->facts().loads; },
          "Of all workers together.")
      .def_property_readonly(
          "worker_loads",
          [](const Split& self) {
            py::list loads;
            for (const WorkerFacts& worker : self->facts().workers) {
              loads.append(worker.loads);
            }
            return loads;
          },
          "Of each worker.")
      .def_property_readonly(
          "makespan", [](const Split& self) { return self->facts().makespan; },
          "The loads of the worker that has most.")
      .def_property_readonly(
          "makespan_bound", [](const Split& self) { return self->facts().makespan_bound.loads; },
          "However it is split, some worker has so many.")
      .def_property_readonly(
          "reason", [](const Split& self) { return self->facts().makespan_bound.reason; },
          "Of that bound.")
      .def_property_readonly(
          "certificate", [](const Split& self) { return self->facts().certificate; },
          "How it was verified, one line.")
      .def("to_json", &Split::to_json,
           "changeover-loads/1: an object for all workers, then one for each step, a line each.")
      .def("steps", &steps_of_worker, py::arg("worker"), "The steps of one worker, from 0.")
      .def("__len__", [](const Split& self) { return self->facts().workers.size(); })
      .def("__repr__", [](const Split& self) {
        return "<WorkerLoads: " + std::to_string(self->facts().workers.size()) +
               " workers, the busiest has " + std::to_string(self->facts().makespan) + " loads>";
      });
  py::class_<AllPairsReport>(module, "Report", "What an out-of-core job did.")
      .def_readonly("finished", &AllPairsReport::finished)
      .def_readonly("steps", &AllPairsReport::steps)
      .def_readonly("steps_resumed", &AllPairsReport::steps_resumed,
                    "Done by an earlier run, as the journal says.")
      .def_readonly("loads", &AllPairsReport::loads)
      .def_readonly("bytes_read", &AllPairsReport::bytes_read)
      .def_readonly("pairs", &AllPairsReport::pairs, "Calls of compute().")
      .def_readonly("most_in_memory", &AllPairsReport::most_in_memory, "Items.");
  module.def(
      "load_order", &order, py::arg("items"), py::arg("room"), py::kw_only(),
      py::arg("pairs") = py::none(), py::arg("against") = py::none(),
      py::arg("done_items") = py::none(), py::arg("workers") = py::none(),
      py::arg("time") = py::none(), py::arg("threads") = 1, py::arg("seed") = 1,
      py::arg("progress") = py::none(),
      "An order of loads after which every pair of `items` items was in memory together, with room for `room`; `time` "
      "seconds of search for a better one. Verified. Iterating gives steps (evict, load).\n\n"
      "pairs: only these must meet, rows of two item numbers, a NumPy array of shape (n, 2), too; items may then be None. "
      "against: each of the items with each of so many others, numbered after them. done_items: the pairs of the first so "
      "many have met before. workers: split it for so many, which gives WorkerLoads. Raises BadInput, ImpossibleParameters.");
  module.def(
      "all_pairs", &run, py::arg("path"), py::arg("item_bytes"), py::arg("room"),
      py::arg("compute"), py::kw_only(), py::arg("header_bytes") = 0, py::arg("threads") = 1,
      py::arg("journal") = "",
      "Runs an all-pairs job over a file of items of item_bytes each, never more than `room` of them in memory.\n\n"
      "compute(i, j, first, second) is called once for each pair i < j and for each item with itself (i = j), with read-only "
      "memoryviews that end with the call; what is made of them (slices, arrays) stays as it is, and keeps the item in "
      "memory beyond the room. With a journal a job that was ended goes on where it was. What compute "
      "raises ends the job. Raises BadInput, MissingResource.");
}

}  // namespace changeover::python
