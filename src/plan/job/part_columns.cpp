#include "plan/job/part_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "io/scan/place.hpp"

namespace changeover {
namespace {

constexpr const char* how_to_say =
    "say --header if it heads the columns, --no-header if it is a part";

const std::string& text_of(const Row& row, std::size_t column) {
  static const std::string none;
  return column < row.size() ? row[column].text : none;
}

// It is meant as one, even if it is none.
bool like_a_number(std::string_view text) {
  return !text.empty() && std::string_view("0123456789.,+-").find(text.front()) != text.npos;
}

// The words of a heading in lower case: what stands between blanks and signs, or begins with a
// capital in the middle of "changeCost".
std::vector<std::string> words_of(std::string_view text) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  std::vector<std::string> words(1);
  char before = ' ';
  for (const char c : text) {
    const bool is_letter = is_small(c) || is_capital(c) || static_cast<unsigned char>(c) >= 0x80;
    if ((!is_letter || (is_capital(c) && is_small(before))) && !words.back().empty()) {
      words.emplace_back();
    }
    if (is_letter) {
      words.back() += is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
    }
    before = c;
  }
  return words;
}

bool has_word_of_headers(const Row& row) {
  return std::any_of(row.begin(), row.end(), [](const Field& field) {
    return heads_parts(field.text) || heads_costs(field.text) || heads_slots(field.text);
  });
}

// Whether one text differs from all others in a way in which they agree.
bool of_another_kind(const std::vector<Row>& rows) {
  const auto alone = [&](auto&& property) {
    const auto first = property(rows.front().front().text);
    const auto others = property(rows[1].front().text);
    return first != others && std::all_of(rows.begin() + 1, rows.end(), [&](const Row& row) {
             return property(row.front().text) == others;
           });
  };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return rows.size() > 2 &&
         (alone([&](const std::string& t) { return std::any_of(t.begin(), t.end(), is_digit); }) ||
          alone([](const std::string& t) { return t.size(); }) ||
          alone([](const std::string& t) { return !t.empty() && t[0] >= 'a' && t[0] <= 'z'; }));
}

// Whether the first row is a header.
bool is_header(const std::vector<Row>& rows, const RowReader& reader, std::string& note) {
  const Row& first = rows.front();
  const auto has_cost = [](const Row& row) { return like_a_number(text_of(row, 1)); };
  const auto others =
      static_cast<std::size_t>(std::count_if(rows.begin() + 1, rows.end(), has_cost));
  const auto doubtful = [&](const std::string& why) {
    reader.fail(first.front(), fmt::format("{} may be a header or a part: {}; {}",
                                           shown(first.front().text), why, how_to_say));
  };
  constexpr std::size_t most_without_header = 2;
  if (first.size() > most_without_header) {
    return has_word_of_headers(first) &&
           std::none_of(first.begin(), first.end(),
                        [](const Field& f) { return like_a_number(f.text); });
  }
  if (has_cost(first)) {
    return false;
  }
  const bool has_word = has_word_of_headers(first);
  const bool two = !text_of(first, 1).empty();
  if (two && !has_word) {
    doubtful(fmt::format("{} is no cost, and {}", shown(first[1].text),
                         others > 0 ? "other rows have one" : "no other row has one"));
  }
  if (has_word) {
    return true;
  }
  if (others > 0 && others + 1 == rows.size()) {
    doubtful("all other rows have a cost");
  }
  const bool one_column =
      std::all_of(rows.begin(), rows.end(), [](const Row& row) { return text_of(row, 1).empty(); });
  if (one_column && of_another_kind(rows)) {
    doubtful("it does not look like the others");
  }
  if (one_column) {
    note = fmt::format("no header: {} is the first part", shown(first.front().text));
  }
  return false;
}

[[noreturn]] void fail_for_two(const Field& one, const Field& other, std::string_view what,
                               const RowReader& reader) {
  reader.fail(other,
              fmt::format("{} and {} may both head the {}; rename or remove one of the columns",
                          shown(one.text), shown(other.text), what));
}

// The column for costs: one that says so, best of changes, or the other one of two.
std::optional<std::size_t> cost_column(const std::vector<Row>& rows, const PartColumns& columns,
                                       const RowReader& reader) {
  const Row& first = rows.front();
  const auto of_changes = [&](std::size_t i) {
    const std::vector<std::string> words = words_of(first[i].text);
    return std::any_of(words.begin(), words.end(),
                       [](const std::string& word) { return word.starts_with("change"); });
  };
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (i == columns.name || !heads_costs(first[i].text)) {
      continue;
    }
    if (found && of_changes(i) == of_changes(*found)) {
      fail_for_two(first[*found], first[i], "costs", reader);
    }
    if (!found || of_changes(i)) {
      found = i;
    }
  }
  const std::size_t other = columns.name == 0 ? 1 : 0;
  if (!found && first.size() == 2 && columns.slot != other) {
    found = other;
  }
  return found;
}

std::string header_note(const Row& first, const PartColumns& columns) {
  std::string text =
      fmt::format("the first row is a header: names in {}", shown(text_of(first, columns.name)));
  text += columns.cost ? fmt::format(", change costs in {}", shown(text_of(first, *columns.cost)))
                       : std::string(", no change costs");
  return columns.slot ? text + fmt::format(", slots in {}", shown(text_of(first, *columns.slot)))
                      : text;
}

}  // namespace

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return result;
}

bool heads_costs(std::string_view text) {
  // Whole words: "Europe" is none, nor is "precision".
  constexpr auto alone = std::to_array<std::string_view>(
      {"cost",    "costs", "price",  "prices", "pricing", "preis",  "preise", "preises", "kosten",
       "aufwand", "prix",  "coût",   "coûts",  "cout",    "couts",  "precio", "precios", "coste",
       "costes",  "costo", "costos", "costi",  "prezzo",  "prezzi", "preço",  "preços",  "preco",
       "precos",  "custo", "custos", "prijs",  "prijzen", "eur",    "euro",   "euros",   "usd",
       "gbp",     "chf",   "€",      "£",      "dollar",  "dollars"});
  // Of a longer word the end: "Umbaukosten", "unitprice", but not "caprice".
  constexpr auto ends = std::to_array<std::string_view>(
      {"cost", "costs", "price", "prices", "preis", "preise", "kosten", "aufwand"});
  constexpr std::size_t least_before = 3;
  const std::vector<std::string> words = words_of(text);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(alone.begin(), alone.end(), word) != alone.end() ||
           std::any_of(ends.begin(), ends.end(), [&](std::string_view end) {
             return word.size() >= end.size() + least_before && word.ends_with(end);
           });
  });
}

bool heads_slots(std::string_view text) {
  const std::string word = lower(text);
  return word == "slot" || word == "slots";
}

bool heads_parts(std::string_view text) {
  constexpr std::array<std::string_view, 24> words{"name",
                                                   "part",
                                                   "component",
                                                   "item",
                                                   "sample",
                                                   "product",
                                                   "article",
                                                   "device",
                                                   "module",
                                                   "specimen",
                                                   "element",
                                                   "wine",
                                                   "first",
                                                   "second",
                                                   "parts",
                                                   "names",
                                                   "teil",
                                                   "bauteil",
                                                   "probe",
                                                   "muster",
                                                   "from",
                                                   "to",
                                                   "pi\xc3\xa8"
                                                   "ce",
                                                   "unit"};
  std::string word = lower(text);
  // "part 2", "part_b"
  const std::size_t last = word.find_last_of(" _-");
  if (last != std::string::npos && last + 2 == word.size()) {
    word.resize(last);
  } else if (word.size() > 1 && word.back() >= '0' && word.back() <= '9') {
    word.pop_back();
  }
  return std::find(words.begin(), words.end(), word) != words.end();
}

PartColumns part_columns(const std::vector<Row>& rows, Header header, const RowReader& reader) {
  const Row& first = rows.front();
  const auto has = [&](std::string_view word) {
    return std::any_of(first.begin(), first.end(),
                       [&](const Field& field) { return field.text == word; });
  };
  if (header == Header::guessed && has("take_out") && has("put_in")) {
    reader.fail(first.front(), "this is a run sheet and no list of parts; give it to --done");
  }
  PartColumns columns;
  columns.header =
      header == Header::guessed ? is_header(rows, reader, columns.note) : header == Header::given;
  if (!columns.header) {
    columns.cost = 1;
    return columns;
  }
  const auto find = [&](auto&& heads) {
    const auto found =
        std::find_if(first.begin(), first.end(), [&](const Field& f) { return heads(f.text); });
    return found == first.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - first.begin()));
  };
  columns.slot = find(heads_slots);
  for (std::size_t i = columns.slot.value_or(first.size()) + 1; i < first.size(); ++i) {
    if (heads_slots(first[i].text)) {
      fail_for_two(first[*columns.slot], first[i], "slots", reader);
    }
  }
  std::size_t other = 0;  // the first column that says nothing else
  while (other + 1 < first.size() && (other == columns.slot || heads_costs(first[other].text))) {
    ++other;
  }
  columns.name = find(heads_parts).value_or(other);
  columns.cost = cost_column(rows, columns, reader);
  columns.note = header_note(first, columns);
  return columns;
}

}  // namespace changeover
