// Bounds by what only some benches can test.
//
// Proof. Let S be some of the benches, and P the needed pairs that no other bench can test. The
// lists of S test P, so they are a plan for P on S alone: its bounds hold for them. The costs of
// sets without a common bench add up.
//
// Where parts are scarce, the other benches only delay S: without their steps no more pieces are
// held at any time, so what S does is still allowed at the same times, and steps that now wait for
// nothing may move left. That is a plan for P on S alone that ends no later; the ends of benches
// that never wait are the sums of their own costs, which is what the bounds count.
//
// Hours are another matter: the length of a day is that of the bench that works longest
// (benches.hpp), which need not be in S. If any bench has hours, makespans are not raised.
#pragma once

#include "plan/search/benches/bench_bounds.hpp"

namespace changeover {

/// Raises the bounds of the field by those of sets of its benches, for jobs of a model on two to
/// four benches that differ. If the scope of this thread (run/control.hpp) requests a stop, looks
/// at no further set. Up to 2^benches times bench_bounds().
void raise_by_some_benches(const BenchField& field, BenchBounds& bounds);

}  // namespace changeover
