#!/usr/bin/env bash
# ranges.sh FILE...: finds algorithms of std::ranges that wasm/standard_library.h does not add. The
# libc++ of the WebAssembly build has none, so this build fails with them.
set -euo pipefail
export LC_ALL=C
added=$(sed -nE 's/^[a-z].* ([a-z_]+)\(Range&&.*/\1/p' "$(dirname "${BASH_SOURCE[0]}")/../../wasm/standard_library.h")
code=0
while IFS=: read -r file _ _ name; do
  if ! grep -qx "$name" <<<"$added"; then
    echo "lint: $file uses std::ranges::$name, which wasm/standard_library.h does not add" >&2
    code=1
  fi
done < <(grep -oHE 'ranges::[a-z_]+' "$@")
exit "$code"
