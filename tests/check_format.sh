#!/usr/bin/env bash
# Fails where a source is not laid out as .clang-format says, and names it.
#   tests/check_format.sh CLANG_FORMAT [ROOT]
set -euo pipefail
cd "${2:-.}"
mapfile -t files < <(find app benchmarks filters plugins rendering tests -name '*.h' -o -name '*.cpp' -o -name '*.cxx')
((${#files[@]} > 0)) || { echo "no sources here" >&2; exit 1; }
"$1" --dry-run -Werror "${files[@]}"
echo "${#files[@]} files"
