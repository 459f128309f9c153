#!/bin/sh
# Makes the figures and tables of the docs anew, with the programs in build/release/bin.
#   tools/figures.sh [--list]   what there is: name, page, rough time, command; and the time of all
#   tools/figures.sh NAME...    these
#   tools/figures.sh --all      all of them, in many hours; one table
#   tools/figures.sh --check    whether every command's programs and scripts exist and its page names it
# Tables go to the terminal and to build/figures/NAME.log, or into their page; charts go to docs/ or
# out/, as the command says. Times in brackets are guesses. Many need povray and an idle machine.
set -u
cd "$(dirname "$0")/.." || exit 1
PATH=$PWD/build/release/bin:$PATH

# VISITOR NAME PAGE TIME COMMAND [PART]: the page has each command of COMMAND as it stands, or PART.
figures() {
  $1 sheets-speed docs/performance.md '(30 min)' \
    'tests/bench/compare.sh --no-views balls; tests/bench/compare.sh --no-views gears'
  $1 print-job docs/performance.md '(40 min)' 'python3 tests/bench/print_job.py' 'python3 tests/bench/print_job.py'
  $1 pixel-cost docs/performance.md '(20 min)' 'python3 tests/bench/pixel_cost.py'
  $1 primitives docs/performance.md '(40 min)' \
    'python3 tests/bench/primitives.py --runs 3 --json build/primitives.json;
     python3 tests/bench/primitives.py --runs 9 --json build/primitives.json
       mesh_million union csg_parts isosurface_noise text;
     python3 tests/bench/primitives.py --json build/primitives.json --table'
  $1 paths docs/performance.md '(3 min)' \
    'python3 tests/bench/same_cost.py build/release build/release --before-option Specialised_Paths=Off --only spd;
     python3 tests/bench/same_cost.py build/release build/release --before-option Specialised_Paths=Off --only corpus'
  $1 parse-speed docs/performance.md '(10 min)' 'python3 tests/bench/parse_speed.py --runs 9'
  $1 building docs/performance.md '(10 min)' 'python3 tests/bench/building.py'
  $1 antialiasing-cost docs/performance.md '(20 min)' 'python3 tests/compat/antialiasing.py --cost'
  $1 embree docs/notes.md '(5 min)' \
    'cmake --preset release -B build/bench -DLENTRAY_BENCHMARKS=ON;
     cmake --build build/bench --target bench_hierarchy; build/bench/bin/bench_hierarchy'

  $1 sheets docs/sheets.md '15 min' \
    'cmake --build --preset release --target test_image;
     build/release/bin/test_image --gtest_filter="*SlowWholeSheet*:*SlowSheetExamples*" | grep "^|"'
  $1 scenes docs/scenes.md '(2 h)' \
    'lentray-batch /usr/share/doc/povray/examples --out build/scenes +W160 +H120 -A --no-scene-ini --time-limit=60s --compare --table docs/scenes.md'
  $1 options docs/options.md '(10 min)' 'python3 tests/compat/options.py --write-docs' \
    tests/compat/options.py

  $1 demo-picture README.md '(1 min)' \
    'lentray scenes/demo.pov Lenticular=On View=0 +W4500 +H225 +A0.1 +Oout/left.png;
     lentray scenes/demo.pov Lenticular=On View=7 +W4500 +H225 +A0.1 +Oout/middle.png;
     lentray scenes/demo.pov Lenticular=On View=14 +W4500 +H225 +A0.1 +Oout/right.png;
     lentray scenes/demo.pov Lenticular=On +W1200 +H900 +Oout/demo.png;
     oiiotool out/left.png out/middle.png out/right.png out/demo.png --cut 300x225+480+390
       --mosaic:pad=4 4x1 -o docs/demo.png' docs/demo.png
  $1 antialiasing-picture docs/lens.md '(1 min)' \
    'V="scenes/demo.pov Lenticular=On View=11 +W2400 +H120"; lentray $V +Oout/plain.png;
     lentray $V +A0.1 +Oout/edges.png; lentray $V +A0.1 Antialias_Angle=8 +Oout/angles.png;
     oiiotool out/plain.png --cut 80x60+60+40 out/edges.png --cut 80x60+60+40
       out/angles.png --cut 80x60+60+40 --mosaic:pad=1 3x1
       --resize:filter=box 1452x360 -o docs/antialiasing.png' docs/antialiasing.png
  $1 print-pictures docs/print.md '(5 min)' \
    'lentray scenes/demo.pov Lenticular=On Lens_LPI=40 Lens_Thickness=1.9mm Lens_IOR=1.57
       Sheet_Width=100mm Sheet_Height=75mm Print_DPI=600 View_Distance=40cm +A0.3 +AM3 +Oout/sheet.png;
     oiiotool out/sheet.png --cut 90x60+1000+1000 --resize:filter=box 720x480 -o docs/print/strip.png;
     lentray-views out/sheet.png --stereo --size 192x144 --out docs/print/eyes.png;
     lentray-print pitch-test --lpi 40 --dpi 600 --size A4 --out out/pitch.pdf;
     pdftoppm -r 50 -gray -png -singlefile out/pitch.pdf docs/print/pitch;
     lentray-print sheet out/sheet.png --bleed 3mm --out out/page.pdf;
     pdftoppm -r 68 -png -singlefile out/page.pdf docs/print/page'
  $1 flip-picture docs/tutorial-flip.md '(1 min)' \
    'lentray scenes/mill.pov +W1200 +H900 +A0.1 +Oout/day.png;
     lentray scenes/mill.pov +W1200 +H900 +A0.1 +Oout/night.png Declare=Night=1;
     lentray-views --interlace out/day.png out/night.png --across --lens-sheet 40lpi --dpi 600
       --size 100x75mm --view-distance 40cm --out out/flip.png;
     lentray-views out/flip.png --eye=-8 --size 240x180 --out out/below.png;
     lentray-views out/flip.png --eye 8 --size 240x180 --out out/above.png;
     oiiotool out/below.png out/above.png --mosaic:pad=4 2x1 -o docs/print/flip.png' print/flip.png
  $1 quilt-picture docs/views.md '(1 min)' \
    'lentray scenes/demo.pov Quilt=5x3 Quilt_Tile=64x48 View_Cone=25 +A0.1 +Odocs/display/quilt.png'
  $1 depth-drawing docs/depth.md '1 s' \
    'lentray /usr/share/doc/povray/examples/advanced/woodbox.pov Lenticular=On +W960 +H300
       --depth-view docs/depth.svg' docs/depth.svg
  $1 prints docs/depth/prints.md '(1 h)' \
    'python3 tests/bench/composition.py --dpi 299.35 --table docs/depth/prints.md'
  $1 depth-three docs/depth.md '(1 min)' \
    'P="scenes/demo.pov Lenticular=On Lens_Sheet=40lpi Sheet_Width=100mm Sheet_Height=75mm Print_DPI=300
       View_Distance=40cm +A0.1"; lentray $P +Oout/print.png; lentray $P Depth=viewer +Oout/viewer.png;
     for S in print viewer; do for E in -15 0 15; do
       lentray-views out/$S.png --eye=$E --size 240x180 --out out/$S$E.png; done; done;
     oiiotool out/print-15.png out/print0.png out/print15.png out/viewer-15.png out/viewer0.png out/viewer15.png
       --mosaic:pad=4 3x2 -o docs/depth/three.png' docs/depth/three.png
  $1 depth-table docs/depth.md '(5 min)' \
    'build/release/bin/test_image --gtest_filter="*SlowDepth*" | grep "^|"' SlowDepth
  $1 accuracy-sheet docs/accuracy.md '(15 min)' \
    'lentray-chart scenes/spd_balls.pov --out build/charts/balls_sheet Declare=Lenticular_Camera=1
       +W150 +H150 --budget 1s --error 3 --reference-limit 8min'
  $1 accuracy-shadows docs/accuracy.md '(10 min)' \
    'lentray-chart /usr/share/doc/povray/examples/lights/shadows.pov --out build/charts/shadows
       +W160 +H120 --budget 2s --error 0.5 --reference-limit 8min'
  $1 accuracy-focalblur docs/accuracy.md '(15 min)' \
    'lentray-chart /usr/share/doc/povray/examples/camera/focalblur.pov --out build/charts/focalblur
       +W160 +H120 --budget 2s --error 1 --reference-limit 8min'
  $1 accuracy-promises docs/accuracy.md '(5 min)' 'tests/chart/promises.py --write'
  $1 subsurface-truth docs/global.md '10 s' 'python3 tests/bench/subsurface_truth.py lentray povray'
  $1 antialiasing docs/rendering.md '(20 min)' 'python3 tests/compat/antialiasing.py'
  $1 eye-samples docs/rendering.md '(1 h)' 'python3 tests/bench/eye_samples.py'
  $1 eye-pattern docs/rendering.md '(1 min)' 'python3 tests/bench/eye_pattern.py'
  $1 eye-picture docs/rendering.md '(5 min)' \
    'E=/usr/share/doc/povray/examples; mkdir -p out;
     for S in objects/csg/granite objects/lathe1a advanced/woodbox advanced/teapot/teapot textures/patterns/agate; do
       for W in 1 3 limit; do case $W in 1) A="+A0.3 -J";; 3) A="+A0.3 +AM3";; *) A="Antialias_Grid=4 +AM3";; esac;
         lentray $E/$S.pov Lenticular=On Lens_Sheet=40lpi Sheet_Width=40mm Sheet_Height=30mm Print_DPI=600
           View_Distance=40cm -D -V $A +Oout/one.png;
         lentray-views out/one.png --eye=-4.6 --size 189x142 --out out/$(basename $S)-$W.png; done; done;
     oiiotool out/granite-1.png out/granite-3.png out/granite-limit.png out/lathe1a-1.png out/lathe1a-3.png out/lathe1a-limit.png
       out/woodbox-1.png out/woodbox-3.png out/woodbox-limit.png out/teapot-1.png out/teapot-3.png out/teapot-limit.png
       out/agate-1.png out/agate-3.png out/agate-limit.png --mosaic:pad=4 3x5 --resize:filter=box 1150x1458 -o docs/eye.png' '(eye.png)'
  $1 blur-convergence docs/rendering.md '(20 min)' 'python3 tests/bench/blur_convergence.py'
  $1 photon-truths docs/global.md '(2 min)' 'python3 tests/bench/photon_truths.py'
  $1 radiosity-truths docs/global.md '(2 min)' 'python3 tests/bench/radiosity_truths.py'
  $1 radiosity-sharing docs/global.md '(5 min)' 'python3 tests/bench/radiosity_sharing.py'
  $1 auto-cost docs/rendering.md '(30 min)' \
    'python3 tests/bench/auto_cost.py --every 9 --size 64x48'

  $1 model-deviations docs/paper.md '(1 min)' 'lentray-model'
  $1 model-figures docs/paper.md '(1 min)' \
    'lentray-model --figures 11,12,16 --folder out; cp out/figure-1[126].png docs/paper'
  $1 model-all docs/paper.md '10 min' 'lentray-model --figures all --folder out'
  $1 model-corners docs/paper.md '(1 min)' \
    'lentray-model --figures near,theta,small,wide,edges --folder out'
  $1 grouping-tests docs/paper.md '(10 min)' \
    'S="scenes/spd_*.pov Declare=Lenticular_Camera=1";
     lentray-grouping $S +W450 +H450 --orders rows,views,columns,hilbert --caches last --repeats 0;
     lentray-grouping $S +W450 +H450 --orders columns --caches grid --repeats 0;
     lentray-grouping $S +W450 +H450 --orders auto --caches auto --accelerators buffer --repeats 0'
  $1 grouping-time docs/paper.md '(30 min)' \
    'S="scenes/spd_*.pov Declare=Lenticular_Camera=1";
     lentray-grouping $S +W300 +H300 --orders auto --accelerators buffer --repeats 9
       --caches off,last,tree,neighbourhood,grid,cascade,auto;
     lentray-grouping $S +W300 +H300 --caches auto --accelerators buffer --repeats 9
       --orders rows,views,columns,strips,tiles,serpentine,hilbert,adaptive,auto'
  $1 grouping-examples docs/paper.md '(10 min)' 'tests/bench/grouping_examples.py --write'
  $1 mosaic docs/paper.md '(10 min)' \
    'lentray-grouping scenes/mosaic.pov +W300 +H300 -UL Declare=Lights=8
       --orders rows,views,columns --caches last --repeats 9 --sizes 40,60'
  $1 gains docs/notes.md '(10 min)' \
    'lentray-grouping scenes/spd_balls.pov scenes/spd_gears.pov Declare=Lenticular_Camera=1
       +W300 +H300 --orders rows,views,columns --caches last --accelerators bvh,grid,list
       --sizes 1,2 --repeats 0 --gains gains.csv --html gains.html;
     lentray-grouping scenes/spd_rings.pov Declare=Lenticular_Camera=1 +W300 +H300
       --orders rows,views,columns --caches last --accelerators bvh,grid --sizes 1,3,5,7
       --repeats 0 --gains gains.csv'

  $1 polynomials docs/stability/tables.md '(5 min)' 'python3 tests/stability/polynomials.py'
  $1 shapes docs/stability/tables.md '(1 h)' 'python3 tests/stability/shapes.py'
  $1 media docs/stability/tables.md '(5 min)' \
    'python3 tests/stability/media.py build/release/bin/lentray --write'
  $1 lens-models docs/stability/tables.md '(1 min)' \
    'python3 tests/stability/lens_models.py build/release/bin/lentray --write'
  $1 noisy-scenes docs/media.md '(10 min)' \
    'python3 tests/bench/noisy_scenes.py build/release/bin/lentray --write'

  $1 cluster-costs docs/cluster.md '7 min' \
    'tests/batch/slurm_costs.py examples; tests/batch/slurm_costs.py sheet'
  $1 cluster-charts docs/cluster.md '(1 min)' 'tests/batch/cluster_simulation.py sweep'
  $1 cluster-prediction docs/cluster.md '5 min' \
    'tests/batch/slurm_prediction.py; tests/batch/slurm_prediction.py --lose;
     tests/batch/slurm_prediction.py --width 240'

  $1 language docs/language.md '(5 min)' 'test_compat --gtest_filter="*CompatLanguage*"'
  $1 language-random docs/language.md '(30 min)' \
    'ctest --test-dir build/release -L slow -R SlowCompatRandom'
  $1 includes docs/language.md '(5 min)' 'test_compat --gtest_filter="*CompatInclude*"'
  $1 parse-scenes docs/language.md '(10 min)' 'python3 tests/compat/parse_scenes.py'
  $1 ways docs/language.md '(10 min)' 'python3 tests/compat/ways.py'
  $1 scene-cases docs/language.md '(5 min)' 'python3 tests/compat/scene_cases.py'
}

# On one line, without what Markdown and the shell need around it.
one_line() { tr '\n' ' ' | tr -d "\\\\\"'" | tr -s ' ' | sed 's/^ //; s/ $//'; }
commands_of() { printf '%s' "$1" | one_line | tr ';' '\n' | sed 's/^ *//; s/ *$//' | grep .; }

show() { printf '%-19s %-20s %9s  %s\n' "$1" "$2" "$3" "$(printf '%s' "$4" | tr -s '\n ' ' ')"; }

names() { echo "$1"; }

failed=0
run() {
  case " $wanted " in *" $1 "*) ;; *) return ;; esac
  printf '== %s (%s) ==\n' "$1" "$2"
  began=$(date +%s)
  # Lines of one command are joined; `set -e` ends a list at its first failure.
  { sh -ec "$(commands_of_run "$4")" 2>&1; echo $? >build/figures/status; } | tee "build/figures/$1.log"
  status=$(cat build/figures/status)
  verdict=made
  [ "$status" -eq 0 ] || { verdict="status $status"; failed=1; }
  printf '| %-18s | %-10s | %6d s |\n' "$1" "$verdict" $(($(date +%s) - began)) >>build/figures/table
}
commands_of_run() { printf '%s' "$1" | tr '\n' ' ' | sed 's/; */\n/g'; }

wrong() { echo "figures.sh: $*"; failed=1; }

# A word of a command: a script or scene must be there, and a program must be one of the tree.
check_word() {  # NAME WORD FIRST
  case $2 in
    tests/* | tools/* | scenes/*)
      # shellcheck disable=SC2086
      for file in $2; do [ -e "$file" ] || wrong "$1: there is no $2"; done
      ! $3 || [ -x "$2" ] || wrong "$1: $2 cannot be executed: python3 before it"
      ;;
    lentray-polynomials) ;;
    lentray*) ! $3 || [ -f "tools/$2/main.cpp" ] || wrong "$1: there is no program $2" ;;
    */bench_*) [ -f "tests/bench/${2##*/}.cpp" ] || wrong "$1: there is no program $2" ;;
    test_* | */test_*)
      grep -q "^lentray_test(${2##*test_} " tests/CMakeLists.txt || wrong "$1: there is no program $2"
      ;;
    --gtest_filter=* | Slow*)
      for suite in $(printf '%s' "${2#--gtest_filter=}" | tr ':*' '  '); do
        grep -rq --include='*.cpp' "$suite" tests || wrong "$1: there is no test $suite"
      done
      ;;
  esac
}

check() {
  if [ ! -f "$2" ]; then
    wrong "$1: there is no $2"
    return
  fi
  page=$(one_line <"$2" | tr -d '`')
  commands=$(commands_of "$4")
  while IFS= read -r command; do
    case $page in
      *"${5:-$command}"*) ;;
      *) wrong "$1: $2 does not name: ${5:-$command}" ;;
    esac
    first=true
    set -f
    for word in $command; do
      set +f
      check_word "$1" "$word" $first
      first=false
      set -f
    done
    set +f
  done <<END
$commands
END
}

# Minutes of all rough times.
minutes() {
  figures rough_times | tr -d '()' | awk '$2 == "h" { m += 60 * $1 } $2 == "min" { m += $1 } $2 == "s" { m += $1 / 60 }
    END { printf "%d h %d min\n", m / 60, m % 60 }'
}
rough_times() { echo "$3"; }

case ${1:-} in
  '' | --list)
    figures show
    echo
    echo "All: about $(minutes)."
    echo 'Put together by hand, no command makes them: docs/batch.png (from screenshots of'
    echo 'tests/batch/page_in_browser.py), docs/stability/poly_pictures.png and coincident.png (from'
    echo 'pictures of test_image).'
    ;;
  --check)
    figures check
    exit $failed
    ;;
  -*) [ "$1" = --all ] || { sed -n '2,/^set /{s/^# \{0,1\}//p;}' "$0"; exit 1; } ;;
esac
case ${1:-} in '' | --list) exit 0 ;; esac
known=$(figures names | tr '\n' ' ')
wanted=$*
[ "$1" != --all ] || wanted=$known
for name in $wanted; do
  case " $known" in *" $name "*) ;; *) echo "figures.sh: there is no $name; there are $known"; exit 1 ;; esac
done
mkdir -p build/figures out
: >build/figures/table
figures run
cat build/figures/table
exit $failed
