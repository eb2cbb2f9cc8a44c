#include "job.hpp"

#include <optional>
#include <string>
#include <unordered_map>

#include "arguments.hpp"
#include "changeover/core/error.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

// Parts by name, found at once.
class PartNames {
 public:
  explicit PartNames(const Job& job) : parts_(job.parts()) {
    for (std::size_t i = 0; i < job.names.size(); ++i) {
      by_name_.emplace(job.names[i], static_cast<Element>(i));
    }
  }

  [[nodiscard]] std::uint64_t parts() const { return parts_; }
  [[nodiscard]] Element named(const py::handle& part) const {
    const std::string text = words_of(part);
    const auto found = by_name_.find(text);
    if (found == by_name_.end()) {
      throw BadInput("no part is called " + quoted(text));
    }
    return found->second;
  }

 private:
  std::uint64_t parts_;
  std::unordered_map<std::string, Element> by_name_;
};

// A string is a sequence of its letters, which nobody means.
void require_list(const char* argument, const char* holds, const py::handle& value) {
  if (py::isinstance<py::str>(value)) {
    throw BadInput(std::string(argument) + " is a list of parts, not a string");
  }
  require_iterable(argument, holds, value);
}

Block parts_named(const PartNames& names, const char* argument, const py::handle& parts) {
  require_list(argument, "parts", parts);
  Block all;
  for_each(parts, [&](const py::handle& part) {
    if (all.size() > names.parts()) {
      throw BadInput(std::string(argument) + " names more parts than there are");
    }
    all.push_back(names.named(part));
  });
  return all;
}

std::vector<Block> setups_named(const Job& job, const char* argument, const py::object& setups) {
  require_list(argument, "set-ups, lists of parts", setups);
  const PartNames names(job);
  std::vector<Block> all;
  for_each(setups,
           [&](const py::handle& setup) { all.push_back(parts_named(names, argument, setup)); });
  return all;
}

// Set-ups, each a list of parts, alone or with its result: (set-up, result) or {"parts": …, "result": …}.
std::vector<DoneTest> done_tests(const Job& job, const py::object& tests) {
  const char* const wanted =
      "done has set-ups, lists of parts, each alone or as (set-up, result), where result is True, False, None or a text";
  require_list("done", "set-ups, lists of parts", tests);
  const PartNames names(job);
  const auto with_result = [&](const py::handle& setup, const py::handle& result) {
    const auto said = result_named(result);
    if (!said) {
      throw BadInput(wanted);
    }
    return DoneTest{parts_named(names, "done", setup), *said};
  };
  std::vector<DoneTest> all;
  for_each(tests, [&](const py::handle& test) {
    if (py::isinstance<py::dict>(test)) {
      const auto both = py::reinterpret_borrow<py::dict>(test);
      const bool has_result = both.contains("result");
      if (!both.contains("parts") || both.size() != (has_result ? 2U : 1U)) {
        throw BadInput(R"(done has dicts with "parts" and "result" only)");
      }
      const py::object parts = both["parts"];
      const py::object result = has_result ? py::object(both["result"]) : py::none();
      all.push_back(with_result(parts, result));
      return;
    }
    const bool may_be_two = py::isinstance<py::tuple>(test) && py::len(test) == 2;
    const auto two = may_be_two ? py::reinterpret_borrow<py::tuple>(test) : py::tuple();
    const bool is_two =
        may_be_two && (py::isinstance<py::list>(two[0]) || py::isinstance<py::tuple>(two[0]) ||
                       py::isinstance<py::set>(two[0]));
    all.push_back(is_two ? with_result(two[0], two[1])
                         : DoneTest{parts_named(names, "done", test), TestResult::done});
  });
  return all;
}

std::pair<Element, Element> pair_named(const PartNames& names, const char* argument,
                                       const py::handle& pair) {
  const Block two = parts_named(names, argument, pair);
  if (two.size() != 2 || two[0] == two[1]) {
    throw BadInput(std::string(argument) + " is pairs of two parts");
  }
  return {two[0], two[1]};
}

PairSet pairs_named(const Job& job, const char* argument, const py::object& pairs) {
  require_list(argument, "pairs of parts", pairs);
  const PartNames names(job);
  PairSet all(job.parts());
  for_each(pairs, [&](const py::handle& pair) {
    const auto [x, y] = pair_named(names, argument, pair);
    all.insert(x, y);
  });
  return all;
}

const char* const too_many_or_few = "parts is a number from 2 to 1000, or that many names";

// The parts, by number, by name, or by name with their costs.
Job parts_and_costs(const Asked& asked) {
  const py::object& parts = asked.parts;
  const bool is_number = py::isinstance<py::int_>(parts);
  if (!is_number) {
    require_list("parts", "names, or is how many there are", parts);
  }
  std::vector<std::string> listed;
  std::vector<Amount> costs;
  if (!is_number) {
    const auto take = [&](const py::handle& part) {
      if (listed.size() == max_parts) {
        throw BadInput(too_many_or_few);
      }
      listed.push_back(words_of(part));
    };
    if (py::isinstance<py::dict>(parts)) {
      for (const auto& [part, cost] : dict_of("parts", parts)) {
        take(part);
        costs.push_back(amount_of(cost));
      }
    } else {
      for_each(parts, take);
    }
    if (const auto twice = py::set(py::cast(listed)); twice.size() != listed.size()) {
      throw BadInput("two parts have the same name");
    }
  }
  if (is_number && !(parts >= py::int_(2) && parts <= py::int_(max_parts))) {
    throw BadInput(too_many_or_few);
  }
  const std::uint64_t count = is_number ? parts.cast<std::uint64_t>() : listed.size();
  if (count < 2) {
    throw BadInput("a pair needs two parts");
  }
  if (asked.change_cost.is_none() && asked.change_costs.is_none() && costs.empty()) {
    throw BadInput("give change_cost, or parts as a dict from names to their change costs");
  }
  Job job = make_job(count, asked.at_once, amount_of(asked.test_cost),
                     asked.change_cost.is_none() ? Amount{} : amount_of(asked.change_cost));
  if (!listed.empty()) {
    job.names = listed;
  }
  for (std::size_t i = 0; i < costs.size(); ++i) {
    job.change_costs[i] = costs[i];
  }
  return job;
}

// What a change costs by what is replaced: a dict from (out, in) to costs, for every two parts.
void take_change_costs(const py::object& change_costs, Job& job) {
  const std::uint64_t v = job.parts();
  const PartNames names(job);
  std::vector<bool> given(v * v);
  job.replace_costs.assign(v * v, Amount{});
  for (const auto& [pair, cost] : dict_of("change_costs", change_costs)) {
    const auto [out, in] = pair_named(names, "change_costs", pair);
    job.replace_costs[out * v + in] = amount_of(cost);
    given[out * v + in] = true;
  }
  for (std::uint64_t i = 0; i < v * v; ++i) {
    if (!given[i] && i / v != i % v) {
      throw BadInput("change_costs does not say what putting in '" + job.names[i % v] +
                     "' costs where '" + job.names[i / v] + "' was taken out");
    }
  }
}

// How many parts are in a slot: a number, or (least, most), where None is no limit.
Slot slot_of(std::string name, const py::handle& room) {
  Slot slot{.name = std::move(name)};
  const auto refuse = [&slot]() {
    throw BadInput("slots says how many parts are in " + quoted(slot.name) +
                   ": a number, or (least, most) with None for no limit");
  };
  const auto number = [&refuse](const py::object& given) {
    if (!py::isinstance<py::int_>(given) ||
        !(given >= py::int_(0) && given <= py::int_(UINT64_MAX))) {
      refuse();
    }
    return given.cast<std::uint64_t>();
  };
  const auto given = py::reinterpret_borrow<py::object>(room);
  if (py::isinstance<py::int_>(given)) {
    slot.least = slot.most = number(given);
    return slot;
  }
  if (!py::isinstance<py::sequence>(given) || py::len(given) != 2) {
    refuse();
  }
  const auto two = py::reinterpret_borrow<py::sequence>(given);
  const py::object least = two[0];
  const py::object most = two[1];
  slot.least = least.is_none() ? slot.least : number(least);
  slot.most = most.is_none() ? slot.most : number(most);
  return slot;
}

// slots: how many parts of each; slot_of: which part is in which.
void take_slots(const Asked& asked, Job& job) {
  std::vector<Slot> slots;
  for (const auto& [name, room] : dict_of("slots", asked.slots)) {
    slots.push_back(slot_of(words_of(name), room));
  }
  std::vector<std::string> of_parts(job.parts());
  if (!asked.slot_of.is_none()) {
    const PartNames names(job);
    for (const auto& [part, slot] : dict_of("slot_of", asked.slot_of)) {
      of_parts[names.named(part)] = words_of(slot);
    }
  }
  set_slots(job, of_parts, std::move(slots));
}

void take_weights(const py::object& weights, Job& job) {
  const PartNames names(job);
  for (const auto& [pair, weight] : dict_of("weights", weights)) {
    const auto [x, y] = pair_named(names, "weights", pair);
    job.weights.set(x, y, amount_of(weight));
  }
}

// What cannot meet need not, unless its pairs were asked for one by one.
void take_needs(const Asked& asked, Job& job) {
  constexpr std::uint64_t triples = 3;
  if (asked.strength != 2 && asked.strength != triples) {
    throw BadInput("strength is 2, every two parts must meet, or 3, every three");
  }
  if (!asked.pairs.is_none() && asked.strength == triples) {
    throw BadInput("pairs are listed for strength 2 only");
  }
  job.never = pairs_named(job, "never", asked.never);
  job.needed =
      asked.pairs.is_none() ? all_pairs_but(job.never) : pairs_named(job, "pairs", asked.pairs);
  stoppable([&] {
    Job any = job;
    any.needed = PairSet(job.parts());
    check(any);  // Without needed pairs: what cannot be at all.
    return true;
  });
  if (asked.strength == triples) {
    stoppable([&] { return need_triples(job), true; });
    if (job.triples.empty()) {
      throw BadInput("no three parts can be in one set-up");
    }
  } else if (asked.pairs.is_none() && !job.slots.empty()) {
    drop_needed(job, stoppable([&] { return cannot_meet(job); }));
  }
  if (job.needed.size() == 0) {
    throw BadInput("no pair has to meet that could");
  }
}

}  // namespace

// Numbers, strings and decimals alike, exactly as they are written.
Amount amount_of(const py::handle& value) { return parse_amount(words_of(value)); }

py::object decimal(Amount amount) {
  return py::module_::import("decimal").attr("Decimal")(to_string(amount));
}

std::vector<std::string> names(const Job& job, const Block& parts) {
  std::vector<std::string> all;
  for (const Element part : parts) {
    all.push_back(job.names[part]);
  }
  return all;
}

Element part_named(const Job& job, const py::handle& part) { return PartNames(job).named(part); }

Block parts_named(const Job& job, const char* argument, const py::handle& parts) {
  return parts_named(PartNames(job), argument, parts);
}

std::optional<TestResult> result_named(const py::handle& result) {
  if (result.is_none()) {
    return TestResult::none;
  }
  if (py::isinstance<py::bool_>(result)) {
    return result.cast<bool>() ? TestResult::pass : TestResult::fail;
  }
  return py::isinstance<py::str>(result) ? std::optional(result_of(words_of(result)))
                                         : std::nullopt;
}

Job job_of(const Asked& asked) {
  Job job = parts_and_costs(asked);
  if (!asked.change_costs.is_none()) {
    take_change_costs(asked.change_costs, job);
  }
  if (asked.slots.is_none() != asked.slot_of.is_none()) {
    throw BadInput(
        "slots and slot_of come together: how many parts a slot has, and which parts are in it");
  }
  if (!asked.slots.is_none()) {
    take_slots(asked, job);
  }
  job.mounted = parts_named(job, "mounted", asked.mounted);
  job.start = parts_named(job, "start", asked.start);
  take_needs(asked, job);
  job.first = setups_named(job, "first", asked.first);
  if (!asked.weights.is_none()) {
    take_weights(asked.weights, job);
  }
  stoppable([&] { return check(job), true; });
  if (const auto tests = done_tests(job, asked.done); !tests.empty()) {
    stoppable([&] {
      mark_tested(job, tests, asked.trust_failed ? FailedTests::trusted : FailedTests::again);
      return true;
    });
  }
  return job;
}

}  // namespace changeover::python
