// Internal: projective and affine planes over finite fields as shares: any two points are on one
// line.
//
//     const Plane plane(3, false);             // 13 points, 13 lines of 4 points
//     plane.line_of(0, 5);                     // the line through two of them
//
// Points and lines of the projective plane over GF(q) have coordinates (1,a,b), (0,1,a) or (0,0,1),
// numbered in this order; the point (x,y,z) is on the line (u,v,w) if ux + vy + wz = 0. The affine
// plane leaves out the line (1,0,0) and its points: it has the points (1,a,b), and the lines from
// the second on. Points are then renumbered at random: the sizes of groups depend on their numbers,
// and no line should have only large groups.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "loadorder/shares/groups/group_shares.hpp"

namespace changeover {

/// Addition and multiplication of numbers below q, a prime power up to 256.
class FiniteField {
 public:
  /// Nullopt if q is not a prime power.
  [[nodiscard]] static std::optional<FiniteField> of_order(std::uint64_t q);

  [[nodiscard]] std::uint32_t order() const { return q_; }
  [[nodiscard]] std::uint32_t add(std::uint32_t a, std::uint32_t b) const {
    return sums_[a * q_ + b];
  }
  [[nodiscard]] std::uint32_t multiply(std::uint32_t a, std::uint32_t b) const {
    return a == 0 || b == 0 ? 0 : powers_[logs_[a] + logs_[b]];
  }
  [[nodiscard]] std::uint32_t negative(std::uint32_t a) const { return negatives_[a]; }
  /// a ≠ 0.
  [[nodiscard]] std::uint32_t inverse(std::uint32_t a) const { return powers_[q_ - 1 - logs_[a]]; }

 private:
  std::uint32_t q_ = 0;
  std::vector<std::uint32_t> sums_;
  std::vector<std::uint32_t> negatives_;
  std::vector<std::uint32_t> logs_;    // to the base of a generator
  std::vector<std::uint32_t> powers_;  // two periods
};

class Plane {
 public:
  /// @throws BadInput if q is not a prime power from 2 to 256
  Plane(std::uint64_t q, bool affine);

  [[nodiscard]] std::uint64_t points() const { return affine_ ? q_ * q_ : q_ * q_ + q_ + 1; }
  [[nodiscard]] std::uint64_t lines() const { return q_ * q_ + q_ + (affine_ ? 0 : 1); }
  [[nodiscard]] std::uint64_t on_a_line() const { return affine_ ? q_ : q_ + 1; }
  [[nodiscard]] std::uint64_t through_a_point() const { return q_ + 1; }

  /// The points of a line, in increasing order.
  [[nodiscard]] std::vector<Element> points_of(std::uint64_t line) const;
  /// The line through two different points. O(1)
  [[nodiscard]] std::uint64_t line_of(std::uint64_t point, std::uint64_t other) const;
  /// The i-th of the q+1 lines through a point. O(1)
  [[nodiscard]] std::uint64_t line_through(std::uint64_t point, std::uint64_t i) const;

 private:
  struct Triple {
    std::uint32_t x = 0, y = 0, z = 0;
  };
  [[nodiscard]] Triple triple(std::uint64_t number) const;
  [[nodiscard]] std::uint64_t number(const Triple& of) const;
  [[nodiscard]] Triple across(const Triple& a, const Triple& b) const;
  // The i-th of the q+1 points on a line, or of the lines through a point.
  [[nodiscard]] Triple beside(const Triple& of, std::uint32_t i) const;

  FiniteField field_;
  std::uint64_t q_;
  bool affine_;
  std::vector<std::uint32_t> place_of_;  // by triple: its point
  std::vector<std::uint32_t> point_at_;  // by point: its triple
};

/// Each worker has the points of a line. @throws as Plane
[[nodiscard]] GroupShares plane_shares(std::uint64_t q, bool affine);

/// The same for less room: of each line one point is streamed, another one for each line as far as
/// can be, so that each point is held on some line. @throws as Plane
[[nodiscard]] GroupShares streamed_plane_shares(std::uint64_t q, bool affine);

}  // namespace changeover
