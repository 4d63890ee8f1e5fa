#include "io/formats/xml_elements.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"

using namespace transformesh;

namespace {

Source source_of(const std::string& text) { return {text, "cameras.xml"}; }

}  // namespace

TEST_CASE("elements are found at any depth, in the order of the file") {
  const std::string text = "<a><n>1</n><b><n>2</n><c/></b><!-- <n>3</n> --><n x='4 5'/></a>";
  const pugi::xml_document document = parse_xml(source_of(text));
  const auto elements = xml_elements(document, "n");
  REQUIRE(elements.size() == 3);
  CHECK(std::string(elements[1].child_value()) == "2");
  CHECK(xml_attribute(elements[2], "x") == "4 5");
  CHECK(!xml_attribute(elements[2], "y"));
  CHECK(xml_elements(xml_element(document, "b"), "n").size() == 1);
  CHECK(!xml_element(document, "none"));
}

TEST_CASE("numbers are finite and separated by blanks") {
  const Source source = source_of("");
  CHECK(xml_numbers(" 1 \n-2.5e3\t", "n", source) == std::vector<double>{1, -2500});
  CHECK(xml_numbers("", "n", source).empty());
  for (const char* text : {"1,2", "inf", "nan", "x", "1e999"})
    CHECK_THROWS_AS(xml_numbers(text, "n", source), InputError);
}

TEST_CASE("a file that is not well-formed is refused with its line") {
  try {
    parse_xml(source_of("<a>\n<b>\n</a>"));
    FAIL("an element is left open");
  } catch (const InputError& error) {
    CHECK(error.problem().sentence.find("(cameras.xml line 3)") != std::string::npos);
  }
  for (const char* text : {"", "<", "<a", "<a>", "text", "<a b=>", "<!--"})
    CHECK_THROWS_AS(parse_xml(source_of(text)), InputError);
}

TEST_CASE("entities of the file are not expanded, and depth is no danger") {
  const std::string bomb = "<!DOCTYPE a [<!ENTITY b \"&c;&c;\"><!ENTITY c \"xxxx\">]><a>&b;</a>";
  CHECK(std::string(xml_element(parse_xml(source_of(bomb)), "a").child_value()) == "&b;");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  for (int i = 0; i < 100000; ++i) deep += "</a>";
  CHECK(xml_elements(parse_xml(source_of(deep)), "a").size() == 100000);
}
