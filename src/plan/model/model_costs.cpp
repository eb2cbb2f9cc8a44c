// Reads the costs of setting values of a model.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/parts/cost_reader.hpp"
#include "plan/model/model_names.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

class ValueCosts {
 public:
  ValueCosts(Input& input, Job& job)
      : reader_(input, {.most_rows = std::uint64_t{1} << 20, .most_bytes = std::uint64_t{1} << 26}),
        job_(job),
        names_(*job.model),
        cost_of_(reader_),
        given_(job.names.size(), false),
        given_by_(job.names.size(), 0) {
    while (auto row = reader_.next()) {
      rows_.push_back(std::move(*row));
    }
    if (rows_.empty()) {
      fail(input.name(), {}, "no cost is listed; write OS,Debian,12.50 or OS,12.50");
    }
  }

  std::vector<bool> read() {
    for (at_ = heads() ? 1 : 0; at_ < rows_.size(); ++at_) {
      const Row& row = rows_[at_];
      const auto parameter = names_.parameter(row.front().text);
      if (!parameter) {
        reader_.fail(row.front(), no_parameter(row.front().text, names_.model()));
      }
      is_table(*parameter) ? read_table(*parameter) : read_row(*parameter);
    }
    for (const Replaced& each : replaced_) {
      if (each.row < given_by_[each.in]) {  // a later row gives the cost of the value
        continue;
      }
      if (job_.replace_costs.empty()) {
        start_replacing();
      }
      job_.replace_costs[each.out * job_.names.size() + each.in] = each.cost;
    }
    return std::move(given_);
  }

 private:
  struct Replaced {
    Element out;
    Element in;
    Amount cost;
    std::size_t row;
  };

  // Whether the first row is a header, "parameter,value,cost".
  [[nodiscard]] bool heads() const {
    const Row& row = rows_.front();
    return same_word(row.front().text, "parameter") && !names_.parameter(row.front().text) &&
           row.size() > 1;
  }

  [[nodiscard]] static std::size_t width(const Row& row) {
    std::size_t fields = row.size();
    while (fields > 0 && row[fields - 1].text.empty()) {
      --fields;
    }
    return fields;
  }

  // Whether this row and the next begin a square table: all values of the parameter, and then one
  // of them with an empty field.
  [[nodiscard]] bool is_table(std::size_t parameter) const {
    const Row& row = rows_[at_];
    const std::size_t values = job_.model->parameters[parameter].values.size();
    if (width(row) != values + 1 || at_ + 1 == rows_.size()) {
      return false;
    }
    std::vector<bool> seen(job_.names.size(), false);
    for (std::size_t i = 1; i <= values; ++i) {
      const auto x = names_.value(parameter, row[i].text);
      if (!x || seen[*x]) {
        return false;
      }
      seen[*x] = true;
    }
    const Row& next = rows_[at_ + 1];
    return names_.value(parameter, next.front().text) && width(next) <= values + 1 &&
           (width(next) < values + 1 ||
            std::ranges::any_of(next, [](const Field& field) { return field.text.empty(); }));
  }

  Element value_in(std::size_t parameter, const Field& field) const {
    const auto x = names_.value(parameter, field.text);
    if (!x) {
      reader_.fail(field, fmt::format("{} has no value {}; write it as the model does",
                                      job_.model->parameters[parameter].name, shown(field.text)));
    }
    return *x;
  }

  void give(Element x, Amount cost) {
    job_.change_costs[x] = cost;
    given_[x] = true;
    given_by_[x] = at_;
  }

  void set(std::size_t parameter, Amount cost) {
    const ModelParameter& of = job_.model->parameters[parameter];
    for (std::size_t i = 0; i < of.values.size(); ++i) {
      give(of.first + static_cast<Element>(i), cost);
    }
  }

  // On how many benches a value can be at a time.
  void set_quantity(Element x, const Field& field) {
    std::uint64_t quantity = 0;
    const char* const end = field.text.data() + field.text.size();
    const auto [rest, failure] = std::from_chars(field.text.data(), end, quantity);
    if (failure != std::errc() || rest != end || quantity == 0) {
      reader_.fail(field, fmt::format("{} is not a quantity; write how many there are, 1 or more",
                                      shown(field.text)));
    }
    job_.quantities.resize(job_.names.size(), enough_for_all);
    job_.quantities[x] = quantity;
  }

  // Rows such as "OS,12.50", "OS,Debian,12.50", "OS,Debian,Fedora,4", "OS,Debian,quantity,1".
  void read_row(std::size_t parameter) {
    const Row& row = rows_[at_];
    switch (width(row)) {
      case 2:
        return set(parameter, cost_of_.read(row[1]));
      case 3:
        if (same_word(row[2].text, "quantity")) {
          reader_.fail(row[2], fmt::format("no quantity of {}; write how many there are, or leave "
                                           "out this row if there are enough",
                                           job_.names[value_in(parameter, row[1])]));
        }
        return give(value_in(parameter, row[1]), cost_of_.read(row[2]));
      case 4: {
        if (same_word(row[2].text, "quantity") && !names_.value(parameter, row[2].text)) {
          return set_quantity(value_in(parameter, row[1]), row[3]);
        }
        const Element out = value_in(parameter, row[1]);
        const Element in = value_in(parameter, row[2]);
        if (out == in) {
          reader_.fail(row[2], fmt::format("{} does not replace itself; leave out this row",
                                           shown(row[2].text)));
        }
        replaced_.push_back({out, in, cost_of_.read(row[3]), at_});
        return;
      }
      default:
        reader_.fail(
            row.front(),
            "expected a cost; write OS,12.50, or OS,Debian,12.50, or OS,Debian,Fedora,4 for "
            "Fedora in place of "
            "Debian");
    }
  }

  void read_table(std::size_t parameter) {
    const ModelParameter& of = job_.model->parameters[parameter];
    std::vector<Element> columns;
    for (std::size_t i = 1; i <= of.values.size(); ++i) {
      columns.push_back(value_in(parameter, rows_[at_][i]));
    }
    const Field head = rows_[at_].front();
    std::vector<bool> seen(job_.names.size(), false);
    for (std::size_t i = 0; i < of.values.size(); ++i) {
      if (++at_ == rows_.size()) {
        reader_.fail(head,
                     fmt::format("the table of {} has {}; give one for each of its {}", of.name,
                                 count_of(i, "row"), count_of(of.values.size(), "value")));
      }
      const Row& row = rows_[at_];
      const Element out = value_in(parameter, row.front());
      if (seen[out]) {
        reader_.fail(row.front(),
                     fmt::format("{} heads two rows; remove one", shown(row.front().text)));
      }
      seen[out] = true;
      for (std::size_t j = 0; j < columns.size(); ++j) {
        const bool given = j + 1 < row.size() && !row[j + 1].text.empty();
        if (given == (columns[j] == out)) {
          reader_.fail(given ? row[j + 1] : row.front(),
                       given ? fmt::format("{} does not replace itself; leave this field empty",
                                           shown(row.front().text))
                             : fmt::format("no cost of {} in place of {}; give one",
                                           job_.names[columns[j]], shown(row.front().text)));
        }
        if (given) {
          replaced_.push_back({out, columns[j], cost_of_.read(row[j + 1]), at_});
        }
      }
      if (width(row) > columns.size() + 1) {
        reader_.fail(row[columns.size() + 1],
                     "more costs than the table has columns; remove this field and those after it");
      }
    }
  }

  // The default for replacing a value is the cost of setting the new one.
  void start_replacing() {
    const std::size_t v = job_.names.size();
    job_.replace_costs.resize(v * v);
    for (std::size_t out = 0; out < v; ++out) {
      for (std::size_t in = 0; in < v; ++in) {
        job_.replace_costs[out * v + in] = out == in ? Amount{} : job_.change_costs[in];
      }
    }
  }

  RowReader reader_;
  Job& job_;
  ModelNames names_;
  CostReader cost_of_;
  std::vector<Row> rows_;
  std::vector<Replaced> replaced_;
  std::vector<bool> given_;            // by part
  std::vector<std::size_t> given_by_;  // by part: the last row that gave a cost
  std::size_t at_ = 0;
};

}  // namespace

std::vector<bool> read_value_costs(Input& input, Job& job) {
  if (job.model == nullptr) {
    throw BadInput("costs of values are for a job of a model");
  }
  return ValueCosts(input, job).read();
}

}  // namespace changeover
