#include "loadorder/shares/known_shares.hpp"

namespace changeover {
namespace {

constexpr const char* lines[] = {
#include "loadorder/shares/share_table.inc"
};

}  // namespace

std::span<const char* const> share_table() { return lines; }

}  // namespace changeover
