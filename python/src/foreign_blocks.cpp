#include "foreign_blocks.hpp"

#include <algorithm>
#include <vector>

#include "arguments.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/transitions.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::python {
namespace {

// Rows of numbers: those below a v that was said, or all that occur if these are 0, 1, …, n−1.
std::optional<Design> from_numbers(const std::vector<std::uint64_t>& numbers, std::size_t k,
                                   const ReadOptions& options) {
  if (numbers.empty() || k == 0) {
    return std::nullopt;
  }
  const std::uint64_t largest = *std::max_element(numbers.begin(), numbers.end());
  if (largest >= max_elements_in_memory || (options.v && largest >= *options.v)) {
    return std::nullopt;
  }
  std::vector<bool> occurs(largest + 1, false);
  for (const std::uint64_t number : numbers) {
    occurs[number] = true;
  }
  if (!options.v && std::find(occurs.begin(), occurs.end(), false) != occurs.end()) {
    return std::nullopt;
  }
  const std::vector<Element> elements(numbers.begin(), numbers.end());
  const auto block = [&](std::size_t index) { return std::span(elements).subspan(index * k, k); };
  std::uint64_t change = 2;
  if (options.change) {
    change = *options.change;
  } else if (elements.size() >= 2 * k) {
    const std::uint64_t first = difference(block(1), block(0)).size();
    change = first == 0 ? 2 : first;
  }
  Design design(Parameters{.v = options.v.value_or(largest + 1),
                           .k = k,
                           .change = change,
                           .kind = options.kind.value_or(Kind::linear),
                           .strength = options.strength.value_or(2)});
  design.reserve(elements.size() / k);
  for (std::size_t i = 0; i < elements.size() / k; ++i) {
    try {
      design.append(block(i));
    } catch (const BadInput& fault) {
      throw BadInput("block " + std::to_string(i + 1) + ": " + fault.what());
    }
  }
  return design;
}

// The numbers of a buffer, row by row; nothing if it is none of two dimensions of whole numbers.
struct Table {
  std::vector<std::uint64_t> numbers;
  std::size_t k = 0;
};

template <typename Number>
bool take(const py::buffer_info& info, std::vector<std::uint64_t>& numbers) {
  for (py::ssize_t i = 0; i < info.shape[0]; ++i) {
    for (py::ssize_t j = 0; j < info.shape[1]; ++j) {
      Number number;
      std::memcpy(&number,
                  static_cast<const char*>(info.ptr) + i * info.strides[0] + j * info.strides[1],
                  sizeof number);
      if (number < Number{0}) {
        throw BadInput("block " + std::to_string(i + 1) +
                       ": an element is negative; elements are 0, 1, ...");
      }
      numbers.push_back(static_cast<std::uint64_t>(number));
    }
  }
  return true;
}

std::optional<Table> from_buffer(const py::object& blocks) {
  if (PyObject_CheckBuffer(blocks.ptr()) == 0) {
    return std::nullopt;
  }
  const py::buffer_info info = py::reinterpret_borrow<py::buffer>(blocks).request();
  if (info.ndim != 2 || info.format.empty()) {
    return std::nullopt;
  }
  Table table;
  table.k = static_cast<std::size_t>(info.shape[1]);
  table.numbers.reserve(static_cast<std::size_t>(info.size));
  const char letter = info.format.back();
  const bool native = info.format.size() == 1 || info.format.front() == '=' ||
                      info.format.front() == '@' || info.format.front() == '<';
  const bool is_signed = std::string_view("bhilqn").find(letter) != std::string_view::npos;
  if (!native ||
      (!is_signed && std::string_view("BHILQN").find(letter) == std::string_view::npos)) {
    return std::nullopt;
  }
  switch (info.itemsize) {
    case 1:
      is_signed ? take<std::int8_t>(info, table.numbers) : take<std::uint8_t>(info, table.numbers);
      break;
    case 2:
      is_signed ? take<std::int16_t>(info, table.numbers)
                : take<std::uint16_t>(info, table.numbers);
      break;
    case 4:
      is_signed ? take<std::int32_t>(info, table.numbers)
                : take<std::uint32_t>(info, table.numbers);
      break;
    case 8:
      is_signed ? take<std::int64_t>(info, table.numbers)
                : take<std::uint64_t>(info, table.numbers);
      break;
    default:
      return std::nullopt;
  }
  return table;
}

// Anything else is written down as JSON and read as a file would be: one set of rules, one set of messages.
Design from_iterables(const py::object& blocks, const ReadOptions& options) {
  JsonWriter json;
  json.begin_array();
  const py::object rows = rows_of("blocks", blocks);
  require_ordered("blocks", "lists of elements", rows);
  for_each(rows, [&](const py::handle& block) {
    require_iterable("blocks", "lists of elements", block);
    json.begin_array();
    for_each(block, [&](const py::handle& element) {
      if (py::isinstance<py::str>(element)) {
        json.value(words_of(element));
      } else {
        const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(element.ptr()));
        if (!number) {
          throw py::error_already_set();
        }
        json.raw(py::str(number).cast<std::string>());
      }
    });
    json.end_array();
  });
  json.end_array();
  return read_design(input_from_text(json.take(), "blocks"), options);
}

}  // namespace

Design design_from(const py::object& blocks, const ReadOptions& options) {
  if (py::isinstance<HeldDesign>(blocks)) {
    const Design& design = *blocks.cast<const HeldDesign&>().design;
    Parameters p = design.parameters();
    p.v = options.v.value_or(p.v);
    p.change = options.change.value_or(p.change);
    p.kind = options.kind.value_or(p.kind);
    p.strength = options.strength.value_or(p.strength);
    return Design(p, design.blocks());
  }
  if (py::isinstance<py::str>(blocks) || py::isinstance<py::bytes>(blocks)) {
    throw py::type_error("blocks are an array or a list of lists; changeover.loads() reads a text");
  }
  if (const auto table = from_buffer(blocks)) {
    if (auto design = from_numbers(table->numbers, table->k, options)) {
      return std::move(*design);
    }
  }
  return from_iterables(blocks, options);
}

}  // namespace changeover::python
