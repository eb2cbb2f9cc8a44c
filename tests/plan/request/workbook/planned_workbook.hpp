// A request whose plan is written as a workbook, and that is asked again from there.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "changeover/plan/job_request.hpp"
#include "changeover/run/control.hpp"

namespace changeover::test {

inline OpenedRequest opened(const std::string& bytes, JobRequest request = {}) {
  request.parts.workbook = bytes;
  return open_workbook(std::move(request));
}

class PlannedWorkbook : public testing::Test {
 protected:
  std::string planned(const OpenedRequest& what) {
    check_options(what.request, Door::document);
    checked.emplace(checked_job(what, Door::document));
    asked = **checked;
    RunControl control({.threads = 1});
    answer = answer_to(*checked, control);
    return written(*checked, answer, "xlsx");
  }
  std::string planned() { return planned({.request = request, .notes = {}}); }

  JobRequest request;
  std::optional<CheckedJobRequest> checked;
  ReadJob asked;  // what it has read
  PlanAnswer answer;
};

}  // namespace changeover::test
