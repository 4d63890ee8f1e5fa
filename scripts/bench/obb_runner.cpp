/// A runner of the Open Boolean Benchmark: obb-runner --request FILE --result FILE [--threads N].
/// The contract is docs/Runner IO Contract.md, version 1, of
/// https://github.com/solidean/boolean-benchmark-runners.
///
/// The benchmark's raw format, in which the library computes, is Mesh (indexed triangles in
/// doubles), which boolean() takes and returns. Therefore io_ms is reading and parsing, and
/// import_ms and export_ms are 0. operation_ms is boolean() with its defaults: coordinates are
/// rounded to doubles, and flat regions at cuts are merged. Operations may have any number of
/// operands.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "transformesh/boolean.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace {

using namespace transformesh;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

/// The contract requires partial results every 10 s, since a watchdog may kill the process.
constexpr std::chrono::seconds flush_interval{10};

struct Unsupported : std::runtime_error {
  using runtime_error::runtime_error;
};

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

BooleanOperation operation_of(const std::string& name) {
  if (name == "boolean-union") return BooleanOperation::unite;
  if (name == "boolean-intersection") return BooleanOperation::intersect;
  if (name == "boolean-difference") return BooleanOperation::subtract;
  throw Unsupported("unknown operation " + name);
}

Mesh load(const Json& operation, Json& result) {
  const auto start = Clock::now();
  Mesh mesh = read_mesh_file(operation.at("path").get<std::string>());
  result["io_ms"] = ms_since(start);
  result["import_ms"] = 0.0;
  return mesh;
}

Mesh combine(const Json& operation, const std::vector<Mesh>& slots, Json& result) {
  const BooleanOperation kind = operation_of(operation.at("op").get<std::string>());
  std::vector<Operand> operands;
  for (const std::size_t slot : operation.at("args").get<std::vector<std::size_t>>())
    operands.push_back({&slots.at(slot), "slot " + std::to_string(slot)});
  if (operands.empty()) throw Unsupported("an operation needs an argument");
  const auto start = Clock::now();
  Mesh mesh = boolean(kind, operands).mesh;
  result["operation_ms"] = ms_since(start);
  result["export_ms"] = 0.0;
  return mesh;
}

/// A slot is the result of the operation with the same index. Returns for each operation the slots
/// that no later operation uses, so that their meshes can be freed after it.
std::vector<std::vector<std::size_t>> last_uses(const Json& operations) {
  std::vector<std::size_t> last(operations.size());
  for (std::size_t i = 0; i < operations.size(); ++i) {
    last[i] = i;
    for (const std::size_t slot : operations[i].value("args", std::vector<std::size_t>()))
      if (slot < i) last[slot] = i;
  }
  std::vector<std::vector<std::size_t>> dead(operations.size());
  for (std::size_t slot = 0; slot < last.size(); ++slot) dead[last[slot]].push_back(slot);
  return dead;
}

/// Runs one operation, and writes its mesh.
Json run_operation(const Json& operation, const std::string& file, std::vector<Mesh>& slots) {
  Json result{{"status", "success"}};
  const auto start = Clock::now();
  try {
    const bool loads = operation.at("op") == "load-mesh";
    slots.push_back(loads ? load(operation, result) : combine(operation, slots, result));
    if (!file.empty()) {
      write_mesh_file(file, slots.back());
      result["file"] = file;
    }
  } catch (const Unsupported& error) {
    result.update({{"status", "unsupported"}, {"error", error.what()}});
  } catch (const InputError& error) {
    result.update({{"status", "invalid_input"}, {"error", error.what()}});
  } catch (const std::exception& error) {
    result.update({{"status", "crash"}, {"error", error.what()}});
  }
  result["debug_total_ms"] = ms_since(start);
  return result;
}

/// Runs the operations of a case until one fails.
Json run_case(const Json& request) {
  const auto start = Clock::now();
  Json result{{"case_id", request.at("case_id")}, {"status", "success"}, {"ops", Json::array()}};
  const std::string format = request.value("out_format", "obj");
  const std::string folder = request.value("out_dir", "");
  const Json& operations = request.at("operations");
  const std::vector<std::vector<std::size_t>> dead = last_uses(operations);
  std::vector<Mesh> slots;
  for (std::size_t i = 0; i < operations.size() && result["status"] == "success"; ++i) {
    const std::string file = folder.empty() ? "" : folder + "/op_" + std::to_string(i) + ".obj";
    Json done = format == "obj" ? run_operation(operations[i], file, slots)
                                : Json{{"status", "unsupported"},
                                       {"error", "meshes are written as obj, not " + format}};
    result["status"] = done["status"];
    result["ops"].push_back(std::move(done));
    for (const std::size_t slot : dead[i])
      if (slot < slots.size()) slots[slot] = {};
  }
  result["duration_ms"] = ms_since(start);
  return result;
}

/// Writes the result atomically.
void write_result(const std::string& path, const Json& result) {
  std::ofstream(path + ".tmp") << result.dump(1) << '\n';
  std::filesystem::rename(path + ".tmp", path);
}

int run(const std::string& request_path, const std::string& result_path) {
  const Json request = Json::parse(std::ifstream(request_path));
  Json result{{"kind", request.at("kind")},
              {"version", request.at("version")},
              {"id", request.at("id")},
              {"runs", Json::array()}};
  bool is_good = true;
  auto flushed = Clock::now();
  for (const Json& one : request.at("runs")) {
    result["runs"].push_back(run_case(one));
    is_good &= result["runs"].back()["status"] == "success";
    if (Clock::now() - flushed < flush_interval) continue;
    write_result(result_path, result);
    flushed = Clock::now();
  }
  write_result(result_path, result);
  return is_good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  std::string request, result;
  int threads = 0;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--request") request = argv[i + 1];
    if (option == "--result") result = argv[i + 1];
    if (option == "--threads") threads = std::atoi(argv[i + 1]);
  }
  if (request.empty() || result.empty()) {
    std::cerr << "usage: obb-runner --request FILE --result FILE [--threads N]\n";
    return 2;
  }
  const ThreadLimit limit(threads);
  try {
    return run(request, result);
  } catch (const std::exception& error) {
    std::cerr << "obb-runner: " << error.what() << '\n';
    return 1;
  }
}
