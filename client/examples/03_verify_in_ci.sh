#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A planner's CI: does the segmentation still find in our recording what it found when we looked at
# it? Needs no camera, no daemon and no shared memory, and runs wherever `cleave` and
# `cleave-workbench` are installed.
#
#   03_verify_in_ci.sh RECORDING.mcap [GOLDEN.mcap]
#
# Record once on the robot, while the planner does what it should:
#
#   cleave record --duration 20 table.mcap
#
# Make the golden file once, and look at what it holds before you commit it:
#
#   cleave verify table.mcap --expect table.golden.mcap --update     (open both in Foxglove)
#
# Ever after, in CI, this is the one line that matters; its exit code is 1 when a label, a segment or
# a border differs, and its output says in which frame and what:
#
#   cleave verify table.mcap --expect table.golden.mcap
#
# In CMake:
#
#   add_test(NAME segments_of_the_table
#            COMMAND cleave verify ${DATA}/table.mcap --expect ${DATA}/table.golden.mcap)
set -euo pipefail

recording=${1:?usage: $0 RECORDING.mcap [GOLDEN.mcap]}
golden=${2:-${recording%.mcap}.golden.mcap}
cleave=${CLEAVE:-cleave}  # e.g. CLEAVE=build/release/bin/cleave

# A recording that was damaged on its way here explains more than any difference does.
"$cleave" info "$recording"

if [ ! -e "$golden" ]; then
  "$cleave" verify "$recording" --expect "$golden" --update
  echo "$golden is new: look at it, and commit it beside $recording"
  exit 0
fi

# Labels are the same on every machine and for every number of workers, so nothing is forgiven. A
# planner that only needs to know where things are may add, e.g., --tolerance-points 0.001
# --tolerance-m 0.002.
"$cleave" verify "$recording" --expect "$golden"
