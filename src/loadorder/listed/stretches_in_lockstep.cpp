#include "loadorder/listed/stretches_in_lockstep.hpp"

#include <algorithm>
#include <utility>

#include "changeover/run/control.hpp"
#include "loadorder/listed/quick_moves.hpp"

namespace changeover {

StretchesInLockstep::StretchesInLockstep(const PairGraph& graph, const std::vector<LoadMove>& moves)
    : StretchesInLockstep(graph, one_step_each(moves)) {}

StretchesInLockstep::StretchesInLockstep(const PairGraph& graph, const std::vector<Move>& moves)
    : items_(static_cast<std::size_t>(graph.items())) {
  std::vector<std::size_t> stay_of(items_, not_again);
  std::vector<bool> met(static_cast<std::size_t>(2 * graph.pairs()), false);
  const auto load = [&](Element x) {
    stay_of[x] = stays_.size();
    stays_.push_back({.item = x, .jobs = {}});
    std::vector<std::size_t> job;
    for (const Element y : graph.partners(x)) {
      const auto place = static_cast<std::size_t>(*graph.place(x, y));
      if (stay_of[y] != not_again && !met[place]) {
        met[place] = true;
        job.push_back(stay_of[y]);
      }
    }
    if (!job.empty() || graph.partners(x).empty()) {
      job.push_back(stay_of[x]);
      for (const std::size_t stay : job) {
        stays_[stay].jobs.push_back(jobs_.size());
      }
      jobs_.push_back(std::move(job));
    }
  };
  for (const Move& move : moves) {
    for (const Element out : move.evict) {
      stay_of[out] = not_again;
    }
    std::ranges::for_each(move.load, load);
  }
}

class StretchesInLockstep::Play {
 public:
  Play(const StretchesInLockstep& all, const std::vector<std::size_t>& begins, std::size_t patience)
      : all_(all),
        patience_(patience),
        events_(begins.size()),
        workers_(begins.size()),
        holder_(all.items_, not_again),
        held_stay_(all.items_, not_again) {
    for (std::size_t w = 0; w < begins.size(); ++w) {
      workers_[w].at = begins[w];
      workers_[w].end = w + 1 < begins.size() ? begins[w + 1] : all.jobs();
    }
  }

  std::optional<LockstepEvents> run(std::uint64_t most_steps) {
    bool stuck = false;
    while (std::ranges::any_of(workers_, [](const Worker& w) { return w.at < w.end; })) {
      if (step_ == most_steps) {
        return std::nullopt;
      }
      release();
      take_from_others(stuck);
      stuck = !load();
      step_ += stuck ? 0 : 1;
    }
    return std::move(events_);
  }

 private:
  struct Worker {
    std::size_t at = 0;  // its next job
    std::size_t end = 0;
    std::vector<Element> done_with;
  };

  void evict(Element x) {
    events_[holder_[x]].push_back({static_cast<std::uint32_t>(step_), x, false});
    holder_[x] = not_again;
  }

  void release() {
    for (Worker& worker : workers_) {
      for (const Element x : std::exchange(worker.done_with, {})) {
        evict(x);
      }
    }
  }

  // Items that the next jobs lack and that can be spared. If no worker can go on, the first one
  // gets what it lacks.
  void take_from_others(bool stuck) {
    for (std::size_t w = 0; w < workers_.size(); ++w) {
      if (workers_[w].at == workers_[w].end) {
        continue;
      }
      for (const std::size_t stay : all_.jobs_[workers_[w].at]) {
        const Element x = all_.stays_[stay].item;
        if (const std::size_t other = holder_[x];
            other != not_again && other != w &&
            (stuck || next_job(x, workers_[other].at) > workers_[other].at + patience_)) {
          evict(x);
          if (stuck) {
            return;
          }
        }
      }
      if (stuck) {
        return;
      }
    }
  }

  // The first job from `at` on that needs a held item.
  [[nodiscard]] std::size_t next_job(Element x, std::size_t at) const {
    const std::vector<std::size_t>& jobs = all_.stays_[held_stay_[x]].jobs;
    const auto found = std::ranges::lower_bound(jobs, at);
    return found == jobs.end() ? not_again : *found;
  }

  // At most one item for each worker. Returns false if no worker loads.
  bool load() {
    bool any = false;
    for (std::size_t w = 0; w < workers_.size(); ++w) {
      Worker& worker = workers_[w];
      bool has_loaded = false;
      while (worker.at < worker.end) {
        const std::vector<std::size_t>& job = all_.jobs_[worker.at];
        bool lacks = false;
        for (const std::size_t stay : job) {
          const Element x = all_.stays_[stay].item;
          if (holder_[x] == not_again && !has_loaded) {
            holder_[x] = w;
            held_stay_[x] = stay;
            events_[w].push_back({static_cast<std::uint32_t>(step_), x, true});
            has_loaded = any = true;
          }
          if (holder_[x] != w) {
            lacks = true;
          } else if (held_stay_[x] != stay) {  // it has just become free, and stays
            held_stay_[x] = stay;
            std::erase(worker.done_with, x);
          }
        }
        if (lacks) {
          break;
        }
        finish_job(worker);
      }
    }
    return any;
  }

  void finish_job(Worker& worker) {
    const std::size_t job = worker.at++;
    for (const std::size_t stay : all_.jobs_[job]) {
      const std::vector<std::size_t>& jobs = all_.stays_[stay].jobs;
      const auto next = std::ranges::upper_bound(jobs, job);
      if (next == jobs.end() || *next >= worker.end) {
        worker.done_with.push_back(all_.stays_[stay].item);
      }
    }
  }

  const StretchesInLockstep& all_;
  std::size_t patience_;
  LockstepEvents events_;
  std::vector<Worker> workers_;
  std::vector<std::size_t> holder_;     // by item
  std::vector<std::size_t> held_stay_;  // by item that is held
  std::uint64_t step_ = 0;
};

std::optional<LockstepEvents> StretchesInLockstep::play(const std::vector<std::size_t>& begins,
                                                        std::size_t patience,
                                                        std::uint64_t most_steps) const {
  return Play(*this, begins, patience).run(most_steps);
}

void StretchesInLockstep::play_each(const std::vector<std::size_t>& begins,
                                    std::uint64_t most_steps,
                                    const std::function<void(LockstepEvents)>& visit) const {
  for (const std::size_t patience : {2U, 8U, 32U, 128U, ~0U}) {
    stop_if_asked();
    if (auto events = play(begins, patience, most_steps)) {
      visit(std::move(*events));
    }
  }
}

std::vector<std::size_t> StretchesInLockstep::even_cut(std::uint64_t workers) const {
  const std::uint64_t count = std::min<std::uint64_t>(workers, jobs());
  std::vector<std::size_t> begins;
  for (std::uint64_t w = 0; w < count; ++w) {
    begins.push_back(static_cast<std::size_t>(w * jobs() / count));
  }
  return begins;
}

}  // namespace changeover
