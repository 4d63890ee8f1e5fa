#include "transformesh/errors.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "support/error_prefix.h"

using namespace transformesh;

namespace {

template <typename Kind>
void check_prefix() {
  try {
    try {
      throw Kind(ErrorKind::not_closed, "the mesh has a border",
                 {.faces = {3, 4}, .name = "a.ply"});
    } catch (const Error&) {
      rethrow_with_prefix("iteration 2: ");
    }
  } catch (const Kind& error) {
    CHECK(std::string(error.what()) == "iteration 2: the mesh has a border");
    CHECK(error.problem().sentence == error.what());
    CHECK(error.kind() == ErrorKind::not_closed);
    CHECK(error.data().faces == std::vector<std::size_t>{3, 4});
    CHECK(error.data().name == "a.ply");
    return;
  }
  FAIL("nothing is thrown");
}

}  // namespace

TEST_CASE("an error without a kind is of kind other and has no data") {
  const InputError error("the file is empty");
  CHECK(std::string(error.what()) == "the file is empty");
  CHECK(error.kind() == ErrorKind::other);
  CHECK(error.data().faces.empty());
  CHECK_FALSE(error.data().position);
}

TEST_CASE("copies of errors share their problem") {
  const GoalError error(ErrorKind::one_sided, "a strip", {.edge = {{1, 2}}});
  const GoalError copy = error;  // NOLINT(performance-unnecessary-copy-initialization)
  CHECK(&copy.problem() == &error.problem());
  static_assert(std::is_nothrow_copy_constructible_v<GoalError>);
}

TEST_CASE("class, kind and data stay when a prefix is added") {
  check_prefix<UsageError>();
  check_prefix<InputError>();
  check_prefix<GoalError>();
  check_prefix<OutputError>();
}

TEST_CASE("other exceptions get no prefix") {
  try {
    try {
      throw CancelledError("cancelled");
    } catch (const std::exception&) {
      rethrow_with_prefix("iteration 2: ");
    }
  } catch (const CancelledError& error) {
    CHECK(std::string(error.what()) == "cancelled");
    return;
  }
  FAIL("nothing is thrown");
}

TEST_CASE("kinds have different names") {
  std::set<std::string> names;
  const auto last = static_cast<int>(ErrorKind::not_a_run);
  for (int kind = 0; kind <= last; ++kind) names.insert(name_of(static_cast<ErrorKind>(kind)));
  CHECK(names.size() == static_cast<std::size_t>(last) + 1);
  CHECK(std::string(name_of(ErrorKind::other)) == "other");
  CHECK(std::string(name_of(ErrorKind::not_a_run)) == "not_a_run");
}
