#!/usr/bin/env bash
# How the program treats the files that it writes: program_files_test.sh PROGRAM
#
# No output is named /dev/stdout or /dev/null: a program that is broken would replace them if root runs the test. Links
# to /dev/fd and pipes in the test's own folder do as well.
program=$1
source "$(dirname "$0")/run_as_a_user.sh"

# A square of two triangles.
make_square() { printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n'; }
is_mesh() { [ "$(grep -c '^vt ' "$1")" -eq 4 ] || fail "$2: $1 holds no mesh with its map"; }
is_picture() { grep -q '</svg>' "$1" || fail "$2: $1 holds no picture"; }
is_report() { [ "$(grep -c '^{"input":.*}$' "$1")/$(wc -l <"$1")" = 1/1 ] || fail "$2: $1 is not the report"; }
has_mode() { [ "$(stat -c %a "$1")" = "$2" ] || fail "$1 has the mode $(stat -c %a "$1") instead of $2"; }

# wrong ARGUMENT...: wrong usage, told before anything is read or written.
wrong() {
  local before
  before=$(find . -type f ! -name stdout ! -name stderr -exec cksum {} + | sort)
  expect 1 "$@"
  [ "$before" = "$(find . -type f ! -name stdout ! -name stderr -exec cksum {} + | sort)" ] || fail "'$*' changed files"
}

# leaves_only FILE...: what the last run left, but for the test's own files.
leaves_only() {
  local left
  left=$(find . -mindepth 1 ! -name stdout ! -name stderr -printf '%P\n' | sort | tr '\n' ' ')
  [ "$left" = "$(printf '%s\n' "$@" | sort | tr '\n' ' ')" ] || fail "left are $left instead of $*"
}

# in_new_folder NAME: goes where nothing is but the square.
in_new_folder() {
  mkdir "$folder/$1"
  cd "$folder/$1" || exit 1
  make_square >square.obj
}

# ---- links ----

in_new_folder links
mkdir elsewhere
echo old >elsewhere/old.obj
ln -s elsewhere/old.obj output.obj
ln -s elsewhere/new.svg picture.svg          # leads nowhere yet
ln -s twice.json report.json
ln -s elsewhere/report.json twice.json
expect 0 square.obj --output output.obj --picture picture.svg --report report.json
[ -L output.obj ] && [ -L picture.svg ] && [ -L report.json ] && [ -L twice.json ] || fail "a link was replaced"
is_mesh elsewhere/old.obj link
is_picture elsewhere/new.svg "link that leads nowhere"
is_report elsewhere/report.json "link to a link"
ln -s loop.obj loop.obj
expect 3 square.obj --output loop.obj
[ -L loop.obj ] || fail "a link to itself was replaced"

# ---- names ----

in_new_folder names
echo mine >out.obj.part
ln -s out.obj.part report.json.part
expect 0 square.obj --output out.obj --report report.json
[ "$(cat out.obj.part)" = mine ] && [ -L report.json.part ] || fail "a file of the user was taken for a temporary one"
leaves_only square.obj out.obj out.obj.part report.json report.json.part

in_new_folder long_names
long=$(printf 'x%.0s' $(seq 251)).obj
expect 0 square.obj --output "$long"
is_mesh "$long" "the longest name"
expect 3 square.obj --output out.obj --picture "x$long.svg"
leaves_only square.obj "$long"

# ---- modes ----

in_new_folder modes
(umask 027 && expect 0 square.obj --output new.obj --report private.json; exit $((failures > 0))) ||
  failures=$((failures + 1))
has_mode new.obj 640
chmod 600 private.json
chmod 664 new.obj
(umask 077 && expect 0 square.obj --output new.obj --report private.json; exit $((failures > 0))) ||
  failures=$((failures + 1))
has_mode new.obj 664
has_mode private.json 600

# ---- permissions ----

# Told before the input is read; root may write everything.
in_new_folder permissions
mkdir locked
touch read_only.obj
chmod 555 locked
chmod 444 read_only.obj
chmod 711 "$folder"
cp "$program" program
as_nobody() { setpriv --reuid=65534 --regid=65534 --clear-groups "$@"; }
[ "$(id -u)" -eq 0 ] || as_nobody() { "$@"; }
if as_nobody ./program --version >/dev/null 2>&1; then
  for output in locked/new.obj read_only.obj; do
    as_nobody ./program missing.obj --output $output >stdout 2>stderr
    [ "$?/$(cat stderr)" = "3/hierarchical_parameterization: $output: cannot be written (Permission denied)" ] ||
      fail "$output without permission: $(cat stderr)"
  done
fi
chmod 755 locked
rm program

# ---- one file for two purposes ----

in_new_folder collisions
make_square >other.obj
ln -s square.obj link.obj
ln square.obj hard.obj
ln -s new.obj nowhere.obj
ln -s . here
mkdir levels
make_square >levels/level_00.obj
for output in square.obj ./square.obj here/square.obj "$PWD/square.obj" link.obj hard.obj; do
  wrong square.obj --output "$output"
  wrong "$output" --report square.obj
done
wrong missing.obj --output ./missing.obj
wrong - --output square.obj <square.obj
wrong levels/level_00.obj --levels levels
wrong other.obj square.obj --report square.obj
for same in new.obj here/new.obj nowhere.obj "$PWD/new.obj"; do
  wrong square.obj --output new.obj --report "$same"
  wrong square.obj --report "$same" --output new.obj
done
wrong square.obj --picture new.svg --report ./new.svg
wrong square.obj --output levels/level_00.obj --levels here/levels
wrong square.obj --report levels/level_01.obj --levels levels
wrong square.obj --output - --report -
ln -s /dev/fd/1 standard_output
wrong square.obj --output standard_output --picture -
rm standard_output
"$program" square.obj --report summary.txt >summary.txt 2>stderr
[ $? -eq 1 ] || fail "the summary and the report went to one file"
rm summary.txt
leaves_only square.obj other.obj link.obj hard.obj nowhere.obj here levels levels/level_00.obj
mkfifo pipe
exec 8<>pipe                                 # holds what is written
expect 0 square.obj --output pipe --picture pipe --report pipe
exec 8>&-
[ -p pipe ] || fail "a pipe was replaced"

# ---- several inputs ----

in_new_folder several_inputs
mkdir charts maps
make_square >charts/a.obj
make_square >charts/b.c.obj
wrong charts/a.obj charts/b.c.obj --output maps/map.obj
wrong charts/a.obj charts/a.obj --output '{.}.uv.obj'
wrong charts/a.obj charts/b.c.obj --output '{.}.obj'
wrong charts/a.obj maps/../charts/a.obj --output 'maps/{/.}.obj'
wrong charts/a.obj --output 'maps/{/.}.obj' --report maps/a.obj
wrong charts/a.obj --output '{.}.svg'
wrong charts/a.obj --output '{.}.ply' --hold charts/a.ply
wrong charts/a.obj --output '{.}.ply' --start charts/a.ply
wrong charts/b.c.obj --output 'maps/{/.}'          # which looks like a format
make_square >a.obj
wrong a.obj charts/a.obj --picture 'maps/{/.}.svg'
rm a.obj
expect 3 charts/a.obj --output 'nowhere/{/.}.obj'
expect 0 charts/a.obj charts/b.c.obj --output 'maps/{/.}.obj' --picture '{.}.svg' --report report.json
leaves_only square.obj charts charts/{a,b.c}.{obj,svg} maps maps/{a,b.c}.obj report.json
for name in a b.c; do is_mesh maps/$name.obj "{/.}"; is_picture charts/$name.svg "{.}"; done
[ "$(wc -l <report.json)" -eq 2 ] || fail "the report has not a line for each input"
rm report.json
expect 2 charts/a.obj missing.obj charts/b.c.obj --output '{.}.uv.obj' --quiet
is_mesh charts/b.c.uv.obj "after an input that is missing"
make_square >'charts/a{.}b.obj'
expect 0 'charts/a{.}b.obj' --output 'maps/{/.}.obj'
is_mesh 'maps/a{.}b.obj' "braces in the name of an input"
for option in report levels; do wrong --output '{.}.obj' --$option '{.}.json'; done

# ---- endings ----

in_new_folder endings
for output in map.gltf map.stl map.off map.obj.gz map. map.svg; do wrong square.obj --output $output; done
for picture in map.png map.obj map.svgz; do wrong square.obj --picture $picture; done
expect 0 square.obj --output MAP.PLY --picture MAP.SVG
grep -q '^ply' MAP.PLY || fail "MAP.PLY is not PLY"
expect 0 square.obj --output map --picture picture
is_mesh map "no ending"
is_picture picture "no ending"

# ---- the standard output ----

in_new_folder standard_output
expect 0 square.obj --report -
is_report stdout "--report -"
[ "$(wc -l <stderr)" -eq 1 ] || fail "--report -: the summary is not on stderr"
expect 0 square.obj --report - --quiet
[ ! -s stderr ] || fail "--quiet --report - printed $(cat stderr)"
ln -s /dev/fd/1 link
expect 0 square.obj --report link
is_report stdout "a link to the standard output"
expect 0 square.obj --output -
is_mesh stdout "--output -"
[ "$(wc -l <stdout)" -eq "$(grep -c -e '^v ' -e '^vt ' -e '^f ' stdout)" ] ||
  fail "--output -: more than the mesh is there"
[ "$("$program" square.obj --quiet --picture - | grep -c '</svg>')" -eq 1 ] || fail "--picture - into a pipe"
"$program" square.obj --quiet --report /dev/fd/7 7>seven.json || fail "--report /dev/fd/7"
is_report seven.json "--report /dev/fd/7"
echo before >appended
"$program" square.obj --quiet --report link >>appended
[ "$(head -1 appended)/$(wc -l <appended)" = before/2 ] ||
  fail "a link to the standard output lost what was in the file"
[ -L link ] || fail "a link to the standard output was replaced"
leaves_only square.obj seven.json appended link

# unprintable ARGUMENT...: exit status 3 and one line of error if the standard output is full, and if it is closed.
unprintable() {
  "$program" "$@" >/dev/full 2>stderr
  [ "$?/$(wc -l <stderr)" = 3/1 ] || fail "'$* >/dev/full': $(cat stderr)"
  "$program" "$@" >&- 2>stderr
  [ "$?/$(wc -l <stderr)" = 3/1 ] || fail "'$* >&-': $(cat stderr)"
}
unprintable square.obj
unprintable --help
unprintable --version
unprintable square.obj --quiet --output -
# A file that is opened while the standard output is closed does not become it.
"$program" square.obj --output closed.obj >&- 2>/dev/null
grep -q triangles closed.obj && fail "the summary went into the output"
"$program" square.obj --quiet --output closed.obj >&- 2>&- || fail "--quiet needs a standard output"

# ---- both files or none ----

in_new_folder both
mkdir folder.svg
for picture in none/map.svg folder.svg /dev/fd/9; do
  expect 3 square.obj --output out.obj --picture $picture 9>/dev/full
  leaves_only square.obj folder.svg
done

# ---- names in messages ----

in_new_folder messages
name=$'two\nlines\e[31m.obj'
expect 2 "$name"
expect 1 "--$name"
expect 1 --method "$name"
expect 3 square.obj --output "none/$name"
expect 1 square.obj --picture "$name"
make_square >"$name"
expect 0 "$name" --report report.json
[ "$(wc -l <stdout)" -eq 1 ] || fail "the summary is not one line"
grep -q '"input":"two\\nlines\\u001b\[31m.obj"' report.json || fail "the report has another name: $(cat report.json)"

# ---- flips ----

in_new_folder flips
make_tube 5 >tube.obj
expect 3 tube.obj --method lscm --flips fail
grep -q -e '; --flips repair or keep$' stderr || fail "no advice on flips: $(cat stderr)"
# Along a longer one it shrinks beyond what doubles can hold: not even a repair helps.
make_tube 1000 >tube.obj
expect 3 tube.obj --method lscm
grep -q 'that cannot be repaired; --flips keep$' stderr || fail "wrong advice after a repair: $(cat stderr)"

# ---- signals ----

in_new_folder signals
mkfifo pipe.svg

# interrupted SIGNAL WANTED [COMMAND]: the exit status if the signal comes when the output is written and the picture
# waits for a reader of the pipe. COMMAND comes before the program.
interrupted() {
  local signal=$1 wanted=$2 before=${3:-:} status=0 waiting=0
  (
    until [ -n "$(find . -name '.part*' -size +0)" ] || [ $((waiting += 1)) -gt 600 ]; do sleep 0.05; done
    kill -s "$signal" "$(cat pid)"
    [ "$wanted" -ne 0 ] || timeout 60 cat pipe.svg >picture
  ) &
  # In the foreground, as a shell lets what runs in the background ignore SIGINT.
  {
    bash -c "$before"'; echo $$ >pid; exec "$@"' bash \
      "$program" square.obj --quiet --output out.obj --picture pipe.svg || status=$?
  } 2>stderr                                 # what bash tells of signals as well
  wait
  [ "$status" -eq "$wanted" ] || fail "after SIG$signal the exit status is $status instead of $wanted"
  rm -f pid
}
for signal in INT TERM HUP; do
  echo old >out.obj
  interrupted $signal $((128 + $(kill -l $signal)))
  [ "$(cat out.obj)" = old ] || fail "SIG$signal: half of two files was written"
  leaves_only square.obj pipe.svg out.obj
done
interrupted HUP 0 'trap "" HUP'
is_mesh out.obj "a signal that is ignored"
is_picture picture "a signal that is ignored"
leaves_only square.obj pipe.svg out.obj picture

cd "$folder" || exit 1
[ "$failures" -eq 0 ] && echo "all passed"
exit $((failures > 0))
