// Tests that foreign names cannot control a terminal.
#include "support/plain_text.hpp"
#include "tests/support/test.hpp"

namespace printable_test {

using fixproof::support::printable;

TEST(Printable, TextStaysAsItIs) {
  EXPECT_EQ(fixproof::support::printable(""), "");
  EXPECT_EQ(fixproof::support::printable("twelve cubes"), "twelve cubes");
  EXPECT_EQ(fixproof::support::printable(
                "zw\xc3\xb6lf W\xc3\xbcrfel \xe2\x80\x9e\xe2\x88\x92\xe2\x80\x9c"),
            "zw\xc3\xb6lf W\xc3\xbcrfel \xe2\x80\x9e\xe2\x88\x92\xe2\x80\x9c");
}

TEST(Printable, WhatSteersATerminalIsAQuestionMark) {
  EXPECT_EQ(fixproof::support::printable("a\x1b[31mb\n\x7f"), "a?[31mb??");
  EXPECT_EQ(fixproof::support::printable("a\xc2\x9b"
                                         "31m"),
            "a?31m");                                               // CSI as a single character
  EXPECT_EQ(fixproof::support::printable("\xc2\xa0"), "\xc2\xa0");  // the first character after C1
}

TEST(Printable, WritingIsNotTurnedRound) {
  EXPECT_EQ(fixproof::support::printable("a\xe2\x80\xae"
                                         "b"),
            "a?b");
  EXPECT_EQ(
      fixproof::support::printable("\xe2\x80\x8e\xe2\x80\x8f\xe2\x80\xaa\xe2\x81\xa6\xe2\x81\xa9"),
      "?????");
  EXPECT_EQ(fixproof::support::printable("\xe2\x80"), "\xe2\x80");  // truncated
}

TEST(Printable, InAsciiOneQuestionMarkStandsForEachOtherByte) {
  EXPECT_EQ(fixproof::support::printable_ascii(" a~\x7f\n\xc3\xb6\xff"), " a~?????");
}

}  // namespace printable_test
