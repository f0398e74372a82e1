#!/usr/bin/env bash
# Makes the body files in this folder, those named or all:
#   ./make.sh [sphere|hollow_sphere|bar|beam|plate|ring|bell|bat|bat_held|coin|bell_map|clamped_plate_map]...
# PYTHON is an interpreter that sees stoss and DOLFINx: that of `make modal-tools`.
set -euo pipefail
case ${1:-} in -h | --help) sed -n '2,4s/^# \?//p' "$0"; exit ;; esac
cd "$(dirname "$0")"
python=${PYTHON:-../../build/venv/bin/python}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}

body_of() { "$python" -m stoss.modal "$1.geo" --unit mm "${@:2}"; }
body() { body_of "$1" --material 'structural steel' "${@:2}"; }
mesh() { # SHAPE MESH OPTION...: quadratic tetrahedra by Gmsh
  "$python" -c 'import sys, gmsh
gmsh.initialize(["gmsh", "-v", "2", "-order", "2", *sys.argv[3:]])
gmsh.open(sys.argv[1])
gmsh.model.mesh.generate(3)
gmsh.write(sys.argv[2])' "$@"
}

for name in "${@:-sphere hollow_sphere bar beam plate ring bell bat bat_held coin bell_map clamped_plate_map}"; do
  for each in $name; do
    case $each in
      sphere)
        body sphere --point 6,0,8 --normal 6,0,8 --tangent 8,0,-6 --size 2 --size-at-point 0.25 \
          --modes 100 -o sphere.json ;;
      hollow_sphere) # by its closed forms, and by two meshes
        "$python" hollow_sphere.py
        body hollow_sphere --point 6,0,8 --normal 6,0,8 --size 0.9 --size-at-point 0.1 --modes 60 \
          -o hollow_sphere_mesh.json ;;
      bar)
        body bar --point 50,0,0 --normal 1,0,0 --size 2.5 --size-at-point 0.12 --modes 60 \
          -o bar.json ;;
      beam)
        body beam --point 0,0,5 --normal 0,0,1 --tangent 1,0,0 --size 4 --size-at-point 0.25 --modes 40 \
          --name "beam struck at x = 0 mm" -o beam_0.json
        for x in 30 55 95; do # on the way, a node of the first mode, near the end
          body beam --point "$x,0,5" --normal 0,0,1 --size 4 --size-at-point 0.25 --modes 40 \
            --name "beam struck at x = $x mm" -o "beam_$x.json"
        done ;;
      plate) # meshed in layers, two of them and one
        for coarser in 1 1.4; do
          mesh plate.geo "$work/plate_$coarser.msh" -setnumber coarser "$coarser"
        done
        "$python" -m stoss.modal "$work"/plate_1.msh "$work"/plate_1.4.msh --unit mm --material 'structural steel' \
          --point 0,0,2.5 --normal 0,0,1 --modes 200 --name plate -o plate.json ;;
      ring)
        for pair in 3:1.35 4:1.8 6:2.7 9:3.5; do # its thickness, two edges and more
          thickness=${pair%:*}
          sed "s/thickness = 4/thickness = $thickness/" ring.geo >"$work/ring_$thickness.geo"
          body "$work/ring_$thickness" --point=-30,0,0 --normal=-1,0,0 --size "${pair#*:}" \
            --size-at-point 0.25 --modes 60 --name "ring $thickness mm thick" -o "ring_$thickness.json"
        done ;;
      bell) # at the sound bow, on the side where the turned profile has no seam
        body_of bell --young 1.05e11 --poisson 0.34 --density 8700 --point=-50,0,9 --normal=-1,0,0 \
          --size 4 --size-at-point 0.6 --coarser 1.25 --modes 40 -o bell.json ;;
      bat)
        for z in 30 100 140 170 210 250 290; do # on the arc of the barrel
          read -r x out along < <(awk -v z="$z" 'BEGIN { t = z - 110; r = sqrt(2000^2 - t^2)
            printf "%.6f %.6f %g\n", 1967 - r, -r, t }')
          body_of bat --young 1.2e10 --poisson 0.3 --density 650 --point="$x,0,$z" \
            --normal="$out,0,$along" --size 9 --size-at-point 2 --coarser 1.3 --modes 30 \
            --name "bat struck $z mm from its far end" -o "bat_$z.json"
        done ;;
      bat_held) # the same, with its handle from 650 to 800 mm as a surface of its own
        sed -e 's/^Spline(4) = .*/Spline(4) = {5, 6, 7, 8}; Spline(9) = {8, 9};/' -e 's/{1, 2, 3, 4, 5, 6, 7, 8};/{1, 2, 3, 4, 9, 5, 6, 7, 8};/' \
          -e 's/Point{4, 6:8}/Point{4, 6:7}/' -e '$aPhysical Surface("grip") = Surface In BoundingBox{-13, -13, 649, 13, 13, 801};' \
          bat.geo >"$work/bat_held.geo"
        for z in 30 140 250; do
          read -r x out along < <(awk -v z="$z" 'BEGIN { t = z - 110; r = sqrt(2000^2 - t^2)
            printf "%.6f %.6f %g\n", 1967 - r, -r, t }')
          for grip in "clamped --clamp grip" "hands --spring grip=3e4N/m"; do
            body_of "$work/bat_held" --young 1.2e10 --poisson 0.3 --density 650 --point="$x,0,$z" \
              --normal="$out,0,$along" --size 9 --size-at-point 2 --coarser 1.3 --modes 30 ${grip#* } \
              --name "bat, ${grip%% *}, struck $z mm from its far end" -o "bat_${grip%% *}_$z.json"
          done
        done ;;
      coin)
        at() { body coin --size 1 --coarser 1.3 --modes 40 "$@"; }
        at --point=0,0,1 --normal=0,0,1 --size-at-point 0.15 --name "coin struck in the middle" \
          -o coin_0.json
        at --point=-9,0,1 --normal=0,0,1 --size-at-point 0.15 \
          --name "coin struck 9 mm from its middle" -o coin_9.json
        body coin --point=-12.5,0,0 --normal=-1,0,0 --size 1 --size-at-point 0.06 --modes 70 \
          --name "coin struck on its edge" -o coin_edge.json ;;
      bell_map) # all over the surface, from which CSV, VTU and PNG come
        body_of bell --young 1.05e11 --poisson 0.34 --density 8700 --size 4 --coarser 1.25 --modes 45 \
          --map "$work/bell_map.vtu" --points 500 --speed 0.1,1 \
          --against 'sphere,radius=0.008,material=bearing steel'
        cp "$work/bell_map.csv" . ;;
      clamped_plate_map)
        body clamped_plate --clamp rim --size 3.5 --coarser 1.3 --modes 45 \
          --map "$work/clamped_plate_map.vtu" --points 400 --speed 0.3,3 \
          --against 'sphere,radius=0.01,material=bearing steel'
        cp "$work/clamped_plate_map.csv" . ;;
      *) echo "make.sh: got '$each', allowed sphere, hollow_sphere, bar, beam, plate, ring, bell, bat, bat_held, coin," "bell_map, clamped_plate_map" >&2; exit 2 ;;
    esac
  done
done
