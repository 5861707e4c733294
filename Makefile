# The two commands of the README, and what developers add to them. Everything else is CMake (CMakePresets.json).
SCAN ?=
JOBS ?= $(shell nproc)

.PHONY: demo test build bench faces engine_bench experiments table1 relabel label_bench segmentation_bench rules_bench knowledge nightly asan clean

demo: build
	bash tools/demo.sh build/release/bin/scenelore "$(SCAN)"

test:
	bash tools/setup.sh build test
	cmake --preset ci
	cmake --build --preset ci -j $(JOBS)
	ctest --test-dir build/ci --output-on-failure -j $(JOBS)

build:
	bash tools/setup.sh build
	cmake --preset release -DSCENELORE_BUILD_TESTS=OFF
	cmake --build --preset release -j $(JOBS)

# Table 1 of the paper on simulated rooms: reference mode and default, before and after constraints.
table1: bench
	build/bench/bin/table1

# The paper's experiments and more, as a report; REAL=folder adds labelled real scans, SETS=10 makes it thorough,
# SEED names the first set.
SETS ?= 2
SEED ?= 9761
REAL ?=
experiments: bench
	build/bench/bin/experiments docs/experiments $(SETS) $(SEED) $(REAL)

# Time of `scenelore label` after one changed row and after one edited rule, on eleven simulated rooms.
relabel: bench
	build/bench/bin/relabel

# Time of each step from stored planes to labels and reasons, in memory, on eight simulated rooms; SCANS="a.gpkg …" for others.
SCANS ?=
label_bench: bench
	build/bench/bin/label_bench $(SCANS)

# Segmentation beside PCL and CGAL on simulated rooms; OPTIONS="--scans FOLDER" for real scans, --only NAME for some methods.
OPTIONS ?=
segmentation_bench: bench
	cmake --build --preset bench -j $(JOBS) --target segmentation_bench
	build/bench/bin/segmentation_bench $(OPTIONS)

# What a relation costs: one call into Lua, and whole buildings with every built-in relation.
rules_bench: bench
	build/bench/bin/rules_bench

# Learns the default priors again from simulated rooms (schemas/knowledge/office_learned.sql).
knowledge: bench
	build/bench/bin/learn_office schemas/knowledge/office.sql > schemas/knowledge/office_learned.sql.new
	mv schemas/knowledge/office_learned.sql.new schemas/knowledge/office_learned.sql

# Learns again from simulated scans what tells a planar face from clutter (perception/src/face_trees.inc); knowledge should be learned
# after it, since it decides which planes there are.
faces: bench
	cmake --build --preset bench -j $(JOBS) --target learn_faces
	build/bench/bin/learn_faces > perception/src/face_trees.inc.new
	mv perception/src/face_trees.inc.new perception/src/face_trees.inc

# The engine beside toulbar2 on the same instances: rooms, random planes, a building, classical problems.
engine_bench: bench
	rm -rf build/bench/rooms && mkdir -p build/bench/rooms
	cd build/bench/rooms && for seed in 7 11 12; do ../bin/scenelore simulate room$$seed.ply --seed $$seed && \
	  ../bin/scenelore run room$$seed.ply --kb rooms.gpkg > /dev/null || exit 1; done
	build/bench/bin/engine_bench build/bench/bin/scenelore build/bench/rooms/rooms.gpkg

# Two million random problems against enumeration, every answer about each one (about half an hour).
nightly:
	bash tools/setup.sh build test
	cmake --preset ci
	cmake --build --preset ci -j $(JOBS) --target nightly

bench:
	bash tools/setup.sh build test
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS)

asan:
	bash tools/setup.sh build test
	cmake --preset asan
	cmake --build --preset asan -j $(JOBS)
	ctest --test-dir build/asan --output-on-failure -j $(JOBS) -LE slow

clean:
	rm -rf build demo
