// Internal: steps that are stored in memory.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "changeover/loadorder/schedule.hpp"

namespace changeover {

class KeptSteps final : public StepSource {
 public:
  explicit KeptSteps(std::shared_ptr<const std::vector<Step>> steps) : steps_(std::move(steps)) {}

  bool next(Step& step) override {
    if (next_ == steps_->size()) {
      return false;
    }
    step = (*steps_)[next_++];
    return true;
  }

 private:
  std::shared_ptr<const std::vector<Step>> steps_;
  std::size_t next_ = 0;
};

}  // namespace changeover
