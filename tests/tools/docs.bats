# Checks the gallery, the site, and its check of links.

load ../helpers/common
load ../helpers/browser

setup() {
  cd "$BATS_TEST_TMPDIR"
  export TM_BUILD=$tm_build
}

gallery() { "$tm_root/scripts/gallery" "$@"; }
links() { "$tm_root/scripts/links" "$@"; }

@test "the gallery: pictures with their commands; only changed ones are made again" {
  needs_command pandoc
  GALLERY='split drawing' gallery out 2>messages
  [ "$(grep -c '^gallery: ' messages)" -eq 2 ]
  [ "$(head -c 4 out/split/picture.png | tail -c 3)" = PNG ]
  grep -q '<svg' out/drawing/picture-1.svg
  [ "$(grep -o '<img' out/index.html | wc -l)" -eq 3 ]
  grep -q 'tm-displace --normal-speed -0.4x --alpha 1 now.ply | tm-clean | tm-remesh' out/index.html
  links out
  # The neck has vanished between the first and the last frame.
  [ "$(tm-info --get components out/split/frame-0.ply)" -eq 1 ]
  [ "$(tm-info --get components out/split/frame-12.ply)" -eq 2 ]
  # Complete pictures of an interrupted gallery stay.
  mv out/drawing out/drawing.unfinished
  GALLERY='split drawing' gallery out 2>messages
  [ "$(cat messages)" = "gallery: drawing" ]
  if has_browser; then check texts out/index.html; fi
}

@test "the gallery makes the picture of the README, below 60 kB" {
  needs_command pandoc
  GALLERY=cleaned gallery out
  cmp out/cleaned/picture.png "$tm_root/docs/cleaned.png"
  [ "$(wc -c <"$tm_root/docs/cleaned.png")" -lt 60000 ]
  grep -qF '(docs/cleaned.png)' "$tm_root/README.md"
}

@test "commands of the gallery that fail are named, and leave no picture" {
  mkdir bin
  printf '#!/bin/sh\nexit 3\n' >bin/tm-render
  chmod +x bin/tm-render
  # Programs of the build take precedence: a folder with all but one of them.
  mkdir -p build/bin
  ln -s "$tm_build"/bin/tm* build/bin
  ln -sf "$PWD/bin/tm-render" build/bin/tm-render
  run --separate-stderr env TM_BUILD="$PWD/build" GALLERY=split "$tm_root/scripts/gallery" out
  assert_status 1
  [[ $stderr == *"the commands of split have failed"* ]]
  [ ! -e out/split ] && [ ! -e out/index.html ]
}

@test "broken links are found: files, anchors, pictures, style sheets" {
  mkdir -p site/sub
  cat >site/index.html <<'HTML'
<h1 id="top">Top</h1><a href="sub/other.html#there">there</a> <a href="#top">up</a> <a href="https://example.org/x">away</a>
<img src="sub/a%20picture.png"> <a href="sub/">folder</a>
<script>const text = '<a href="not-a-link.html">';</script>
HTML
  echo '<p id="there">There <a
    href="../index.html?query#top">back</a> <link href="style.css">' >site/sub/other.html
  : >"site/sub/a picture.png"
  echo 'p { background: url("a picture.png") }' >site/sub/style.css
  links site
  echo '<a href="sub/other.html#nowhere">x</a><a href="gone.html">x</a><img src="gone.png"><a href="/index.html">x</a>' >>site/index.html
  echo '@import url(/elsewhere/gone.css);' >>site/sub/style.css
  run --separate-stderr links site
  assert_status 1
  [ "$(wc -l <<<"$stderr")" -eq 5 ] || fail "$stderr"
  for what in 'no place for sub/other.html#nowhere' 'no file for gone.html' 'no file for gone.png' \
    'no file for /index.html' 'no file for /elsewhere/gone.css'; do
    [[ $stderr == *"$what"* ]] || fail "$what is not found"
  done
  [ "$(find site -name '.*' -type f)" = "" ]
}

@test "the site: tutorial, gallery, man pages and references, and no broken link" {
  for program in doxygen pandoc sphinx-build; do needs_command "$program"; done
  /usr/bin/python3 -c 'import breathe, furo' 2>/dev/null || skip "breathe and furo are not installed"
  ls "$tm_build"/python/transformesh/_transformesh.*.so >/dev/null 2>&1 || skip "the Python module is not built"
  GALLERY=split GALLERY_FOLDER=$PWD/gallery "$tm_root/scripts/docs" site >out 2>messages || fail "$(cat messages)"
  [ "$(cat out)" = "$PWD/site/index.html" ]
  # There is a page for every man page, and the pages have links to each other.
  for page in "$tm_root"/man/*.md; do
    [ -e "site/man/$(basename "$page" .md).html" ] || fail "$page has no page"
  done
  grep -q 'href="tm-stitch.1.html"' site/man/tm-clean.1.html
  # Contracts have links to types, and functions have their arguments.
  grep -q 'TransforMesh (paper 3)' site/reference/cpp/clean.html
  grep -q 'href="mesh.html#_CPPv44Mesh"' site/reference/cpp/clean.html
  grep -q 'id="transformesh.evolve"' site/reference/python.html
  grep -q 'src="_images/picture.png"' site/gallery.html
  links site
  if has_browser; then
    check texts site/index.html site/gallery.html site/man/tm-clean.1.html site/reference/cpp/clean.html \
      site/reference/python.html site/readme.html site/recipes.html
  fi
}
