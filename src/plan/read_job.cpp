#include "changeover/plan/read_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <unordered_map>

#include "changeover/core/error.hpp"
#include "io/place.hpp"
#include "plan/rows.hpp"

namespace changeover {
namespace {

using plan_detail::Field;
using plan_detail::Row;
using plan_detail::RowText;

constexpr std::size_t longest_name = 255;

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return result;
}

// Parts by name or number.
class PartFinder {
 public:
  explicit PartFinder(const std::vector<std::string>& names) : names_(&names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      by_name_.emplace(names[i], static_cast<Element>(i));
    }
  }

  [[nodiscard]] std::optional<Element> find(const std::string& word) const {
    if (const auto found = by_name_.find(word); found != by_name_.end()) {
      return found->second;
    }
    std::size_t number = 0;
    const char* const end = word.data() + word.size();
    const auto [rest, failure] = std::from_chars(word.data(), end, number);
    if (failure == std::errc() && rest == end && number >= 1 && number <= names_->size()) {
      return static_cast<Element>(number - 1);
    }
    return std::nullopt;
  }

  // What to say of a word that is no part: with the name that differs in its case only, if there is one.
  [[nodiscard]] std::string complaint(const std::string& word) const {
    for (const std::string& name : *names_) {
      if (lower(name) == lower(word)) {
        return fmt::format("there is no part {}; did you mean {}?", io_detail::shown(word),
                           io_detail::shown(name));
      }
    }
    return fmt::format(
        "there is no part {}; give a name of the parts list or a number from 1 to {}",
        io_detail::shown(word), names_->size());
  }

 private:
  const std::vector<std::string>* names_;
  std::unordered_map<std::string, Element> by_name_;
};

// Fields that are parts, none twice; says which field is at fault.
template <typename Fail>
Block find_parts(const PartFinder& finder, const Row& row, Fail&& fail) {
  Block parts;
  for (const Field& field : row) {
    if (field.text.empty()) {
      continue;
    }
    const auto part = finder.find(field.text);
    if (!part) {
      fail(field, finder.complaint(field.text));
    }
    if (std::find(parts.begin(), parts.end(), *part) != parts.end()) {
      fail(field, fmt::format("{} stands here twice; remove one", io_detail::shown(field.text)));
    }
    parts.push_back(*part);
  }
  return parts;
}

// A row of numbers with blanks between them and no comma: "1 2 3".
Row at_blanks(const Field& field) {
  Row row;
  for (std::size_t at = 0; at < field.text.size();) {
    const std::size_t start = field.text.find_first_not_of(" \t", at);
    if (start == std::string::npos) {
      break;
    }
    at = std::min(field.text.find_first_of(" \t", start), field.text.size());
    row.push_back({field.text.substr(start, at - start), field.offset + start});
  }
  return row;
}

struct PartColumns {
  std::size_t name = 0;
  std::optional<std::size_t> cost = 1;
  bool header = false;
};

PartColumns columns_of(const Row& first) {
  constexpr std::array<std::string_view, 4> words{"name", "part", "component", "item"};
  const auto is_word = [&](const Field& field) {
    return std::find(words.begin(), words.end(), lower(field.text)) != words.end();
  };
  const auto has_digit = [](const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  PartColumns columns;
  columns.header = std::any_of(first.begin(), first.end(), is_word) ||
                   (first.size() > 1 && !first[1].text.empty() && !has_digit(first[1].text));
  if (columns.header) {
    const auto name = std::find_if(first.begin(), first.end(), is_word);
    const auto cost = std::find_if(first.begin(), first.end(), [](const Field& field) {
      return lower(field.text).find("cost") != std::string::npos;
    });
    columns.name = name == first.end() ? 0 : static_cast<std::size_t>(name - first.begin());
    columns.cost = cost == first.end()
                       ? std::nullopt
                       : std::optional(static_cast<std::size_t>(cost - first.begin()));
  }
  return columns;
}

}  // namespace

PartList read_parts(Input& input) {
  const RowText text(read_to_end(input), input.name());
  const std::vector<Row> rows = text.rows();
  PartList parts;
  std::unordered_map<std::string, std::size_t> seen;
  const PartColumns columns = rows.empty() ? PartColumns{} : columns_of(rows.front());
  for (std::size_t i = columns.header ? 1 : 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (!columns.header && row.size() > 2) {
      text.fail(row[2].offset,
                "a third field; write a name and a change cost, and quote a name with a comma");
    }
    if (columns.name >= row.size() || row[columns.name].text.empty()) {
      text.fail(row.front().offset, "a row without a name; name the part");
    }
    const Field& name = row[columns.name];
    if (name.text.size() > longest_name) {
      text.fail(name.offset, fmt::format("a name of more than {} bytes; shorten it", longest_name));
    }
    if (!seen.emplace(name.text, i).second) {
      text.fail(name.offset,
                fmt::format("a second part is called {}; rename one", io_detail::shown(name.text)));
    }
    if (parts.names.size() == max_parts) {
      text.fail(name.offset,
                fmt::format("more than {} parts; plan for fewer at a time", max_parts));
    }
    parts.names.push_back(name.text);
    parts.change_costs.emplace_back();
    if (columns.cost && *columns.cost < row.size() && !row[*columns.cost].text.empty()) {
      const Field& cost = row[*columns.cost];
      try {
        parts.change_costs.back() = parse_amount(cost.text);
      } catch (const Error& fault) {
        text.fail(cost.offset, fault.what());
      }
    }
  }
  if (parts.names.empty()) {
    text.fail(0, "no part is listed; write one a line");
  }
  return parts;
}

PairSet read_pairs(Input& input, const std::vector<std::string>& names) {
  const RowText text(read_to_end(input), input.name());
  const PartFinder finder(names);
  PairSet pairs(names.size());
  for (const Row& row : text.rows()) {
    const Block pair = find_parts(finder, row, [&](const Field& field, const std::string& what) {
      text.fail(field.offset, what);
    });
    if (pair.size() != 2) {
      text.fail(row.front().offset,
                fmt::format("{} here, and a pair has two; write A,B",
                            pair.size() == 1 ? "one part stands" : "more than two stand"));
    }
    pairs.insert(pair[0], pair[1]);
  }
  return pairs;
}

std::vector<Block> read_setups(Input& input, const std::vector<std::string>& names) {
  const RowText text(read_to_end(input), input.name());
  const PartFinder finder(names);
  const std::vector<Row> rows = text.rows();
  std::vector<Block> setups;
  std::optional<std::size_t> column;
  if (!rows.empty()) {
    for (std::size_t i = 0; i < rows.front().size(); ++i) {
      if (rows.front()[i].text == "set_up") {
        column = i;
      }
    }
  }
  for (std::size_t i = column ? 1 : 0; i < rows.size(); ++i) {
    const auto fail = [&](const Field& field, const std::string& what) {
      text.fail(column ? rows[i][*column].offset : field.offset, what);
    };
    if (column && *column >= rows[i].size()) {
      text.fail(rows[i].front().offset, "a row without a set-up; remove it or complete it");
    }
    Row row = column ? plan_detail::split_row(rows[i][*column].text) : rows[i];
    if (!column && row.size() == 1 && !finder.find(row.front().text)) {
      row = at_blanks(row.front());
    }
    setups.push_back(find_parts(finder, row, fail));
  }
  return setups;
}

Block parse_parts(std::string_view text, const std::vector<std::string>& names) {
  return find_parts(PartFinder(names), plan_detail::split_row(text),
                    [](const Field&, const std::string& what) { throw BadInput(what); });
}

std::string parts_text(const Block& parts, const std::vector<std::string>& names) {
  std::string text;
  for (const Element x : parts) {
    text += (text.empty() ? "" : ", ") + plan_detail::quoted(names[x]);
  }
  return text;
}

}  // namespace changeover
