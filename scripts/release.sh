#!/usr/bin/env bash
# Makes a release of what is committed: writes its version and its date wherever a file names them, commits that and
# tags it. The version stands in CMakeLists.txt; what names it again is held to it by tests/docs/test_versions.py. With
# --check nothing is changed, and what stands in the way is said; --left says what is left to a person after `make
# release`. Nothing is pushed or published.
#   release.sh [--check | --left] VERSION
set -euo pipefail
cd "$(dirname "$0")/.."
only=
case ${1:-} in --check | --left) only=$1 && shift ;; esac
version=${1:-}
[[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || { echo "release: VERSION: got '$version', allowed three numbers: 2.0.0" >&2; exit 2; }

if [ "$only" = --left ]; then
  git rev-parse -q --verify "refs/tags/v$version" >/dev/null ||
    { echo "release: VERSION: got $version, which has no tag v$version (make release VERSION=$version)" >&2; exit 1; }
  cat <<END
release: $version is tagged, and its packages are in build/dist, build/deb, build/static and build/docs. Left to you:
  - CITATION.cff and docs/paper/paper.md: people, their ORCID and the repository, where they are placeholders
  - the tag, signed with your key: git tag -f -s v$version v$version^{} -m "stoss $version"
  - git push --follow-tags, with your rights to the repository; then a release of it with build/static/stoss
  - build/deb: debsign with your key, and dput to an archive that takes them
  - build/dist/*.whl and *.tar.gz: twine upload, with a token of the Python package index
  - build/dist/*.tgz: npm publish, with a token of the npm registry
  - build/docs: to the server of the site
  - a DOI of the archive of the tag, for CITATION.cff; the paper to its journal
To take it back before anything is pushed: git tag -d v$version && git reset --hard HEAD~1
END
  exit
fi

faults=0
refuse() { echo "release: $*" >&2; faults=1; }

old=$(sed -n 's/^project(stoss VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
last=$(git describe --tags --abbrev=0 --match 'v[0-9]*' 2>/dev/null || true)
changed=$(git status --porcelain | wc -l)
[ "$changed" = 0 ] || refuse "tree: got $changed changed files, allowed none: commit them first"
[ "$(printf '%s\n' "$old" "$version" | sort -V | tail -n 1)" = "$version" ] ||
  refuse "VERSION: got $version, allowed $old (CMakeLists.txt) and above"
! git rev-parse -q --verify "refs/tags/v$version" >/dev/null || refuse "VERSION: got $version, whose tag v$version exists"

section=$(sed -n '/^## /,$p' CHANGELOG.md | sed '1!{/^## /,$d}')
title=$(sed -n '1s/^## //p' <<<"$section")
if [ "$title" != Unreleased ] && [ "${title%% *}" != "$version" ]; then
  refuse "CHANGELOG.md: got '$title' at its top, allowed a section 'Unreleased' or '$version'"
elif ! grep -q '^- ' <<<"$section"; then
  refuse "CHANGELOG.md: got nothing under '$title', allowed what users notice"
elif [ "$(sed -n 's/^### //p' <<<"$section" | head -n 1)" != "What you must change" ]; then
  refuse "CHANGELOG.md: '$title' must begin with '### What you must change' (or say there that it is nothing)"
fi
[ -z "$last" ] || ! git diff --quiet "$last" -- CHANGELOG.md || refuse "CHANGELOG.md: got that of $last, unchanged"
grep -q "^Within the versions ${version%%.*}\.x:" docs/developer/versions.md ||
  refuse "docs/developer/versions.md: what is stable must be said of ${version%%.*}.x"

if grep -q '^# Placeholders' CITATION.cff; then
  echo "release: note: CITATION.cff has placeholders for people and repository; fill them in where they are known"
fi
[ $faults = 0 ] || exit 1
if [ -n "$only" ]; then
  echo "release: $version can follow ${last:-no release}; make test-long must pass first"
  exit 0
fi

day=$(date -u +%F)
was=${old//./\\.}
sed -i "s/^project(stoss VERSION $was /project(stoss VERSION $version /" CMakeLists.txt
sed -i -e '/^date-released: /d' -e "s/^version: .*/version: $version\ndate-released: $day/" CITATION.cff
sed -i "0,/^## .*/s//## $version ($day)/" CHANGELOG.md
sed -i "s/\bstoss $was\( follows\|: \)/stoss $version\1/g" docs/developer/versions.md
sed -i "s/as in \"$was\"/as in \"$version\"/" include/stoss/stoss.h include/stoss/version.hpp
if ! head -n 1 debian/changelog | grep -q "^stoss ($version-"; then
  who=$(sed -n 's/^ -- \(.*>\)  .*/\1/p' debian/changelog | head -n 1)
  entry=$(printf 'stoss (%s-1) unstable; urgency=medium\n\n  * New version: see CHANGELOG.md.\n\n -- %s  %s' \
    "$version" "$who" "$(date -uR)")
  printf '%s\n\n%s\n' "$entry" "$(cat debian/changelog)" >debian/changelog.new
  mv debian/changelog.new debian/changelog
fi
git commit -qam "Release $version"
git tag -a "v$version" -m "stoss $version"
echo "release: $version is committed and tagged v$version"
