#!/usr/bin/env bash
# Runs a script in a folder of its own, which goes away with it: in_fresh_folder.sh SCRIPT
set -u
script=$(realpath -- "$1")
folder=$(mktemp -d "${TMPDIR:-/tmp}/changeover-hostile-XXXXXX") || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
bash "$script"
