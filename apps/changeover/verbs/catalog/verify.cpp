// changeover catalog verify: everything that the catalog says, held to what is built.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "answer/answer.hpp"
#include "changeover/core/error.hpp"
#include "changeover/curator/curator.hpp"
#include "changeover/io/output.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/file/file_lock.hpp"
#include "io/write/json_writer.hpp"
#include "request/catalog_request.hpp"
#include "request/output.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct AuditRequest {
  FilterRequest filter;
  std::string resume;
  CatalogRequest catalog;
  RunRequest run;
  OutputRequest output;
};

// The labels that are done, a line each, after a line with the checksum of what is asked for.
class Ledger {
 public:
  Ledger(const std::string& path, const AuditScope& scope) : path_(path) {
    if (path.empty()) {
      return;
    }
    lock_.emplace(path);
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
      throw BadInput(printable(path) + ": not a regular file; name another with --resume");
    }
    const std::string first = "changeover-catalog-verify/1 " + scope.checksum;
    std::ifstream old(path);
    std::string line;
    const bool is_there = static_cast<bool>(std::getline(old, line));
    if (is_there && !line.starts_with("changeover-catalog-verify/1 ")) {
      throw BadInput(printable(path) +
                     ": not a list that catalog verify --resume wrote; name another file");
    }
    const bool goes_on = is_there && line == first;
    const std::set<std::string> labels(scope.labels.begin(), scope.labels.end());
    while (goes_on && std::getline(old, line)) {
      // A line that was broken off has no end; one that names no entry counts for nothing.
      if (!old.eof() && labels.contains(line)) {
        done.insert(line);
      }
    }
    old.close();
    // Rewritten, so that nothing is appended to half a line, and as a whole, so that nothing is
    // lost.
    OutputFile whole(path);
    whole.write(first + "\n");
    for (const std::string& label : done) {
      whole.write(label + "\n");
    }
    whole.commit();
    file_.open(path, std::ios::app);
    flush();
  }

  void add(const std::string& label) {
    if (!path_.empty()) {
      file_ << label << '\n';
      if (++unsaved_ == 64) {
        flush();
      }
    }
  }

  void flush() {
    unsaved_ = 0;
    if (!path_.empty() && !file_.flush()) {
      throw MissingResource(printable(path_) +
                            ": cannot be written; name another file with --resume");
    }
  }

  std::set<std::string> done;

 private:
  std::string path_;
  std::optional<FileLock> lock_;
  std::ofstream file_;
  int unsaved_ = 0;
};

Answer run(const AuditRequest& request) {
  const Catalog& catalog = request.catalog.open();
  const CatalogFilter filter = request.filter.filter();
  const auto running = std::make_shared<Running>(request.run, request.output);
  const AuditScope scope = audit_scope(catalog, filter);
  Ledger ledger(request.resume, scope);
  Audit audit = audit_entries(catalog, scope, running->control(), ledger.done,
                              [&](const std::string& label) { ledger.add(label); });
  if (const std::string problem = catalog.problem(); !problem.empty() && audit.faults.empty()) {
    audit.faults.push_back({"your own catalog", problem});  // It was left out.
  }
  ledger.flush();
  const double seconds = running->control().elapsed().count();
  running->finish();
  const bool complete = audit.complete(ledger.done.size());
  const int code = !audit.faults.empty() ? exit_code::refuted
                   : complete            ? exit_code::done
                                         : exit_code::limit_reached;
  std::string text;
  JsonWriter json;
  json.begin_object().key("entries").value(audit.entries).key("checked").value(audit.checked);
  json.key("checked_before").value(std::uint64_t{ledger.done.size()}).key("complete");
  json.value(complete);
  json.list("faults", audit.faults, [&](const Audit::Fault& fault) {
    text += fmt::format("WRONG: {}: {}\n", fault.label, printable(fault.what));
    json.begin_object().key("label").value(fault.label).key("what").value(fault.what).end_object();
  });
  json.end_object();
  text += fmt::format("{} of {} built and verified{} in {:.1f} s, {}{}\n", audit.checked,
                      count_of(audit.entries, "design"),
                      ledger.done.empty() ? "" : fmt::format(" ({} before)", ledger.done.size()),
                      seconds,
                      audit.faults.empty() ? "all as they say"
                                           : fmt::format("{} not as they say", audit.faults.size()),
                      complete ? "" : "; stopped");
  return final_answer(running, text_answer(request.output.json() ? json.take() + "\n" : text,
                                           request.output, code));
}

}  // namespace

void add_catalog_verify(Program& program) {
  auto [verb, request] = program.add<AuditRequest>(
      "catalog-verify", "rebuild every design of the catalog, and check its entry", run);
  request.filter.add_to(verb, FilterRequest::Unless::best_is_asked_for);
  verb.option("--resume", request.resume, "FILE",
              "record the checked designs in FILE, and continue from it");
  request.catalog.add_to(verb);
  verb.require([&asked = request] { check_kept(asked.output.path, {"--resume", asked.resume}); });
  request.output.add_to(verb, {"text", "json"});
  request.run.add_limits_to(verb, "", request.output);
  verb.examples({"changeover catalog verify --threads 2 --resume done.txt",
                 "changeover catalog verify --users"});
  verb.outcomes({{exit_code::done, "every entry is correct"},
                 {exit_code::refuted, "some entry is wrong"},
                 {exit_code::limit_reached, "stopped before the end"}});
}

}  // namespace changeover::cli
