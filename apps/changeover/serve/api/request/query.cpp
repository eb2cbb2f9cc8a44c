#include "serve/api/request/query.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "cli/cli.hpp"
#include "core/printable.hpp"
#include "request/parameters.hpp"

namespace changeover::serve {
namespace {

// What is quoted in a message is short.
std::string shown(const std::string& value) {
  constexpr std::size_t most = 40;
  return printable(value.size() > most ? value.substr(0, most) + "…" : value);
}

Parameters parameters_of(const Request& request, Kind kind) {
  const std::uint64_t strength = number_of(request, "strength").value_or(2);
  if (strength < 2 || strength > max_strength) {
    throw Refusal{400, fmt::format("strength={}: give 2 to {}", strength, max_strength)};
  }
  const Parameters p{.v = needed_number(request, "v"),
                     .k = needed_number(request, "k"),
                     .change = number_of(request, "change").value_or(2),
                     .kind = kind,
                     .strength = static_cast<std::uint32_t>(strength)};
  check(p);
  return p;
}

}  // namespace

std::optional<std::uint64_t> number_of(const Request& request, std::string_view name) {
  const auto text = request.parameter(name);
  if (!text) {
    return std::nullopt;
  }
  std::uint64_t value = 0;
  const char* const end = text->data() + text->size();
  const auto [rest, failure] = std::from_chars(text->data(), end, value);
  if (failure != std::errc() || rest != end || text->empty()) {
    throw Refusal{400, fmt::format("{}={}: write a whole number", name, shown(*text))};
  }
  return value;
}

std::uint64_t needed_number(const Request& request, std::string_view name) {
  const auto number = number_of(request, name);
  if (!number) {
    throw Refusal{400, fmt::format("{} is missing; write {}=N", name, name)};
  }
  return *number;
}

std::string word_of(const Request& request, std::string_view name,
                    const std::vector<std::string>& words) {
  const auto word = request.parameter(name);
  if (word && std::ranges::find(words, *word) == words.end()) {
    throw Refusal{400, fmt::format("{}={}: write {}", name, shown(*word), fmt::join(words, ", "))};
  }
  return word.value_or(words.front());
}

std::optional<Kind> kind_of(const Request& request) {
  const auto word = request.parameter("kind");
  if (!word) {
    return std::nullopt;
  }
  const auto kind = kind_from_string(*word);
  if (!kind) {
    throw Refusal{400, fmt::format("kind={}: write circular or linear", shown(*word))};
  }
  return kind;
}

Parameters cell_of(const Request& request) {
  const auto kind = kind_of(request);
  if (!kind) {
    throw Refusal{400, "kind is missing; write kind=circular or kind=linear"};
  }
  return parameters_of(request, *kind);
}

std::vector<Parameters> cells_of(const Request& request) {
  std::vector<Parameters> cells;
  for (const Kind kind : cli::kinds_of(kind_of(request))) {
    cells.push_back(parameters_of(request, kind));
  }
  return cells;
}

cli::Range range_of(const Request& request, std::string_view name, const cli::Range& usual) {
  const auto text = request.parameter(name);
  if (!text) {
    return usual;
  }
  try {
    return cli::range_of(std::string(name) + ":", shown(*text), 2);
  } catch (const cli::UsageError& fault) {
    throw Refusal{400, fault.message};
  }
}

}  // namespace changeover::serve
