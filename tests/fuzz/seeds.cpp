// Makes the initial inputs of the targets, by the generators of the library and of tests/corpus.
//   fuzz_seeds FOLDER     writes FOLDER/TARGET/NUMBER
#include <filesystem>
#include <fstream>
#include <iostream>

#include "corpus/cases.h"
#include "corpus/hostile_shapes.h"
#include "fuzz/tiny_mesh.h"
#include "helpers/encoded_images.h"
#include "transformesh/mesh_io.h"
#include "transformesh/shapes.h"
#include "views/cameras/camera_output.h"
#include "views/cameras/camera_ring.h"

using namespace transformesh;

namespace {

class Seeds {
 public:
  explicit Seeds(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& target, const std::string& bytes) {
    const std::filesystem::path folder = folder_ / target;
    std::filesystem::create_directories(folder);
    std::ofstream file(folder / std::to_string(count_[target]++), std::ios::binary);
    file << bytes;
    if (!file) throw std::runtime_error("cannot write into " + folder.string());
  }

 private:
  std::filesystem::path folder_;
  std::map<std::string, int> count_;
};

/// Small meshes: shapes of the library, of the corpus and of the hostile families.
std::vector<Mesh> tiny_meshes() {
  std::vector<Mesh> meshes;
  const auto add = [&](Mesh mesh) {
    if (mesh.faces.size() <= fuzz::most_faces) meshes.push_back(std::move(mesh));
  };
  for (const char* kind : {"sphere", "box", "torus", "two-spheres"}) {
    ShapeOptions options;
    options.kind = kind;
    options.faces = 16;
    add(make_shape(options));
  }
  corpus::Cases cases;
  for (const auto add_cases :
       {corpus::add_coplanar_cases, corpus::add_contact_cases, corpus::add_degenerate_cases,
        corpus::add_nesting_cases, corpus::add_coordinate_cases, corpus::add_open_cases})
    add_cases(cases);
  for (const corpus::Case& shape : cases) add(shape.make());
  for (const corpus::HostileFamily& family : corpus::hostile_families())
    for (const std::uint64_t seed : {1, 2}) add(hostile_mesh(family, seed, Scalar::float64));
  return meshes;
}

/// Returns a document of the mesh with columns and comments, so that all parts of a file occur.
Document documented(const Mesh& mesh) {
  Document document;
  document.mesh = mesh;
  const std::size_t vertices = mesh.positions.size(), faces = mesh.faces.size();
  for (const char* channel : {"red", "green", "blue"})
    document.mesh.vertex_columns.get(channel, Scalar::uint8, vertices);
  document.mesh.face_columns.get("label", Scalar::int16, faces);
  Column& list = document.mesh.face_columns.get("uv", Scalar::float32, 0);
  list.list_count_type = Scalar::uint8;
  list.values = {1, 2};
  list.list_offsets.assign(faces + 1, 2);
  list.list_offsets[0] = 0;
  document.other_elements.push_back({"edge", 2, {}});
  document.other_elements[0].columns.get("vertex1", Scalar::uint32, 2);
  document.style.comments = {"a comment"};
  return document;
}

void add_mesh_files(const Mesh& mesh, Seeds& seeds) {
  constexpr std::size_t largest = 4096;
  for (Document document : {Document{mesh, {}, {}}, documented(mesh)}) {
    const std::pair<const char*, Format> kinds[] = {
        {"ply", Format::ply_ascii},  {"ply", Format::ply_little}, {"ply", Format::ply_big},
        {"off", Format::off},        {"obj", Format::obj},        {"stl", Format::stl_ascii},
        {"stl", Format::stl_binary}, {"gltf", Format::glb},       {"three_mf", Format::three_mf},
        {"vtp", Format::vtp},        {"points", Format::xyz}};
    for (const auto& [target, format] : kinds) {
      document.style.format = format;
      try {
        const std::string bytes = write_mesh(document).bytes;
        if (bytes.size() <= largest) seeds.add(target, bytes);
      } catch (const GoalError&) {  // too large for floats
      }
    }
  }
}

/// Adds files that the library's writers do not make: polygons that are concave, have bridges,
/// intersect themselves or repeat their outline, values that are not finite, unknown statements and
/// elements.
void add_odd_mesh_files(Seeds& seeds) {
  const std::string square = "0 0 0\n4 0 0\n4 4 0\n0 4 0\n1 1 0\n3 1 0\n3 3 0\n1 3 0\n";
  for (const char* corners : {"4 0 1 4 2", "10 0 1 2 3 0 4 7 6 5 4", "4 0 2 1 3", "5 0 2 4 6 0",
                              "8 0 1 2 3 0 1 2 3", "6 0 4 6 2 6 4"})
    seeds.add("off", "OFF\n8 1 0\n" + square + corners + "\n");
  seeds.add("off", "NOFF\n3 1 0\n0 0 nan 0 0 1\n1 0 0 inf 0 1\n0 1 0 1.#QNAN 0 1\n3 0 1 2\n");
  seeds.add("obj",
            "4 4\n$ x\nv 0 0 0 .5 nan 1\nv 1 0 0\nv 1 1 1e999\nv 0 1 0\nv .5 .2 0\n"
            "vw 1\nf 1 2 5 3 4\nf 1 2 4 5\n");
  const std::string ply =
      "ply\nformat ascii 1.0\nCreated by x\nelement vertex 4\nproperty FLOAT x\n"
      "property float y\nproperty float z\nproperty float nx\n"
      "property float ny\nproperty float nz\n";
  const std::string vertices = "0 0 0 0 0 1\n1 0 0 nan 0 1\n0 1 0 0 0 1\n0 inf 1 0 0 1\n";
  seeds.add("ply", ply + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                       vertices + "9 0 1 2 3 -1 3 2 1 0\n");
  seeds.add("ply", ply +
                       "element face 1\nproperty list uchar int vertex_indices\n"
                       "property list uchar float texcoord\nend_header\n" +
                       vertices + "4 0 2 1 3 8 0 0 1 0 1 1 0 1\n");
  seeds.add("stl",
            "\nsolid x\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\n"
            "vertex .5 .5 0\nvertex 0 2 0\nendloop\nendfacet\n");
  seeds.add("stl", std::string(84, '\0') + std::string(100, '\x3f'));
}

/// Adds small files of formats that can only be read, and files as other programs write them.
void add_further_formats(Seeds& seeds) {
  const std::string vtk = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n";
  const std::string points = "POINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\n";
  seeds.add("vtk", vtk + points +
                       "POLYGONS 1 5 4 0 1 2 3\nTRIANGLE_STRIPS 1 5 4 0 1 3 2\nCELL_DATA 2\n"
                       "SCALARS a int\nLOOKUP_TABLE default\n1 2\nPOINT_DATA 4\nNORMALS n float\n"
                       "0 0 1 0 0 1 0 0 1 0 0 1\nFIELD f 1\nb 2 4 double\n1 2 3 4 5 6 7 8\n");
  seeds.add("vtk", "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\n" + points +
                       "CELLS 2 9\n4 0 1 2 3\n3 0 1 2\nCELL_TYPES 2\n10 5\n");
  seeds.add("vtk", "# vtk DataFile Version 5.1\n\nBINARY\nDATASET POLYDATA\nPOINTS 1 float\n" +
                       std::string(12, '\0') + "\nVERTICES 2 1\nOFFSETS vtktypeint64\n" +
                       std::string(16, '\0') + "\nCONNECTIVITY vtktypeint64\n" +
                       std::string(8, '\0'));
  const std::string fields =
      "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n";
  seeds.add("pcd", fields + "WIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3 4\n");
  seeds.add("pcd", fields + "POINTS 1\nDATA binary\n" + std::string(16, '\x3f'));
  seeds.add("pcd", fields + "POINTS 1\nDATA binary_compressed\n" +
                       std::string("\x11\0\0\0\x10\0\0\0\x0f", 9) + std::string(16, '\x3f'));
  seeds.add("points", "x,y,z,r,g,b\n1,2,3,255,0,0\n4,5,6,0,255,0\n");
  seeds.add("points", "2\n1 2 3 -7 255 0 0\n4 5 6 7 0 255 0\n");
  seeds.add(
      "three_mf",
      "<model unit=\"inch\"><resources><colorgroup id=\"2\"><color color=\"#FF0000\"/>"
      "</colorgroup><object id=\"1\" pid=\"2\" pindex=\"0\"><mesh><vertices><vertex x=\"0\" "
      "y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/>"
      "</vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\" p1=\"0\"/></triangles></mesh>"
      "</object><object id=\"3\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 "
      "0 0 1 0 0 5\"/></components></object></resources><build><item objectid=\"3\"/></build>"
      "</model>");
  seeds.add(
      "gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,)"
      R"("scale":[1,-1,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":)"
      R"({"count":1,"indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
      R"("data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
}

void add_meshes(Seeds& seeds) {
  constexpr std::size_t most_files = 40;
  const std::vector<Mesh> meshes = tiny_meshes();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::string bytes = fuzz::tiny_mesh_bytes(meshes[i]);
    if (i % (meshes.size() / most_files + 1) == 0) add_mesh_files(meshes[i], seeds);
    if (bytes.empty()) continue;
    seeds.add("clean", std::string(1, '\0') + bytes);
    seeds.add("stitch", std::string(3, '\0') + bytes);
    seeds.add("remesh", std::string("\x20\x20\2\1\1\0\0\0\0\0\0\0", 12) + bytes);
    seeds.add("step", std::string("\0\x40\x33\0\0", 5) + bytes + bytes);
  }
}

void add_images(Seeds& seeds) {
  using namespace transformesh::test;
  for (const int channels : {1, 3, 4})
    for (const bool is_progressive : {false, true})
      seeds.add("images", jpeg_of({channels, is_progressive, is_progressive ? 0U : 1U}, 9, 5,
                                  noise(static_cast<std::size_t>(45 * channels))));
  // Color types of PNG: gray 0, color 2, palette 3, with alpha 4 and 6.
  const std::array<std::pair<int, std::size_t>, 5> types{{{0, 1}, {2, 3}, {3, 1}, {4, 2}, {6, 4}}};
  for (const auto& [type, channels] : types)
    for (const bool is_interlaced : {false, true})
      seeds.add("images", png_of({type, 8, is_interlaced}, 9, 5, Rows(45 * channels, 1)));
  for (const int samples : {1, 3})
    for (const int bits : {8, 16})
      for (const int compression : {1, 5, 8, 32773})  // none, LZW, Deflate, PackBits
        for (const int tile : {0, 16}) {
          TiffKind kind;
          kind.bits = bits, kind.samples = samples, kind.photometric = samples == 1 ? 1 : 2;
          kind.compression = compression, kind.tile = tile;
          const auto size = static_cast<std::size_t>(45 * samples * bits / 8);
          seeds.add("images", tiff_of(kind, 9, 5, noise(size)));
        }
  for (const char* text : {"P2 2 2 255 0 1 2 3", "P3 1 1 9 1 2 3", "P5 2 1 65535 abcd"})
    seeds.add("images", text);
  seeds.add("images", "P6\n# a comment\n1 1\n255\nabc");
}

void add_cameras(Seeds& seeds) {
  CameraRing ring;
  ring.count = 3;
  const CameraList list = camera_ring(ring);
  for (const CameraFormat format :
       {CameraFormat::middlebury, CameraFormat::colmap, CameraFormat::matrices})
    seeds.add("cameras", write_cameras(list, format));
  seeds.add("cameras", "# Bundle file v0.3\n1 0\n1000 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -5\n");
  seeds.add("cameras", "CONTOUR\n1 0 0 0\n0 1 0 0\n0 0 1 5\n");
}

void add_words(Seeds& seeds) {
  for (const char* line :
       {"--flag\n--number=3\n-n\n1e3\n--integer\n7", "--length=5%\n-l\n0.7x\n--text\na b",
        "--choice\ntwo\n--numbers=1,2,3\n--seed=9\nfile.ply", "--reference-edge\nauto\n--\n-x",
        "-ft\nname\n--optional-integer=-3\n1.5GiB\n500M", "--lenght=1"})
    seeds.add("options", line);
  for (const char* names :
       {"view1.png\nview2.png\nview1.txt\nview2.txt", "a9\na10\nb09-mask\nb10-mask",
        "001.pgm\n002.pgm\ncamera1_P\ncamera2_P", "x/y.tar.gz\n.hidden\nx\n"})
    seeds.add("names", names);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "fuzz_seeds: name the folder to write to, and nothing else\n";
    return 2;
  }
  Seeds seeds(argv[1]);
  add_meshes(seeds);
  add_odd_mesh_files(seeds);
  add_further_formats(seeds);
  add_images(seeds);
  add_cameras(seeds);
  add_words(seeds);
  return 0;
}
