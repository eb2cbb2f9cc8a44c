#include "search/enumerate/enumeration_team.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <memory>
#include <mutex>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "changeover/search/enumeration.hpp"
#include "changeover/verify/verdict.hpp"
#include "run/threads.hpp"
#include "search/enumerate/enumeration_case.hpp"
#include "search/enumerate/enumeration_tree.hpp"

namespace changeover {
namespace {

constexpr std::size_t prefixes_wanted = 512;  // per case, if it has that many
constexpr std::size_t prefixes_at_most = 1'000'000;
constexpr std::size_t found_at_once = 64;  // passed on together

struct Prefix {
  std::size_t own_case = 0;
  std::vector<Mask> blocks;
};

// Collects the nodes at one depth.
class PrefixCollector final : public EnumerationVisitor {
 public:
  explicit PrefixCollector(RunControl& control) : control_(&control) {}

  bool reached(std::span<const Mask> blocks) override {
    found.emplace_back(blocks.begin(), blocks.end());
    return !too_many();
  }
  [[nodiscard]] bool too_many() const { return found.size() > prefixes_at_most; }

  bool go_on(std::uint64_t more) override {
    nodes += more;
    return !control_->stop_wanted();
  }

  std::vector<std::vector<Mask>> found;
  std::uint64_t nodes = 0;

 private:
  RunControl* control_;
};

// The design of a list of masks: the elements that are in every block first.
Design design_of(const Parameters& p, std::size_t fixed, std::span<const Mask> blocks) {
  Design design(p);
  design.reserve(blocks.size());
  Block block;
  for (const Mask mask : blocks) {
    block.clear();
    for (std::size_t x = 0; x < fixed; ++x) {
      block.push_back(static_cast<Element>(x));
    }
    for (Mask rest = mask; rest != 0; rest &= rest - 1) {
      block.push_back(
          static_cast<Element>(fixed + static_cast<std::size_t>(std::countr_zero(rest))));
    }
    design.append(block);
  }
  return design;
}

class Team {
 public:
  Team(const EnumerationTask& task, RunControl& control) : task_(task), control_(control) {}

  EnumerationRun run() {
    require_memory();
    cut();
    slots_.resize(mine_.size());
    const std::size_t threads = std::min<std::size_t>(control_.threads(), mine_.size());
    run_together(control_, static_cast<unsigned>(threads), [this](unsigned) { work(); });
    // A limit may have left gaps; results behind them are still valid.
    for (Slot& slot : slots_) {
      hand_out(slot.found);
    }
    const WhyStopped why = control_.why_stopped();
    result_.why_stopped = why == WhyStopped::running ? WhyStopped::exhausted : why;
    result_.nodes = nodes_;
    result_.prefixes = whole_ ? prefixes_.size() : 0;
    result_.prefixes_done = explored_;
    return result_;
  }

 private:
  // The results of one prefix that were not passed on yet.
  struct Slot {
    std::vector<DesignClass> found;
    bool done = false;
  };

  // One prefix being explored.
  class Explorer final : public EnumerationVisitor {
   public:
    Explorer(Team& team, std::size_t turn) : team_(team), turn_(turn) {}

    bool reached(std::span<const Mask> blocks) override {
      const Prefix& prefix = team_.prefixes_[team_.mine_[turn_]];
      const EnumerationCase& own = team_.task_.cases[prefix.own_case];
      if (auto judged = team_.task_.judge(design_of(team_.task_.parameters, own.fixed, blocks))) {
        found_.push_back(std::move(*judged));
        if (found_.size() >= found_at_once && team_.turn_ == turn_) {
          const std::scoped_lock lock(team_.handing_out_);
          team_.hand_out(found_);
        }
      }
      return team_.control_.why_stopped() != WhyStopped::fault;
    }
    bool go_on(std::uint64_t nodes) override {
      team_.nodes_ += nodes;
      team_.tell();
      return !team_.control_.stop_wanted();
    }

    std::vector<DesignClass> found_;

   private:
    Team& team_;
    std::size_t turn_;
  };

  // Tables by the number of fixed elements, and one tree per thread.
  void require_memory() const {
    std::uint64_t bytes = 0;
    for (std::size_t c = 0; c < task_.cases.size(); ++c) {
      if (c == 0 || task_.cases[c].fixed != task_.cases[c - 1].fixed) {
        bytes += DegreeTable::bytes(task_.cases[c].b);
      }
    }
    if (!task_.cases.empty()) {
      bytes += (control_.threads() + 1) * EnumerationTree::bytes(task_.cases.front().b);
    }
    control_.require_memory(bytes, "the tables of this enumeration");
  }

  void cut() {
    const WorkShare share = control_.settings().share;
    for (std::size_t c = 0; c < task_.cases.size() && !control_.stop_wanted(); ++c) {
      const EnumerationCase& own = task_.cases[c];
      if (c == 0 || own.fixed != task_.cases[c - 1].fixed) {
        degrees_.push_back(std::make_shared<const DegreeTable>(own));
      } else {
        degrees_.push_back(degrees_.back());
      }
      EnumerationTree tree(own, *degrees_.back());
      const std::vector<Mask> root{own.first_block()};
      std::vector<std::vector<Mask>> cut{root};
      std::uint64_t nodes = 0;
      for (std::size_t depth = 1; depth < own.b && !control_.stop_wanted(); ++depth) {
        PrefixCollector collector(control_);
        tree.explore(root, depth, collector);
        if (collector.too_many()) {
          break;  // one level up there were few, and so they stay
        }
        cut = std::move(collector.found);
        nodes = collector.nodes;
        if (cut.empty() || cut.size() >= prefixes_wanted) {
          break;
        }
      }
      const std::size_t length = cut.empty() ? 0 : cut.front().size();
      list_bytes_ += cut.size() * (sizeof(Prefix) + length * sizeof(Mask));
      control_.require_memory(list_bytes_, "the beginnings into which this enumeration is cut");
      for (auto& blocks : cut) {
        prefixes_.push_back({.own_case = c, .blocks = std::move(blocks)});
      }
      nodes_ += share.index == 0 ? nodes : 0;
    }
    whole_ = !control_.stop_wanted();
    for (std::size_t i = share.index; i < prefixes_.size();
         i += std::max<std::uint64_t>(share.of, 1)) {
      mine_.push_back(i);
    }
  }

  void work() {
    std::optional<EnumerationTree> tree;
    std::size_t last_case = task_.cases.size();
    for (std::size_t turn = next_++; turn < mine_.size(); turn = next_++) {
      if (control_.stop_wanted()) {
        return;
      }
      const Prefix& prefix = prefixes_[mine_[turn]];
      const EnumerationCase& own = task_.cases[prefix.own_case];
      if (prefix.own_case != last_case) {
        tree.emplace(own, *degrees_[prefix.own_case]);
        last_case = prefix.own_case;
      }
      Explorer explorer(*this, turn);
      tree->explore(prefix.blocks, own.b - 1, explorer);
      explored_ += control_.stop_wanted() ? 0 : 1;
      finish(turn, std::move(explorer.found_));
    }
  }

  void finish(std::size_t turn, std::vector<DesignClass> found) {
    const std::scoped_lock lock(handing_out_);
    slots_[turn].found = std::move(found);
    slots_[turn].done = true;
    std::size_t next = turn_;
    while (next < slots_.size() && slots_[next].done) {
      hand_out(slots_[next].found);
      turn_ = ++next;
    }
  }

  void hand_out(std::vector<DesignClass>& found) {
    for (DesignClass& each : found) {
      ++result_.forms;
      if (task_.hand_out) {
        task_.hand_out(each);
      }
    }
    found.clear();
  }

  void tell() {
    if (control_.progress_due()) {
      control_.tell(
          {.phase = fmt::format("enumeration: {} of {} prefixes", turn_.load(), mine_.size()),
           .steps = nodes_,
           .unit = "nodes"});
    }
  }

  const EnumerationTask& task_;
  RunControl& control_;
  std::vector<std::shared_ptr<const DegreeTable>> degrees_;  // by case
  std::vector<Prefix> prefixes_;
  bool whole_ = false;  // the work was cut to its end
  std::uint64_t list_bytes_ = 0;
  std::vector<std::size_t> mine_;  // prefixes of this share
  std::vector<Slot> slots_;        // by position in mine_
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> turn_{0};
  std::atomic<std::uint64_t> nodes_{0};
  std::atomic<std::uint64_t> explored_{0};  // prefixes, to their end
  std::mutex handing_out_;
  EnumerationRun result_;
};

}  // namespace

EnumerationRun explore_together(const EnumerationTask& task, RunControl& control) {
  return Team(task, control).run();
}

namespace {

Verdict verified(const Design& design, std::uint64_t b) {
  Verdict verdict = verify(design);
  if (!verdict.valid() || verdict.b != b) {
    throw InternalError(
        fmt::format("enumeration of {} found a list that is none", name(design.parameters())));
  }
  return verdict;
}

// v = k: one block holds everything, and nothing can change.
std::optional<Design> single_block(const Parameters& p, std::uint64_t b) {
  if (p.v != p.k || b != 1) {
    return std::nullopt;
  }
  Block block;
  for (Element x = 0; x < p.v; ++x) {
    block.push_back(x);
  }
  return Design(p, std::vector<Block>{block});
}

EnumerationRun explore(const EnumerationTask& task, std::uint64_t b, RunControl& control) {
  // Only one share finds the single block.
  const auto single = single_block(task.parameters, b);
  if (!single || control.settings().share.index != 0) {
    return explore_together(task, control);
  }
  EnumerationRun result{
      .why_stopped = WhyStopped::exhausted, .forms = 1, .nodes = 1, .prefixes = 0};
  if (auto judged = task.judge(*single)) {
    task.hand_out(*judged);
  }
  return result;
}

}  // namespace

EnumerationRun enumerate_designs(const Parameters& p, std::uint64_t b, RunControl& control,
                                 const std::function<void(const Design&)>& on_design) {
  EnumerationTask task;
  task.parameters = p;
  task.cases = enumeration_cases(p, b, false);
  task.judge = [&](const Design& design) -> std::optional<DesignClass> {
    // Linear designs come in standard form; circular ones also depend on where the list ends.
    DesignClass found{
        .representative = p.kind == Kind::linear ? design : standard_form(design).design,
        .group_order = {}};
    verified(found.representative, b);
    return found;
  };
  task.hand_out = [&](DesignClass& found) {
    if (on_design) {
      on_design(found.representative);
    }
  };
  return explore(task, b, control);
}

Classification classify_designs(const Parameters& p, std::uint64_t b,
                                const ClassifyOptions& options, RunControl& control) {
  const Sameness same{.rotation = true, .reversal = options.reversal};
  EnumerationTask task;
  task.parameters = p;
  task.cases = enumeration_cases(p, b, true);
  // Several sequences of a class are found. Only one of them is its canonical form, which begins
  // with a longest run and so is always among them.
  task.judge = [&](const Design& design) -> std::optional<DesignClass> {
    CanonicalForm own = standard_form(design);
    CanonicalForm least = canonical_form(own.design, same);
    if (!std::ranges::equal(own.design.elements(), least.design.elements())) {
      return std::nullopt;
    }
    const Verdict verdict = verified(least.design, b);
    const AutomorphismGroup group = automorphisms(least.design, same);
    DesignClass found{.representative = std::move(least.design), .group_order = group.order};
    found.forms = standard_forms_in_class(found.representative, group, same);
    found.rotations = group.rotations;
    found.reflections = group.reflections;
    found.fixed = verdict.fixed.size();
    found.tight = verdict.tight();
    found.economical = verdict.economical();
    return found;
  };
  Classification result;
  task.hand_out = [&](DesignClass& found) {
    ++result.classes;
    result.standard_forms += found.forms;
    result.tight += found.tight ? 1 : 0;
    ++result.group_orders[found.group_order];
    if (options.on_class) {
      options.on_class(found);
    }
    if (result.kept.size() < options.keep) {
      result.kept.push_back(std::move(found));
    }
  };
  const EnumerationRun run = explore(task, b, control);
  result.why_stopped = run.why_stopped;
  result.nodes = run.nodes;
  result.prefixes = run.prefixes;
  result.prefixes_done = run.prefixes_done;
  return result;
}

}  // namespace changeover
