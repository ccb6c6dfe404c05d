# Sourced by tests that run a program as a user would, in an empty folder that goes with them.
set -u
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fail() { echo "FAILED: $*" >&2; failures=$((failures + 1)); }

# expect STATUS ARGUMENT...: $program ends with that status; on an error with exactly one line on stderr.
expect() {
  local wanted=$1 status=0
  shift
  "$program" "$@" >stdout 2>stderr || status=$?
  [ "$status" -eq "$wanted" ] || fail "'$*' ended with $status instead of $wanted: $(cat stderr)"
  [ "$wanted" -eq 0 ] || [ "$(wc -l <stderr)" -eq 1 ] ||
    fail "'$*' printed $(wc -l <stderr) lines on stderr instead of one"
}

is_in_output() { grep -q -- "$1" stdout || fail "'$1' is not in: $(cat stdout)"; }
told() { grep -q -- "$1" stderr || fail "'$1' is not in: $(cat stderr)"; }

# A closed surface, as OFF.
make_tetrahedron() { printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n'; }

# make_tube N: a tube of N storeys of three squares, closed at one end. A conformal map shrinks along it.
make_tube() {
  awk -v n=3 -v m="$1" 'BEGIN {
    turn = 8 * atan2(1, 1) / n
    for (j = 0; j <= m; ++j) for (i = 0; i < n; ++i) print "v", cos(i * turn), sin(i * turn), 2 * j
    for (j = 0; j < m; ++j) for (i = 0; i < n; ++i) {
      a = j * n + i + 1; b = j * n + (i + 1) % n + 1
      print "f", a, b, b + n; print "f", a, b + n, a + n
    }
    print "f", m * n + 1, m * n + 2, m * n + 3
  }'
}
