#include "core/small_letters.hpp"

#include "core/printable.hpp"

namespace changeover {
namespace {

char32_t small_letter(char32_t c) {
  const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  const bool by_32 = within(U'A', U'Z') || (within(U'À', U'Þ') && c != U'×') ||
                     within(U'Α', U'Ϋ') || within(U'А', U'Я') || within(U'Ａ', U'Ｚ');
  const bool even = within(U'Ā', U'ķ') || within(U'Ŋ', U'ŷ');  // capitals, each before its own
  const bool odd = within(U'Ĺ', U'ň') || within(U'Ź', U'ž');
  return by_32                                         ? c + 32
         : within(U'Ѐ', U'Џ')                          ? c + 80
         : (even && c % 2 == 0) || (odd && c % 2 == 1) ? c + 1
         : c == U'Ÿ'                                   ? U'ÿ'
                                                       : c;
}

}  // namespace

std::u32string in_small_letters(std::string_view text) {
  std::u32string letters;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    letters += small_letter(point.value);
    text.remove_prefix(point.bytes);
  }
  return letters;
}

}  // namespace changeover
