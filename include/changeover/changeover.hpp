// Everything that this library offers, in one line.
//
//     check(Parameters{.v = 61, .k = 4});
//     std::cout << version << '\n';
//
// What is included here is the public interface: these headers include each other, the standard
// library and nothing else, and what they do not show may change at any time. A program that needs
// one module includes its headers only, which compile faster.
//
// Pages that comments name, as docs/theorems.md, are in the sources and on the site that
// `./dev docs` makes; what is below src/ is internal.
//
//   core         parameters, blocks and designs, recipes, faults
//   run          limits, stop and progress of all that takes long
//   verify       the verdict on a list of blocks
//   bounds       how few blocks there can be
//   catalog      designs that are known, with labels that last
//   construct    designs by recipe: the registry, recursions, plans of whole ranges
//   draw         pictures of designs, recipes and tables, as SVG and TikZ
//   io           files in and out, tables
//   isomorphism  the same up to names, and the groups
//   proof        checked proofs that there is none
//   search       designs that are found, and proofs that there are none
//   curator      designs into the catalog and out of it, and what it says held to what is built
//   plan         run sheets for experiments
//   loadorder    load orders, and all-pairs jobs that run them
#pragma once

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/one_factorization.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/fans.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/core/sha256.hpp"
#include "changeover/core/version.hpp"
#include "changeover/curator/curator.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/draw/picture.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/io/request.hpp"
#include "changeover/io/tables.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/changeover_loadorder.h"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/plan/job_request.hpp"
#include "changeover/plan/model.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/proof/proof.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/base_block_search.hpp"
#include "changeover/search/enumeration.hpp"
#include "changeover/search/exact.hpp"
#include "changeover/search/local_search.hpp"
#include "changeover/search/wanted.hpp"
#include "changeover/verify/difference.hpp"
#include "changeover/verify/fans.hpp"
#include "changeover/verify/verdict.hpp"
