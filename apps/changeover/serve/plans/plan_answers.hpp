// Jobs as the server takes them, and what it answers.
//
//     const OpenedRequest opened = sent_job(request.body);
//     const auto asked = from_body([&] { return checked_job(opened, Door::document); });
//     …
//     json_response(plan_json(asked, answer));
#pragma once

#include <cstddef>
#include <string>

#include "changeover/plan/job_request.hpp"

namespace changeover::serve {

/// A job document without files, its workbook opened; costs are 1 where nothing is said. @throws
/// Refusal 422, BadInput
[[nodiscard]] OpenedRequest sent_job(const std::string& body);

/// The answer as a document, and for a plan the keys that there were before it. @throws Refusal 413
/// if it has more than so many bytes, as below; most of those are not written first.
[[nodiscard]] std::string plan_json(const CheckedJobRequest& asked, const PlanAnswer& answer,
                                    std::size_t most_bytes);

/// The answer in a format of changeover plan. @throws Refusal 413; BadOption
[[nodiscard]] std::string plan_file(const CheckedJobRequest& asked, const PlanAnswer& answer,
                                    const std::string& format, std::size_t most_bytes);

/// How much memory an answer takes, about.
[[nodiscard]] std::size_t bytes_of(const PlanAnswer& answer);

/// What files say of a job, as one document whose lists are rows: {"request", "done", "notes"}. The
/// job need not be complete: what is missing stays so. @throws Refusal 422, BadInput
[[nodiscard]] std::string read_job_json(const std::string& body);

}  // namespace changeover::serve
