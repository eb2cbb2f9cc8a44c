// Load orders and the executor: the systems door.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <functional>
#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "gil.hpp"
#include "loadorder/order/searched.hpp"
#include "loadorder/show/loads_answer.hpp"
#include "loadorder/show/marius_writer.hpp"
#include "loadorder/show/step_writer.hpp"
#include "long_work.hpp"
#include "memory.hpp"

namespace changeover::python {
namespace {

struct Steps {
  std::unique_ptr<StepSource> source;
  bool busy = false;
};

// The next step; other threads of Python run meanwhile. @throws stop_iteration at the end
template <typename Reader>
Step next_of(Reader& self) {
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
  return step;
}

py::tuple next_step(Steps& self) {
  const Step step = next_of(self);
  return py::make_tuple(py::cast(step.evict), py::cast(step.load));
}

// Steps with what each computes, of all workers one after another.
struct Work {
  std::shared_ptr<const LoadsAnswer> answer;  // outlives the source
  std::unique_ptr<StepSource> source;
  bool busy = false;
};

// (worker, evict, load, pairs): the items of the pairs one after the other, as bytes.
py::tuple next_work(Work& self) {
  const Step step = next_of(self);
  std::vector<Element> ends;
  ends.reserve(2 * step.compute.size());
  for (const auto& [x, y] : step.compute) {
    ends.push_back(x);
    ends.push_back(y);
  }
  return py::make_tuple(
      step.worker, py::cast(step.evict), py::cast(step.load),
      py::bytes(reinterpret_cast<const char*>(ends.data()), ends.size() * sizeof(Element)));
}

// Steps with all that was asked for.
struct FullSteps : Work {};

// (number, worker, evict, load, store, pairs, overlap, late, epoch, fast_evict, fast_load)
py::tuple next_full(FullSteps& self) {
  const Step step = next_of(self);
  return py::make_tuple(step.number, step.worker, py::cast(step.evict), py::cast(step.load),
                        py::cast(step.store), py::cast(step.compute), py::cast(step.overlap),
                        step.late, step.epoch, py::cast(step.fast_evict), py::cast(step.fast_load));
}

// Reads all steps on a separate thread; destroying it stops that.
class Check {
 public:
  explicit Check(std::shared_ptr<const LoadsAnswer> answer)
      : control_({.interrupted = &stop_}),
        verdict_(std::async(std::launch::async, [this, answer = std::move(answer)] {
          const RunScope scope(control_);
          return answer->fault();
        })) {}
  ~Check() { stop_ = true; }
  Check(const Check&) = delete;
  Check& operator=(const Check&) = delete;

  /// Empty if the steps are right.
  [[nodiscard]] std::string fault() const { return verdict_.get(); }

 private:
  std::atomic<bool> stop_{false};
  RunControl control_;
  std::shared_future<std::string> verdict_;  // waits when it is destroyed
};

// Pairs as the bytes of their items, one after the other.
std::shared_ptr<const PairGraph> pairs_in(std::optional<std::uint64_t> items,
                                          std::string_view bytes) {
  if (bytes.size() % (2 * sizeof(Element)) != 0) {
    throw BadInput("the numbers of the pairs are not whole pairs");
  }
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
  std::shared_ptr<const Check> check = nullptr;  // if steps are verified beside

  [[nodiscard]] const LoadOrder* one() const { return answer->order(); }
  [[nodiscard]] const WorkerSplit& split() const { return *answer->split(); }
  [[nodiscard]] std::string in_format(const std::string& format) const {
    const GilReleased released;
    StringSink sink;
    answer->write(format, sink);
    return sink.text();
  }
};

// @throws ImpossibleParameters for so many items that it is not kept in mind which pairs were
// computed
Work work_of(const Loads& loads) {
  const LoadOrder& order = loads.one() != nullptr ? *loads.one() : loads.split().order();
  ScheduleRules rules = order.rules(ComputeRules{});
  if (loads.one() == nullptr) {
    rules.items = loads.split().facts().items;
    rules.room = loads.split().facts().room;
  }
  if (rules.items > max_elements_in_memory && rules.wanted.graph() == nullptr) {
    throw ImpossibleParameters(
        "all pairs of more than 65535 items: group items into larger ones, or list the pairs");
  }
  auto steps = loads.one() != nullptr ? order.stream() : loads.split().stream();
  auto owners = loads.one() != nullptr ? nullptr : loads.split().owners();
  return {loads.answer, std::make_unique<StepWork>(std::move(steps), rules, std::move(owners))};
}

// The shares of workers without their steps, of any number of items.
class Shapes {
 public:
  explicit Shapes(const Loads& loads) : loads_(loads.answer) {
    const LoadOrder* const one = loads.one();
    items_ = one != nullptr ? one->facts().items : loads.split().facts().items;
    groups_ = one != nullptr ? items_ : loads.split().facts().groups;
    steps_ = one != nullptr ? one->stream() : loads.split().stream();
    known_ =
        one == nullptr && loads.split().facts().pairs_are_known ? &loads.split().facts() : nullptr;
    met_.resize(groups_ <= most_kept_groups ? groups_ : 0);
    first_of_group_.resize(met_.empty() ? 0 : groups_);
    for (std::uint64_t g = 0; g < first_of_group_.size(); ++g) {
      first_of_group_[g] = g * items_ / groups_;
      met_[g].resize(g + 1);
    }
  }

  // For each worker its loads, those of its first step, and its pairs.
  [[nodiscard]] std::vector<std::uint64_t> read() {
    const SplitFacts* const known = known_;
    std::vector<std::uint64_t> shapes;
    std::vector<std::uint64_t> held;
    std::uint64_t count = 0;
    std::uint64_t worker = 0;
    bool first = true;
    for (Step step; steps_->next(step);) {
      stop_if_asked();
      if (step.worker >= shapes.size() / 3) {
        shapes.resize(3 * (step.worker + 1));
      }
      if (step.worker != worker || first) {
        worker = step.worker;
        held.clear();
        count = 0;
        shapes[3 * worker + 1] = step.load.size();
      }
      shapes[3 * worker] += step.load.size();
      if (known != nullptr) {
        shapes[3 * worker + 2] = known->workers[static_cast<std::size_t>(worker)].pairs;
      } else {
        shapes[3 * worker + 2] +=
            met_.empty() ? by_number(step, count, first) : by_group(step, held);
      }
      count = count + step.load.size() - step.evict.size();
      first = false;
    }
    return shapes;
  }

 private:
  static constexpr std::uint64_t most_kept_groups = 20'000;

  // Each load is taken to meet all that is there; what a later worker loads first has met before,
  // but for one item.
  static std::uint64_t by_number(const Step& step, std::uint64_t count, bool first) {
    const std::uint64_t there = count - std::min<std::uint64_t>(count, step.evict.size());
    const std::uint64_t come = step.load.size();
    if (there == 0 && !first) {
      return come == 0 ? 0 : come - 1;
    }
    return come * there + come * (come - std::min<std::uint64_t>(come, 1)) / 2;
  }

  // Groups come and go as a whole.
  std::uint64_t by_group(const Step& step, std::vector<std::uint64_t>& held) {
    for (const std::uint64_t g : groups_in(step.evict)) {
      std::erase(held, g);
    }
    std::uint64_t pairs = 0;
    for (const std::uint64_t g : groups_in(step.load)) {
      held.push_back(g);
      for (const std::uint64_t h : held) {
        if (!met_[std::max(g, h)][std::min(g, h)]) {
          met_[std::max(g, h)][std::min(g, h)] = true;
          pairs += g == h ? size(g) * (size(g) - 1) / 2 : size(g) * size(h);
        }
      }
    }
    return pairs;
  }

  [[nodiscard]] std::uint64_t size(std::uint64_t g) const {
    return (g + 1) * items_ / groups_ - g * items_ / groups_;
  }

  [[nodiscard]] std::vector<std::uint64_t> groups_in(const std::vector<Element>& items) const {
    std::vector<std::uint64_t> found;
    for (const Element x : items) {
      const std::uint64_t g = ((std::uint64_t{x} + 1) * groups_ - 1) / items_;
      if (first_of_group_[g] == x) {
        found.push_back(g);
      }
    }
    return found;
  }

  std::shared_ptr<const LoadsAnswer> loads_;
  std::unique_ptr<StepSource> steps_;
  std::uint64_t items_ = 0, groups_ = 0;
  const SplitFacts* known_ = nullptr;  // that say how many pairs workers compute
  std::vector<std::uint64_t> first_of_group_;
  std::vector<std::vector<bool>> met_;  // groups that have met, larger number first
};

py::bytes shapes_of(const Loads& loads) {
  const auto shapes = stoppable([&] { return Shapes(loads).read(); });
  return {reinterpret_cast<const char*>(shapes.data()), shapes.size() * sizeof(shapes[0])};
}

Loads planned(const std::string& document, const std::optional<py::bytes>& pairs,
              py::object progress) {
  const LoadRequest request = load_request(document, "", Door::python);
  const std::string_view ends = pairs ? static_cast<std::string_view>(*pairs) : std::string_view();
  const CheckedLoads asked = stoppable([&] {
    return checked_loads(request, Door::python, pairs ? pairs_in(request.items, ends) : nullptr);
  });
  const double seconds = request.seconds.value_or(0);
  const std::uint64_t seed = request.seed.value_or(1);
  LongWork work({.threads = request.threads.value_or(1),
                 .seed = seed,
                 .progress = std::move(progress),
                 .keeps_best = request.seconds.has_value()});
  Loads loads;
  work.run([&](RunControl& control) {
    // What Ctrl-C stops in a search is kept, and what follows is done as without it.
    bool keeps_best = false;
    RunControl::Settings settings = control.settings();
    settings.found_elsewhere = [&] { return !keeps_best && control.stop_wanted(); };
    RunControl planning(std::move(settings));
    const RunScope scope(planning);
    LoadOrderOptions options;
    options.seed = seed;
    if (seconds > 0) {
      options = searched(seconds, seed, [&](const std::function<void(RunControl&)>& search) {
        RunControl part(control, std::chrono::duration<double>(seconds));
        search(part);
        keeps_best = keeps_best || control.stop_wanted();
      });
    }
    loads.answer = std::make_shared<const LoadsAnswer>(asked, options);
  });
  // What steps compute and store is verified now, or beside, as loads are.
  if (request.verify_beside) {
    loads.check = std::make_shared<const Check>(loads.answer);
  }
  return loads;
}

// The steps of an order that a pickle has.
class RecordedSteps final : public StepSource {
 public:
  explicit RecordedSteps(std::vector<Step> steps) : steps_(std::move(steps)) {}

  bool next(Step& step) override {
    if (read_ == steps_.size()) {
      return false;
    }
    step = steps_[read_++];
    return true;
  }

 private:
  std::vector<Step> steps_;
  std::size_t read_ = 0;
};

// (number, worker, evict, load, store, pairs, overlap, late, epoch, fast_evict, fast_load), as
// next_full() has it
Step recorded_step(const py::handle& given) {
  const auto step = given.cast<py::tuple>();
  std::size_t at = 0;
  const auto take = [&](auto& field) {
    field = step[at++].cast<std::remove_reference_t<decltype(field)>>();
  };
  Step read;
  take(read.number);
  take(read.worker);
  take(read.evict);
  take(read.load);
  take(read.store);
  take(read.compute);
  take(read.overlap);
  take(read.late);
  take(read.epoch);
  take(read.fast_evict);
  take(read.fast_load);
  return read;
}

// An order that a pickle has, for COLMAP or Marius, as LoadsAnswer::write() has it. Where the steps
// are without pairs, these are found again; `fast_room` is that of the order.
std::string recorded_in_format(const std::string& document, const std::optional<py::bytes>& pairs,
                               std::optional<std::uint64_t> fast_room, const py::iterable& steps,
                               bool has_pairs, const std::string& format) {
  const LoadRequest request = load_request(document, "", Door::python);
  const std::string_view ends = pairs ? static_cast<std::string_view>(*pairs) : std::string_view();
  const CheckedLoads asked =
      checked_loads(request, Door::python, pairs ? pairs_in(request.items, ends) : nullptr);
  check_format(asked, format);
  std::vector<Step> read;
  for (const py::handle step : steps) {
    read.push_back(recorded_step(step));
    if (!has_pairs) {
      read.back().compute.clear();
    }
  }
  return stoppable([&] {
    ScheduleRules rules{.items = asked.items(),
                        .room = asked.room(),
                        .fast_room = fast_room,
                        .lockstep = request.disjoint ? request.workers.value_or(1) : 0,
                        .wanted = asked.wanted(),
                        .compute = ComputeRules{},
                        .sizes = asked.sizes(),
                        .epochs = request.epochs.value_or(1)};
    if (request.shuffle) {
      rules.compute->shuffle = request.seed.value_or(1);
    }
    if (request.spread) {
      rules.compute->spread = request.seed.value_or(1);
    }
    const bool is_marius = format == "marius";
    rules.compute->ordered = rules.compute->self = is_marius;
    std::unique_ptr<StepSource> source = std::make_unique<RecordedSteps>(std::move(read));
    if (!has_pairs) {
      source = std::make_unique<StepWork>(std::move(source), rules);
    }
    StringSink sink;
    if (is_marius) {
      LoadOrderFacts facts;
      facts.items = rules.items;
      facts.room = rules.room;
      facts.wanted = rules.wanted;
      write_steps_for_marius(facts, *source, sink);
    } else {
      StepWriter writer(sink, format, nullptr, {});
      for (Step step; source->next(step);) {
        writer.write(step);
      }
      writer.end();
    }
    return sink.text();
  });
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
             const std::string& journal, std::uint64_t share, std::uint64_t shares,
             const std::vector<std::string>& earlier, bool verify_beside, bool short_last) {
  if (threads == 0) {
    throw BadInput("threads 0: give at least 1");
  }
  if (threads > std::numeric_limits<unsigned>::max()) {
    throw BadInput(std::to_string(threads) + " threads are too many; give at most 4096");
  }
  AllPairsReport report;
  LongWork work({.threads = 1});
  work.run([&](RunControl& control) {
    FileItems file(path, item_bytes, {.header_bytes = header_bytes, .whole_items = !short_last});
    LoadOrderOptions planning;
    planning.read_first = !verify_beside;
    const LoadOrder loads = plan_load_order(file.item_count(), room, planning);
    std::atomic<bool> cancelled = false;
    AllPairsOptions options;
    options.threads = static_cast<unsigned>(threads);
    options.journal = journal;
    options.share = {share, shares};
    options.earlier = earlier;
    options.verify_beside = verify_beside;
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

// Calls update() with both items, which it may write. @throws BadInput if it has kept one
void call_update(const py::function& update, const PairUpdate& pair) {
  const GilHeld held;
  const std::array<const HeldItem*, 2> items{&pair.first, &pair.second};
  const std::array<long, 2> owners{pair.first.memory->use_count(), pair.second.memory->use_count()};
  {
    const py::object first = writable_view_of(pair.first);
    const py::object second = writable_view_of(pair.second);
    {
      const py::tuple arguments = py::make_tuple(pair.first.item, pair.second.item, first, second);
      made_by_python([&] { return PyObject_CallObject(update.ptr(), arguments.ptr()); });
    }
    end_view(first);
    end_view(second);
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i]->memory->use_count() > owners[i]) {
      throw BadInput("update() has kept memory of item " + std::to_string(items[i]->item) +
                     ", which another item takes later; copy what is to stay");
    }
  }
}

py::dict run_updates(const std::string& path, std::uint64_t item_bytes, std::uint64_t room,
                     const py::function& update, const std::string& journal, std::uint64_t workers,
                     std::uint64_t epochs, bool ordered, bool with_self, bool shuffle, bool spread,
                     std::uint64_t seed, std::uint64_t checkpoint_every) {
  UpdateReport report;
  LongWork work({.threads = 1});
  work.run([&](RunControl& control) {
    const FileItems file(path, item_bytes);
    const std::uint64_t items = file.item_count();
    const LoadOrder order = repeat_order(
        workers == 1 ? plan_load_order(items, room) : plan_disjoint_order(items, room, workers),
        epochs);
    std::atomic<bool> cancelled = false;
    UpdateOptions options{.data = path, .item_bytes = item_bytes, .journal = journal};
    options.checkpoint_every = checkpoint_every;
    options.work = {.ordered = ordered, .self = with_self};
    if (shuffle) {
      options.work.shuffle = seed;
    }
    if (spread) {
      options.work.spread = seed;
    }
    options.cancelled = &cancelled;
    options.on_step = [&](std::uint64_t) { cancelled = control.stop_wanted(); };
    report = update_pairs(
        order, [&](const PairUpdate& pair) { call_update(update, pair); }, options);
    if (!report.finished) {
      throw Stopped(control.why_stopped());
    }
  });
  return py::dict(py::arg("finished") = report.finished, py::arg("steps") = report.steps,
                  py::arg("steps_resumed") = report.steps_resumed, py::arg("loads") = report.loads,
                  py::arg("stores") = report.stores,
                  py::arg("checkpoint_stores") = report.checkpoint_stores,
                  py::arg("updates") = report.updates, py::arg("note") = report.note);
}

}  // namespace

void bind_loads(py::module_& module) {
  py::class_<Steps>(module, "Steps")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &next_step);
  py::class_<Work>(module, "Work")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &next_work);
  py::class_<FullSteps>(module, "FullSteps")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &next_full);
  py::class_<Loads>(module, "Loads")
      .def_static("planned", &planned)
      .def("head", [](const Loads& self) { return stoppable([&] { return self.answer->head(); }); })
      .def("work", &work_of)
      .def("shapes", &shapes_of)
      .def("in_format", &Loads::in_format)
      .def("fault",
           [](const Loads& self) {
             const GilReleased released;
             return self.check == nullptr ? std::string() : self.check->fault();
           })
      .def("steps_from", [](const Loads& self,
                            std::uint64_t step) { return Steps{self.one()->stream_from(step)}; })
      .def("full_steps",
           [](const Loads& self, std::optional<std::uint64_t> worker) {
             return FullSteps{{self.answer, self.answer->steps(worker)}};
           })
      .def("steps", [](const Loads& self, std::uint64_t worker) {
        return Steps{self.one() == nullptr               ? self.split().stream(worker)
                     : self.one()->facts().lockstep == 0 ? self.one()->stream()
                                                         : self.one()->stream(worker)};
      });
  module.def("recorded_in_format", &recorded_in_format);
  module.attr("most_items") = most_items;
  module.def("load_request_json",
             [](const std::string& document) { return to_json(load_request(document)); });
  module.def("all_pairs", &run);
  module.def("update_pairs", &run_updates);
}

}  // namespace changeover::python
