# What the scripts that drive the program share. They run in a folder of their own.

mote=$1
data=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# run CODE COMMAND...: the command must exit with CODE; its output goes to out and err.
run() {
  local wanted=$1
  shift
  "$@" >out 2>err
  local code=$?
  [ $code = "$wanted" ] || { cat out err; fail "exit code $code, not $wanted: $*"; }
}

# said FILE TEXT: the file contains the text.
said() { grep -qF -- "$2" "$1" || { cat "$1"; fail "$1 does not say: $2"; }; }

# one_sentence: err is a single line that begins with "mote: ".
one_sentence() {
  [ "$(wc -l <err)" = 1 ] && grep -q '^mote: ' err || { cat err; fail "not one sentence"; }
}

# png_size FILE: "WIDTHxHEIGHT" of a PNG, from its header; nothing if it is none.
png_size() {
  [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] || return
  set -- $(od -A n -t u1 -j 16 -N 8 "$1")
  echo "$(($1 << 24 | $2 << 16 | $3 << 8 | $4))x$(($5 << 24 | $6 << 16 | $7 << 8 | $8))"
}

# alike FILE FILE: the two are the same, byte for byte.
alike() { cmp -s "$1" "$2" || fail "$1 and $2 differ"; }

# is_picture FILE SIZE: a PNG of that size with something on it.
is_picture() {
  [ "$(png_size "$1")" = "$2" ] || fail "$1 is no PNG of $2 but '$(png_size "$1")'"
  [ "$(stat -c %s "$1")" -gt 8000 ] || fail "there is hardly anything on $1"
}

# two_lines FILE: lines of a legacy VTK file with values of points and of lines.
two_lines() {
  cat >"$1" <<VTK
# vtk DataFile Version 3.0
two lines, one of which stands still at its second point and turns back at its end
ASCII
DATASET POLYDATA
POINTS 8 float
0 0 0  1 0 0  1 0 0  2 1 0  1.2 0.2 0  0 2 0  1 2 0.5  2 2 0
LINES 2 10
5 0 1 2 3 4
3 5 6 7
POINT_DATA 8
SCALARS speed float 1
LOOKUP_TABLE default
0 1 2 3 4 5 6 7
SCALARS width float 1
LOOKUP_TABLE default
0.1 0.1 0.1 0.1 0.1 0.2 0.2 0.2
CELL_DATA 2
SCALARS line float 1
LOOKUP_TABLE default
1 2
VTK
}
