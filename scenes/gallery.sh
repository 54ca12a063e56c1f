#!/bin/sh
# The pictures of the ladder from naive path tracing to many lights, each by one run of `ajar lab`:
#   scenes/gallery.sh [AJAR [FOLDER]]     AJAR: the command (default ajar), FOLDER: where to (default gallery)
# and, by `ajar render` and oiiotool, the sheet that the README begins with (FOLDER/gallery.jpg).
# AJAR_GALLERY_SECONDS (default 10) is the time of a case where time is what counts.
set -eu

ajar=${1:-ajar}
folder=${2:-gallery}
scenes=$(dirname "$0")
seconds=${AJAR_GALLERY_SECONDS:-10}

# The sheet: what scenes look like when they are done.
picture() { # SCENE SIZE OPTIONS...
    scene=$1
    size=$2
    shift 2
    echo "gallery: $scene" >&2
    "$ajar" render "$scenes/$scene/$scene.gltf" -o "$folder/$scene.png" --size "$size" --samples 256 "$@"
}
mkdir -p "$folder"
picture cornell-box 300x300
picture glossy-and-specular 300x300
picture veach-mis 400x300 --light-sampler tree
picture textured 400x300
oiiotool "$folder/cornell-box.png" --create 1412x300 3 --paste +0+0 \
    "$folder/glossy-and-specular.png" --swap --paste +304+0 "$folder/veach-mis.png" --swap --paste +608+0 \
    "$folder/textured.png" --swap --paste +1012+0 --compression jpeg:92 -o "$folder/gallery.jpg"

lab() { # NAME SCENE OPTIONS...
    name=$1
    scene=$2
    shift 2
    echo "gallery: $name" >&2
    "$ajar" lab "$scenes/$scene/$scene.gltf" -o "$folder/$name" "$@"
}

# What samples buy, and what bounces do.
lab samples cornell-box --size 320x320 --exposure 1 --samples 64 --sheet-samples 4,16,64 \
    --title "Cornell box: 4, 16 and 64 samples"
lab indirect cornell-box --size 320x320 --exposure 1 --samples 64 --title "Without and with indirect light" \
    --case "direct light alone: --max-bounces 0" --case "and indirect light: --max-bounces 12"

# Lights found by chance, or asked for.
lab naive cornell-box --size 320x320 --exposure 1 --samples 64 --sheet-samples 4,16,64 \
    --integrators naive,path --title "Naive path tracing against direct lighting"
lab veach-mis veach-mis --size 480x320 --samples 16 --strategies light,bsdf,mis \
    --title "Veach's plates: light sampling, BSDF sampling, both"

# Which of ten thousand lights, in the same time.
for market in many-lights-10000 many-lights-walled-10000; do
    lab "$market" "$market" --size 480x270 --seconds "$seconds" \
        --light-samplers uniform,power,tree,visibility \
        --reference-options "--light-sampler tree" --title "$market: how a light is picked"
done

# Where light comes through a door ajar, all of them fail.
lab ajar-door ajar-door --size 480x320 --seconds "$seconds" --integrators naive,path \
    --strategies light,bsdf,mis --title "Ajar door: direct lighting fails"
