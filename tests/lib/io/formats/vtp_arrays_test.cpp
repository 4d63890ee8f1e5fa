#include "io/formats/vtp_arrays.h"

#include "lib/io/bytes.h"
#include "lib/io/gltf_text.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

/// Returns the array that an XML element contains.
VtkArray array_of(const std::string& element, const VtpEncoding& encoding = {}) {
  pugi::xml_document document;
  REQUIRE(document.load_string(element.c_str()));
  const Source source{element, "input"};
  ExpansionBudget budget(source);
  return VtpArrays(source, encoding, budget).read(document.document_element());
}

std::string inline_array(const std::string& type, const std::string& bytes) {
  return "<DataArray type=\"" + type + "\" Name=\"a\" format=\"binary\">" + base64_by_bits(bytes) +
         "</DataArray>";
}

}  // namespace

TEST_CASE("vtp arrays: types of numbers, and headers of 32 and 64 bits") {
  CHECK(array_of(inline_array("Int16", Bytes().u32(4).u16(0xffff).u16(7).str())).values ==
        std::vector<double>{-1, 7});
  const std::string wide = Bytes().u32(8).u32(0).f64(0.1).str();
  CHECK(array_of(inline_array("Float64", wide), {.has_wide_headers = true}).values ==
        std::vector<double>{0.1});
  const std::string big = Bytes(true).u32(4).u32(258).str();
  CHECK(array_of(inline_array("UInt32", big), {.is_big_endian = true}).values ==
        std::vector<double>{258});
  const VtkArray text = array_of(
      "<DataArray type=\"UInt8\" Name=\"t\" NumberOfComponents=\"2\" format=\"ascii\">\n1 "
      "2\n</DataArray>");
  CHECK(text.components == 2);
  CHECK(text.type == Scalar::uint8);
}

TEST_CASE("vtp arrays: data that is not all there") {
  CHECK_THROWS_WITH_AS(array_of(inline_array("UInt8", Bytes().u32(3).u16(0).str())),
                       doctest::Contains("announces 3 bytes, but there are 2"), InputError);
  CHECK_THROWS_WITH_AS(array_of(inline_array("UInt8", Bytes().u16(3).str())),
                       doctest::Contains("is cut off in its header"), InputError);
  CHECK_THROWS_WITH_AS(array_of(inline_array("Int32", Bytes().u32(3).u8(1).u8(2).u8(3).str())),
                       doctest::Contains("ends within a number"), InputError);
  CHECK_THROWS_WITH_AS(
      array_of("<DataArray type=\"Int8\" Name=\"a\" format=\"appended\" offset=\"9\"/>"),
      doctest::Contains("starts beyond the appended data"), InputError);
  // A header that announces as many blocks as 32 bits can count.
  CHECK_THROWS_WITH_AS(
      array_of(inline_array("UInt8", Bytes().u32(0xffffffff).str()), {.is_compressed = true}),
      doctest::Contains("announces more than there are bytes"), InputError);
}
