#include "io/formats/text_rows.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "transformesh/errors.h"

using namespace transformesh;

namespace {

constexpr TextRows::Rules plain{};
constexpr TextRows::Rules with_comments{'#', false};
constexpr TextRows::Rules joining{'#', true};

/// The words of all rows, joined by commas, and rows by semicolons.
std::string words(const std::string& text, TextRows::Rules rules) {
  const Source source{text, "a"};
  TextRows rows(source, 0, rules);
  std::string result;
  while (rows.next_row()) {
    while (rows.has_more()) result += std::string(rows.word()) + ",";
    result += ";";
  }
  return result;
}

template <class Read>
std::string refusal(const std::string& text, const Read& read) {
  const Source source{text, "file"};
  TextRows rows(source, 0, plain);
  try {
    rows.next_row();
    read(rows);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const auto what = [] { return std::string("x of vertex 3"); };

}  // namespace

TEST_CASE("rows end as lines of Unix, DOS and old Macintoshes do, and blank ones are left out") {
  const std::string expected = "a,b,;c,;";
  CHECK(words("a b\nc\n", plain) == expected);
  CHECK(words("a b\r\nc\r\n", plain) == expected);
  CHECK(words("a b\rc\r", plain) == expected);
  CHECK(words("\n \t\n  a\tb \n\n\nc", plain) == expected);
  CHECK(words("", plain).empty());
  CHECK(words("\n\n", plain).empty());
}

TEST_CASE("comments are kept where they are whole lines, and counted behind data") {
  const std::string text = "# first\n1 2 # behind\n#second \n  # third\n3#4\n#\n";
  const Source source{text, "a"};
  TextRows rows(source, 0, with_comments);
  REQUIRE(rows.next_row());
  CHECK(rows.words_left() == 2);
  REQUIRE(rows.next_row());
  CHECK(rows.word() == "3");
  CHECK_FALSE(rows.has_more());
  CHECK_FALSE(rows.next_row());
  CHECK(rows.comments == std::vector<std::string>{"first", "second ", "third", ""});
  CHECK(rows.trailing_comments == 2);
}

TEST_CASE("a backslash joins lines where the format says so, but not inside a comment") {
  CHECK(words("f 1 2 \\\n3\nv 4\n", joining) == "f,1,2,3,;v,4,;");
  CHECK(words("f 1 2 \\\n3\nv 4\n", with_comments) == "f,1,2,\\,;3,;v,4,;");
  CHECK(words("f 1 # \\\n3\n", joining) == "f,1,;3,;");
}

TEST_CASE("words are peeked, read, counted and skipped, without blanks around them") {
  const std::string text = "name  of a  mesh \nnext\n";
  const Source source{text, "a"};
  TextRows rows(source, 0, plain);
  REQUIRE(rows.next_row());
  CHECK(rows.peek() == "name");
  CHECK(rows.words_left() == 4);
  CHECK(rows.word() == "name");
  CHECK(rows.last_word() == "name");
  CHECK(rows.words_left() == 3);
  CHECK(rows.skip_row() == "of a  mesh");
  CHECK(rows.word().empty());
  REQUIRE(rows.next_row());
  CHECK(rows.peek() == "next");
}

TEST_CASE("numbers are read whole, and what is none is named with its line") {
  const std::string text = "1 -2.5e1 +3\n";
  const Source source{text, "a"};
  TextRows rows(source, 0, plain);
  REQUIRE(rows.next_row());
  CHECK(rows.number<std::uint32_t>(what) == 1);
  CHECK(rows.number<double>(what) == -25);
  CHECK(rows.number<int>(what) == 3);
  CHECK_NOTHROW(rows.end_row([] { return std::string("row"); }));

  const auto number = [](TextRows& r) { r.number<double>(what); };
  const auto index = [](TextRows& r) { r.number<std::uint32_t>(what); };
  const auto finite = [](TextRows& r) { r.finite_number<double>(what); };
  const auto end = [](TextRows& r) { r.end_row([] { return std::string("vertex 3"); }); };
  CHECK(refusal("\n\n1,5", number).find("x of vertex 3 is not a number: '1,5'") == 0);
  CHECK(refusal("\n\n1,5", number).find("line 3") != std::string::npos);
  CHECK(refusal("-1", index).find("is not a whole number of 0 or more: '-1'") != std::string::npos);
  CHECK(refusal("5000000000", index).find("is out of range: '5000000000'") != std::string::npos);
  CHECK(refusal("nan", finite).find("is not a finite number: 'nan'") != std::string::npos);
  CHECK(refusal("7 8", end).find("vertex 3 has more values than it should, beginning with '7'") ==
        0);
}
