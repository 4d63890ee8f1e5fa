#include "io/streams/zip_archive.h"

#include "lib/io/stored_zip.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

std::optional<std::string> read(const std::string& archive, const std::string& name) {
  const Source source{archive, "input"};
  ExpansionBudget budget(source);
  return ZipReader(source, budget).read(name);
}

}  // namespace

TEST_CASE("zip: files by name, in upper and lower case") {
  const std::string archive = stored_zip({{"a/B.txt", "first"}, {"empty", ""}});
  CHECK(is_zip(archive));
  CHECK(read(archive, "a/B.txt") == "first");
  CHECK(read(archive, "A/b.TXT") == "first");
  CHECK(read(archive, "empty") == "");
  CHECK_FALSE(read(archive, "other").has_value());
}

TEST_CASE("zip: what is written is read, and is the same bytes each time") {
  const std::string text(300000, 'x');
  const auto write = [&] {
    ZipWriter writer;
    writer.add("long.txt", text);
    writer.add("short.txt", "y");
    return writer.finish();
  };
  const std::string archive = write();
  CHECK(archive.size() < 2000);
  CHECK(read(archive, "long.txt") == text);
  CHECK(read(archive, "short.txt") == "y");
  CHECK(write() == archive);
}

TEST_CASE("zip: damages, encryption and bombs") {
  const std::string archive = stored_zip({{"name", "content"}});
  CHECK_THROWS_WITH_AS(read(archive.substr(0, archive.size() / 2), "name"),
                       doctest::Contains("no list of its files"), InputError);
  std::string damaged = archive;
  damaged[archive.find("content")] = 'C';
  CHECK_THROWS_WITH_AS(read(damaged, "name"), "'name' in the archive is damaged (input)",
                       InputError);
  std::string encrypted = archive;
  encrypted[archive.find("PK\1\2") + 8] = 1;
  CHECK_THROWS_WITH_AS(read(encrypted, "name"), doctest::Contains("is encrypted"), InputError);
  ZipWriter bomb;
  bomb.add("name", std::string(std::size_t{80} << 20U, ' '));
  CHECK_THROWS_WITH_AS(read(bomb.finish(), "name"), doctest::Contains("more than 64 MB"),
                       InputError);
}
