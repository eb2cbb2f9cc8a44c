#include "plan/search/budget.hpp"

#include <algorithm>
#include <new>

#include "changeover/core/error.hpp"

namespace changeover {

ShareOfTime::ShareOfTime(RunControl& whole, double share) : whole_(&whole) {
  if (const auto left = whole.time_left()) {
    part_.emplace(whole, *left * share);
  }
}

std::optional<std::chrono::duration<double>> time_of_attempt(const RunControl& control,
                                                             std::size_t attempt,
                                                             std::size_t attempts, double share) {
  const auto left = control.time_left();
  if (!left || left->count() <= 0) {
    return std::nullopt;
  }
  const std::size_t threads = std::max<std::size_t>(1, control.threads());
  const std::size_t rounds = (attempts - attempt + threads - 1) / threads;
  return *left * (share / static_cast<double>(rounds));
}

bool Rounds::go_on(bool better, const Limits& limits) {
  ++round_;
  idle_ = better ? 0 : idle_ + 1;
  return options_->until_stopped || (options_->steps == 0 && round_ < limits.most &&
                                     (round_ < limits.least || idle_ < limits.most_idle));
}

WhyStopped why_it_ended(const RunControl& control, bool proved) {
  const WhyStopped why = control.why_stopped();
  return why != WhyStopped::running ? why
         : proved                   ? WhyStopped::found
         : control.time_was_up()    ? WhyStopped::time_limit
                                    : WhyStopped::step_limit;
}

void keep_what_there_is(std::optional<std::string>& shortage, const std::function<void()>& work,
                        const std::function<std::string()>& no_memory) {
  try {
    work();
  } catch (const Stopped&) {
    // The control knows why.
  } catch (const MissingResource& fault) {
    shortage = fault.what();
  } catch (const std::bad_alloc&) {
    shortage = no_memory();
  }
}

}  // namespace changeover
