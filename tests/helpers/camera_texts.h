/// Checks error messages for camera files, for tests of their formats.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "transformesh/errors.h"
#include "views/cameras/camera_file.h"

namespace transformesh::test {

/// Returns the error message for a text; empty if the text is accepted.
inline std::string refusal(const std::string& text) {
  try {
    parse_cameras(text, "some.txt");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Checks that the error message contains `what` and ends with the line number.
inline bool is_refused(const std::string& text, const std::string& what, int line) {
  const std::string message = refusal(text);
  INFO(message);
  const std::string place = "(some.txt line " + std::to_string(line) + ")";
  CHECK(message.ends_with(place));
  CHECK(message.find(what) != std::string::npos);
  return message.ends_with(place) && message.find(what) != std::string::npos;
}

}  // namespace transformesh::test
