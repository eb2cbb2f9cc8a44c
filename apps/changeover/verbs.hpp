// The verbs, one file each.
#pragma once

#include "cli/cli.hpp"

namespace changeover::cli {

using AddVerb = void(Program& program);
AddVerb add_design, add_verify, add_bounds, add_explain, add_search, add_classify, add_same,
    add_minima, add_table, add_plan, add_expand, add_draw, add_dossier, add_factorize,
    add_constructions, add_paper, add_loadorder, add_serve, add_catalog_show, add_catalog_list,
    add_catalog_history, add_catalog_cite, add_catalog_completeness, add_catalog_add,
    add_catalog_retract, add_catalog_alias, add_catalog_export, add_catalog_import,
    add_catalog_verify, add_catalog_diff, add_catalog_improve, add_catalog_submit, add_completion,
    add_manual, add_describe;

}  // namespace changeover::cli
