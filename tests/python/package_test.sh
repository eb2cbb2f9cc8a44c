#!/usr/bin/env bash
# The source archive has what the build needs and nothing that builds left behind; the wheel of this
# build works where it is unpacked, without the build folder.
# usage: package_test.sh PYTHON SOURCE BUILD
set -euo pipefail
python=$1 source=$2 build=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
PYTHONPATH=$source/python "$python" -c '
import sys, build_backend
print(build_backend.build_sdist("."))
print(build_backend.build_wheel(".", {"built": sys.argv[1]}))' "$build" 2>said || {
  cat said >&2
  exit 1
}
archive=$(echo ./*.tar.gz)
tar -tzf "$archive" >listed
for path in CMakeLists.txt pyproject.toml PKG-INFO python/build_backend.py \
  python/changeover/plans.py python/changeover/cluster/_team.py web/dist/index.html LICENSE; do
  grep -q "^[^/]*/$path\$" listed || {
    printf 'the source archive lacks %s\n' "$path" >&2
    exit 1
  }
done
grep -q '^[^/]*/catalog/written/' listed
if grep -E '/(build|node_modules|__pycache__)/' listed; then
  printf 'the source archive has what builds leave behind\n' >&2
  exit 1
fi
"$python" -m zipfile -e ./*.whl site
PYTHONPATH=$folder/site "$python" -c '
import changeover, importlib.metadata, pathlib
assert pathlib.Path(changeover.__file__).parent.parent.name == "site"
assert importlib.metadata.version("changeover") == changeover.__version__
assert changeover.design(61, 4).b == 366
import changeover.cluster
assert changeover.cluster.simulate(items=9, room=4, workers=2, pair_seconds=1, item_bytes=1).pairs == 36'
