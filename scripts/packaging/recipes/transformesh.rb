# Homebrew formula. Not tried here: neither Homebrew nor macOS was there, and no build with clang++ of macOS is
# known. Replace addresses and hash by those of the release's source archive.
class Transformesh < Formula
  desc "Mesh evolution as Unix filters: exact removal of self-intersections, remeshing"
  homepage "https://example.org/transformesh"
  url "https://example.org/transformesh/releases/download/v1.0.0/transformesh-1.0.0.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license "GPL-3.0-only"

  depends_on "cmake" => :build
  depends_on "fast_float" => :build
  depends_on "nlohmann-json" => :build
  depends_on "pandoc" => :build
  depends_on "boost"
  depends_on "cgal"
  depends_on "eigen"
  depends_on "gmp"
  depends_on "jpeg-turbo"
  depends_on "libpng"
  depends_on "libtiff"
  depends_on "minizip"
  depends_on "mpfr"
  depends_on "pugixml"

  uses_from_macos "zlib"

  def install
    args = %w[-DTM_STATIC=OFF -DBUILD_TESTING=OFF -DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON]
    system "cmake", "-S", ".", "-B", "build", *args, *std_cmake_args
    system "cmake", "--build", "build", "--target", "installed"
    system "cmake", "--install", "build"
  end

  test do
    system "#{bin}/tm-shape two-spheres --faces 500 | #{bin}/tm-clean > clean.ply"
    assert_equal "1", shell_output("#{bin}/tm-info --get components clean.ply").strip
  end
end
