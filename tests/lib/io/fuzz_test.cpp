// Valid files, damaged at random with a fixed seed. Reading succeeds or throws InputError, and a
// mesh that is read can be written and read again. The asan preset also finds reads out of bounds.
// TM_FUZZ_ROUNDS raises the number of rounds.
#include <cstdlib>
#include <random>

#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

std::vector<std::string> valid_files() {
  Document document;
  document.mesh = tetrahedron();
  document.mesh.vertex_columns.get("red", Scalar::uint8, 4).values = {1, 2, 3, 4};
  document.mesh.vertex_columns.get("green", Scalar::uint8, 4);
  document.mesh.vertex_columns.get("blue", Scalar::uint8, 4);
  document.mesh.face_columns.get("label", Scalar::int16, 4).values = {-1, 2, -3, 4};
  Column& list = document.mesh.face_columns.get("uv", Scalar::float32, 0);
  list.list_count_type = Scalar::uint16;
  list.values = {1, 2, 3};
  list.list_offsets = {0, 1, 1, 3, 3};
  document.other_elements.push_back({"edge", 2, {}});
  document.other_elements[0].columns.get("vertex1", Scalar::uint32, 2).values = {1, 4294967295.0};
  document.style.comments = {"a comment"};
  std::vector<std::string> files;
  for (const Format format : {Format::ply_ascii, Format::ply_little, Format::ply_big, Format::off,
                              Format::obj, Format::stl_ascii, Format::stl_binary}) {
    document.style.format = format;
    files.push_back(write_mesh(document).bytes);
  }
  document.mesh.face_columns.columns.clear();
  document.style.format = Format::ply_little;
  files.push_back(write_mesh(document).bytes);  // the fast path
  return files;
}

std::string damaged(std::string file, std::mt19937& random) {
  const std::vector<std::string> words{
      "-1",   "0",    "4294967295", "18446744073709551615", "1e999", "nan", "\n", " ", "\\\n", "#",
      "list", "\r\n", "\0",         "9999999999",           "/"};
  const std::size_t changes = 1 + random() % 4;
  for (std::size_t i = 0; i < changes && !file.empty(); ++i) {
    const std::size_t place = random() % file.size();
    const std::size_t length = std::min<std::size_t>(1 + random() % 8, file.size() - place);
    switch (random() % 6) {
      case 0:
        file[place] = static_cast<char>(random() % 256);
        break;
      case 1:
        file[place] = static_cast<char>(file[place] ^ (1 << random() % 8));
        break;
      case 2:
        file.resize(place);
        break;
      case 3:
        file.erase(place, length);
        break;
      case 4:
        file.replace(place, length, words[random() % words.size()]);
        break;
      default:
        file.insert(place, file.substr(random() % file.size(), 1 + random() % 30));
    }
  }
  return file;
}

/// Returns whether the bytes are refused with InputError, or read, written and read again with
/// equal result.
bool is_handled(const std::string& bytes, const std::string& name) {
  Document document;
  try {
    document = read_mesh(bytes, name).document;
  } catch (const InputError&) {
    return true;
  }
  for (const Format format :
       {document.style.format, Format::off, Format::obj, Format::stl_binary}) {
    document.style.format = format;
    std::string written;
    try {
      written = write_mesh(document).bytes;
    } catch (const GoalError&) {
      continue;  // too large for float
    }
    if (read_document(written).mesh.faces.size() != document.mesh.faces.size()) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("io fuzz: damaged files are refused or read, never more") {
  const char* rounds_text = std::getenv("TM_FUZZ_ROUNDS");
  const long rounds = rounds_text ? std::atol(rounds_text) : 300;
  const std::vector<std::string> files = valid_files();
  const std::vector<std::string> names{"input", "a.ply", "a.off", "a.obj", "a.stl"};
  std::mt19937 random(20110301);
  for (long round = 0; round < rounds; ++round) {
    for (const std::string& file : files) {
      const std::string bytes = damaged(file, random);
      const std::string name = names[random() % names.size()];
      INFO("round " << round << ", name " << name);
      REQUIRE(is_handled(bytes, name));
    }
  }
}

TEST_CASE("io fuzz: every beginning of a valid file is handled") {
  for (const std::string& file : valid_files()) {
    for (std::size_t size = 0; size < file.size(); ++size) {
      CHECK(is_handled(file.substr(0, size), "input"));
    }
  }
}
