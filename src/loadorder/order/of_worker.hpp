// Internal: the steps of one worker, selected from those of all.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "changeover/loadorder/schedule.hpp"

namespace changeover {

class OfWorker final : public StepSource {
 public:
  OfWorker(std::unique_ptr<StepSource> all, std::uint64_t worker)
      : all_(std::move(all)), worker_(worker) {}

  bool next(Step& step) override {
    while (all_->next(step)) {
      if (step.worker == worker_) {
        return true;
      }
    }
    return false;
  }

 private:
  std::unique_ptr<StepSource> all_;
  std::uint64_t worker_;
};

}  // namespace changeover
