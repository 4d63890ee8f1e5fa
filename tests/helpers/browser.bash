# Functions that check pages in headless Chromium, if scripts/setup --browser has installed it.

has_browser() {
  TM_CHROMIUM=$(command -v chromium || command -v chromium-browser) || return 1
  export TM_CHROMIUM
  command -v node >/dev/null && [ -e "$tm_root/tools/viewer/node_modules/puppeteer-core" ] &&
    [ -e "$tm_root/tools/viewer/node_modules/axe-core" ] && [ -e "$tm_build/share/transformesh/viewer.html" ]
}

needs_browser() {
  has_browser || skip "there is no Chromium or no viewer: scripts/setup --browser"
}

# check NAME PAGE|WORD...: runs a check of tests/browser/checks.mjs. Names of pages become URLs.
check() {
  local name=$1 words=() word
  shift
  for word; do
    [[ $word != /*.html ]] || word=file://$word
    [[ $word != *.html || $word == file:* ]] || word=file://$PWD/$word
    words+=("$word")
  done
  timeout 300 node "$tm_root/tests/browser/checks.mjs" "$name" "${words[@]}" 3>&-
}
