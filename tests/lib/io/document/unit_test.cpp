#include "io/document/unit.h"

#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("units: the comment, and the convention of STL") {
  Document document;
  CHECK(unit_of(document) == nullptr);
  document.style.format = Format::stl_binary;  // the output format
  CHECK(unit_of(document) == nullptr);
  document.style.is_from_stl = true;
  document.style.format = Format::ply_little;
  CHECK(unit_of(document) == find_unit("mm"));
  set_unit(document, *find_unit("in"));
  set_unit(document, *find_unit("foot"));
  CHECK(document.style.comments == std::vector<std::string>{"tm:unit foot"});
  CHECK(unit_of(document)->millimeters == doctest::Approx(12 * 25.4));
  CHECK(find_unit("parsec") == nullptr);
}
