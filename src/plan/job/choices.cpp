#include "plan/job/choices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/plan/model.hpp"
#include "changeover/run/control.hpp"
#include "core/contains.hpp"
#include "plan/job/pair_numbers.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

Literal value_literal(Element x) { return static_cast<Literal>(x) + 1; }

}  // namespace

ChoiceSolver::ChoiceSolver(const Job& job) : job_(&job), rules_(*job.model) {
  Cnf& cnf = solver_.cnf;
  rules_.add_to(cnf);
  job.never.for_each(all_of_them, [&](Element x, Element y) {
    cnf.add({-value_literal(x), -value_literal(y)});
  });
  for (const Element x : job.mounted) {
    cnf.add({value_literal(x)});
  }
  for (const Element x : job.barred) {
    cnf.add({-value_literal(x)});
  }
  in_range_ = cnf.new_variable();
  for (Element x = 0; x < job.parts(); ++x) {
    if (job.model->value(x).negative) {
      cnf.add({-in_range_, -value_literal(x)});
    }
  }
}

std::optional<Block> ChoiceSolver::completed(std::span<const Element> parts,
                                             std::span<const Element> liked) {
  if (auto row = as_liked(parts, liked, false)) {
    return row;
  }
  assumed_.clear();
  for (const Element x : parts) {
    assumed_.push_back(value_literal(x));
  }
  preferred_.clear();
  for (const Element x : liked) {
    preferred_.push_back(value_literal(x));
  }
  return solve();
}

std::optional<Block> ChoiceSolver::testing(std::span<const Element> parts,
                                           std::span<const Element> liked) {
  const bool in_range = !out_of_range(*job_, parts);
  if (auto row = as_liked(parts, liked, in_range)) {
    return row;
  }
  assumed_.clear();
  for (const Element x : parts) {
    assumed_.push_back(value_literal(x));
  }
  if (in_range) {
    assumed_.push_back(in_range_);
  }
  // As few values other than the liked ones as can be: rows that the solver makes at will repeat.
  preferred_.clear();
  for (Element x = 0; x < job_->parts() && !liked.empty(); ++x) {
    preferred_.push_back(-value_literal(x));
  }
  for (const Element x : liked) {
    preferred_[x] = value_literal(x);
  }
  return solve();
}

std::optional<Block> ChoiceSolver::as_liked(std::span<const Element> parts,
                                            std::span<const Element> liked, bool in_range) const {
  if (liked.size() != job_->slots.size()) {
    return std::nullopt;
  }
  Block row(liked.begin(), liked.end());
  for (const Element m : job_->mounted) {
    row[job_->slot_of[m]] = m;
  }
  for (const Element x : parts) {
    row[job_->slot_of[x]] = x;
  }
  const auto has = [&](Element x) { return row[job_->slot_of[x]] == x; };
  if (!std::ranges::all_of(parts, has) || !std::ranges::all_of(job_->mounted, has)) {
    return std::nullopt;
  }
  for (std::size_t s = 0; s < row.size(); ++s) {
    const Element x = row[s];
    if (job_->slot_of[x] != s || rules_.banned(x) || contains(job_->barred, x) ||
        !rules_.allows(row, s, x) || (in_range && job_->model->value(x).negative)) {
      return std::nullopt;
    }
    for (std::size_t t = 0; t < s; ++t) {
      if (rules_.apart(row[t], x) || job_->never.contains(row[t], x)) {
        return std::nullopt;
      }
    }
  }
  return row;
}

std::optional<Block> ChoiceSolver::solve() {
  RunControl undisturbed({});
  RunControl* const above = RunScope::current();
  const Outcome outcome =
      solver_.solve_with(above == nullptr ? undisturbed : *above, assumed_, preferred_);
  if (outcome == Outcome::unknown) {
    throw Stopped(above == nullptr ? WhyStopped::fault : above->why_stopped());
  }
  if (outcome == Outcome::none) {
    return std::nullopt;
  }
  Block setup(job_->slots.size());
  for (Element x = 0; x < job_->parts(); ++x) {
    if (solver_.holds(value_literal(x))) {
      setup[job_->slot_of[x]] = x;
    }
  }
  return setup;
}

namespace {

/// Generates set-ups with many new pairs: of a few values of each parameter, the one with most.
class NewRows {
 public:
  NewRows(const Job& job, const PairSet& seen) : seen_(&seen), values_(job.slots.size()) {
    for (Element x = 0; x < job.parts(); ++x) {
      values_[job.slot_of[x]].push_back(x);
    }
  }

  Block next() {
    constexpr int samples = 4;
    Block row;
    for (const std::vector<Element>& values : values_) {
      Element best = values.front();
      std::ptrdiff_t most = -1;
      for (int i = 0; i < samples; ++i) {
        const Element x = values[random_.below(static_cast<std::uint32_t>(values.size()))];
        const std::ptrdiff_t fresh =
            std::ranges::count_if(row, [&](Element y) { return !seen_->contains(x, y); });
        if (fresh > most) {
          most = fresh;
          best = x;
        }
      }
      row.push_back(best);
    }
    return row;
  }

 private:
  const PairSet* seen_;
  std::vector<std::vector<Element>> values_;
  Random random_{1};
};

}  // namespace

PairSet apart_in_choices(const Job& job) {
  PairSet apart(job.parts());
  ChoiceSolver solver(job);
  PairSet seen(job.parts());
  NewRows rows(job, seen);
  Block last;
  // A value that no test has, as where another one is mounted, is in many pairs: it is asked for
  // once.
  std::vector<std::optional<bool>> known(job.parts());
  const auto is_possible = [&](Element x) {
    known[x] = known[x] ? known[x] : solver.completed(std::span(&x, 1), {}).has_value();
    return *known[x];
  };
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    stop_if_asked();
    if (seen.contains(x, y)) {
      return;
    }
    const Element both[] = {x, y};
    const bool may = job.slot_of[x] != job.slot_of[y] && is_possible(x) && is_possible(y);
    auto setup = may ? solver.testing(both, rows.next()) : std::nullopt;
    if (!setup) {
      apart.insert(x, y);
      return;
    }
    last = *std::move(setup);
    const auto hiding = out_of_range(job, last);
    for (std::size_t i = 0; i < last.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!hiding || *hiding == last[i] || *hiding == last[j]) {
          seen.insert(last[i], last[j]);
        }
      }
    }
  });
  return apart;
}

std::vector<Triple> together_in_choices(const Job& job, const std::vector<Triple>& triples) {
  std::vector<Triple> found;
  ChoiceSolver solver(job);
  const std::size_t v = job.names.size();
  std::vector<bool> seen(v * v * v, false);
  Block last;
  const auto place = [v](const Triple& t) { return (t[0] * v + t[1]) * v + t[2]; };
  for (const Triple& t : triples) {
    const bool same = job.slot_of[t[0]] == job.slot_of[t[1]] ||
                      job.slot_of[t[0]] == job.slot_of[t[2]] ||
                      job.slot_of[t[1]] == job.slot_of[t[2]];
    if (same) {
      continue;
    }
    if (!seen[place(t)]) {
      auto setup = solver.testing(t, last);
      if (!setup) {
        continue;
      }
      last = *std::move(setup);
      Block in_order = last;
      std::ranges::sort(in_order);
      const auto hiding = out_of_range(job, last);
      for (std::size_t i = 0; i < in_order.size(); ++i) {
        for (std::size_t j = i + 1; j < in_order.size(); ++j) {
          for (std::size_t l = j + 1; l < in_order.size(); ++l) {
            if (!hiding || *hiding == in_order[i] || *hiding == in_order[j] ||
                *hiding == in_order[l]) {
              seen[place({in_order[i], in_order[j], in_order[l]})] = true;
            }
          }
        }
      }
    }
    found.push_back(t);
  }
  return found;
}

std::optional<std::string> model_defect(const Job& job) {
  const Model& model = *job.model;
  const std::size_t parameters = model.parameters.size();
  bool fits = job.parts() == model.values() && job.at_once >= parameters &&
              job.slots.size() == parameters && job.slot_of.size() == job.names.size();
  for (std::size_t p = 0; fits && p < parameters; ++p) {
    fits = job.slots[p].least == 1 && job.slots[p].most == 1;
  }
  for (Element x = 0; fits && x < job.parts(); ++x) {
    fits = job.slot_of[x] == model.parameter_of(x);
  }
  return fits ? std::nullopt
              : std::optional<std::string>(
                    "the parts are not the values of the model, or the slots not its parameters");
}

std::optional<std::string> no_setup_of_model(const Job& job) {
  const Model& model = *job.model;
  const auto has_setup = [&](std::size_t rules) {
    Job some = job;
    Model beginning = model;
    beginning.constraints.resize(rules);
    some.model = std::make_shared<const Model>(std::move(beginning));
    return ChoiceSolver(some).completed({}, {}).has_value();
  };
  std::size_t impossible = model.constraints.size();
  if (has_setup(impossible)) {
    return std::nullopt;
  }
  if (impossible == 0 || !has_setup(0)) {
    return !job.barred.empty()   ? "no test is left of what it has; let it have more values"
           : job.mounted.empty() ? "no test is left beside what must never meet; leave a pair out"
                                 : "no test has all values that stay mounted; leave one out";
  }
  for (std::size_t possible = 0; possible + 1 < impossible;) {
    const std::size_t middle = possible + (impossible - possible) / 2;
    (has_setup(middle) ? possible : impossible) = middle;
  }
  const ModelConstraint& last = model.constraints[impossible - 1];
  return fmt::format("{}:{}: no test obeys this rule and those before it{}: {}; change one of them",
                     model.name, last.line,
                     job.mounted.empty() && job.never.size() == 0 && job.barred.empty() ? ""
                     : job.barred.empty() ? ", with what stays mounted and what must never meet"
                                          : ", without what the bench lacks",
                     last.text);
}

std::optional<Element> out_of_range(const Job& job, std::span<const Element> setup) {
  if (job.model != nullptr) {
    for (const Element x : setup) {
      if (job.model->value(x).negative) {
        return x;
      }
    }
  }
  return std::nullopt;
}

bool has_two_out_of_range(const Job& job, std::span<const Element> setup) {
  return job.model != nullptr &&
         std::ranges::count_if(setup, [&](Element x) { return job.model->value(x).negative; }) > 1;
}

}  // namespace changeover
