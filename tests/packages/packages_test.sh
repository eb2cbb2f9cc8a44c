#!/usr/bin/env bash
# The Debian packages of a build: two runs make the same bytes, whatever the clock says; installed
# below their own root the programs run, Python imports, and a program in C compiles; an older
# version is upgraded; a purge leaves nothing behind. Needs neither root nor a network.
# usage: packages_test.sh SOURCE BUILD CC LIBDIR PYTHON
set -euo pipefail
source=$1 build=$2 cc=$3 libdir=$4 python=$5
for tool in dpkg dpkg-deb dpkg-shlibdeps cpack file strip; do
  command -v "$tool" >/dev/null || {
    echo "skipped: there is no $tool"
    exit 77
  }
done
fail() {
  printf '%s\n' "$@" >&2
  exit 1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PATH=$PATH:/usr/sbin:/sbin

# make_packages FOLDER TIME [OPTION…]: as `./dev package`, but quickly compressed.
make_packages() {
  local folder=$1 time=$2
  shift 2
  SOURCE_DATE_EPOCH=$time cpack --config "$build/CPackConfig.cmake" -B "$folder" -D \
    CPACK_DEBIAN_COMPRESSION_TYPE=gzip "$@" \
    >"$work/said" 2>&1 || fail "cpack failed:" "$(<"$work/said")"
  rm -rf "$folder/_CPack_Packages"
}
umask 022
make_packages "$work/first" 1700000000
make_packages "$work/second" 1700000000
packages=("$work"/first/*.deb)
[[ ${#packages[@]} -ge 3 ]] || fail "only these packages were made: ${packages[*]}"
for package in "${packages[@]}"; do
  cmp "$package" "$work/second/${package##*/}" || fail "two runs make different packages"
done

# What every package has, and none: documents, checksums that are right, dependencies that were
# found, no paths of this build.
for package in "${packages[@]}"; do
  name=$(dpkg-deb --field "$package" Package)
  mkdir "$work/$name"
  dpkg-deb --raw-extract "$package" "$work/$name"
  for document in copyright changelog.gz changelog.Debian.gz; do
    [[ -s $work/$name/usr/share/doc/$name/$document ]] || fail "$name has no $document"
  done
  (cd "$work/$name" && md5sum --quiet --check DEBIAN/md5sums) || fail "$name: wrong checksums"
  listed=$(wc -l <"$work/$name/DEBIAN/md5sums")
  [[ $(find "$work/$name" -type f -not -path '*/DEBIAN/*' | wc -l) == "$listed" ]] ||
    fail "$name: checksums of some files only"
  for folder in "$source" "$build"; do
    if grep -rlF -- "$folder" "$work/$name"; then fail "$name names $folder, where it was built"; fi
  done
  for binary in "$work/$name"/usr/bin/* "$work/$name/usr/$libdir"/*.so.*; do
    if [[ -f $binary && $(file -b "$binary") == ELF*'not stripped'* ]]; then fail "$name: ${binary##*/} is not stripped"; fi
  done
done
[[ $(dpkg-deb --field "$work"/first/changeover_*.deb Depends) == *'libsqlite3-0 (>= '* ]] ||
  fail "changeover depends on no SQLite"
# The comparison above sees what it must: another date makes another package.
make_packages "$work/third" 1700000001 -D CPACK_COMPONENTS_ALL=library
package=$(basename "$work"/third/libchangeover-loadorder*.deb)
[[ -f $work/first/$package && -f $work/third/$package ]] ||
  fail "there is no package of the library alone: $package"
if cmp -s "$work/third/$package" "$work/first/$package"; then
  fail "packages of different dates are the same"
fi

# An older version of each, with a file that the new one has no more.
mkdir "$work/old"
for package in "${packages[@]}"; do
  name=$(dpkg-deb --field "$package" Package)
  sed -i -e 's/^Version: .*/Version: 0.0.9-1/' -e \
    's/\(libchangeover-loadorder[0-9]* (= \)[^)]*/\10.0.9-1/' "$work/$name/DEBIAN/control"
  echo old >"$work/$name/usr/share/doc/$name/of_the_old_version"
  dpkg-deb --root-owner-group -Zgzip -z1 --build "$work/$name" "$work/old/" >/dev/null
done

root=$work/root
mkdir -p "$root/var/lib/dpkg/"{info,updates,triggers}
: >"$root/var/lib/dpkg/status"
# What the packages depend on is outside of this root, so that is not asked; scripts run outside,
# too, and are told where the root is.
in_root() {
  dpkg --root="$root" --log=/dev/null --force-not-root --force-depends --force-script-chrootless \
    --force-bad-path "$@" \
    >"$work/said" 2>&1 || fail "dpkg $1 failed:" "$(<"$work/said")"
}
state() { dpkg-query --admindir="$root/var/lib/dpkg" --show \
  --showformat='${Package} ${Version} ${db:Status-Status}\n'; }

in_root --install "$work"/old/*.deb
[[ $(state | grep -c ' 0.0.9-1 installed$') == "${#packages[@]}" ]] ||
  fail "the old version is not installed:" "$(state)"
in_root --install "${packages[@]}"
[[ $(state | grep -vc ' 0.0.9-1 ') == "${#packages[@]}" ]] ||
  fail "the old version is still there:" "$(state)"
left=$(find "$root" -name of_the_old_version)
[[ -z $left ]] || fail "the upgrade left what only the old version had:" "$left"

cd "$work"
"$root/usr/bin/changeover" design 15 5 --format text >design.txt
[[ $("$root/usr/bin/checkdesign" design.txt) == valid* ]] ||
  fail "the installed programs do not agree about a design"
$cc -std=c11 -Wall -Werror -I"$root/usr/include" "$source/tests/install/c_consumer/main.c" -o in_c \
  -L"$root/usr/$libdir" -lchangeover_loadorder
[[ $(LD_LIBRARY_PATH=$root/usr/$libdir ./in_c) =~ ^[1-9][0-9]*$ ]] ||
  fail "the program in C counts no loads"
if [[ -d $root/usr/lib/python3/dist-packages/changeover ]]; then
  PYTHONPATH=$root/usr/lib/python3/dist-packages PYTHONPYCACHEPREFIX='' PYTHONDONTWRITEBYTECODE='' \
    "$python" -c '
import changeover, importlib.metadata, sys
assert changeover.__file__.startswith(sys.argv[1]), changeover.__file__
assert importlib.metadata.version("changeover") == changeover.__version__
assert changeover.design(61, 4).b == 366' "$root" || fail "Python does not import the installed package"
  [[ -d $root/usr/lib/python3/dist-packages/changeover/__pycache__ ]] ||
    fail "Python compiled nothing that a purge could forget"
fi

# The bill of materials lists libraries of either kind, of this machine's architecture only.
SOURCE_DATE_EPOCH=1700000000 "$python" "$source/.ci/bill_of_materials.py" "$build/changeover" \
  >"$work/bill.json" || fail "no bill of materials"
"$python" -c 'import json, sys
bill = json.load(open(sys.argv[1]))
links = {link["relatedSpdxElement"]: link["relationshipType"] for link in bill["relationships"]}
assert links["SPDXRef-libsqlite3-0"] == "DYNAMIC_LINK", links
assert links["SPDXRef-nlohmann-json3-dev"] == "STATIC_LINK", links
assert not [name for name in links if "i386" in name], links' "$work/bill.json" ||
  fail "the bill of materials is not whole"

mapfile -t names < <(state | cut -d ' ' -f 1)
in_root --purge "${names[@]}"
left=$(find "$root" -path "$root/var/lib/dpkg" -prune -o -not -type d -print)
[[ -z $left ]] || fail "a purge leaves:" "$left"
left=$(find "$root/usr" -name '*changeover*' 2>/dev/null || true)
[[ -z $left ]] || fail "a purge leaves:" "$left"
[[ -z $(state) ]] || fail "packages are known still:" "$(state)"
