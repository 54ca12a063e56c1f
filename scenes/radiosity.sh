#!/bin/sh
# The lecture's pictures of radiosity beside path tracing, how three solvers converge, and how the error falls
# as patches shrink:
#   scenes/radiosity.sh [AJAR [FOLDER]]     AJAR: the command, FOLDER: where to (default radiosity)
# contact-sheet.png and what else `ajar lab` writes, solvers.svg, patches.csv.
set -eu

ajar=${1:-ajar}
folder=${2:-radiosity}
scene=$(dirname "$0")/cornell-box/cornell-box.gltf
mkdir -p "$folder"

echo "radiosity: pictures" >&2
"$ajar" lab "$scene" -o "$folder" --size 256x256 --exposure 1 --samples 64 --reference-samples 1024 \
    --insets none --patches 2000 --title "Radiosity on 2,000 patches, and path tracing" \
    --case "patches: --integrator radiosity --shading flat" \
    --case "smooth: --integrator radiosity --shading smooth" \
    --case "final gather: --integrator radiosity --shading gather" \
    --case "path traced: --integrator path"

echo "radiosity: solvers" >&2
"$ajar" radiosity "$scene" -o "$folder/solved.png" --size 256x256 --patches 5000 \
    --plot "$folder/solvers.svg" --plot-solvers all

# Root of relMSE against path tracing, whose own noise is .004, and a gather's .005.
echo "radiosity: patches" >&2
"$ajar" render "$scene" -o "$folder/traced.exr" --float --size 48x48 --samples 8192 --seed 1 \
    --max-bounces 32
echo "patches,shading,error" > "$folder/patches.csv"
for patches in 100 300 1000 3000 10000 20000; do
    for shading in flat smooth gather; do
        "$ajar" radiosity "$scene" -o "$folder/shown.exr" --float --size 48x48 --samples 1024 \
            --shading $shading --patches $patches --rays 1024 --shadow-samples 256
        "$ajar" compare "$folder/shown.exr" "$folder/traced.exr" --json > "$folder/compared.json" ||
            test $? = 3
        sed -n "s/.*\"relmse\": *\([-+.e0-9]*\).*/\1/p" "$folder/compared.json" |
            awk -v p=$patches -v s=$shading '{ printf "%d,%s,%.4f\n", p, s, sqrt($1) }' \
                >> "$folder/patches.csv"
    done
done
rm "$folder/shown.exr" "$folder/compared.json"
cat "$folder/patches.csv"
