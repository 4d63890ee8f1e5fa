#include "transformesh/document.h"

#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("documents are joined: faces are renumbered, comments not repeated") {
  Document first, second;
  first.mesh = second.mesh = tetrahedron();
  first.style.comments = {"one", "tm:reference-edge 2"};
  second.style.comments = {"one", "tm:reference-edge 3", "two"};
  second.mesh.face_columns.get("label", Scalar::uint8, 4).values = {1, 2, 3, 4};
  CHECK(append(first, second).empty());
  CHECK(first.mesh.faces[4] == Face{4, 6, 5});
  CHECK(column(first.mesh.face_columns, "label").values ==
        std::vector<double>{0, 0, 0, 0, 1, 2, 3, 4});
  CHECK(first.style.comments == std::vector<std::string>{"one", "tm:reference-edge 2", "two"});
}

TEST_CASE("joined documents keep the unit of the first, and a difference is said") {
  Document first, second;
  first.style.comments = {"tm:unit millimeter"};
  second.style.comments = {"tm:unit meter"};
  CHECK(append(first, second) ==
        std::vector<std::string>{
            "the units differ, millimeter and meter: numbers are joined as they are"});
  CHECK(first.style.comments == std::vector<std::string>{"tm:unit millimeter"});
  CHECK(append(second, Document()).empty());
}
