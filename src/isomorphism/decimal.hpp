// Products of many small numbers, exact, in decimal: orders of groups.
//
//     Decimal order;                 // 1
//     order.multiply(366);
//     order.text();                  // "366"
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace changeover {

class Decimal {
 public:
  /// O(number of digits).
  void multiply(std::uint32_t factor) {
    std::uint64_t carry = 0;
    for (std::uint32_t& limb : limbs_) {
      const std::uint64_t product = std::uint64_t{limb} * factor + carry;
      limb = static_cast<std::uint32_t>(product % base);
      carry = product / base;
    }
    while (carry > 0) {
      limbs_.push_back(static_cast<std::uint32_t>(carry % base));
      carry /= base;
    }
  }

  [[nodiscard]] std::string text() const {
    std::string text = std::to_string(limbs_.back());
    for (std::size_t i = limbs_.size() - 1; i-- > 0;) {
      const std::string digits = std::to_string(limbs_[i]);
      text += std::string(base_digits - digits.size(), '0') + digits;
    }
    return text;
  }

 private:
  static constexpr std::uint32_t base = 1'000'000'000;
  static constexpr std::size_t base_digits = 9;
  std::vector<std::uint32_t> limbs_{1};  // lowest first
};

}  // namespace changeover
