#include "plan/search/choices/tests_apart.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

#include "changeover/plan/model.hpp"
#include "changeover/run/control.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/pair_numbers.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_tuples = 200'000;
constexpr std::size_t most_questions = 3000;

// The values that are never in one test: by rules of two parameters, or of more, which the solver
// decides.
std::vector<std::vector<bool>> values_apart(const Job& job) {
  ChoiceSolver solver(job);
  const std::size_t v = job.names.size();
  std::vector<std::vector<bool>> apart(v, std::vector<bool>(v, false));
  RunControl undisturbed({});
  const RunScope scope(undisturbed);
  std::size_t questions = 0;
  for (Element x = 0; x < v; ++x) {
    for (Element y = 0; y < x; ++y) {
      bool never = job.slot_of[x] == job.slot_of[y] || solver.rules().apart(x, y) ||
                   solver.rules().banned(x) || solver.rules().banned(y) || job.never.contains(x, y);
      if (!never && !job.needed.contains(x, y) && questions < most_questions) {
        ++questions;
        const Element both[] = {x, y};
        never = !solver.completed(both, {});
      }
      apart[x][y] = apart[y][x] = never;
    }
  }
  return apart;
}

class ApartSearch {
 public:
  explicit ApartSearch(const Job& job) : job_(job) {
    if (job.triples.empty()) {
      job.needed.for_each(all_of_them, [&](Element x, Element y) { tuples_.push_back({x, y}); });
    } else {
      for (const Triple& t : job.triples) {
        tuples_.emplace_back(t.begin(), t.end());
      }
    }
  }

  std::vector<Block> run() {
    if (tuples_.empty() || tuples_.size() > most_tuples) {
      return {};
    }
    find_conflicts();
    fits_with_.assign(tuples_.size(), 0);
    chosen_.assign(tuples_.size(), false);
    until_.assign(tuples_.size(), 0);
    begin();
    constexpr std::size_t work = 60'000'000;
    const std::size_t moves = std::clamp<std::size_t>(work / tuples_.size(), 50, 20'000);
    std::vector<bool> best = chosen_;
    std::size_t most = size_;
    for (move_ = 1; move_ <= moves; ++move_) {
      if (!step()) {
        break;
      }
      if (size_ > most) {
        most = size_;
        best = chosen_;
      }
    }
    std::vector<Block> found;
    for (std::size_t i = 0; i < tuples_.size(); ++i) {
      if (best[i]) {
        found.push_back(tuples_[i]);
      }
    }
    return found;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // By value and tuple size: whether a tuple has a value that is never with this one.
  void find_conflicts() {
    apart_ = values_apart(job_);
    for (const Block& tuple : tuples_) {
      hidden_.push_back(none);
      for (const Element x : tuple) {
        if (job_.model->value(x).negative) {
          hidden_.back() = x;
        }
      }
    }
  }

  [[nodiscard]] bool conflict(std::size_t i, std::size_t j) const {
    if (hidden_[i] != hidden_[j]) {
      return true;
    }
    return std::ranges::any_of(tuples_[i], [&](Element x) {
      return std::ranges::any_of(tuples_[j], [&](Element y) { return x != y && apart_[x][y]; });
    });
  }

  // Starts with all tuples of the parameters that have most, which exclude each other, and those of
  // each value out of range with one parameter.
  void begin() {
    std::map<std::vector<std::uint32_t>, std::vector<std::size_t>> by_parameters;
    for (std::size_t i = 0; i < tuples_.size(); ++i) {
      std::vector<std::uint32_t> key;
      for (const Element x : tuples_[i]) {
        key.push_back(job_.slot_of[x]);
      }
      std::ranges::sort(key);
      if (hidden_[i] != none) {
        key.push_back(static_cast<std::uint32_t>(job_.slots.size() + hidden_[i]));
      }
      by_parameters[key].push_back(i);
    }
    std::vector<const std::vector<std::size_t>*> groups;
    groups.reserve(by_parameters.size());
    for (const auto& [key, group] : by_parameters) {
      groups.push_back(&group);
    }
    std::ranges::stable_sort(groups, {}, [](const auto* group) { return -std::ssize(*group); });
    for (const auto* group : groups) {
      for (const std::size_t i : *group) {
        if (!chosen_[i] && fits_with_[i] == 0) {
          set(i, true);
        }
      }
    }
  }

  // Adds or removes a tuple and updates the counts of the others.
  void set(std::size_t i, bool chosen) {
    chosen_[i] = chosen;
    chosen ? ++size_ : --size_;
    for (std::size_t j = 0; j < tuples_.size(); ++j) {
      if (j != i && !conflict(i, j)) {
        chosen ? ++fits_with_[j] : --fits_with_[j];
      }
    }
  }

  // Adds a tuple that excludes all chosen ones; or exchanges it with the only one that it does not
  // exclude, which may not return at once; or removes one.
  bool step() {
    std::size_t best = none;
    std::uint32_t fewest = 2;
    std::uint32_t ties = 0;
    for (std::size_t i = 0; i < tuples_.size(); ++i) {
      if (chosen_[i] || fits_with_[i] > fewest || fits_with_[i] >= 2 ||
          (fits_with_[i] == 1 && until_[i] > move_)) {
        continue;
      }
      ties = fits_with_[i] < fewest ? 0 : ties;
      fewest = fits_with_[i];
      if (random_.below(++ties) == 0) {
        best = i;
      }
    }
    if (best == none) {
      return drop_any();
    }
    if (fewest == 1) {
      for (std::size_t i = 0; i < tuples_.size(); ++i) {
        if (chosen_[i] && !conflict(i, best)) {
          set(i, false);
          until_[i] = move_ + 7 + random_.below(10);
          break;
        }
      }
    }
    set(best, true);
    return true;
  }

  bool drop_any() {
    if (size_ == 0) {
      return false;
    }
    std::uint32_t skip = random_.below(static_cast<std::uint32_t>(size_));
    for (std::size_t i = 0; i < tuples_.size(); ++i) {
      if (chosen_[i] && skip-- == 0) {
        set(i, false);
        until_[i] = move_ + 7 + random_.below(10);
        break;
      }
    }
    return true;
  }

  const Job& job_;
  std::vector<Block> tuples_;
  std::vector<std::vector<bool>> apart_;  // by two values
  std::vector<std::size_t> hidden_;       // by tuple: its value out of range
  std::vector<std::uint32_t>
      fits_with_;  // by tuple: number of chosen ones that fit into a test with it
  std::vector<bool> chosen_;
  std::vector<std::size_t> until_;  // by tuple: the move before which it does not return
  std::size_t size_ = 0;
  std::size_t move_ = 0;
  Random random_{1, 9'000'000};
};

}  // namespace

std::vector<Block> tuples_for_tests_apart(const Job& job) { return ApartSearch(job).run(); }

}  // namespace changeover
