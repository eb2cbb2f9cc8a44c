#include "cli/description.hpp"

#include "cli/cli.hpp"
#include "cli/spelling.hpp"

namespace changeover::cli {

std::string VerbDescription::typed() const { return as_typed(name); }

std::string VerbDescription::group() const {
  const std::size_t hyphen = name.find('-');
  return hyphen == std::string::npos ? std::string() : name.substr(0, hyphen);
}

const std::vector<ExitCodeDescription>& exit_codes() {
  static const std::vector<ExitCodeDescription> all{
      {exit_code::done, "done, or the design is valid"},
      {exit_code::refuted, "the claim was refuted"},
      {exit_code::usage, "wrong options or arguments"},
      {exit_code::bad_input, "a file is malformed"},
      {exit_code::missing_resource,
       "nothing serves these parameters, or a file, memory or disk space is missing"},
      {exit_code::bug, "a result failed its own verification: a bug of ours"},
      {exit_code::found, "a search found what it was asked for"},
      {exit_code::proved_none, "a search proved that there is none"},
      {exit_code::limit_reached, "it was stopped, by a limit or by Ctrl-C, before it knew"}};
  return all;
}

std::vector<ExitCodeDescription> refusals() {
  std::vector<ExitCodeDescription> some = exit_codes();
  std::erase_if(some, [](const ExitCodeDescription& each) {
    return each.code < exit_code::usage || each.code > exit_code::bug;
  });
  return some;
}

}  // namespace changeover::cli
