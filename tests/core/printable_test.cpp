#include "core/printable.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::printable_test {
namespace {

TEST(Printable, LeavesTextOfAnyScriptAsItIs) {
  for (const std::string text : {"", "B-12", "∞_s", "Ünïcode 漢", "a\\x1bb", "𝔽₂", "עברית"}) {
    EXPECT_EQ(printable(text), text);
    EXPECT_TRUE(is_printable(text));
  }
}

TEST(Printable, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a\\x1b[2Jb");
  EXPECT_EQ(printable("\a\b\x7f"), "\\x07\\x08\\x7f");
  EXPECT_EQ(printable("a\r\n\tb"), "a\\r\\n\\tb");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(printable("\u009b31m"), "\\u{009b}31m");
  EXPECT_EQ(printable("\x9b"), "\\x9b");
  EXPECT_EQ(printable("\u202egnp\u2066"), "\\u{202e}gnp\\u{2066}");
  EXPECT_EQ(printable("\u2028"), "\\u{2028}");
}

TEST(Printable, EscapesBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("M\xfcller"), "M\\xfcller");
  EXPECT_EQ(printable("\xc0\x80"), "\\xc0\\x80") << "an overlong form";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
}

RC_GTEST_PROP(Printable, AnyBytesBecomePrintableAndStaySo, (const std::string& bytes)) {
  const std::string once = printable(bytes);
  RC_ASSERT(is_printable(once));
  RC_ASSERT(printable(once) == once);
  RC_ASSERT(is_printable(bytes) == (once == bytes));
}

TEST(Printable, EveryFaultIsOneLineThatIsSafeToShow) {
  EXPECT_STREQ(BadInput("a\x1b[0m\n\xff: wrong").what(), "a\\x1b[0m\\n\\xff: wrong");
  EXPECT_STREQ(ReaderGone("\u0085").what(), "\\u{0085}");
}

TEST(LabelDefect, RefusesWhatNotEveryFormatAndTerminalCanCarry) {
  for (const std::string label : {"", "a b", "a\tb", "a,b", "a\"b", "#a", "\x1b", "\x7f", "\u009b",
                                  "\u202e", "\u2028", "\xff", "M\xfcller"}) {
    EXPECT_TRUE(label_defect(label)) << printable(label);
    Design design(Parameters{.v = 2, .k = 2}, std::vector<Block>{{0, 1}});
    EXPECT_REFUSAL(design.set_labels({"x", label}), BadInput, "the label '") << printable(label);
  }
  for (const std::string label : {"a", "=1", "∞", "'", "-", "漢"}) {
    EXPECT_FALSE(label_defect(label)) << label;
  }
}

TEST(Shown, QuotesAWordAndCutsItBetweenCharacters) {
  EXPECT_EQ(shown("a\nb"), "'a\\nb'");
  EXPECT_EQ(shown(std::string(40, 'x')), "'" + std::string(40, 'x') + "'");
  EXPECT_EQ(shown(std::string(41, 'x')), "'" + std::string(40, 'x') + "…'");
  EXPECT_EQ(shown(std::string(39, 'x') + "∞"), "'" + std::string(39, 'x') + "…'");
}

TEST(FirstDefect, SaysWhereATextIsNoPlainText) {
  EXPECT_FALSE(first_defect("a ∞", false));
  EXPECT_FALSE(first_defect("a\tb", true));
  const auto at = [](std::string_view text) { return first_defect(text, false).value().offset; };
  EXPECT_EQ(at("a\tb"), 1U);
  EXPECT_EQ(at("∞\r"), 3U);
  EXPECT_EQ(at("ab\xff"), 2U);
  EXPECT_EQ(at("\u2028"), 0U);
  EXPECT_EQ(first_defect("\x1b", false).value().what, control_byte_defect('\x1b'));
  EXPECT_EQ(first_defect("\u202e", false).value().what,
            "U+202E, which reverses the direction of writing; remove it");
}

TEST(Visible, IsANameAsItLooks) {
  EXPECT_EQ(visible("a\u200bb"), "ab");
  EXPECT_EQ(visible("\u00a0a\u2003b "), "a b");
  EXPECT_EQ(visible("\u200b"), "");
}

}  // namespace
}  // namespace changeover::printable_test
