# The release checklist, the workflows, and the scripts of their jobs.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# step N: prints the first command of a step of the checklist.
step() {
  sed -n "s/^$1\. [^\`]*\`\([^\`]*\)\`.*/\1/p" "$tm_root/RELEASE_CHECKLIST.md"
}

@test "release: the checklist has ten steps, each a command, and all scripts that it names are there" {
  [ "$(grep -cE '^[0-9]+\. [^`]*: `' "$tm_root/RELEASE_CHECKLIST.md")" -eq 10 ]
  for number in $(seq 10); do [ -n "$(step "$number")" ] || fail "step $number"; done
  for script in $(grep -ohE 'scripts/[a-z/-]+' "$tm_root/RELEASE_CHECKLIST.md" "$tm_root"/.github/workflows/*.yml |
    grep -vx scripts/wasm | sort -u); do
    [ -x "$tm_root/$script" ] || fail "$script"
  done
}

@test "release: the first three steps set the version and date the changes, in a clone" {
  git -C "$tm_root" rev-parse HEAD >/dev/null 2>&1 || skip "needs a clone"
  git clone -q --depth 1 "file://$tm_root" clone
  cd clone
  export VERSION=9.8.7 GIT_AUTHOR_NAME=t GIT_AUTHOR_EMAIL=t@t GIT_COMMITTER_NAME=t GIT_COMMITTER_EMAIL=t@t
  for number in 1 2 3; do bash -e -c "$(step "$number")" >../log || fail "step $number: $(cat ../log)"; done
  grep -q '^project(transformesh VERSION 9.8.7 ' CMakeLists.txt
  grep -qx 'cff-version: 1.2.0' CITATION.cff
  grep -qx 'version: 9.8.7' CITATION.cff
  grep -qx "## \[9.8.7\] - $(date -u +%F)" CHANGELOG.md
  [ "$(git show --name-only --format=%s | sort | tr '\n' ' ')" = " CHANGELOG.md CITATION.cff CMakeLists.txt Release 9.8.7 " ]
  # The first step refuses a clone with uncommitted changes.
  echo change >>README.md
  run ! bash -e -c "$(step 1)"
}

@test "release: yamllint has nothing to say about workflows and templates of issues" {
  needs_command yamllint
  yamllint --strict "$tm_root/.github"
}

@test "release: every run line of a workflow is a script, or a call of a package manager" {
  command -v python3 >/dev/null && python3 -c 'import yaml' 2>/dev/null || skip "needs python3-yaml"
  python3 - "$tm_root"/.github/workflows/*.yml <<'PYTHON'
import re, sys, yaml
for name in sys.argv[1:]:
    for job in yaml.safe_load(open(name))['jobs'].values():
        for step in job['steps']:
            for line in step.get('run', '').splitlines():
                assert re.match(r'scripts/|apt-get|cp build-wasm/', line), (name, line)
PYTHON
}
