#!/usr/bin/env bash
# Debian packages into build/deb, of the files that Git lists as they are now: dpkg-buildpackage makes them and fetches
# nothing; lintian must find no error. The site of `make docs` comes along as a second tarball of the source, site/; with
# DEB_BUILD_PROFILES=nodoc there is none, and no stoss-doc.
set -euo pipefail
jobs=${1:-2}
out=build/deb
fail() { echo "deb: $*" >&2; exit 1; }

version=$(sed -n 's/^project(stoss VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
packaged=$(dpkg-parsechangelog --show-field Version)
[ "${packaged%-*}" = "$version" ] ||
  fail "debian/changelog: got version $packaged, allowed $version-1 and its like, as CMakeLists.txt says: add an entry"
rm -rf "$out"
mkdir -p "$out"

# The same files give the same tarball.
pack() {
  tar --sort=name --owner=0 --group=0 --numeric-owner --mode=u+rw,go=rX \
    "--mtime=@$(dpkg-parsechangelog --show-field Timestamp)" --use-compress-program="gzip --no-name" -cf "$@"
}
tree=stoss-$version
git ls-files -z -- . ':!debian' |
  pack "$out/stoss_$version.orig.tar.gz" --null --verbatim-files-from --files-from=- --transform="s|^|$tree/|"
tar -C "$out" -xf "$out/stoss_$version.orig.tar.gz"

if [[ " ${DEB_BUILD_PROFILES:-} " != *" nodoc "* ]]; then
  [ -f build/docs/index.html ] && [ -f build/wasm/stoss.mjs ] && [ -d web/node_modules ] ||
    fail "build/docs: got no site with the page, allowed that of make docs, or DEB_BUILD_PROFILES=nodoc"
  cp -R build/docs "$out/site"
  # A source package has no code that nobody can read, nor what Debian has: the page is built anew.
  rm -rf "$out"/site/{.buildinfo,.doctrees,page,_static/katex}
  STOSS_DOCUMENTATION=../ web/build.sh "$out/site/page" --minify false
  pack "$out/stoss_$version.orig-site.tar.gz" -C "$out" site
  mv "$out/site" "$out/$tree/site"
fi

cp -R debian "$out/$tree/debian"
# The source package is no repository: what `stoss --version` names comes along.
echo '@commit@' >"$out/commit.in"
cmake -DSOURCE="$PWD" -DTEMPLATE="$PWD/$out/commit.in" -DOUTPUT="$PWD/$out/$tree/debian/commit" -DCOMMIT=auto -DGIT=git \
  -P cmake/commit.cmake
cd "$out"
(cd "$tree" && dpkg-buildpackage --no-sign "--jobs=$jobs") >log 2>&1 || { tail -n 60 log >&2; fail "see $out/log"; }
lintian --allow-root --fail-on error "stoss_${packaged}"_*.changes
echo "built: $(ls -- *.deb | grep -v dbgsym | sed "s|^|$out/|" | xargs)"
