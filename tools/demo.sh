#!/usr/bin/env bash
# The main job, shown: a scan (the user's, or one from the simulator), labelled. Usage: demo.sh SCENELORE [SCAN]
set -euo pipefail
scenelore=$1
scan=${2:-}

mkdir -p demo
if [ -z "$scan" ]; then
  scan=demo/office.ply
  "$scenelore" simulate "$scan" --seed 11 >/dev/null
fi
name=$(basename "${scan%.*}")
"$scenelore" run "$scan" --kb "demo/$name.gpkg" --labelled "demo/${name}_labelled.ply"
"$scenelore" export "demo/$name.gpkg" "$name" "demo/${name}_plan.svg" >/dev/null
# A file that was there before has other planes than 1, and keeps the knowledge that it was made with.
plane=$("$scenelore" query "demo/$name.gpkg" "SELECT min(plane.id) FROM plane JOIN scan ON scan.id = scan_id WHERE name = '$name'" --csv | tail -n 1)
cat <<END

Left in demo/:
  $name.gpkg          the knowledge base: open it with any SQLite tool, or in QGIS
  ${name}_labelled.ply  the scan with a class colour, plane, label and probability a point
  ${name}_plan.svg      a floor plan
Ask it:  $scenelore query demo/$name.gpkg "SELECT * FROM labelled_plane"
         $scenelore why demo/$name.gpkg ${plane:-1}
END
