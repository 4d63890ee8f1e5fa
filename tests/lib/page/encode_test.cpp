#include "page/encode.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include <cstdint>

using namespace transformesh;

TEST_CASE("zlib inflates what was deflated") {
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(std::int64_t{i} * i / 97);
  for (const std::string& text : {std::string(), std::string("a"), bytes}) {
    const std::string packed = deflated(text);
    std::string back(text.size() + 1, '\0');
    uLongf size = back.size();
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(back.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK);
    CHECK(back.substr(0, size) == text);
  }
}

TEST_CASE("nothing of HTML is left in an escaped text") {
  CHECK(html_escaped("a<b>&\"'c") == "a&lt;b&gt;&amp;&quot;&#39;c");
}
