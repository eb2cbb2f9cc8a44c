#include "loadorder/listed/parts.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "loadorder/listed/quick_moves.hpp"

namespace changeover {
namespace {

/// Plays all workers, each of which loads at most one item in a step.
class Lockstep {
 public:
  Lockstep(const Tasks& tasks, std::uint64_t items, std::uint64_t room, std::uint64_t workers,
           NextTask choice)
      : tasks_(tasks),
        room_(room),
        choice_(choice),
        events_(static_cast<std::size_t>(workers)),
        workers_(events_.size()),
        is_done_(tasks.tasks.size(), false),
        is_locked_(tasks.parts.size(), false),
        left_(tasks.parts.size(), 0),
        items_(static_cast<std::size_t>(items)) {
    for (const Task& task : tasks.tasks) {
      left_[task.a] += task.moves().size();
      left_[task.b] += task.a == task.b ? 0 : task.moves().size();
    }
  }

  LockstepEvents events() {
    std::size_t running = 0;
    std::size_t left = tasks_.tasks.size();
    for (bool changed = true; left + running > 0; ++step_) {
      for (std::size_t w = 0; changed && w < workers_.size(); ++w) {
        if (workers_[w].task == not_again && take_task(w)) {
          --left;
          ++running;
        }
      }
      changed = false;
      for (std::size_t w = 0; w < workers_.size(); ++w) {
        if (workers_[w].task != not_again && !load_next(w)) {
          --running;
          changed = true;
        }
      }
    }
    for (std::vector<LockstepEvent>& each : events_) {
      std::ranges::stable_sort(each, [](const auto& e, const auto& f) {
        return std::pair(e.step, e.comes) < std::pair(f.step, f.comes);
      });
    }
    return std::move(events_);
  }

 private:
  struct Worker {
    std::size_t task = not_again;
    std::size_t last = not_again;    // its last task
    std::size_t next = 0;            // move of the task
    std::vector<std::size_t> again;  // by move: the next one that loads the item
    std::vector<Element> memory;
    std::set<std::pair<std::size_t, Element>> idle;  // by when it is loaded next
  };
  struct Item {
    std::size_t holder = not_again;
    std::size_t place = 0;     // in memory
    std::size_t needed = 0;    // if it is idle
    std::size_t upcoming = 0;  // the next move of `task` that loads it
    std::size_t task = not_again;
    bool is_idle = false;
  };

  bool take_task(std::size_t w) {
    std::size_t best = not_again;
    std::pair<bool, std::uint64_t> value;
    const std::size_t last = workers_[w].last;
    for (std::size_t t = 0; t < tasks_.tasks.size(); ++t) {
      const Task& task = tasks_.tasks[t];
      if (is_done_[t] || is_locked_[task.a] || is_locked_[task.b]) {
        continue;
      }
      const auto shares = [&](std::size_t part) {
        return part == tasks_.tasks[last].a || part == tasks_.tasks[last].b;
      };
      const std::pair<bool, std::uint64_t> its{
          choice_ == NextTask::same_part && last != not_again && (shares(task.a) || shares(task.b)),
          choice_ == NextTask::largest ? task.moves().size() : left_[task.a] + left_[task.b]};
      if (best == not_again || its > value) {
        best = t;
        value = its;
      }
    }
    if (best == not_again) {
      return false;
    }
    begin(w, best);
    return true;
  }

  void begin(std::size_t w, std::size_t t) {
    const Task& task = tasks_.tasks[t];
    Worker& worker = workers_[w];
    is_done_[t] = true;
    worker.task = worker.last = t;
    worker.next = 0;
    for (const std::size_t part : {task.a, task.b}) {
      is_locked_[part] = true;
      for (const Element x : tasks_.parts[part]) {
        if (items_[x].holder != not_again && items_[x].holder != w) {
          evict(x);
        }
      }
    }
    worker.again.assign(task.moves().size(), not_again);
    for (std::size_t i = task.moves().size(); i > 0; --i) {
      Item& item = items_[task.moves()[i - 1].load];
      worker.again[i - 1] = item.task == t ? item.upcoming : not_again;
      item.task = t;
      item.upcoming = i - 1;
    }
    worker.idle.clear();
    for (const Element x : worker.memory) {
      items_[x].is_idle = false;
      make_idle(x);
    }
  }

  // Returns false if the task is over.
  bool load_next(std::size_t w) {
    Worker& worker = workers_[w];
    const Task& task = tasks_.tasks[worker.task];
    bool has_loaded = false;
    while (!has_loaded && worker.next < task.moves().size()) {
      const std::size_t i = worker.next++;
      const auto& [x, out] = task.moves()[i];
      if (out != LoadMove::nothing && items_[out].holder == w) {
        make_idle(out);
      }
      if (items_[x].holder == w) {
        unmake_idle(x);
      } else {
        if (worker.memory.size() == room_) {
          evict(worker.idle.rbegin()->second);
        }
        load(w, x);
        has_loaded = true;
      }
      items_[x].upcoming = worker.again[i];
    }
    if (worker.next < task.moves().size()) {
      return true;
    }
    is_locked_[task.a] = is_locked_[task.b] = false;
    left_[task.a] -= task.moves().size();
    left_[task.b] -= task.a == task.b ? 0 : task.moves().size();
    for (const Element x : worker.memory) {
      make_idle(x);
    }
    worker.task = not_again;
    return false;
  }

  void make_idle(Element x) {
    Item& item = items_[x];
    Worker& worker = workers_[item.holder];
    if (!item.is_idle) {
      item.is_idle = true;
      item.needed = item.task == worker.task ? item.upcoming : not_again;
      worker.idle.emplace(item.needed, x);
    }
  }
  void unmake_idle(Element x) {
    Item& item = items_[x];
    workers_[item.holder].idle.erase({item.needed, x});
    item.is_idle = false;
  }

  void load(std::size_t w, Element x) {
    Item& item = items_[x];
    item.holder = w;
    item.place = workers_[w].memory.size();
    workers_[w].memory.push_back(x);
    events_[w].push_back({static_cast<std::uint32_t>(step_), x, true});
  }
  void evict(Element x) {
    Item& item = items_[x];
    Worker& worker = workers_[item.holder];
    unmake_idle(x);
    const Element moved = worker.memory.back();
    worker.memory[item.place] = moved;
    items_[moved].place = item.place;
    worker.memory.pop_back();
    events_[item.holder].push_back({static_cast<std::uint32_t>(step_), x, false});
    item.holder = not_again;
  }

  const Tasks& tasks_;
  std::uint64_t room_;
  NextTask choice_;
  LockstepEvents events_;
  std::vector<Worker> workers_;
  std::vector<bool> is_done_;    // by task: taken
  std::vector<bool> is_locked_;  // by part
  std::vector<std::uint64_t> left_;
  std::vector<Item> items_;
  std::uint64_t step_ = 0;
};

}  // namespace

LockstepEvents play_tasks(const Tasks& tasks, std::uint64_t items, std::uint64_t room,
                          std::uint64_t workers, NextTask choice) {
  return Lockstep(tasks, items, room, workers, choice).events();
}

}  // namespace changeover
