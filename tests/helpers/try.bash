# Functions that test the page of docs/try in headless Chromium, with the module that scripts/wasm
# builds.

load ../helpers/browser

has_try() {
  has_browser && [ -e "$tm_root/build-wasm/package/transformesh.wasm" ]
}

needs_try() {
  needs_browser
  has_try || skip "there is no WebAssembly module: scripts/wasm"
}

# try_page NAME [WORD...]: runs a check of tests/try/checks.mjs on the page in the folder `site`.
try_page() {
  timeout 300 node "$tm_root/tests/try/checks.mjs" "$BATS_FILE_TMPDIR/site" "$@" 3>&-
}
