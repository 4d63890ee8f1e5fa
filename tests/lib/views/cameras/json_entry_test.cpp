#include "views/cameras/json_entry.h"

#include <doctest/doctest.h>

#include <functional>

#include "transformesh/errors.h"

using namespace transformesh;

namespace {

std::string refusal(const std::string& text, const std::function<void(const JsonEntry&)>& use) {
  const Source source{text, "a.json"};
  try {
    const nlohmann::json json = parse_camera_json(source);
    use(JsonEntry(json, source));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void ignore(const JsonEntry& /*entry*/) {}

}  // namespace

TEST_CASE("entries of JSON: numbers may be text, and every mistake names its path") {
  const std::string text = R"({"a":[{"b":"2.5"},{"b":[1,2]}],"n":3,"t":true,"e":""})";
  const std::string message = refusal(text, [](const JsonEntry& file) {
    CHECK(file.at("a").at(std::size_t{0}).at("b").number() == 2.5);
    CHECK(file.at("a").at(1).at("b").numbers(2) == std::vector<double>{1, 2});
    CHECK(file.at("n").text() == "3");
    CHECK(file.at("n").side() == 3);
    CHECK(file.at("t").is_true());
    CHECK_FALSE(file.at("n").is_true());
    CHECK(file.at("e").elements().empty());
    CHECK(file.number("missing", 7) == 7);
    file.at("a").at(1).at("b").number();
  });
  CHECK(message == "a[1].b is not a finite number (a.json)");
  CHECK(refusal(text, [](const JsonEntry& file) { file.at("x"); }) == "the file has no x (a.json)");
  CHECK(refusal(text, [](const JsonEntry& file) { file.at("n").at("x"); }) ==
        "n is not an object (a.json)");
  CHECK(refusal(text, [](const JsonEntry& file) { file.at("a").at(2); }) ==
        "a has no element 2 (a.json)");
  CHECK(refusal(text, [](const JsonEntry& file) { file.at("n").elements(); }) ==
        "n is not a list (a.json)");
  CHECK(refusal(text, [](const JsonEntry& file) { file.at("a").numbers(3); }) ==
        "a has 2 elements instead of 3 (a.json)");
  CHECK(refusal(text, [](const JsonEntry& file) { file.at("t").text(); }) ==
        "t is not a string (a.json)");
  CHECK(refusal(R"({"w":1.5})", [](const JsonEntry& file) { file.at("w").side(); }) ==
        "w is not a whole number of 1 or more (a.json)");
}

TEST_CASE("JSON: what is malformed is refused with its byte, and points are skipped") {
  CHECK(refusal("{\"a\":}", ignore) == "the JSON is malformed (a.json byte 5)");
  CHECK(refusal("{\"a\":1", ignore).find("ends too early") != std::string::npos);
  CHECK(refusal("[1]", ignore) == "the JSON is not an object (a.json)");
  CHECK(refusal(std::string(1000000, '['), ignore).find("a.json") != std::string::npos);
  refusal(R"({"structure":[1,2],"views":{"structure":1}})", [](const JsonEntry& file) {
    CHECK_FALSE(file.has("structure"));
    CHECK(file.at("views").has("structure"));
  });
}
