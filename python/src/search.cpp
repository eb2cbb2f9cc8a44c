// Searches and classifications: they end when they are asked to, and keep what they found.
#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/enumeration.hpp"
#include "changeover/search/exact.hpp"
#include "changeover/search/local_search.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

struct Found {
  std::optional<HeldDesign> design;
  std::uint64_t lower_bound = 0;
  std::string reason;  // of the bound, or why there is none
  std::string why_stopped;
  std::string how;
  bool settled = false;  // the design has lower_bound blocks, or none exists
  std::uint64_t moves = 0;
  double seconds = 0;
};

// The answer of a search without proofs.
template <typename Result>
Found found_by(const Result& result, std::string how) {
  Found found;
  found.lower_bound = result.lower_bound;
  found.why_stopped = to_string(result.why_stopped);
  found.how = std::move(how);
  found.moves = result.moves;
  found.seconds = result.elapsed.count();
  if (result.design) {
    found.settled = result.design->block_count() == result.lower_bound;
    found.design = held(*result.design);
  }
  return found;
}

Found search_locally(const Parameters& p, LongWork& work, std::optional<std::uint64_t> target,
                     const std::optional<Design>& start) {
  ImproveResult result;
  work.run([&](RunControl& control) {
    result = improve(p, {.target = target, .start = start}, control);
  });
  return found_by(result, result.unsearched.empty() ? result.how : result.unsearched);
}

// Designs that have what is wanted, without proofs.
Found search_wanted(const Parameters& p, LongWork& work, const Wanted& wanted, bool anew,
                    std::optional<std::uint64_t> target) {
  LockedResult result;
  work.run([&](RunControl& control) {
    result =
        search_locked(p, wanted, {.blocks = target, .moves = {}, .from_known = !anew}, control);
  });
  return found_by(result, result.known ? "a known design, with its elements renumbered"
                                       : "local search with locked cells");
}

Found search_exactly(const Parameters& p, LongWork& work, const MinimumOptions& options,
                     const std::optional<Design>& start) {
  MinimumResult result;
  work.run([&](RunControl& control) { result = find_minimum(p, options, control, start); });
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

py::dict search(std::uint64_t v, std::uint64_t k, std::uint64_t change, const std::string& kind,
                std::uint64_t strength, std::optional<double> time, std::uint64_t threads,
                std::uint64_t seed, std::optional<std::uint64_t> target,
                const std::optional<HeldDesign>& start, bool exact, py::object progress,
                const Block& first, const Block& last, bool expansion_set,
                const std::vector<Block>& contains, bool anew) {
  const Parameters p = parameters(v, k, change, kind_of(kind), strength);
  if (exact && target) {
    throw BadInput(
        "target has no meaning with exact=True, which ends at the minimum; leave it out");
  }
  const Wanted wanted{first, last, expansion_set, contains};
  if (wanted.any() && start) {
    throw BadInput(
        "start has no meaning with first, last, expansion_set or contains; leave it out");
  }
  if (anew && !wanted.any()) {
    throw BadInput("anew is for first, last, expansion_set or contains; give one of them, too");
  }
  LongWork work(limits(time, threads, seed, std::move(progress)));
  const std::optional<Design> from = start ? std::optional(*start->design) : std::nullopt;
  MinimumOptions options;
  options.exact.wanted = wanted;
  options.from_known = !anew;
  const Found found = exact          ? search_exactly(p, work, options, from)
                      : wanted.any() ? search_wanted(p, work, wanted, anew, target)
                                     : search_locally(p, work, target, from);
  return py::dict(py::arg("design") = found.design, py::arg("lower_bound") = found.lower_bound,
                  py::arg("reason") = found.reason, py::arg("minimum") = found.settled,
                  py::arg("why_stopped") = found.why_stopped,
                  py::arg("interrupted") = work.interrupted(), py::arg("how") = found.how,
                  py::arg("moves") = found.moves, py::arg("seconds") = found.seconds);
}

py::dict classify(std::uint64_t v, std::uint64_t k, std::uint64_t b, std::uint64_t change,
                  const std::string& kind, bool reversal, std::uint64_t keep,
                  std::optional<double> time, std::uint64_t threads, py::object progress,
                  const std::pair<std::uint64_t, std::uint64_t>& share) {
  const Parameters p = parameters(v, k, change, kind_of(kind));
  LongOptions options = limits(time, threads, 1, std::move(progress));
  options.share = {share.first, share.second};
  LongWork work(std::move(options));
  Classification all;
  work.run([&](RunControl& control) {
    all = classify_designs(p, b, {.reversal = reversal, .keep = keep}, control);
  });
  py::list designs;
  for (const DesignClass& each : all.kept) {
    designs.append(held(surely_verified(each.representative, name(p))));
  }
  py::list orders;
  for (const auto& [order, count] : all.group_orders) {
    orders.append(py::make_tuple(order, count));
  }
  return py::dict(py::arg("standard_forms") = all.standard_forms, py::arg("classes") = all.classes,
                  py::arg("tight") = all.tight,
                  py::arg("complete") = all.why_stopped == WhyStopped::exhausted,
                  py::arg("interrupted") = work.interrupted(), py::arg("group_orders") = orders,
                  py::arg("designs") = designs, py::arg("prefixes") = all.prefixes,
                  py::arg("prefixes_done") = all.prefixes_done);
}

// Whether there is a design with b blocks, of so many cubes those of a share: each with a checked
// proof.
py::dict decide_share(std::uint64_t v, std::uint64_t k, std::uint64_t change,
                      const std::string& kind, std::uint64_t strength, std::uint64_t b,
                      std::uint64_t cubes, const std::pair<std::uint64_t, std::uint64_t>& share,
                      std::optional<double> time, std::uint64_t threads, py::object progress) {
  const Parameters p = parameters(v, k, change, kind_of(kind), strength);
  LongOptions limited = limits(time, threads, 1, std::move(progress));
  limited.share = {share.first, share.second};
  LongWork work(std::move(limited));
  Decision decision;
  work.run([&](RunControl& control) { decision = decide(p, b, {.cubes = cubes}, control); });
  std::vector<Cube> excluded;
  std::uint64_t proof_bytes = 0;
  for (const CheckedPart& part : decision.parts) {
    excluded.push_back(part.cube);
    proof_bytes += part.proof_bytes;
  }
  std::optional<HeldDesign> design;
  if (decision.design) {
    design = held(std::move(*decision.design));
  }
  return py::dict(py::arg("outcome") = std::string(to_string(decision.outcome)),
                  py::arg("design") = design, py::arg("cubes") = decision.cubes,
                  py::arg("excluded") = excluded, py::arg("proof_bytes") = proof_bytes,
                  py::arg("why_stopped") = std::string(to_string(decision.why_stopped)),
                  py::arg("interrupted") = work.interrupted());
}

}  // namespace

void bind_search(py::module_& module) {
  module.def("search", &search);
  module.def("classify", &classify);
  module.def("decide_share", &decide_share);
  module.def("cubes_cover_everything",
             [](const std::vector<Cube>& cubes) { return cubes_cover_everything(cubes); });
}

}  // namespace changeover::python
