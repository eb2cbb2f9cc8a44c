#include <algorithm>
#include <array>
#include <string>

#include "cli/team.hpp"
#include "cli/terminal.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct NamedVerb {
  const char* name;
  AddVerb* add;
  bool of_all = false;  // it speaks of all verbs
};

// In the order of the help.
constexpr std::array all_verbs = {
    NamedVerb{"design", add_design},
    NamedVerb{"verify", add_verify},
    NamedVerb{"bounds", add_bounds},
    NamedVerb{"explain", add_explain},
    NamedVerb{"search", add_search},
    NamedVerb{"classify", add_classify},
    NamedVerb{"same", add_same},
    NamedVerb{"table", add_table},
    NamedVerb{"minima", add_minima},
    NamedVerb{"plan", add_plan},
    NamedVerb{"expand", add_expand},
    NamedVerb{"draw", add_draw},
    NamedVerb{"dossier", add_dossier},
    NamedVerb{"factorize", add_factorize},
    NamedVerb{"constructions", add_constructions},
    NamedVerb{"paper", add_paper},
    NamedVerb{"loadorder", add_loadorder},
    NamedVerb{"serve", add_serve},
    NamedVerb{"catalog-show", add_catalog_show},
    NamedVerb{"catalog-list", add_catalog_list},
    NamedVerb{"catalog-history", add_catalog_history},
    NamedVerb{"catalog-cite", add_catalog_cite},
    NamedVerb{"catalog-completeness", add_catalog_completeness},
    NamedVerb{"catalog-add", add_catalog_add},
    NamedVerb{"catalog-retract", add_catalog_retract},
    NamedVerb{"catalog-alias", add_catalog_alias},
    NamedVerb{"catalog-export", add_catalog_export},
    NamedVerb{"catalog-import", add_catalog_import},
    NamedVerb{"catalog-verify", add_catalog_verify},
    NamedVerb{"catalog-diff", add_catalog_diff},
    NamedVerb{"catalog-improve", add_catalog_improve},
    NamedVerb{"catalog-submit", add_catalog_submit},
    NamedVerb{"completion", add_completion, true},
    NamedVerb{"manual", add_manual, true},
    NamedVerb{"describe", add_describe, true},
};

// All verbs, or the one that the command line names: the others take a third of a start.
void add_verbs(Program& program, int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  const std::string both = first + "-" + (argc > 2 ? argv[2] : "");
  const auto* const named = std::ranges::find_if(all_verbs, [&](const NamedVerb& verb) {
    return !verb.of_all && (verb.name == first || verb.name == both);
  });
  const auto add_catalog = [&] {
    program.add_group("catalog", "browse and extend the catalog of known designs");
  };
  if (named != all_verbs.end()) {
    add_catalog();
    named->add(program);
    return;
  }
  for (const NamedVerb& verb : all_verbs) {
    if (verb.add == &add_catalog_show) {
      add_catalog();
    }
    verb.add(program);
  }
}

}  // namespace
}  // namespace changeover::cli

int main(int argc, char** argv) {
  using namespace changeover::cli;
  prepare_process();
  const Watched watched;
  Program program;
  add_verbs(program, argc, argv);
  const int code = program.run(argc, argv);
  Team::leave(code);
  return code;
}
