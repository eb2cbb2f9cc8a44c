// Bounds by what only some benches can test.
//
// Proof. Let S be some of the benches, and P the needed pairs that no other bench can test. The
// lists of S test P, so they are a plan for P on S alone: its bounds hold for them. The costs of
// sets without a common bench add up.
#pragma once

#include "plan/search/benches/bench_bounds.hpp"

namespace changeover {

/// Raises the bounds of the field by those of sets of its benches, for jobs of a model on two to
/// four benches that differ. If the scope of this thread (run/control.hpp) requests a stop, looks
/// at no further set. Up to 2^benches times bench_bounds().
void raise_by_some_benches(const BenchField& field, BenchBounds& bounds);

}  // namespace changeover
