#include "job.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "long_work.hpp"
#include "plan/job/part_columns.hpp"

namespace changeover::python {
namespace {

constexpr std::size_t most_rows = std::size_t{1} << 22;  // as in a file

// Numbers, strings and decimals alike, exactly as they are written.
std::string amount_in(const char* argument, const py::handle& value) {
  std::string words = words_of(value);
  try {
    static_cast<void>(parse_amount(words));
  } catch (const BadInput& fault) {
    throw BadInput(std::string(argument) + ": " + fault.what());
  }
  return words;
}

std::string amount_if_any(const char* argument, const py::object& value) {
  return value.is_none() ? std::string() : amount_in(argument, value);
}

std::vector<std::string> words_in(const char* argument, const py::handle& parts) {
  require_iterable(argument, "parts", parts);
  std::vector<std::string> all;
  for_each(parts, [&](const py::handle& part) {
    if (all.size() > max_parts) {
      throw BadInput(std::string(argument) + " names more parts than there are");
    }
    all.push_back(words_of(part));
  });
  return all;
}

template <typename MakeRow>
RequestList rows_from(const char* argument, const py::object& given, const MakeRow& make) {
  RequestList list{.file = {}, .text = {}, .rows = std::vector<ListRow>()};
  for_each(given, [&](const py::handle& row) {
    if (list.rows->size() == most_rows) {
      throw BadInput(std::string(argument) + " has more than 4194304 rows; give each once");
    }
    list.rows->push_back(make(row));
  });
  return list;
}

ListRow pair_in(const char* argument, const py::handle& pair) {
  ListRow row{words_in(argument, pair)};
  if (row.fields.size() != 2 || row.fields[0] == row.fields[1]) {
    throw BadInput(std::string(argument) + " is pairs of two parts");
  }
  return row;
}

RequestList pairs_in(const char* argument, const py::object& pairs) {
  const py::object rows = rows_of(argument, pairs);
  require_iterable(argument, "pairs of parts", rows);
  return rows_from(argument, rows, [&](const py::handle& pair) { return pair_in(argument, pair); });
}

RequestList setups_in(const char* argument, const py::object& setups) {
  const py::object rows = rows_of(argument, setups);
  require_ordered(argument, "set-ups, lists of parts", rows);
  return rows_from(argument, rows,
                   [&](const py::handle& setup) { return ListRow{words_in(argument, setup)}; });
}

std::string result_in(const py::handle& result, const char* wanted) {
  const auto said = result_named(result);
  if (!said) {
    throw BadInput(wanted);
  }
  if (is_text(result)) {
    return words_of(result);
  }
  return *said == TestResult::pass ? "pass" : *said == TestResult::fail ? "fail" : "";
}

// Set-ups, each a list of parts, alone or with its result: (set-up, result) or {"parts": …, "result": …}.
RequestList tests_in(const py::object& tests) {
  const char* const wanted =
      "done has set-ups, lists of parts, each alone or as (set-up, result), where result is True, False, None or a text";
  const py::object rows = rows_of("done", tests);
  require_iterable("done", "set-ups, lists of parts", rows);
  const auto with_result = [&](const py::handle& setup, const py::handle& result) {
    std::string said = result_in(result, wanted);
    return ListRow{words_in("done", setup), std::move(said)};
  };
  return rows_from("done", rows, [&](const py::handle& test) {
    if (py::isinstance<py::dict>(test)) {
      const auto both = py::reinterpret_borrow<py::dict>(test);
      const bool has_result = both.contains("result");
      if (!both.contains("parts") || both.size() != (has_result ? 2U : 1U)) {
        throw BadInput(R"(done has dicts with "parts" and "result" only)");
      }
      const py::object parts = both["parts"];
      return has_result ? with_result(parts, both["result"]) : ListRow{words_in("done", parts)};
    }
    const bool may_be_two = py::isinstance<py::tuple>(test) && py::len(test) == 2;
    const auto two = may_be_two ? py::reinterpret_borrow<py::tuple>(test) : py::tuple();
    const bool is_two = may_be_two && py::isinstance<py::iterable>(two[0]) && !is_text(two[0]);
    return is_two ? with_result(two[0], two[1]) : ListRow{words_in("done", test)};
  });
}

const char* const too_many_or_few = "parts is a number from 2 to 1000, or that many names";

// What is said of parts, each by name.
struct Listed {
  std::vector<std::string> names;
  std::vector<std::string> costs;  // by part, as they are written; empty where none has one
  std::vector<std::string> slots;  // by part; empty where none has one
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
  Listed listed{std::move(list.names), {}, std::move(list.slots)};
  for (const auto& cost : list.change_costs) {
    listed.costs.push_back(cost ? to_string(*cost) : "");
  }
  return listed;
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
      listed.costs.push_back(amount_in("parts", cost));
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

// The parts by number, by name, or by name with their costs and slots.
void take_parts(const GivenJob& given, JobRequest& request) {
  const bool is_number =
      PyIndex_Check(given.parts.ptr()) != 0 && !py::isinstance<py::iterable>(given.parts);
  const py::object parts =
      is_number ? py::reinterpret_steal<py::object>(PyNumber_Index(given.parts.ptr()))
                : given.parts;
  if (!parts) {
    throw py::error_already_set();
  }
  if (is_number && !(parts >= py::int_(2) && parts <= py::int_(max_parts))) {
    throw BadInput(too_many_or_few);
  }
  if (is_number && given.slot_of.is_none()) {
    request.items = parts.cast<std::uint64_t>();
    return;
  }
  Listed listed;
  if (is_number) {
    for (std::uint64_t i = 1; i <= parts.cast<std::uint64_t>(); ++i) {
      listed.names.push_back(std::to_string(i));
    }
  } else {
    listed = is_data_frame(parts) ? listed_in_columns(parts) : listed_one_by_one(parts);
  }
  if (listed.names.size() < 2) {
    throw BadInput("a pair needs two parts");
  }
  const bool has_column = !listed.slots.empty();
  if (has_column && !given.slot_of.is_none()) {
    throw BadInput("parts has a column slot, and slot_of says the same; give one of them");
  }
  if (given.slots.is_none() == (has_column || !given.slot_of.is_none())) {
    throw BadInput(
        has_column
            ? "parts has a column slot; give slots, how many parts each has, or leave the column out"
            : "slots and slot_of come together: how many parts a slot has, and which parts are in it");
  }
  if (!given.slot_of.is_none()) {
    listed.slots.resize(listed.names.size());
    for (const auto& [part, slot] : dict_of("slot_of", given.slot_of)) {
      const std::string name = words_of(part);
      const auto found = std::ranges::find(listed.names, name);
      if (found == listed.names.end()) {
        throw BadInput("slot_of: there is no part " + quoted(name));
      }
      listed.slots[static_cast<std::size_t>(found - listed.names.begin())] = words_of(slot);
    }
  }
  request.parts.rows.emplace();
  for (std::size_t i = 0; i < listed.names.size(); ++i) {
    const auto field = [i](const std::vector<std::string>& of) {
      return i < of.size() ? of[i] : std::string();
    };
    request.parts.rows->push_back({{listed.names[i], field(listed.costs), field(listed.slots)}});
  }
  const bool all_have_costs =
      !listed.costs.empty() &&
      std::ranges::none_of(listed.costs, [](const std::string& cost) { return cost.empty(); });
  if (given.change_cost.is_none() && given.change_costs.is_none() && !all_have_costs) {
    throw BadInput("give change_cost, or parts as a dict from names to their change costs");
  }
}

// What a change costs by what is replaced: a dict from (out, in) to costs, as a square table with its heads.
RequestList table_in(const py::object& change_costs) {
  std::map<std::pair<std::string, std::string>, std::string> costs;
  std::vector<std::string> heads;
  const auto add_head = [&](const std::string& name) {
    if (std::ranges::find(heads, name) == heads.end()) {
      if (heads.size() == max_parts) {
        throw BadInput("change_costs names more parts than there are");
      }
      heads.push_back(name);
    }
  };
  for (const auto& [pair, cost] : dict_of("change_costs", change_costs)) {
    const ListRow row = pair_in("change_costs", pair);
    add_head(row.fields[0]);
    add_head(row.fields[1]);
    costs[{row.fields[0], row.fields[1]}] = amount_in("change_costs", cost);
  }
  RequestList list{.file = {}, .text = {}, .rows = std::vector<ListRow>()};
  ListRow header{{""}};
  header.fields.insert(header.fields.end(), heads.begin(), heads.end());
  list.rows->push_back(std::move(header));
  for (const std::string& out : heads) {
    ListRow row{{out}};
    for (const std::string& in : heads) {
      const auto found = costs.find({out, in});
      row.fields.push_back(found == costs.end() ? "" : found->second);
    }
    list.rows->push_back(std::move(row));
  }
  return list;
}

// How many parts are in a slot: a number, or (least, most), where None is no limit.
ListRow slot_in(const std::string& name, const py::handle& room) {
  const auto refuse = [&name]() {
    throw BadInput("slots says how many parts are in " + quoted(name) +
                   ": a number, or (least, most) with None for no limit");
  };
  const auto number = [&refuse](const py::object& given) {
    if (!py::isinstance<py::int_>(given) ||
        !(given >= py::int_(0) && given <= py::int_(UINT64_MAX))) {
      refuse();
    }
    return words_of(given);
  };
  const auto given = py::reinterpret_borrow<py::object>(room);
  if (py::isinstance<py::int_>(given)) {
    return {{name, number(given), number(given)}};
  }
  if (!py::isinstance<py::sequence>(given) || py::len(given) != 2) {
    refuse();
  }
  const auto two = py::reinterpret_borrow<py::sequence>(given);
  const py::object least = two[0];
  const py::object most = two[1];
  return {{name, least.is_none() ? std::string() : number(least),
           most.is_none() ? std::string() : number(most)}};
}

RequestList slots_in(const py::object& slots) {
  RequestList list{.file = {}, .text = {}, .rows = std::vector<ListRow>()};
  for (const auto& [name, room] : dict_of("slots", slots)) {
    list.rows->push_back(slot_in(words_of(name), room));
  }
  return list;
}

RequestList weights_in(const py::object& weights) {
  RequestList list{.file = {}, .text = {}, .rows = std::vector<ListRow>()};
  for (const auto& [pair, weight] : dict_of("weights", weights)) {
    ListRow row = pair_in("weights", pair);
    row.fields.push_back(amount_in("weights", weight));
    list.rows->push_back(std::move(row));
  }
  return list;
}

// Nothing is asked for by a list without rows.
RequestList unless_empty(RequestList list) { return list.rows->empty() ? RequestList() : list; }

}  // namespace

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

Block parts_named(const Job& job, const char* argument, const py::handle& parts) {
  return changeover::parts_named(words_in(argument, parts), job.names);
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

JobRequest request_of(const GivenJob& given) {
  JobRequest request;
  take_parts(given, request);
  request.test_cost = amount_in("test_cost", given.test_cost);
  request.change_cost = amount_if_any("change_cost", given.change_cost);
  request.budget = amount_if_any("budget", given.budget);
  if (!given.change_costs.is_none()) {
    request.change_costs = table_in(given.change_costs);
  }
  if (!given.slots.is_none()) {
    request.slots = slots_in(given.slots);
  }
  if (!given.pairs.is_none()) {
    request.pairs = pairs_in("pairs", given.pairs);
  }
  request.never = unless_empty(pairs_in("never", given.never));
  request.mounted = words_in("mounted", given.mounted);
  request.start = words_in("start", given.start);
  request.first = unless_empty(setups_in("first", given.first));
  if (!given.weights.is_none()) {
    request.weights = unless_empty(weights_in(given.weights));
  }
  request.done = unless_empty(tests_in(given.done));
  return request;
}

}  // namespace changeover::python
