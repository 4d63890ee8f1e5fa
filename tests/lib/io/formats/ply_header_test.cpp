#include "lib/io/bytes.h"
#include "lib/io/ply_text.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("ply: headers of DOS and of old Macintoshes") {
  std::string dos = ascii_triangle("3 0 1 2");
  std::string mac;
  for (std::size_t i = 0; (i = dos.find('\n', i)) != std::string::npos; i += 2) {
    dos.replace(i, 1, "\r\n");
  }
  for (const char c : dos) {
    if (c != '\n') mac += c;
  }
  for (const std::string& text : {dos, mac}) {
    CHECK(read_document(text).mesh.positions[1] == Vec3(1, 0, 0));
    CHECK(read_document(text).mesh.faces == std::vector<Face>{{0, 1, 2}});
  }
  const Bytes binary = Bytes()
                           .text(
                               "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 1\r\n"
                               "property float x\r\nproperty float y\r\nproperty float z\r\n"
                               "end_header\r\n")
                           .f32(1)
                           .f32(2)
                           .f32(3);
  CHECK(read_document(binary.str()).mesh.positions == std::vector<Vec3>{{1, 2, 3}});
}

TEST_CASE("ply: blanks behind every line of the header") {
  std::string text = ascii_triangle("3 0 1 2");
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos; i += 4) {
    text.replace(i, 1, " \t \n");
  }
  CHECK(read_document(text).mesh.positions[1] == Vec3(1, 0, 0));
  CHECK(read_document(text).mesh.faces == std::vector<Face>{{0, 1, 2}});
}

TEST_CASE("ply: malformed headers are refused with their line") {
  const auto error_of = [](const std::string& lines) { return read_error("ply\n" + lines); };
  CHECK(error_of("format ascii 1.0\nelement vertex 3\n") ==
        "the PLY header has no line 'end_header' (input line 4)");
  CHECK(error_of("element vertex 0\nend_header\n") ==
        "the PLY header has no line 'format ascii 1.0' (or binary_little_endian, "
        "binary_big_endian) (input line 3)");
  CHECK(error_of("format binary 1.0\nend_header\n") ==
        "PLY is ascii, binary_little_endian or binary_big_endian, not 'binary' (input line 2)");
  CHECK(error_of("format ascii 2.0\nend_header\n") ==
        "only PLY version 1.0 is supported, not '2.0' (input line 2)");
  CHECK(error_of("format ascii 1.0\nelement vertex -1\nend_header\n") ==
        "'element NAME COUNT' needs a name and a count of 0 or more, not 'element vertex -1' "
        "(input line 3)");
  CHECK(contains(error_of("format ascii 1.0\nelement vertex 99999999999999999999\nend_header\n"),
                 "a count of 0 or more"));
  CHECK(error_of("format ascii 1.0\nproperty float x\nend_header\n") ==
        "there is a property before the first element (input line 3)");
  CHECK(contains(error_of("format ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n"),
                 "unknown type 'half'"));
  CHECK(contains(error_of("format ascii 1.0\nelement face 1\nproperty list float int "
                          "vertex_indices\nend_header\n"),
                 "the count of a list must have an integer type"));
  CHECK(contains(error_of("format ascii 1.0\nelement a 1\nelement a 1\nend_header\n"),
                 "the element 'a' is listed twice"));
  // An unknown line after an element may describe data, so it is not taken for a comment.
  CHECK(contains(error_of("format ascii 1.0\nelement vertex 1\nproprety float x\nend_header\n"),
                 "unknown word in the PLY header: 'proprety'"));
}

TEST_CASE("ply: types in upper case, and comments without their keyword") {
  const std::string text =
      "ply\nformat ascii 1.0\nCreated by a program, source file: \nelement vertex 1\n"
      "property FLOAT x\nproperty Double y\nproperty float z\nelement face 0\n"
      "property list UCHAR INT vertex_indices\nend_header\n1 2 3\n";
  const ReadResult result = read_mesh(text, "input");
  CHECK(result.document.mesh.positions == std::vector<Vec3>{{1, 2, 3}});
  CHECK(result.document.style.comments ==
        std::vector<std::string>{"Created by a program, source file: "});
  CHECK(has_note(result.notes, "ply: 1 line of the header without a keyword taken as a comment"));
  CHECK(contains(strict_error(text), "unknown word in the PLY header: 'Created'"));
  CHECK(contains(strict_error("ply\nformat ascii 1.0\nelement vertex 1\nproperty FLOAT x\n"),
                 "unknown type 'FLOAT'"));
}

TEST_CASE("ply: headers without a mesh are refused") {
  CHECK(read_error(header("ascii", "element face 0\n")) ==
        "the PLY header has no element 'vertex' (input)");
  CHECK(read_error(header("ascii", "element vertex 1\nproperty float x\n") + "1\n") ==
        "the vertices need the properties x, y and z (input)");
  CHECK(read_error(header("ascii", "element vertex 1\n" + vertex_header + "property float x\n") +
                   "1 2 3 4\n") == "vertex property 'x' is listed twice (input)");
  CHECK(read_error(header("ascii", "element vertex 0\n" + vertex_header +
                                       "element face 1\nproperty int label\n") +
                   "1\n") == "the faces need a property list vertex_indices (input)");
  CHECK(read_error(header("ascii", "element vertex 0\n" + vertex_header +
                                       "element face 1\nproperty list uchar float vertex_index\n") +
                   "0\n") == "face property 'vertex_index' must be a list of integers (input)");
  CHECK(contains(read_error(header("ascii", "element vertex 0\n" + vertex_header +
                                                "element tristrips 1\nproperty int length\n") +
                            "1\n"),
                 "the triangle strips need a property list vertex_indices of integers"));
}

TEST_CASE("ply: counts beyond the bytes present are refused before memory is taken") {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    for (const char* count : {"4000000000", "9223372036854775808", "18446744073709551615"}) {
      const std::string lines = std::string("element vertex ") + count + '\n' + vertex_header +
                                "element face 0\n" + face_header;
      const std::string error = read_error(header(format, lines) + "0 0 0 0 0 0 0\n");
      CHECK(contains(error, std::string("announces ") + count + " rows of element 'vertex'"));
    }
  }
  // A list that announces four thousand million entries.
  Bytes file;
  file.text(header("binary_little_endian",
                   "element vertex 1\n" + vertex_header + "property list uint uchar data\n"));
  file.f32(0).f32(0).f32(0).u32(0xffffffff).u8(1);
  CHECK(contains(read_error(file.str()),
                 "the length of property 'data' of vertex 0 is 4294967295, with only 1 byte left"));
}
