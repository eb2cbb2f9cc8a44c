#include "job.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>

#include "arguments.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "long_work.hpp"
#include "plan/job/part_columns.hpp"

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

Block parts_named(const PartNames& names, const char* argument, const py::handle& parts) {
  require_iterable(argument, "parts", parts);
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
  const py::object rows = rows_of(argument, setups);
  require_ordered(argument, "set-ups, lists of parts", rows);
  const PartNames names(job);
  std::vector<Block> all;
  for_each(rows,
           [&](const py::handle& setup) { all.push_back(parts_named(names, argument, setup)); });
  return all;
}

// Set-ups, each a list of parts, alone or with its result: (set-up, result) or {"parts": …, "result": …}.
std::vector<DoneTest> done_tests(const Job& job, const py::object& tests) {
  const char* const wanted =
      "done has set-ups, lists of parts, each alone or as (set-up, result), where result is True, False, None or a text";
  const py::object rows = rows_of("done", tests);
  require_iterable("done", "set-ups, lists of parts", rows);
  const PartNames names(job);
  const auto with_result = [&](const py::handle& setup, const py::handle& result) {
    const auto said = result_named(result);
    if (!said) {
      throw BadInput(wanted);
    }
    return DoneTest{parts_named(names, "done", setup), *said};
  };
  std::vector<DoneTest> all;
  for_each(rows, [&](const py::handle& test) {
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
    const bool is_two = may_be_two && py::isinstance<py::iterable>(two[0]) && !is_text(two[0]);
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
  const py::object rows = rows_of(argument, pairs);
  require_iterable(argument, "pairs of parts", rows);
  const PartNames names(job);
  PairSet all(job.parts());
  for_each(rows, [&](const py::handle& pair) {
    const auto [x, y] = pair_named(names, argument, pair);
    all.insert(x, y);
  });
  return all;
}

const char* const too_many_or_few = "parts is a number from 2 to 1000, or that many names";

// What is said of parts, each by name.
struct Listed {
  std::vector<std::string> names;
  std::vector<std::optional<Amount>> costs;  // by part; empty where none has one
  std::vector<std::string> slots;            // by part; empty where none has one
};

// A column that would be dropped, or read as something else than it says, is refused: a file of it
// gets a note about that, which nobody would see here.
void check_columns(const py::object& frame) {
  std::vector<std::string> names;
  std::vector<std::string> costs;
  std::vector<std::string> slots;
  std::vector<std::string> others;
  std::size_t numbered = 0;  // without a heading
  for_each(frame.attr("columns"), [&](const py::handle& column) {
    const std::string heading = words_of(column);
    numbered += PyIndex_Check(column.ptr()) != 0 ? 1U : 0U;
    (heads_parts(heading)   ? names
     : heads_slots(heading) ? slots
     : heads_costs(heading) ? costs
                            : others)
        .push_back(heading);
  });
  constexpr std::size_t names_and_costs = 2;
  if (numbered == py::len(frame.attr("columns")) && numbered <= names_and_costs) {
    return;
  }
  if (names.empty() && !others.empty()) {
    names.push_back(others.front());
    others.erase(others.begin());
  }
  if (names.empty()) {
    throw BadInput("parts: no column has the names; call one of them name");
  }
  for (const auto* const each : {&names, &costs, &slots}) {
    others.insert(others.end(), each->begin() + (each->empty() ? 0 : 1), each->end());
  }
  if (!others.empty()) {
    throw BadInput(
        "parts: the column " + quoted(others.front()) +
        " is not read; leave it out, or have one column each called name, cost and slot");
  }
}

// A table of columns is read as a file of it would be: the same headers, the same refusals.
Listed listed_in_columns(const py::object& given) {
  py::object frame = given;
  const py::object index = frame.attr("index");
  const bool is_range = words_of(py::type::of(index).attr("__name__")) == "RangeIndex";
  bool has_names = false;
  for_each(frame.attr("columns"), [&](const py::handle& column) {
    has_names = has_names || heads_parts(words_of(column));
  });
  // Rows that were left out leave numbers that say nothing.
  const bool says_nothing =
      index.attr("name").is_none() && (is_range || (has_names && has_numbered_rows(frame)));
  if (!says_nothing) {
    if (py::hasattr(index, "levels")) {
      throw py::type_error("parts: an index of several levels; give reset_index() of it");
    }
    frame = frame.attr("rename_axis")(index.attr("name").is_none()
                                          ? py::str(has_names ? "index" : "name")
                                          : py::object(index.attr("name")));
    frame = frame.attr("reset_index")();  // The names are beside the columns.
  }
  check_columns(frame);
  const py::object text = py::module_::import("io").attr("StringIO")();
  const py::object writer = py::module_::import("csv").attr("writer")(text);
  writer.attr("writerow")(frame.attr("columns"));
  const py::object rows =
      frame.attr("itertuples")(py::arg("index") = false, py::arg("name") = py::none());
  std::size_t count = 0;
  for_each(rows, [&](const py::handle& row) {
    ++count;
    py::list fields;
    for_each(row, [&](const py::handle& field) {
      fields.append(is_missing(field) ? py::object(py::str(""))
                                      : py::reinterpret_borrow<py::object>(field));
    });
    writer.attr("writerow")(fields);
  });
  const auto input = input_from_text(words_of(text.attr("getvalue")()), "parts");
  PartList list = read_parts(*input, Header::given);
  if (list.names.size() != count) {
    throw BadInput("parts: a row without a name; name the part");
  }
  return {std::move(list.names), std::move(list.change_costs), std::move(list.slots)};
}

// What has items inside is no name, nor is what is missing.
std::string name_of(const py::handle& part) {
  const bool is_several = !is_text(part) && (is_bytes(part) || py::isinstance<py::iterable>(part));
  if (is_several || is_missing(part)) {
    throw py::type_error("parts has names, texts or numbers, not " +
                         quoted(words_of(py::repr(part))));
  }
  return words_of(part);
}

Listed listed_one_by_one(const py::object& parts) {
  Listed listed;
  const auto take = [&](const py::handle& part) {
    if (listed.names.size() == max_parts) {
      throw BadInput(too_many_or_few);
    }
    listed.names.push_back(name_of(part));
  };
  if (leads_from_keys(parts)) {
    if (py::hasattr(parts, "index") && has_numbered_rows(parts)) {
      throw py::type_error(
          "parts is a Series with numbers as its index; give list(...) of it if its values are "
          "names, to_dict() of it if they are costs");
    }
    // Read as it is now: to read it runs code of the caller, which may change it.
    for_each(py::list(parts.attr("items")()), [&](const py::handle& item) {
      const auto [part, cost] = item.cast<std::pair<py::object, py::object>>();
      take(part);
      listed.costs.emplace_back(amount_of(cost));
    });
  } else {
    require_ordered("parts", "names, or is how many there are", parts);
    for_each(parts, take);
  }
  if (const auto twice = py::set(py::cast(listed.names)); twice.size() != listed.names.size()) {
    throw BadInput("two parts have the same name");
  }
  return listed;
}

// The parts, by number, by name, or by name with their costs. Their slots go to `slots`, where a table has them.
Job parts_and_costs(const Asked& asked, std::vector<std::string>& slots) {
  const bool is_number =
      PyIndex_Check(asked.parts.ptr()) != 0 && !py::isinstance<py::iterable>(asked.parts);
  const py::object parts =
      is_number ? py::reinterpret_steal<py::object>(PyNumber_Index(asked.parts.ptr()))
                : asked.parts;
  if (!parts) {
    throw py::error_already_set();
  }
  Listed listed = is_number              ? Listed()
                  : is_data_frame(parts) ? listed_in_columns(parts)
                                         : listed_one_by_one(parts);
  if (is_number && !(parts >= py::int_(2) && parts <= py::int_(max_parts))) {
    throw BadInput(too_many_or_few);
  }
  const std::uint64_t count = is_number ? parts.cast<std::uint64_t>() : listed.names.size();
  if (count < 2) {
    throw BadInput("a pair needs two parts");
  }
  const bool all_have_costs =
      !listed.costs.empty() &&
      std::ranges::all_of(listed.costs, [](const auto& cost) { return cost.has_value(); });
  if (asked.change_cost.is_none() && asked.change_costs.is_none() && !all_have_costs) {
    throw BadInput("give change_cost, or parts as a dict from names to their change costs");
  }
  Job job = make_job(count, asked.at_once, amount_of(asked.test_cost),
                     asked.change_cost.is_none() ? Amount{} : amount_of(asked.change_cost));
  if (!listed.names.empty()) {
    job.names = std::move(listed.names);
  }
  for (std::size_t i = 0; i < listed.costs.size(); ++i) {
    job.change_costs[i] = listed.costs[i].value_or(job.change_costs[i]);
  }
  slots = std::move(listed.slots);
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
void take_slots(const Asked& asked, std::vector<std::string> of_parts, Job& job) {
  std::vector<Slot> slots;
  for (const auto& [name, room] : dict_of("slots", asked.slots)) {
    slots.push_back(slot_of(words_of(name), room));
  }
  of_parts.resize(job.parts());
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
  if (is_missing(result)) {
    return TestResult::none;
  }
  const bool is_numpys =
      py::hasattr(result, "dtype") && words_of(result.attr("dtype").attr("kind")) == "b";
  if (py::isinstance<py::bool_>(result) || is_numpys) {
    return py::bool_(py::reinterpret_borrow<py::object>(result)) ? TestResult::pass
                                                                 : TestResult::fail;
  }
  return py::isinstance<py::str>(result) ? std::optional(result_of(words_of(result)))
                                         : std::nullopt;
}

Job job_of(const Asked& asked) {
  std::vector<std::string> slots_of_parts;
  Job job = parts_and_costs(asked, slots_of_parts);
  if (!asked.change_costs.is_none()) {
    take_change_costs(asked.change_costs, job);
  }
  const bool has_column = !slots_of_parts.empty();
  if (has_column && !asked.slot_of.is_none()) {
    throw BadInput("parts has a column slot, and slot_of says the same; give one of them");
  }
  if (asked.slots.is_none() == (has_column || !asked.slot_of.is_none())) {
    throw BadInput(
        has_column
            ? "parts has a column slot; give slots, how many parts each has, or leave the column out"
            : "slots and slot_of come together: how many parts a slot has, and which parts are in it");
  }
  if (!asked.slots.is_none()) {
    take_slots(asked, std::move(slots_of_parts), job);
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
