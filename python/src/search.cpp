// Searches and classifications: they end when they are asked to, and keep what they found.
#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/outcome.hpp"
#include "changeover/search/enumeration.hpp"
#include "changeover/search/local_search.hpp"
#include "changeover/search/minimum_search.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

struct Found {
  std::optional<HeldDesign> design;
  std::uint64_t lower_bound = 0;
  std::string reason;  // of the bound, or why there is none
  std::string why_stopped;
  std::string how;
  bool interrupted = false;
  bool settled = false;  // the design has lower_bound blocks, or none exists
  std::uint64_t moves = 0;
  double seconds = 0;
};

LongOptions limits(std::optional<double> time, std::uint64_t threads, std::uint64_t seed,
                   py::object progress) {
  return {.seconds = time,
          .threads = threads,
          .seed = seed,
          .progress = std::move(progress),
          .keeps_best = true};
}

Found search_locally(const Parameters& p, LongWork& work, std::optional<std::uint64_t> target,
                     const std::optional<Design>& start) {
  ImproveResult result;
  work.run([&](RunControl& control) {
    result = improve(p, {.target = target, .start = start}, control);
  });
  Found found;
  found.lower_bound = result.lower_bound;
  found.why_stopped = to_string(result.why_stopped);
  found.how = result.unsearched.empty() ? result.how : result.unsearched;
  found.moves = result.moves;
  found.seconds = result.elapsed.count();
  if (result.design) {
    found.settled = result.design->block_count() == result.lower_bound;
    found.design = held(std::move(*result.design));
  }
  return found;
}

Found search_exactly(const Parameters& p, LongWork& work, const std::optional<Design>& start) {
  MinimumResult result;
  work.run([&](RunControl& control) { result = find_minimum(p, {}, control, start); });
  Found found;
  found.lower_bound = result.lower;
  found.reason = result.impossible.value_or(
      result.lower == result.start.blocks
          ? result.start.reason
          : "fewer blocks were excluded, each number by a checked proof");
  found.why_stopped = to_string(result.why_stopped);
  found.how = "exact search";
  found.seconds = result.time.count();
  found.settled = result.impossible || result.settled();
  if (result.best) {
    found.design = held(std::move(*result.best));
  }
  return found;
}

Found search(std::uint64_t v, std::uint64_t k, std::uint64_t change, const std::string& kind,
             std::uint32_t strength, std::optional<double> time, std::uint64_t threads,
             std::uint64_t seed, std::optional<std::uint64_t> target,
             const std::optional<HeldDesign>& start, bool exact, py::object progress) {
  const Parameters p{.v = v, .k = k, .change = change, .kind = kind_of(kind), .strength = strength};
  check(p);
  if (exact && target) {
    throw BadInput("target is for the search that is not exact; an exact one ends at the minimum");
  }
  LongWork work(limits(time, threads, seed, std::move(progress)));
  const std::optional<Design> from = start ? std::optional(*start->design) : std::nullopt;
  Found found = exact ? search_exactly(p, work, from) : search_locally(p, work, target, from);
  found.interrupted = work.interrupted();
  return found;
}

struct Classes {
  Classification all;
  std::vector<HeldDesign> designs;
  bool interrupted = false;
};

Classes classify(std::uint64_t v, std::uint64_t k, std::uint64_t b, std::uint64_t change,
                 const std::string& kind, bool reversal, std::uint64_t keep,
                 std::optional<double> time, std::uint64_t threads, py::object progress) {
  const Parameters p{.v = v, .k = k, .change = change, .kind = kind_of(kind)};
  check(p);
  LongWork work(limits(time, threads, 1, std::move(progress)));
  Classes classes;
  work.run([&](RunControl& control) {
    classes.all = classify_designs(p, b, {.reversal = reversal, .keep = keep}, control);
  });
  for (const DesignClass& each : classes.all.kept) {
    classes.designs.push_back(held(surely_verified(each.representative, name(p))));
  }
  classes.interrupted = work.interrupted();
  return classes;
}

}  // namespace

void bind_search(py::module_& module) {
  py::class_<Found>(module, "SearchResult",
                    "What a search found before it ended; the best so far if it was stopped.")
      .def_readonly("design", &Found::design, "The best design, verified, or None.")
      .def_property_readonly(
          "b",
          [](const Found& self) {
            return self.design ? std::optional(self.design->design->block_count()) : std::nullopt;
          },
          "Its number of blocks, or None.")
      .def_readonly("lower_bound", &Found::lower_bound, "No design has fewer blocks.")
      .def_readonly("reason", &Found::reason, "Of the bound, if the search was exact.")
      .def_readonly("minimum", &Found::settled,
                    "Proved: nothing has fewer blocks than `design`, or nothing exists.")
      .def_readonly("why_stopped", &Found::why_stopped,
                    "'found', 'exhausted', 'time limit', 'interrupted', …")
      .def_readonly("interrupted", &Found::interrupted, "Ctrl-C ended it.")
      .def_readonly("how", &Found::how, "How the design was found, one line.")
      .def_readonly("moves", &Found::moves, "Proposals of the local search.")
      .def_readonly("seconds", &Found::seconds)
      .def("__repr__", [](const Found& self) {
        return "<SearchResult: " +
               (self.design ? std::to_string(self.design->design->block_count()) + " blocks"
                            : std::string("no design")) +
               ", at least " + std::to_string(self.lower_bound) + ", " + self.why_stopped + ">";
      });
  py::class_<Classes>(module, "Classification",
                      "All designs with so many blocks, up to isomorphism.")
      .def_property_readonly("standard_forms",
                             [](const Classes& self) { return self.all.standard_forms; })
      .def_property_readonly(
          "classes", [](const Classes& self) { return self.all.classes; }, "Isomorphism classes.")
      .def_property_readonly(
          "tight", [](const Classes& self) { return self.all.tight; }, "Classes of tight designs.")
      .def_property_readonly(
          "complete",
          [](const Classes& self) { return self.all.why_stopped == WhyStopped::exhausted; },
          "These are all; otherwise the search was stopped, and these are some.")
      .def_readonly("interrupted", &Classes::interrupted)
      .def_property_readonly(
          "group_orders",
          [](const Classes& self) {
            py::dict orders;
            for (const auto& [order, count] : self.all.group_orders) {
              orders[py::int_(py::str(order))] = count;
            }
            return orders;
          },
          "How many classes have an automorphism group of each order.")
      .def_readonly("designs", &Classes::designs, "The first `keep` representatives.")
      .def("__repr__", [](const Classes& self) {
        return "<" + std::to_string(self.all.classes) + " classes>";
      });
  module.def(
      "search", &search, py::arg("v"), py::arg("k"), py::arg("change") = 2,
      py::arg("kind") = "linear", py::arg("strength") = 2, py::kw_only(), py::arg("time") = 60.0,
      py::arg("threads") = 1, py::arg("seed") = 1, py::arg("target") = py::none(),
      py::arg("start") = py::none(), py::arg("exact") = false, py::arg("progress") = py::none(),
      "Looks for a design with fewer blocks than any that is known, for `time` seconds (None: until it is the lower "
      "bound) with `threads` threads.\n\n"
      "exact=True walks up from the lower bound and proves each number of blocks impossible, with checked proofs, "
      "until there is a design: the minimum. progress is called now and then with a dict (phase, steps, best, elapsed, "
      "left, ...); what it raises ends the search and arrives here. Ctrl-C ends it and keeps the best so far, marked "
      "interrupted. With one thread the result of a search that no clock ends depends on the seed alone.");
  module.def(
      "classify", &classify, py::arg("v"), py::arg("k"), py::arg("b"), py::arg("change") = 2,
      py::arg("kind") = "linear", py::kw_only(), py::arg("reversal") = false, py::arg("keep") = 100,
      py::arg("time") = py::none(), py::arg("threads") = 1, py::arg("progress") = py::none(),
      "All designs with exactly b blocks up to names of elements and rotation, and reversal if asked for. Raises "
      "ImpossibleParameters above 64 elements or 4096 blocks. Exponential in b.");
}

}  // namespace changeover::python
