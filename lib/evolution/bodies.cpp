#include "evolution/bodies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "evolution/integration.h"
#include "evolution/loop/stages.h"
#include "mesh/local_measures.h"
#include "step/limit_movements.h"
#include "support/error_prefix.h"
#include "support/number.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

std::map<double, std::vector<Index>> faces_by_number(const Mesh& mesh, const std::string& column) {
  const Column* numbers = mesh.face_columns.find(column);
  if (numbers == nullptr || numbers->list_count_type)
    throw InputError("the mesh has no face property '" + column +
                     "' with the number of the body of each face");
  std::map<double, std::vector<Index>> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    faces[numbers->values[f]].push_back(static_cast<Index>(f));
  return faces;
}

Body body_of(const Document& document, double number, const std::vector<Index>& faces) {
  Body body{{}, number, {}};
  body.document.style = document.style;
  const Mesh& whole = document.mesh;
  Mesh& mesh = body.document.mesh;
  std::vector<Index> numbers(whole.positions.size(), no_index);
  for (const Index f : faces) {
    Face face = whole.faces[f];
    for (Index& v : face) {
      if (numbers[v] == no_index) {
        numbers[v] = static_cast<Index>(body.vertices.size());
        body.vertices.push_back(v);
        mesh.positions.push_back(whole.positions[v]);
      }
      v = numbers[v];
    }
    mesh.faces.push_back(face);
  }
  mesh.vertex_columns = whole.vertex_columns.select(body.vertices);
  mesh.face_columns = whole.face_columns.select(faces);
  return body;
}

[[noreturn]] void rethrow_with_body(const Body& body) {
  rethrow_with_prefix("body " + shortest_text(body.number) + ": ");
}

/// Returns all bodies except one as a mesh without columns.
Mesh others_of(const std::vector<Body>& bodies, std::size_t left_out) {
  Mesh all;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i == left_out) continue;
    const auto first = static_cast<Index>(all.positions.size());
    const Mesh& mesh = bodies[i].document.mesh;
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const Face& face : mesh.faces)
      all.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
  }
  return all;
}

std::vector<Vec3> selected(const std::vector<Vec3>& vectors, const std::vector<Index>& rows) {
  std::vector<Vec3> result;
  result.reserve(rows.size());
  for (const Index row : rows) result.push_back(vectors[row]);
  return result;
}

void add(const IterationResult& part, IterationResult& sum) {
  const double squares = part.displaced.rms_displacement * part.displaced.rms_displacement *
                         static_cast<double>(part.vertices);
  const double before = sum.displaced.rms_displacement * sum.displaced.rms_displacement *
                        static_cast<double>(sum.vertices);
  sum.vertices += part.vertices;
  sum.faces += part.faces;
  sum.pairs += part.pairs;
  sum.was_cleaned = sum.was_cleaned || part.was_cleaned;
  sum.topology.components += part.topology.components;
  sum.topology.genus += part.topology.genus;
  sum.displaced.moved += part.displaced.moved;
  sum.displaced.held_back += part.displaced.held_back;
  sum.displaced.max_displacement =
      std::max(sum.displaced.max_displacement, part.displaced.max_displacement);
  sum.displaced.rms_displacement =
      std::sqrt((before + squares) / static_cast<double>(sum.vertices));
  sum.seconds_clean += part.seconds_clean;
  sum.seconds_remesh += part.seconds_remesh;
}

}  // namespace

std::vector<Body> split_bodies(const Document& document, const std::string& column) {
  std::vector<Body> bodies;
  for (const auto& [number, faces] : faces_by_number(document.mesh, column))
    bodies.push_back(body_of(document, number, faces));
  return bodies;
}

void join_bodies(const std::vector<Body>& bodies, const std::string& column, Document& document) {
  const Scalar type = document.mesh.face_columns.find(column)->type;
  Document joined;
  joined.style = document.style;
  for (const Body& body : bodies) {
    Document part = body.document;
    part.mesh.face_columns.get(column, type, part.mesh.faces.size())
        .values.assign(part.mesh.faces.size(), body.number);
    append(joined, part);
  }
  document.mesh = std::move(joined.mesh);
}

Topology clean_bodies(Document& document, const BodyContact& contact, bool outermost,
                      const Progress& progress) {
  std::vector<Body> bodies = split_bodies(document, contact.column);
  Topology sum;
  for (Body& body : bodies) {
    try {
      const Topology part = clean_in_place(body.document, progress, outermost).topology;
      sum.components += part.components;
      sum.genus += part.genus;
    } catch (const Error&) {
      rethrow_with_body(body);
    }
  }
  join_bodies(bodies, contact.column, document);
  return sum;
}

namespace {

/// Moves, cleans and remeshes body `i`.
BodiesResult iterate_body(std::vector<Body>& bodies, std::size_t i, std::vector<Vec3> movements,
                          double gap, IterationOptions options,
                          const std::function<bool(ErrorKind)>& may_vanish,
                          const Progress& progress) {
  Document& document = bodies[i].document;
  const Mesh others = others_of(bodies, i);
  const KeepOutOptions keep_out{others.faces.empty() ? nullptr : &others, gap};
  options.remesh.keep_out = keep_out;
  double moved_volume = 0;
  BodiesResult result;
  result.iteration.vertices = movements.size();
  result.iteration.was_cleaned = true;
  const auto move = [&](Mesh& mesh, const Progress&) {
    LimitedMovements limited;
    if (keep_out.surface != nullptr)
      limited = limit_movements(mesh, keep_out, document.style.coordinate, movements);
    result.iteration.displaced = move_vertices(mesh, movements, halfedge_lengths(mesh).mean);
    result.iteration.displaced.held_back = limited.held_back;
    moved_volume = volume(mesh);
    return result.iteration.displaced;
  };
  try {
    result.iteration = iterate(document, move, options, progress);
  } catch (const GoalError& error) {
    if (!may_vanish(error.kind())) throw;
    document.mesh = select_faces(document.mesh, std::vector<bool>(document.mesh.faces.size()));
  }
  if (!result.iteration.was_cleaned) result.remeshed = volume(document.mesh) - moved_volume;
  return result;
}

}  // namespace

BodiesResult iterate_bodies(Document& document, const std::vector<Vec3>& displacements,
                            const BodyContact& contact, const IterationOptions& options,
                            const std::function<bool(ErrorKind)>& may_vanish,
                            const Progress& progress) {
  std::vector<Body> bodies = split_bodies(document, contact.column);
  BodiesResult sum;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    try {
      const BodiesResult part = iterate_body(bodies, i, selected(displacements, bodies[i].vertices),
                                             contact.gap, options, may_vanish, progress);
      add(part.iteration, sum.iteration);
      sum.remeshed += part.remeshed;
    } catch (const Error&) {
      rethrow_with_body(bodies[i]);
    }
  }
  join_bodies(bodies, contact.column, document);
  return sum;
}

}  // namespace transformesh
