#include "plan/search/bounds/least_sum.hpp"

#include <algorithm>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

constexpr double nearly_zero = 1e-7;

}  // namespace

LeastSum::LeastSum(const std::vector<double>& costs) : columns_(costs.size()), reduced_(costs) {
  for (std::size_t j = 0; j < columns_; ++j) {
    free_.push_back(j);
    place_of_.push_back(j);
    row_of_.push_back(no_place);
  }
}

void LeastSum::add(const Row& row, std::int64_t least) {
  std::vector<double> line(columns_ + 1, 0.0);
  line[columns_] = -static_cast<double>(least);
  for (const Term& term : row) {
    const auto factor = static_cast<double>(term.factor);
    if (place_of_[term.column] != no_place) {
      line[place_of_[term.column]] += factor;
      continue;
    }
    const std::vector<double>& of_basic = table_[row_of_[term.column]];
    for (std::size_t j = 0; j <= columns_; ++j) {
      line[j] += factor * of_basic[j];
    }
  }
  const std::size_t variable = place_of_.size();
  basic_.push_back(variable);
  place_of_.push_back(no_place);
  row_of_.push_back(table_.size());
  table_.push_back(std::move(line));
}

void LeastSum::pivot(std::size_t row, std::size_t place) {
  std::vector<double>& line = table_[row];
  const double divisor = line[place];
  // The basic variable leaves: `line` expresses the entering one.
  for (double& number : line) {
    number = -number / divisor;
  }
  line[place] = 1.0 / divisor;
  const auto put_in = [&](std::vector<double>& other, std::size_t numbers) {
    const double factor = other[place];
    if (factor == 0.0) {
      return;
    }
    other[place] = 0.0;
    for (std::size_t j = 0; j < numbers; ++j) {
      other[j] += factor * line[j];
    }
  };
  for (std::size_t i = 0; i < table_.size(); ++i) {
    if (i != row) {
      put_in(table_[i], columns_ + 1);
    }
  }
  put_in(reduced_, columns_);
  const std::size_t entering = free_[place];
  const std::size_t leaving = basic_[row];
  basic_[row] = entering;
  free_[place] = leaving;
  row_of_[entering] = row;
  place_of_[entering] = no_place;
  place_of_[leaving] = place;
  row_of_[leaving] = no_place;
}

// The row shows that its variable, which must not be negative, is negative for any values of the
// others: so any price can be charged for it.
void LeastSum::raise(std::size_t row, double enough) {
  const std::vector<double>& line = table_[row];
  const double times = std::max(0.0, enough - sum_) / -line[columns_];
  for (std::size_t j = 0; j < columns_; ++j) {
    reduced_[j] = std::max(0.0, reduced_[j] - times * line[j]);
  }
  raised_ = basic_[row];
  raised_by_ = times;
}

LeastSum::End LeastSum::solve(std::uint64_t& work, double enough) {
  for (;;) {
    stop_if_asked();
    std::size_t row = no_place;
    double lowest = -nearly_zero;
    for (std::size_t i = 0; i < table_.size(); ++i) {
      if (table_[i][columns_] < lowest) {
        lowest = table_[i][columns_];
        row = i;
      }
    }
    if (row == no_place) {
      return End::solved;
    }
    const std::uint64_t numbers = table_.size() * (columns_ + 1);
    if (work < numbers) {
      return End::worked;
    }
    work -= numbers;
    std::size_t place = no_place;
    const std::vector<double>& line = table_[row];
    for (std::size_t j = 0; j < columns_; ++j) {
      if (line[j] <= nearly_zero) {
        continue;
      }
      const double more = place == no_place ? 0 : reduced_[j] * line[place];
      const double least = place == no_place ? 0 : reduced_[place] * line[j];
      if (place == no_place || more < least || (more == least && line[j] > line[place])) {
        place = j;
      }
    }
    if (place == no_place) {
      raise(row, enough);
      return End::impossible;
    }
    sum_ += reduced_[place] * -line[columns_] / line[place];
    pivot(row, place);
    for (double& cost : reduced_) {
      cost = std::max(cost, 0.0);
    }
  }
}

double LeastSum::value(std::size_t column) const {
  return row_of_[column] == no_place ? 0.0 : std::max(0.0, table_[row_of_[column]][columns_]);
}

double LeastSum::price(std::size_t row) const {
  const std::size_t variable = columns_ + row;
  const std::size_t place = place_of_[variable];
  return variable == raised_ ? raised_by_ : place == no_place ? 0.0 : reduced_[place];
}

}  // namespace changeover
