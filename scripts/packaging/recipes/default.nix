# Nix expression, for nix-build scripts/packaging/recipes/default.nix. Untested, because Nix was not available.
{ pkgs ? import <nixpkgs> { } }:

pkgs.stdenv.mkDerivation {
  pname = "transformesh";
  version = "1.0.0";
  src = pkgs.lib.cleanSource ../../..;

  nativeBuildInputs = with pkgs; [ cmake ninja pandoc pkg-config ];
  buildInputs = with pkgs; [
    boost cgal eigen gmp libjpeg libpng libtiff minizip mpfr nlohmann_json pugixml zlib
  ];
  cmakeFlags = [ "-DTM_STATIC=OFF" "-DBUILD_TESTING=OFF" ];
  ninjaFlags = [ "installed" ];

  doInstallCheck = true;
  installCheckPhase = ''
    $out/bin/tm-shape two-spheres --faces 500 | $out/bin/tm-clean | $out/bin/tm-checkmanifold --closed
  '';

  meta = with pkgs.lib; {
    description = "Mesh evolution as Unix filters: exact removal of self-intersections, remeshing, morphing";
    license = licenses.gpl3Only;
    platforms = platforms.linux;
  };
}
