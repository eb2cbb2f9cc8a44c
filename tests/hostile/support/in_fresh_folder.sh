#!/usr/bin/env bash
# Runs a script in its own folder, which is removed at the end: in_fresh_folder.sh SCRIPT
set -u
script=$(realpath -- "$1")
folder=$(mktemp -d "${TMPDIR:-/tmp}/changeover-hostile-XXXXXX") || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
bash "$script"
