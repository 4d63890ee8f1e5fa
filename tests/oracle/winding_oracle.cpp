// Judges the output of tm-clean by winding numbers at sample points.
//   winding_oracle INPUT OUTPUT [--level K] [--samples N] [--seed S] [--tolerance T]
// Prints `tested N wrong N undecided N`. Exit 0: right; 1: wrong, or more than a tenth of the
// samples undecided; 2: usage; 3: a file cannot be read.
#include "helpers/winding_oracle.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

#include "io/mesh_io.h"
#include "support/error.h"

using namespace transformesh;

namespace {

Document read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("cannot open " + path);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return read_mesh(bytes, path).document;
}

/// How far rounding may move a coordinate, as a share of the largest.
double tolerance_of(const Document& document) {
  return document.style.coordinate == Scalar::float32 ? 1e-6 : 1e-9;
}

int judge(int argc, char** argv) {
  if (argc < 3 || argc % 2 == 0) throw UsageError("usage: winding_oracle INPUT OUTPUT [OPTIONS]");
  const Document input = read_file(argv[1]);
  const Document output = read_file(argv[2]);
  test::WindingOracleOptions options;
  options.tolerance = tolerance_of(output);
  for (int i = 3; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    const char* value = argv[i + 1];
    if (name == "--level")
      options.winding_level = std::atoi(value);
    else if (name == "--samples")
      options.samples = std::strtoull(value, nullptr, 10);
    else if (name == "--seed")
      options.seed = std::strtoull(value, nullptr, 10);
    else if (name == "--tolerance")
      options.tolerance = std::atof(value);
    else
      throw UsageError("unknown option " + name);
  }
  const test::WindingOracleResult result = test::compare_windings(input.mesh, output.mesh, options);
  std::cout << test::describe(result) << '\n';
  return result.is_right() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return judge(argc, argv);
  } catch (const UsageError& error) {
    std::cerr << "winding_oracle: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "winding_oracle: " << error.what() << '\n';
    return 3;
  }
}
