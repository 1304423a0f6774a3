#!/bin/sh
# Makes twenty pairs of horizontal motions in a folder: noise with the envelope and the filter of towers.toml, each with its seed.
set -e
scene=$(dirname "$0")/towers.toml
mkdir -p "$1"
for event in $(seq 20); do
    for axis in 000 090; do
        sed -e "s/seed = 7/seed = $event$axis/" -e "s/m_per_s2 = 2.5/m_per_s2 = 0.5/" "$scene" > "$1/one.toml"
        pounding motion convert "$1/one.toml" "$1/event${event}_$axis.csv"
    done
done
rm "$1/one.toml"
