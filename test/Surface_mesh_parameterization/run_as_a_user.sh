# Sourced by tests that run a program as a user would, in an empty folder that goes with them.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
failures=0

fail() { echo "FAILED: $*" >&2; failures=$((failures + 1)); }

# expect STATUS ARGUMENT...: $program ends with that status; on an error with exactly one line on stderr.
expect() {
  local wanted=$1 status=0
  shift
  "$program" "$@" >stdout 2>stderr || status=$?
  [ "$status" -eq "$wanted" ] || fail "'$*' ended with $status instead of $wanted: $(cat stderr)"
  [ "$wanted" -eq 0 ] || [ "$(wc -l <stderr)" -eq 1 ] || fail "'$*' printed $(wc -l <stderr) lines on stderr instead of one"
}
