#!/usr/bin/env bash
# Runs every ```sh block of a document, in order, in a folder of its own that holds office.ply, and stops at the first
# command that fails. A block ```lua file=NAME becomes rules/NAME on the way, ```sql FILE is given to sqlite3. Usage: documented_commands.sh SCENELORE DOCUMENT
set -euo pipefail
scenelore=$(realpath "$1")
document=$(realpath "$2")

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" && ln -s "$scenelore" "$folder/bin/scenelore"
export PATH="$folder/bin:$PATH"
cd "$folder"
scenelore simulate office.ply --seed 11 > /dev/null

awk '/^```sh$/ { inside = 1; next }
     /^```lua file=/ { sub(/^```lua file=/, ""); print "mkdir -p rules; cat > rules/" $0 " <<'"'"'END_OF_BLOCK'"'"'"; inside = 2; next }
     /^```sql .*gpkg$/ { print "sqlite3 -bail " $2 " <<'"'"'END_OF_BLOCK'"'"'"; inside = 2; next }
     /^```/ { if (inside == 2) print "END_OF_BLOCK"; inside = 0 }
     inside' "$document" > commands.sh
[ -s commands.sh ] || { echo "$document shows no commands"; exit 1; }
bash -exo pipefail commands.sh
