#!/usr/bin/env bash
# Do the stubs of the Python package say what the module has, and can a program that uses it be checked by them? A
# wrong use must be found, too.
# usage: check_stubs.sh PYTHON PACKAGES
set -euo pipefail
python=$1 packages=$2
"$python" -c 'import mypy' 2>/dev/null || {
  printf 'skipped: mypy is not installed\n'
  exit 77
}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat >allowed <<'END'
changeover\._core.*
changeover\..*\.__(init|new|class_getitem|eq|hash|buffer|contains|reversed|iter|next)__
changeover\.Blocks\.(count|index)
END
# The metaclass of compiled classes is pybind11's own, which no stub can name.
MYPYPATH=$packages "$python" -m mypy.stubtest changeover --concise --ignore-missing-stub --ignore-positional-only \
  --allowlist allowed --ignore-unused-allowlist >said 2>&1 || true
if grep -v 'is inconsistent, metaclass differs$' said | grep .; then
  printf 'the stubs do not say what the module has\n' >&2
  exit 1
fi
grep -q 'changeover.Design' said # It looked.
cat >right.py <<'END'
import changeover

design = changeover.design(61, 4, kind="circular")
assert design is not None
rows: list[list[int]] = design.blocks.tolist()
bound: int | None = changeover.bounds(20, 5).lower_bound
for evict, load in changeover.load_order(12, 4):
    print(len(evict) + len(load))
END
MYPYPATH=$packages "$python" -m mypy --strict right.py
printf 'import changeover\nchangeover.design(61, 4, kind="round")\nchangeover.bounds("v", 4)\n' >wrong.py
if MYPYPATH=$packages "$python" -m mypy --strict wrong.py >said; then
  printf 'wrong uses were not found\n' >&2
  exit 1
fi
[[ $(grep -c 'error:' said) -eq 2 ]]
