#include "plan/request/first_lists.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "core/contains.hpp"
#include "core/printable.hpp"
#include "io/scan/place.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/job/bench_list.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover {
namespace {

class FirstList {
 public:
  FirstList(Input& input, const OldListOptions& options, Job& job, std::vector<Bench>& benches)
      : name_(input.name()), options_(options), job_(job), benches_(benches) {
    const std::uint64_t most = most_at_once(job, benches);
    if (is_model()) {
      list_ = read_first_list(input, *options.all_values, most);
      if (options.notes != nullptr) {
        options.notes->insert(options.notes->end(), list_.notes.begin(), list_.notes.end());
      }
    } else {
      list_ = read_first_list(input, *options.names, most, options.gone);
    }
  }

  void take() {
    is_model() ? refuse_left_out() : note_left_out();
    for (const DoneRow& row : list_.rows) {
      of_row_.push_back(bench_of(row));
    }
    is_model() ? take_tests() : take_setups();
  }

 private:
  [[nodiscard]] bool is_model() const { return job_.model != nullptr; }

  [[nodiscard]] bool is_left_out(Element x) const { return (*options_.left)(Block{x}).empty(); }

  [[nodiscard]] std::optional<std::size_t> bench_of(const DoneRow& row) const {
    const auto bench = find_bench(benches_, row.bench);
    if (!row.bench.empty() && !bench) {
      fail(name_, {row.line, 1},
           benches_.empty()
               ? fmt::format("the test is on bench {}, but there are no benches; give them too",
                             shown(row.bench))
               : fmt::format("there is no bench {}; give the name or the number of one",
                             shown(row.bench)));
    }
    return bench;
  }

  // No test of a model can have a value that is left out from now on.
  void refuse_left_out() {
    for (DoneRow& row : list_.rows) {
      for (const Element x : row.setup) {
        if (is_left_out(x)) {
          fail(name_, {row.line, 1},
               fmt::format("{} is left out from now on; set another value, or leave this one open",
                           options_.all_values->names[x]));
        }
      }
      row.setup = (*options_.left)(row.setup);
    }
  }

  // Parts that broke are in no set-up.
  void note_left_out() const {
    Block without;
    for (const DoneRow& row : list_.rows) {
      for (const Element x : row.setup) {
        if (is_left_out(x) && !contains(without, x)) {
          without.push_back(x);
        }
      }
    }
    if (!without.empty() && options_.notes != nullptr) {
      options_.notes->push_back(fmt::format("{}: left out from now on, so not in its set-ups: {}",
                                            name_, parts_text(without, *options_.names)));
    }
  }

  // What a test of a model leaves open depends on the bench.
  void take_tests() {
    if (benches_.empty()) {
      job_.first = checked_first(name_, std::move(list_), job_);
      return;
    }
    for (std::size_t b = 0; b < benches_.size(); ++b) {
      if (benches_[b].down) {
        continue;
      }
      DoneList own;
      for (const bool of_all : {true, false}) {
        for (std::size_t i = 0; i < of_row_.size(); ++i) {
          if (of_all ? !of_row_[i] : of_row_[i] == b) {
            own.rows.push_back(list_.rows[i]);
          }
        }
      }
      if (!own.rows.empty()) {
        const Job job = job_of_bench(job_, benches_[b], PairSet(job_.parts()));
        benches_[b].first =
            checked_first(name_, std::move(own), job, "bench " + name_of(benches_, b));
      }
    }
  }

  void take_setups() {
    for (std::size_t i = 0; i < of_row_.size(); ++i) {
      const DoneRow& row = list_.rows[i];
      const std::optional<std::size_t>& bench = of_row_[i];
      const Block setup = (*options_.left)(row.setup);
      if (setup.empty() && (row.lacks || !row.setup.empty())) {
        continue;
      }
      if (bench || benches_.empty()) {
        if (const auto defect =
                setup_defect(bench ? job_of_bench(job_, benches_[*bench]) : job_, setup)) {
          fail(name_, {row.line, 1}, *defect);
        }
      }
      if (!bench) {
        job_.first.push_back(setup);
        continue;
      }
      std::optional<std::vector<Block>>& own = benches_[*bench].first;
      own = own.value_or(std::vector<Block>());
      own->push_back(setup);
    }
    for (Bench& bench : benches_) {
      if (bench.first) {
        bench.first->insert(bench.first->begin(), job_.first.begin(), job_.first.end());
      }
    }
  }

  std::string name_;
  const OldListOptions& options_;
  Job& job_;
  std::vector<Bench>& benches_;
  DoneList list_;
  std::vector<std::optional<std::size_t>> of_row_;  // its bench
};

}  // namespace

void take_first(Input& input, const OldListOptions& options, Job& job,
                std::vector<Bench>& benches) {
  FirstList(input, options, job, benches).take();
}

}  // namespace changeover
